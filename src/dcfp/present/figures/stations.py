"""Stations drawn: the ground motion of both directions and in the plane, and the response spectra over all directions."""

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.errors import InputError
from dcfp.motion.station_measures import principal_axes
from dcfp.present.figures import style
from dcfp.present.figures.drawing import between_equal_limits, draw_cross
from dcfp.schema.formulas import metres_per_second, millimetres, typeset
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.methods.spectra.of_station import StationSpectrum
    from dcfp.motion.station import Station

#: Most stations on a page, and the height of each and of its head [in].
_MOST, _HEIGHT, _HEAD = 3, 3.0, 0.35
_DIRECTIONS = (("x", style.BLUE), ("y", style.OCHRE), ("vertical", style.GREY))
_COLOURS = (style.BLUE, style.RED, style.OCHRE, style.INK, style.GREY, "#6699CC", "#228833", "#AA3377")
_OF_MEASURES = {"rotd50": style.BLUE, "rotd100": style.RED, "srss": style.INK, "geomean": style.OCHRE}
_TICKS = (0.1, 1.0, 10.0)


@style.styled
def plot_stations(stations: "Sequence[Station]") -> "Figure":
    """Draw the histories of every station by direction and, beside them, the path of its velocity in the plane with the principal axes, on a new figure.

    Raises
    ------
    InputError
        If there are more than a page can hold.
    """
    if len(stations) > _MOST:
        msg = f"a figure holds at most {_MOST} stations, not {len(stations)}; name fewer."
        raise InputError(msg)
    figure = style.new_figure(_HEAD * len(stations) + _HEIGHT * len(stations))
    rows: Any = figure.subfigures(len(stations), 1, squeeze=False)
    for row, station in zip(rows[:, 0], stations, strict=True):
        left, right = row.subfigures(1, 2, width_ratios=(1.35, 1.0))
        _draw_histories(left.subplots(3, 1, sharex=True), station)
        _draw_path(right.subplots(), station)
        peaks = f"PGA {typeset(station.peak_acceleration / 1e3, 2)} m/s², PGV {metres_per_second(station.peak_velocity)}, PGD {millimetres(station.peak_displacement)}"
        row.suptitle(f"{style.drawable(station.name, 36)}:  {peaks} (resultant)", x=0.01, ha="left")
    return figure


def _draw_histories(panels: "np.ndarray", station: "Station") -> None:
    for axes, name in zip(panels, ("acceleration", "velocity", "displacement"), strict=True):
        entry = quantity(f"ground_{name}")
        drawn = [entry.display(getattr(one, name)) for one in station.components]
        # the first before the others
        for place, (heights, (label, colour)) in enumerate(zip(drawn, _DIRECTIONS, strict=False)):
            style.draw_line(axes, station.x.time, heights, colour, 0.5, label=label, zorder=3.0 - 0.1 * place)
        style.label_axes(axes, "", entry.label, 6, 4, xlim=(0.0, station.duration))
        between_equal_limits(axes, *drawn)
    style.legend_above(panels[0])
    panels[-1].set_xlabel(quantity("time").label)


def _draw_path(axes: "Axes", station: "Station") -> None:
    entry = quantity("ground_velocity")
    x, y = entry.display(station.velocity).T
    draw_cross(axes)
    style.draw_line(axes, x, y, style.BLUE, 0.5)
    reach = 1.08 * max(float(np.hypot(x, y).max()), 1e-9)
    axes_of = principal_axes(station)
    for turn, size in ((0.0, 1.0), (90.0, axes_of.ratio)):
        angle = math.radians(axes_of.angle + turn)
        ends = np.array([-reach, reach]) * 0.9 * size
        style.draw_line(axes, ends * math.cos(angle), ends * math.sin(angle), style.RED, 0.8, linestyle=style.DASHED)  # fmt: skip
    x_label, y_label = (f"ground velocity, direction {name} [{entry.shown.name}]" for name in ("x", "y"))
    style.label_axes(axes, x_label, y_label, 5, 5, xlim=(-reach, reach), ylim=(-reach, reach))
    axes.set_aspect("equal")
    words = f"principal axes at {typeset(axes_of.angle, 0)}°, ratio {axes_of.ratio:.2f}"
    axes.set_title(words, loc="left", color=style.RED)


