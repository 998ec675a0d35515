"""Several analyses or tests beside each other: their loops, and what friction depends on, after Figures 3, 4 and 6 to 8 of Li et al. (2020)."""

import math
import textwrap
from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from dcfp.errors import InputError
from dcfp.present.figures import style
from dcfp.present.figures.drawing import (
    colour_shows,
    draw_cross,
    draw_measured,
    plot_loop,
    plot_test,
)
from dcfp.present.panels import colour_ends
from dcfp.schema.formulas import metres_per_second, millimetres, typeset
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.analysis import Response
    from dcfp.analysis.rig import Loops, Measurement, Program
    from dcfp.arrays import FloatArray

#: Most panels in a row of analyses, when they follow each other and when each is a PGV, and of tests.
_COLUMNS, _TABLE_COLUMNS, _TEST_COLUMNS = 5, 7, 4
#: Characters of a title in the width of the page.
_TITLE_WIDTH = 92
#: Height of two lines of numbers [in].
_NUMBERS_HEIGHT = 0.36
#: Names of tests beyond the first go above pressure and speed, so that they stay clear of the next panel; beyond the second they are cut.
_SHORT_NAME, _LONGEST_NAME = 6, 24
#: Colour and line of each model, in their order.
_LINES: "tuple[tuple[str, Any], ...]" = (
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


def _name_axes(figure: "Figure") -> None:
    figure.supxlabel(quantity("displacement").label, fontsize=8)
    figure.supylabel(quantity("force").label, fontsize=8)


def _add_scale(figure: "Figure", axes: Any, shows: str, norm: Normalize, aspect: float) -> None:
    drawn = ScalarMappable(norm, style.colours_of(shows))
    bar: Any = figure.colorbar(drawn, ax=axes, pad=0.015, aspect=aspect, fraction=0.03)
    style.finish_colour_bar(bar, quantity(shows).label)


@style.styled
def plot_overview(responses: "Sequence[Response]") -> "Figure":
    """Draw the loops of several analyses to the same scales, on a new figure.

    Records are rows and PGVs columns where every record was analysed at the same PGVs; otherwise the panels
    follow each other, each with its own title.
    """
    grid = _grid(responses)
    columns = len(grid[0])
    panel = (style.PAGE_WIDTH - 0.9) / max(columns, 3)
    height = 0.62 + len(grid) * (0.85 * panel + 0.1)
    figure = style.new_figure(height, min(style.PAGE_WIDTH, panel * columns + 0.9))
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
    rows = [[metres_per_second(one.motion.peak_velocity) for one in row] for row in records.values()]
    if all(row == rows[0] for row in rows) and 1 < len(rows[0]) <= _TABLE_COLUMNS:
        return [list(row) for row in records.values()]
    columns = min(_COLUMNS, math.ceil(math.sqrt(len(responses))))
    filled: list[Response | None] = [*responses, *([None] * (-len(responses) % columns))]
    return [filled[first : first + columns] for first in range(0, len(filled), columns)]


def _write_numbers(axes: "Axes", response: "Response") -> None:
    words = f"{millimetres(response.peak_displacement)}\n{typeset(response.peak_temperature)} °C"
    colour = style.RED if response.status.value == "beyond capacity" else style.INK
    box = {"boxstyle": "square,pad=0.05", "facecolor": "white", "edgecolor": "none", "alpha": 0.85}
    axes.text(0.03, 0.98, words, transform=axes.transAxes, va="top", color=colour, bbox=box)


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


def plot_program(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> "Figure":
    """Draw what fits a program of tests, on a new figure: a sheet of its one test, its dependencies, or the loops of all.

    Parameters
    ----------
    program
        What was run.
    runs
        Its tests by the name of the model.
    measured
        Measured tests by the name of the test that they belong to.
    """
    first = next(iter(runs.values()))
    if len(runs) == 1 and len(first) == 1:
        return plot_test(first[0], measured.get(first[0].test.name))
    plot = plot_tests if _dependency_tests(program) is None else plot_dependency
    return plot(program, runs, measured)


@style.styled
def plot_tests(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> "Figure":
    """Draw a panel for each test on a new figure: all loops in colours, or of several models the first cycle in lines.

    Parameters
    ----------
    program, runs, measured
        As for `plot_program`.
    """
    tests = list(zip(*runs.values(), strict=True))
    columns = min(_TEST_COLUMNS, math.ceil(math.sqrt(len(tests))))
    rows = math.ceil(len(tests) / columns)
    panel = (style.PAGE_WIDTH - 0.6) / max(columns, 2)
    first = next(iter(runs.values()))
    shows, norm = _shared_range(first)
    height = 0.55 + rows * (0.8 * panel + 0.22)
    figure = style.new_figure(height, min(style.PAGE_WIDTH, panel * columns + 0.9))
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
    if len(runs) > 1:
        _name_models(figure, program, runs, measured, ":  first cycles")
    else:
        words = f",  {first[0].friction_law.name},  {first[0].heating.name} heating"
        style.write_title(figure, _title(program, first) + words)
        _add_scale(figure, axes, shows, norm, 40)
    return figure


def _title(program: "Program", tests: "Sequence[Loops]") -> str:
    return f"{style.drawable(program.name)},  {style.drawable(tests[0].bearing.name)}"


def _draw_first_cycles(axes: "Axes", tests: "Sequence[Loops]") -> None:
    for test, look in zip(tests, cycle(_LINES), strict=False):
        part = test.time <= test.cycle_times[min(1, test.cycle_times.size - 1)] * (1.0 + 1e-9)
        _draw_model(axes, test, look, part, 0.9)
    draw_cross(axes)


def _draw_model(axes: "Axes", test: "Loops", look: "tuple[str, Any]", part: Any, width: float) -> None:
    path = (quantity(name).display(getattr(test, name)[part]) for name in ("displacement", "force"))
    axes.plot(*path, color=look[0], linestyle=look[1], linewidth=width)


def _name_panel(axes: "Axes", test: "Loops") -> None:
    pressure = float(np.mean(test.load)) / test.bearing.slider_area
    name = style.drawable(test.test.name, _LONGEST_NAME)
    gap = " " if len(name) <= _SHORT_NAME else "\n"
    words = f"{name}:{gap}{pressure:.0f} N/mm², {test.test.waveform.peak_velocity:.0f} mm/s"
    axes.set_title(words, loc="left", parse_math=False, size=6.2)
    style.label_axes(axes, "", "", 3, 5)


def _name_models(
    figure: "Figure",
    program: "Program",
    runs: "Mapping[str, Sequence[Loops]]",
    measured: "Mapping[str, Measurement]",
    words: str,
) -> None:
    """Write a title with these words at its end, and a legend of the models, above the panels."""
    looks: dict[str, Any] = dict(zip(runs, cycle(_LINES), strict=False))
    looks |= {"measured": (style.GREY, "-")} if measured else {}
    handles = [Line2D([], [], color=look[0], linestyle=look[1], label=name) for name, look in looks.items()]
    figure.legend(handles=handles, loc="upper right", ncols=4, frameon=False)
    style.write_title(figure, _title(program, next(iter(runs.values()))) + words)


def _dependency_tests(program: "Program") -> tuple[int, list[int]] | None:
    """Return the places of the test for the velocity and of those for the pressure; None where either is missing."""
    fast, slow = (
        [i for i, test in enumerate(program.tests) if test.purpose == f"{what} dependency"]
        for what in ("velocity", "pressure")
    )
    return (fast[0], slow) if fast and len(slow) > 1 else None


@style.styled
def plot_dependency(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> "Figure":
    """Draw the factors of pressure and velocity, the friction at zero displacement over time, and the loops of the fast test.

    Parameters
    ----------
    program
        With tests for ``velocity dependency`` and ``pressure dependency``.
    runs
        Its tests by the name of the model.
    measured
        Measured tests by the name of the test that they belong to.

    Raises
    ------
    InputError
        If the program has no tests for ``velocity dependency`` and ``pressure dependency``.
    """
    places = _dependency_tests(program)
    if places is None:
        msg = f"{program.name} has no tests for both 'velocity dependency' and 'pressure dependency'."
        raise InputError(msg)
    drawn = _Dependency(*places, runs, measured)
    figure = style.new_figure(5.4)
    axes: Any = figure.subplots(2, 2)
    drawn.pressure(axes[0, 0])
    drawn.velocity(axes[0, 1])
    drawn.friction(axes[1, 0])
    drawn.loops(axes[1, 1])
    _name_models(figure, program, runs, measured, f",  {drawn.law.name}")
    return figure


class _Dependency:
    """What the panels of the dependencies have in common; `fast` and `slow` are the places of the tests in the program."""

    def __init__(
        self,
        fast: int,
        slow: list[int],
        runs: "Mapping[str, Sequence[Loops]]",
        measured: "Mapping[str, Measurement]",
    ) -> None:
        self.fast, self.slow, self.runs, self.measured = fast, slow, runs, measured
        self.first = next(iter(runs.values()))
        self.law, self.name = self.first[0].friction_law, self.first[fast].test.name
        #: Histories of every model and of the measured tests, with their colours.
        self.all: list[tuple[Sequence[Loops | Measurement | None], str]] = [
            (loops, colour) for loops, (colour, _) in zip(runs.values(), cycle(_LINES), strict=False)
        ]
        if measured:
            self.all.append(([measured.get(test.test.name) for test in self.first], style.GREY))

    def pressure(self, axes: "Axes") -> None:
        """Draw the factor of the pressure."""
        pressures = [float(test.load.mean()) / test.bearing.slider_area for test in self.first]
        middle = sorted(self.slow, key=lambda i: pressures[i])[len(self.slow) // 2]
        sigma = np.linspace(0.5 * min(pressures), 1.25 * max(pressures), 200)
        curve = self.law.pressure_factor(sigma) / self.law.pressure_factor(pressures[middle])
        style.draw_line(axes, sigma, curve, style.INK, 1.0, label=r"$\gamma$ of the law")
        self._points(axes, pressures, self.slow, middle, 2)
        axes.set_ylim(0.0, 1.15 * float(curve.max()))
        label = rf"$\mu\,/\,\mu$ at {pressures[middle]:.0f} N/mm²"
        style.label_axes(axes, "pressure on the slider [N/mm²]", label, 6, 5)
        axes.set_title("(a) pressure: slow tests, reduced by their heat", loc="left")
        axes.legend(loc="lower left")

    def velocity(self, axes: "Axes") -> None:
        """Draw the factor of the velocity."""
        fast, law = self.fast, self.law
        speeds = [test.test.waveform.peak_velocity for test in self.first]
        share = min(self.first[0].bearing.shares) if law.speed_is_of_surface else 1.0
        speed = np.linspace(0.0, 1.1 * speeds[fast], 300)
        curve = law.velocity_factor(speed * share) / law.velocity_factor(speeds[fast] * share)
        style.draw_line(axes, speed, curve, style.INK, 1.0, label=r"$\alpha$ of the law")
        pressure = float(self.first[fast].load[0])
        same = [i for i in self.slow if abs(float(self.first[i].load[0]) / pressure - 1.0) < 0.01]
        self._points(axes, speeds, (fast, *same), fast, 1)
        label = rf"$\mu\,/\,\mu$ at {speeds[fast]:.0f} mm/s"
        style.label_axes(axes, "relative velocity [mm/s]", label, 6, 5, ylim=(0.0, 1.3))
        axes.set_title("(b) velocity: first cycle, reduced by its heat", loc="left")
        axes.legend(loc="lower right")

    def _points(
        self, axes: "Axes", at: "Sequence[float]", chosen: "Sequence[int]", reference: int, number: int
    ) -> None:
        """Draw the friction of chosen tests in a cycle over that of the reference test."""
        for histories, colour in self.all:
            base = histories[reference]
            for i in chosen if base is not None else ():
                one = histories[i]
                if one is not None:
                    ratio = _friction_in(one, number) / _friction_in(base, number)
                    style.draw_marks(axes, at[i], ratio, "o", 4, colour, alpha=0.85)

    def friction(self, axes: "Axes") -> None:
        """Draw the friction at zero displacement over time."""
        for histories, colour in self.all:
            fast = histories[self.fast]
            if fast is not None:
                crossings = fast.crossings
                friction = np.abs(crossings[:, 1]) / crossings[:, 2]
                style.draw_line(axes, crossings[:, 0], friction, colour, 0.7, marker="o", markersize=3.5)
        # late: the package of bearings imports the kernels
        from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

        axes.axhline(NOMINAL_COEFFICIENT, color=style.RED, linewidth=0.7, linestyle=style.DASHED)
        look: dict[str, Any] = {"color": style.RED, "ha": "right", "va": "bottom"}
        words = r"$\mu_n = 0.043$, tests of Li et al."
        axes.text(0.985, 1.08 * NOMINAL_COEFFICIENT, words, transform=axes.get_yaxis_transform(), **look)
        ends: dict[str, Any] = {"xlim": (0.0, None), "ylim": (0.0, 1.25 * self.law.reference)}
        style.label_axes(axes, quantity("time").label, r"$\mu$ at zero displacement", 6, 5, **ends)
        axes.set_title(f"(c) {self.name}: friction at zero displacement", loc="left")

    def loops(self, axes: "Axes") -> None:
        """Draw the loops of the fast test."""
        tests = [loops[self.fast] for loops in self.runs.values()]
        if self.name in self.measured:
            draw_measured(axes, self.measured[self.name])
        for test, look in zip(tests, cycle(_LINES), strict=False):
            _draw_model(axes, test, look, slice(None), 0.8)
        _mark_second_cycle(axes, tests[0])
        draw_cross(axes)
        style.label_axes(axes, quantity("displacement").label, quantity("force").label, 5, 5)
        axes.set_title(f"(d) {self.name}: loops, c and d in the second cycle", loc="left")


def _friction_in(history: Any, number: int) -> float:
    """Return the friction at zero displacement in a cycle, or in the last there is; where the temperature is known, as if it were cold."""
    place = min(number, len(history.cycles)) - 1
    friction, law = history.cycles[place].friction, getattr(history, "friction_law", None)
    if law is None:
        return friction
    first, last = history.cycle_times[place], history.cycle_times[place + 1]
    times: FloatArray = history.crossings[:, 0]
    inside = times[(times > 0.99 * first) & (times < first + 0.98 * (last - first))]
    heat = law.temperature_factor(np.interp(inside, history.time, history.temperature))
    return friction / float(np.asarray(heat).mean())


def _mark_second_cycle(axes: "Axes", test: "Loops") -> None:
    """Mark the points at zero displacement from which the nominal coefficient is taken."""
    if test.cycle_times.size < 3:
        return
    times, forces = test.crossings[:, 0], quantity("force").display(test.crossings[:, 1])
    first, last = test.cycle_times[1:3] - 1e-9 * test.time[-1]
    for height, letter in zip(forces[(times >= first) & (times < last)].tolist(), "cd", strict=False):
        style.draw_marks(axes, 0.0, height, "o", 4, style.INK, zorder=4)
        beside = (4, 4 if height > 0.0 else -9)
        axes.annotate(letter, (0.0, height), xytext=beside, textcoords="offset points", weight="bold")
