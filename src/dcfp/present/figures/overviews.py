"""Loops of several analyses or tests beside each other."""

import math
import textwrap
from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from dcfp.present.figures import style
from dcfp.present.figures.drawing import colour_shows, colours_of, draw_cross, plot_loop
from dcfp.present.figures.sheets import draw_measured
from dcfp.present.panels import colour_ends
from dcfp.schema.formulas import metres_per_second, millimetres, typeset
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.analysis import Response
    from dcfp.analysis.rig import Loops, Measurement, Program

#: Most panels in a row of analyses, when they follow each other and when each is a PGV, and of tests.
_COLUMNS, _TABLE_COLUMNS, _TEST_COLUMNS = 5, 7, 4
#: Characters of a title in the width of the page.
_TITLE_WIDTH = 92
#: Height of two lines of numbers [in].
_NUMBERS_HEIGHT = 0.36
#: Names of tests beyond the first go above pressure and speed, so that they stay clear of the next panel; beyond the second they are cut.
_SHORT_NAME, _LONGEST_NAME = 6, 24
#: Colour and line of each model, in their order.
LINES: "tuple[tuple[str, Any], ...]" = (
    (style.BLUE, "-"),
    (style.OCHRE, (0, (4, 1.5))),
    (style.RED, (0, (1.2, 1.2))),
)


def _shared_range(histories: "Sequence[Response | Loops]") -> tuple[str, Normalize]:
    """Return what the colours of loops show, and the range that they share."""
    shows = colour_shows(list(histories))
    ends = [colour_ends(one, shows) for one in histories]
    return shows, Normalize(min(low for low, _ in ends), max(high for _, high in ends))


def _draw_loop(axes: "Axes", history: "Response | Loops", shows: str, norm: Normalize) -> None:
    plot_loop(history, axes, colour=shows, norm=norm, colour_bar=False, thin=0.7)
    axes.set(xlabel="", ylabel="")


def _name_axes(figure: Figure) -> None:
    figure.supxlabel(quantity("displacement").label, fontsize=8)
    figure.supylabel(quantity("force").label, fontsize=8)


def _add_scale(figure: Figure, axes: Any, shows: str, norm: Normalize, aspect: float) -> None:
    drawn = ScalarMappable(norm, colours_of(shows))
    bar: Any = figure.colorbar(drawn, ax=axes, pad=0.015, aspect=aspect, fraction=0.03)
    style.finish_colour_bar(bar, quantity(shows).label)


@style.styled
def plot_overview(responses: "Sequence[Response]") -> Figure:
    """Draw the loops of several analyses to the same scales, on a new figure.

    Records are rows and PGVs columns where every record was analysed at the same PGVs; otherwise the panels
    follow each other, each with its own title.
    """
    grid = _grid(responses)
    columns = len(grid[0])
    panel = (style.PAGE_WIDTH - 0.9) / max(columns, 3)
    figure = style.new_figure(
        0.62 + len(grid) * (0.85 * panel + 0.1), min(style.PAGE_WIDTH, panel * columns + 0.9)
    )
    axes = figure.subplots(len(grid), columns, squeeze=False)
    shows, norm = _shared_range(responses)
    for panels, row in zip(axes, grid, strict=True):
        for one, response in zip(panels, row, strict=True):
            if response is None:
                one.set_axis_off()
            else:
                _draw_loop(one, response, shows, norm)
                _write_numbers(one, response)
    _name_panels(axes, grid)
    _share_limits(axes, responses)
    _add_scale(figure, axes, shows, norm, 18 * len(axes))
    _name_axes(figure)
    return figure


def _grid(responses: "Sequence[Response]") -> "list[list[Response | None]]":
    """Return rows of analyses: one row for each record if all have the same PGVs, else rows of a few."""
    records: dict[str, list[Response]] = {}
    for response in responses:
        records.setdefault(response.motion.name, []).append(response)
    velocities = [
        [metres_per_second(response.motion.peak_velocity) for response in row] for row in records.values()
    ]
    if all(row == velocities[0] for row in velocities) and 1 < len(velocities[0]) <= _TABLE_COLUMNS:
        return [list(row) for row in records.values()]
    columns = min(_COLUMNS, math.ceil(math.sqrt(len(responses))))
    filled: list[Response | None] = [*responses, *([None] * (-len(responses) % columns))]
    return [filled[first : first + columns] for first in range(0, len(filled), columns)]


def _write_numbers(axes: "Axes", response: "Response") -> None:
    words = f"{millimetres(response.peak_displacement)}\n{typeset(response.peak_temperature)} °C"
    beyond = response.status.value == "beyond capacity"
    box = {"boxstyle": "square,pad=0.05", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}
    axes.text(
        0.03,
        0.98,
        words,
        transform=axes.transAxes,
        va="top",
        color=style.RED if beyond else style.INK,
        bbox=box,
    )


def _name_panels(axes: "np.ndarray", grid: "list[list[Response | None]]") -> None:
    of_one = (len({r.motion.name if r else "" for r in row}) == 1 for row in grid)
    table = all(of_one) and len(grid[0]) > 1
    width = _TITLE_WIDTH // max(len(grid[0]), 3)
    for row, (panels, responses) in enumerate(zip(axes, grid, strict=True)):
        for one, response in zip(panels, responses, strict=True):
            if response is None:
                continue
            name = style.drawable(response.motion.name)
            if not table:
                one.set_title(_folded(f"{name}, ", response, width), parse_math=False)
            elif row == 0:
                one.set_title(_folded("PGV ", response, width))
            if table and one is panels[0]:
                one.set_ylabel(textwrap.fill(name, 16), weight="bold", parse_math=False)