@style.styled
def plot_station_spectra(spectra: "Sequence[StationSpectrum]", velocities: "Sequence[float]") -> "Figure":
    """Draw displacement and pseudo-acceleration over the period, and how they differ, on a new figure.

    Of one station all measures with both components, and their ratios to RotD50; of several RotD100, with its ratio to RotD50. `velocities` are the PGVs
    of the resultants [mm/s], for the legend; of more stations than colours the lines are thin and grey, with their geometric mean.
    """
    figure = style.new_figure(2.9)
    panels: Any = figure.subplots(1, 3)
    if len(spectra) == 1:
        _draw_measures(panels, spectra[0])
        head = f"{style.drawable(spectra[0].name, 60)}, PGV {metres_per_second(velocities[0])} (resultant)"
        panels[0].set_title(head, loc="left", parse_math=False)
    else:
        _draw_largest(panels, spectra, velocities)
    ratio = "over RotD50 [-]" if len(spectra) == 1 else "RotD100 over RotD50 [-]"
    labels = ("$S_d$ [mm]", "$S_a$ [m/s²]", ratio)
    for panel, label in zip(panels, labels, strict=True):
        panel.set(xscale="log", xlabel="$T$ [s]", ylabel=label)
        panel.set_xticks(_TICKS, [f"{tick:g}" for tick in _TICKS])
    for panel in panels[:2]:
        panel.set_ylim(0.0, None)
    columns = 6 if len(spectra) == 1 else 1 if len(spectra) > len(_COLOURS) else min(4, len(spectra))
    style.legend_outside(panels[0], columns)
    return figure


def _draw_measures(panels: Any, spectrum: "StationSpectrum") -> None:
    lines = [("x", spectrum.x, style.GREY, 0.6, "-"), ("y", spectrum.y, style.GREY, 0.6, style.DASHED)]
    from dcfp.methods.spectra.of_station import PAIR_MEASURES  # late: it loads the kernels

    lines += [(one.title, one.get(spectrum), _OF_MEASURES[name], 1.0, "-") for name, one in PAIR_MEASURES.items()]  # fmt: skip
    middle = spectrum.rotated(50.0)
    for label, values, colour, width, dashes in lines:
        for panel, heights in zip(panels, _heights(spectrum, values, middle), strict=True):
            style.draw_line(panel, spectrum.periods, heights, colour, width, label=label, linestyle=dashes)


def _draw_largest(panels: Any, spectra: "Sequence[StationSpectrum]", velocities: "Sequence[float]") -> None:
    many = len(spectra) > len(_COLOURS)
    every = [_heights(one, one.rotated(100.0), one.rotated(50.0)) for one in spectra]
    for place, (one, pgv) in enumerate(zip(spectra, velocities, strict=True)):
        label = None if many else f"{style.drawable(one.name, 30)}, {metres_per_second(pgv)}"
        colour, width = (style.GREY, 0.3) if many else (_COLOURS[place], 0.9)
        for panel, heights in zip(panels, every[place], strict=True):
            style.draw_line(panel, one.periods, heights, colour, width, label=label)
    if many:
        for place, panel in enumerate(panels):
            mean = np.exp(np.log(np.maximum([one[place] for one in every], 1e-12)).mean(axis=0))
            words = f"RotD100, geometric mean of {len(spectra)}"
            style.draw_line(panel, spectra[0].periods, mean, style.BLUE, 1.4, label=words)
    panels[0].set_title("RotD100", loc="left")


def _heights(spectrum: "StationSpectrum", values: "np.ndarray", middle: "np.ndarray") -> "tuple[np.ndarray, ...]":  # fmt: skip
    omega = 2.0 * np.pi / spectrum.periods
    return values, values * omega**2 / 1e3, values / np.maximum(middle, 1e-12)
