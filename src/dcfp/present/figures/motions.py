"""Ground motions beside each other, their spectra, and what the methods of codes say of them beside the analysis."""

import textwrap
from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.errors import InputError
from dcfp.motion.measures import baseline_warning
from dcfp.present.figures import style
from dcfp.present.figures.drawing import between_equal_limits, mark_peak
from dcfp.schema.formulas import metres_per_second, millimetres
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.methods.code_comparison import CodeComparison
    from dcfp.methods.spectra import EnergySpectrum
    from dcfp.motion.ground_motion import GroundMotion

#: Most motions beside each other, and on a page.
_COLUMNS, _MOST = 4, 12
_ROW_HEIGHT, _HEAD_HEIGHT = 0.95, 0.5
#: Characters of a head in the width of the page.
_HEAD_WIDTH = 108
#: Peaks that differ by more than this factor do not share an axis [-].
_COMPARABLE = 4.0
_COLOURS = (style.BLUE, style.RED, style.OCHRE, style.INK, style.GREY, "#6699CC", "#228833", "#AA3377")
#: Periods that are named on the axis [s].
_TICKS = (0.1, 1.0, 10.0)
#: Periods at which a spectrum is drawn [s].
_PERIODS = np.geomspace(0.05, 10.0, 300)
_COLOURS_OF_METHODS = (style.BLUE, style.OCHRE, style.RED, style.INK, style.GREY, "#6699CC")
#: Height of a row of panels, and of the legend above [in].
_ROW, _HEAD = 2.3, 0.5


@style.styled
def plot_motions(motions: "Sequence[GroundMotion]") -> "Figure":
    """Draw acceleration, velocity and displacement of motions, a column for each, on a new figure.

    Four stand beside each other; those that follow stand below. The motions beside each other share their scales
    where their peaks are comparable.

    Raises
    ------
    InputError
        If there are more than a page can hold.
    """
    if len(motions) > _MOST:
        msg = f"a figure holds at most {_MOST} motions, not {len(motions)}; name fewer records."
        raise InputError(msg)
    columns = min(len(motions), _COLUMNS)
    blocks = [motions[first : first + columns] for first in range(0, len(motions), columns)]
    figure = style.new_figure((3.0 * _ROW_HEIGHT + _HEAD_HEIGHT) * len(blocks))
    panels = figure.subplots(3 * len(blocks), columns, squeeze=False)
    for number, block in enumerate(blocks):
        _draw_block(panels[3 * number : 3 * number + 3], block)
    figure.align_ylabels(list(panels[:, 0]))
    return figure