def _folded(words: str, response: "Response", width: int) -> str:
    """Return words and a PGV in lines of at most `width` characters, the number and its unit together."""
    velocity = metres_per_second(response.motion.peak_velocity).replace(" ", "\u00a0")
    return textwrap.fill(words + velocity, width).replace("\u00a0", " ")


def _share_limits(axes: "np.ndarray", responses: "Sequence[Response]") -> None:
    """Give all panels the same limits, and only the outer ones numbers."""
    reach = 1.06 * max(max(response.peak_displacement for response in responses), 1e-6)
    height = 1.1 * quantity("force").display(max(max(response.peak_force for response in responses), 1e-3))
    columns = axes.shape[1]
    # in small panels the two lines of numbers need a band of their own above the loop
    band = 0.0 if columns <= _COLUMNS else min(0.5, _NUMBERS_HEIGHT * columns / style.PAGE_WIDTH)
    capacity = responses[0].bearing.displacement_capacity
    shown = np.array([[one.axison for one in row] for row in axes])
    for (row, column), one in np.ndenumerate(axes):
        one.set(xlim=(-reach, reach), ylim=(-height, height * (1.0 + band) / (1.0 - band)))
        style.calm_ticks(one, 4 if columns <= _COLUMNS else 2, 5)
        lowest = row + 1 == len(axes) or not shown[row + 1, column]
        one.tick_params(labelbottom=bool(lowest), labelleft=column == 0)
        if capacity is not None and capacity < reach and one.axison:
            for side in (-capacity, capacity):
                one.axvline(side, color=style.RED, linewidth=0.5, linestyle=style.DASHED, zorder=0)


# The loops of several tests, after Figures 6 and 8 of Li et al. (2020).


@style.styled
def plot_tests(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> Figure:
    """Draw a panel for each test on a new figure: all loops in colours, or of several models the first cycle in lines.

    Parameters
    ----------
    program
        What was run.
    runs
        Its tests by the name of the model.
    measured
        Measured tests by the name of the test that they belong to.
    """
    tests = list(zip(*runs.values(), strict=True))
    columns = min(_TEST_COLUMNS, math.ceil(math.sqrt(len(tests))))
    rows = math.ceil(len(tests) / columns)
    panel = (style.PAGE_WIDTH - 0.6) / max(columns, 2)
    first = next(iter(runs.values()))
    shows, norm = _shared_range(first)
    figure = style.new_figure(
        0.55 + rows * (0.8 * panel + 0.22), min(style.PAGE_WIDTH, panel * columns + 0.9)
    )
    axes: Any = figure.subplots(rows, columns, squeeze=False)
    for one, test in zip(axes.flat, tests, strict=False):
        if test[0].test.name in measured:
            draw_measured(one, measured[test[0].test.name])
        if len(runs) > 1:
            _draw_first_cycles(one, test)
        else:
            _draw_loop(one, test[0], shows, norm)
        _name_panel(one, test[0])
    for one in axes.flat[len(tests) :]:
        one.set_axis_off()
    _name_axes(figure)
    title = f"{style.drawable(program.name)},  {style.drawable(first[0].bearing.name)}"
    if len(runs) > 1:
        title += ":  first cycles"
        name_models(figure, list(runs), with_measured=bool(measured))
    else:
        title += f",  {first[0].friction_law.name},  {first[0].heating.name} heating"
        _add_scale(figure, axes, shows, norm, 40)
    style.write_title(figure, title)
    return figure


def _draw_first_cycles(axes: "Axes", tests: "Sequence[Loops]") -> None:
    """Draw the first cycle of a test with every model."""
    for test, look in zip(tests, cycle(LINES), strict=False):
        part = test.time <= test.cycle_times[min(1, test.cycle_times.size - 1)] * (1.0 + 1e-9)
        draw_model(axes, test, look, part, 0.9)
    draw_cross(axes)


def draw_model(axes: "Axes", test: "Loops", look: "tuple[str, Any]", part: Any, width: float) -> None:
    """Draw a part of the loop of a test in the look of its model."""
    path = (quantity(name).display(getattr(test, name)[part]) for name in ("displacement", "force"))
    axes.plot(*path, color=look[0], linestyle=look[1], linewidth=width)


def _name_panel(axes: "Axes", test: "Loops") -> None:
    """Write what a panel shows above it."""
    pressure = float(np.mean(test.load)) / test.bearing.slider_area
    name = style.drawable(test.test.name)
    name = name if len(name) <= _LONGEST_NAME else f"{name[: _LONGEST_NAME - 1]}…"
    gap = " " if len(name) <= _SHORT_NAME else "\n"
    words = f"{name}:{gap}{pressure:.0f} N/mm², {test.test.waveform.peak_velocity:.0f} mm/s"
    axes.set_title(words, loc="left", parse_math=False, size=6.2)
    style.label_axes(axes, "", "", 3, 5)


def name_models(figure: Figure, names: "Sequence[str]", *, with_measured: bool) -> None:
    """Write a legend of models above the panels."""
    handles = [
        Line2D([], [], color=colour, linestyle=line, label=name)
        for name, (colour, line) in zip(names, cycle(LINES), strict=False)
    ]
    handles += [Line2D([], [], color=style.GREY, label="measured")] if with_measured else []
    figure.legend(handles=handles, loc="upper right", ncols=4, frameon=False)
