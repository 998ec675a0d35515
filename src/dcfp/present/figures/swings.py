"""Pulses of the ground and swings of the structure over time, as Figures 13 and 14 of Li et al. (2020) show them."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.errors import InputError
from dcfp.present.figures.extent import shown
from dcfp.present.figures.histories import between_equal_limits
from dcfp.present.figures.style import BLUE, GREY, INK, OCHRE, calm_ticks
from dcfp.present.figures.words import millimetres
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.analysis import Response
    from dcfp.analysis.swings import Swing
    from dcfp.arrays import FloatArray
    from dcfp.inference import Case
    from dcfp.methods import Pulses

#: Part of the hysteretic energy before and after the strong part of a response [-].
_WEAK = 0.02
#: How strongly pulses and swings are shaded in each colour [-].
_SHADES = {BLUE: 0.16, OCHRE: 0.3}


def response_of(case: "Case") -> "Response":
    """Return the analysis that a case kept.

    Raises
    ------
    InputError
        If it kept none.
    """
    if case.response is None:
        msg = f"{case.record}: the analysis was not kept; compare with keep_response=True to draw it."
        raise InputError(msg)
    return case.response


def strong_part(response: "Response", swing: "Swing | None") -> tuple[float, float]:
    """Return first and last time [s] of the part in which nearly all of the energy is dissipated, and the swing is."""
    time, dissipated = response.time, response.energy.hysteretic
    whole = float(dissipated[-1])
    part = shown(response)
    if whole == 0.0 or swing is None:
        return float(time[part.start]), float(time[part.stop - 1])
    first, last = np.interp((_WEAK * whole, (1.0 - _WEAK) * whole), dissipated, time)
    first, last = min(float(first), swing.start), max(float(last), swing.end)
    margin = 0.06 * (last - first)
    return max(0.0, first - margin), min(float(time[-1]), last + margin)


def limit_time(panels: "Sequence[Axes]", limits: tuple[float, float]) -> None:
    """Give panels above each other the same times, and only the lowest the name of the axis."""
    for axes in panels:
        axes.set_xlim(*limits)
        calm_ticks(axes, 8, 4)
    panels[-1].set_xlabel(quantity("time").label)


def history_width(limits: tuple[float, float]) -> float:
    """Return the width [pt] at which the waves between two times stay apart."""
    span = limits[1] - limits[0]
    return 0.9 if span < 15.0 else 0.7 if span < 40.0 else 0.5


def draw_pulses(axes: "Axes", response: "Response", pulses: "Pulses", width: float) -> None:
    """Draw the ground velocity and its peaks, joined by straight lines."""
    entry = quantity("ground_velocity")
    velocity = entry.display(response.ground_velocity)
    axes.plot(response.time, velocity, color=GREY, linewidth=width)
    axes.plot(
        pulses.times,
        entry.display(pulses.velocities),
        color=BLUE,
        linewidth=0.6,
        marker="o",
        markersize=2.4,
        zorder=3,
    )
    axes.set_ylabel(entry.label)
    between_equal_limits(axes, float(np.abs(velocity).max()))


def mark_pulse(axes: "Axes", pulses: "Pulses", number: int, colour: str) -> None:
    """Shade the time of a pulse, and draw its lines thick; pulses are counted from zero."""
    places = slice(number, number + 3)
    times = pulses.times[places]
    axes.axvspan(
        float(times[0]), float(times[-1]), color=colour, alpha=_SHADES[colour], linewidth=0.0, zorder=0
    )
    velocities = quantity("ground_velocity").display(pulses.velocities[places])
    axes.plot(times, velocities, color=colour, linewidth=1.2, marker="o", markersize=3.0, zorder=4)


def draw_velocities(axes: "Axes", response: "Response", swing: "Swing | None", width: float) -> None:
    """Draw the velocities of ground and structure; the area between them is the displacement, that of a swing filled."""
    entry = quantity("velocity")
    ground, structure = (
        entry.display(values) for values in (response.ground_velocity, response.structure_velocity)
    )
    for name, values, colour in (("ground_velocity", ground, GREY), ("structure_velocity", structure, BLUE)):
        label = f"${quantity(name).symbol}$"
        axes.plot(response.time, values, color=colour, linewidth=width, label=label)
    if swing is not None:
        time, below, above = during(swing, response.time, ground, structure)
        area = rf"area $=\Delta y=$ {millimetres(abs(swing.change))}"
        axes.fill_between(time, below, above, color=OCHRE, alpha=0.7, linewidth=0.0, label=area)
    axes.set_ylabel(entry.label)
    between_equal_limits(axes, float(max(np.abs(ground).max(), np.abs(structure).max())))


def draw_displacement(axes: "Axes", response: "Response", swing: "Swing | None", width: float) -> None:
    """Draw the displacement, with the change of one swing from peak to peak."""
    axes.plot(response.time, response.displacement, color=BLUE, linewidth=width, label="analysis")
    if swing is not None:
        _draw_change(axes, response, swing)
    axes.set_ylabel(quantity("displacement").label)
    between_equal_limits(axes, float(np.abs(response.displacement).max()))


def shade_swing(axes: "Axes", swing: "Swing") -> None:
    """Shade the time of a swing."""
    axes.axvspan(swing.start, swing.end, color=OCHRE, alpha=_SHADES[OCHRE], linewidth=0.0, zorder=0)


def during(swing: "Swing", time: "FloatArray", *histories: "FloatArray") -> "tuple[FloatArray, ...]":
    """Return time and histories from the start of a swing to its end, both of which lie between samples."""
    inside = (swing.start < time) & (time < swing.end)
    times = np.concatenate(([swing.start], time[inside], [swing.end]))
    return times, *(np.interp(times, time, values) for values in histories)


def _draw_change(axes: "Axes", response: "Response", swing: "Swing") -> None:
    first, last = (
        float(value) for value in np.interp((swing.start, swing.end), response.time, response.displacement)
    )
    mark_change(axes, (swing.start, swing.end), (first, last))
    name_swing(axes, swing, rf"$\Delta y$ {millimetres(abs(swing.change))}")


def mark_change(axes: "Axes", times: tuple[float, float], values: tuple[float, float]) -> None:
    """Mark two points of a history, and with an arrow the difference of their values."""
    (_, end), (first, last) = times, values
    axes.plot(times, values, color=INK, marker="o", markersize=2.6, linestyle="none", zorder=4)
    axes.plot(times, (first, first), color=INK, linewidth=0.5, linestyle=(0, (2, 2)), zorder=3)
    arrow = {"arrowstyle": "<->", "color": INK, "linewidth": 0.7, "shrinkA": 0.0, "shrinkB": 0.0}
    axes.annotate("", (end, last), (end, first), arrowprops=arrow)


def name_swing(axes: "Axes", swing: "Swing", words: str) -> None:
    """Write words at the top of the panel, above a swing."""
    axes.annotate(
        words,
        (0.5 * (swing.start + swing.end), 0.985),
        xycoords=axes.get_xaxis_transform(),
        ha="center",
        va="top",
        annotation_clip=True,
        zorder=5,
    )