def _draw_block(panels: "np.ndarray", motions: "Sequence[GroundMotion]") -> None:
    columns = panels.shape[1]
    for axes in panels[:, len(motions) :].ravel():
        axes.set_axis_off()
    for column, motion in enumerate(motions):
        _draw_column(panels[:, column], motion, columns)
        _write_head(panels[0, column], motion, _HEAD_WIDTH // columns)
    for axes in panels[:, 1:].ravel():
        axes.set_ylabel("")
    for row in panels[:, : len(motions)]:
        _share_limits(list(row))


def _draw_column(panels: "np.ndarray", motion: "GroundMotion", columns: int) -> None:
    width = 0.5 if motion.duration * columns > 60.0 else 0.7
    histories: dict[str, Callable[[float], str]] = {
        "acceleration": lambda value: f"{metres_per_second(value)}²",
        "velocity": metres_per_second,
        "displacement": millimetres,
    }
    for axes, (name, words) in zip(panels, histories.items(), strict=True):
        entry, values = quantity(f"ground_{name}"), getattr(motion, name)
        heights = entry.display(values)
        style.draw_line(axes, motion.time, heights, style.BLUE, width)
        style.label_axes(axes, "", entry.label, max(4, 10 // columns), 4, xlim=(0.0, motion.duration))
        mark_peak(axes, motion.time, heights, words(float(np.abs(values).max())))
        between_equal_limits(axes, heights)
        axes.tick_params(labelbottom=axes is panels[-1])
    panels[-1].set_xlabel(quantity("time").label)
    if baseline_warning(motion) is not None:
        place: Any = {"xy": (0.02, 0.03), "xycoords": "axes fraction"}
        panels[-1].annotate("baseline in doubt", color=style.RED, va="bottom", **place)


def _share_limits(row: "list[Axes]") -> None:
    limits = [axes.get_ylim()[1] for axes in row]
    if max(limits) > _COMPARABLE * min(limits):
        return
    for axes in row:
        axes.set_ylim(-max(limits), max(limits))
    for axes in row[1:]:
        axes.tick_params(labelleft=False)


def _write_head(axes: "Axes", motion: "GroundMotion", width: int) -> None:
    origin = motion.origin
    words = [style.drawable(word) for word in (origin.station, origin.event, origin.component) if word]
    lines = textwrap.wrap(", ".join(words), width, max_lines=3, placeholder=" …")
    name = textwrap.shorten(style.drawable(motion.name), max(width - 4, 12), placeholder=" …")
    place: dict[str, Any] = {"xytext": (0.0, 4.0), "xycoords": "axes fraction", "textcoords": "offset points"}
    look: dict[str, Any] = {"va": "bottom", "size": 6.5, "color": "#555555", "parse_math": False}
    axes.annotate("\n".join(lines), (0.0, 1.0), **place, **look)
    axes.set_title(name, loc="left", weight="bold", pad=6.0 + 9.0 * len(lines), parse_math=False)


@style.styled
def plot_spectra(spectra: "Sequence[EnergySpectrum]", velocities: "Sequence[float]") -> "Figure":
    """Draw displacement, pseudo-acceleration and equivalent velocity of the input energy over the period, on a new figure.

    `velocities` are the PGVs of the motions [mm/s], for the legend; of more motions than colours the lines are thin and grey, with their
    geometric mean.
    """
    many = len(spectra) > len(_COLOURS)
    figure = style.new_figure(2.9)
    axes: Any = figure.subplots(1, 3)
    every = [_values(one) for one in spectra]
    for place, (one, pgv) in enumerate(zip(spectra, velocities, strict=True)):
        label = None if many else f"{style.drawable(one.name, 30)}, {metres_per_second(pgv)}"
        colour, width = (style.GREY, 0.3) if many else (_COLOURS[place], 0.9)
        for panel, values in zip(axes, every[place], strict=True):
            style.draw_line(panel, one.periods, values, colour, width, label=label)
    labels = ("$S_d$ [mm]", "$S_a$ [m/s²]", "$V_E$ [m/s]")
    for place, (panel, label) in enumerate(zip(axes, labels, strict=True)):
        if many and all(np.array_equal(one.periods, spectra[0].periods) for one in spectra):
            mean = np.exp(np.log(np.maximum([one[place] for one in every], 1e-12)).mean(axis=0))
            words = f"geometric mean of {len(spectra)}"
            style.draw_line(panel, spectra[0].periods, mean, style.BLUE, 1.4, label=words)
        panel.set(xscale="log", xlabel="$T$ [s]", ylabel=label, ylim=(0.0, None))
        panel.set_xticks(_TICKS, [f"{tick:g}" for tick in _TICKS])
    style.legend_outside(axes[0], min(4, max(1 if many else len(spectra), 1)))
    return figure


def _values(one: "EnergySpectrum") -> "tuple[np.ndarray, ...]":
    omega = 2.0 * np.pi / one.periods
    return one.displacement, one.displacement * omega**2 / 1e3, np.sqrt(2.0 * one.relative) / 1e3


@style.styled
def plot_codes(comparisons: "Sequence[CodeComparison]") -> "Figure":
    """Draw for every demand the results in the displacement spectrum, and their displacements as bars, on a new figure.

    Left the spectrum at a damping of 5 % with effective period and displacement of every method that has both; right the displacements beside the
    analysis, a line. What is outside of the limits of its method is hollow, and hatched on the right.
    """
    figure = style.new_figure(_HEAD + _ROW * len(comparisons))
    axes: Any = figure.subplots(len(comparisons), 2, squeeze=False, width_ratios=(1.0, 1.15))
    for row, comparison in zip(axes, comparisons, strict=True):
        _draw_spectrum(row[0], comparison)
        _draw_bars(row[1], comparison)
    axes[-1][0].set_xlabel("$T$ [s]")
    axes[-1][1].set_xlabel("$D$ [mm]")
    return figure


def _draw_spectrum(axes: "Axes", comparison: "CodeComparison") -> None:
    demand = comparison.inputs.spectrum.acceleration(_PERIODS) * (_PERIODS / (2.0 * np.pi)) ** 2
    style.draw_line(axes, _PERIODS, demand, style.GREY, 1.0)
    for colour, said in zip(cycle(_COLOURS_OF_METHODS), comparison.results.values(), strict=False):
        if said.period is not None:
            face = "white" if said.valid is False else colour
            style.draw_marks(axes, said.period, said.displacement, "o", 4.0, colour, markerfacecolor=face)
    axes.set(ylabel="$S_d$ [mm]", ylim=(0.0, None), xlim=(0.0, float(_PERIODS[-1])))
    pgv = "" if comparison.pgv is None else f",  PGV {metres_per_second(comparison.pgv)}"
    axes.set_title(f"{style.drawable(comparison.name)}{pgv}", loc="left", weight="bold", parse_math=False)


def _draw_bars(axes: "Axes", comparison: "CodeComparison") -> None:
    bar: dict[str, Any] = {"height": 0.6, "linewidth": 1.0}
    beside: dict[str, Any] = {"textcoords": "offset points", "va": "center", "size": 6.5}
    # where the line of the analysis passes behind the words
    box = {"facecolor": "white", "edgecolor": "none", "pad": 0.5}
    results, analysed = comparison.results, comparison.displacement
    for place, (colour, said) in enumerate(zip(cycle(_COLOURS_OF_METHODS), results.values(), strict=False)):
        face, hatch = ("white", "////") if said.valid is False else (colour, None)
        axes.barh(place, said.displacement, color=face, edgecolor=colour, hatch=hatch, **bar)
        words, end = millimetres(said.displacement), (said.displacement, place)
        axes.annotate(words, end, (4.0, 0.0), **beside).set_bbox(box)
    title = "hollow: outside of its limits"
    if analysed is not None:
        axes.axvline(analysed, color=style.INK, linewidth=1.0, linestyle=(0, (4, 2)))
        title = f"analysis {millimetres(analysed)}; {title}"
    axes.set_title(title, loc="left")
    axes.set_yticks(range(len(results)), list(results))
    axes.invert_yaxis()
    axes.set_xlim(0.0, 1.25 * max([said.displacement for said in results.values()] + [analysed or 0.0, 1.0]))
