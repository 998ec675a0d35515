"""One virtual test on one sheet; the loops of several tests beside each other, after Figures 6 and 8 of Li et al. (2020)."""

import math
from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from dcfp.present.figures.histories import plot_displacement, plot_friction, plot_temperature
from dcfp.present.figures.loop import (
    ColourQuantity,
    colour_quantity,
    colour_range,
    draw_cross,
    plot_loop,
    plot_profile,
)
from dcfp.present.figures.style import (
    BLUE,
    GREY,
    OCHRE,
    PAGE_WIDTH,
    RED,
    calm_ticks,
    drawable,
    finish_colour_bar,
    number,
    style,
    time_colours,
    warm_colours,
)
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.analysis.rig import Loops, Measurement, Program


_ROW_HEIGHT = 1.05
_KILO, _MEGA = 1e3, 1e6


def plot_test(loops: "Loops", measured: "Measurement | None" = None) -> Figure:
    """Compose the loops and the histories of one test, with the measures of its first and last cycle, on a new figure.

    Parameters
    ----------
    loops
        The test.
    measured
        What was measured in reality, drawn in grey below it.
    """
    drawn: list[Callable[[Loops, Axes], Axes]] = [plot_displacement, plot_temperature, plot_friction]
    with style():
        shows = colour_quantity(loops)
        norm = colour_range(loops, shows)
        if loops.profiles is not None:
            shared = norm if shows == "temperature" else None
            drawn.append(lambda test, axes: plot_profile(test, axes, norm=shared, colour_bar=False))
        height = _ROW_HEIGHT * max(len(drawn), 3)
        figure = Figure(figsize=(PAGE_WIDTH, height + 0.6), layout="constrained")
        halves: Any = figure.subfigures(2, 1, height_ratios=[0.5, height], hspace=0.0)
        sides: Any = halves[1].subfigures(1, 2, width_ratios=[1.0, 1.1], wspace=0.02)
        _write_head(halves[0], loops)
        left = sides[0].subplots()
        if measured is not None:
            draw_measured(left, measured)
        plot_loop(loops, left, colour=shows, norm=norm)
        if measured is not None:
            _make_room(left, measured)
            left.legend(handles=[Line2D([], [], color=GREY, label="measured")], loc="upper left")
        panels: Any = sides[1].subplots(len(drawn), 1, sharex=True)
        for draw, axes in zip(drawn, panels, strict=True):
            draw(loops, axes)
        for axes in panels[:-1]:
            axes.set_xlabel("")
            axes.tick_params(labelbottom=False)
        sides[1].align_ylabels(list(panels))
    return figure


def draw_measured(axes: "Axes", measured: "Measurement") -> None:
    """Draw measured loops in grey."""
    axes.plot(
        quantity("displacement").display(measured.displacement),
        quantity("force").display(measured.force),
        color=GREY,
        linewidth=0.7,
        zorder=1,
        label="measured",
    )


def _make_room(axes: "Axes", measured: "Measurement") -> None:
    for values, name, limits, set_limits in (
        (measured.displacement, "displacement", axes.get_xlim(), axes.set_xlim),
        (measured.force, "force", axes.get_ylim(), axes.set_ylim),
    ):
        largest = max(limits[1], 1.08 * float(abs(quantity(name).display(values)).max()))
        set_limits(-largest, largest)


def _write_head(head: Any, loops: "Loops") -> None:
    test, bearing = loops.test, loops.bearing
    words = f"{drawable(test.name)},  {test.waveform.kind}"
    title = head.text(0.012, 0.68, words, size=10, weight="bold", va="center")
    title.set_parse_math(False)
    model = (
        f"{drawable(bearing.name)};  friction {loops.friction_law.name}, reference {loops.friction_law.reference:.3g};"
        f"  heating {loops.heating.name}"
    )
    right = head.text(0.988, 0.68, model, ha="right", va="center", color="#555555")
    right.set_parse_math(False)
    first, last = loops.cycles[0], loops.cycles[-1]
    pairs = [
        (
            r"$k_{\mathrm{eff}}$",
            first.effective_stiffness / _KILO,
            last.effective_stiffness / _KILO,
            2,
            "kN/mm",
        ),
        (r"$\beta_{\mathrm{eff}}$", first.effective_damping, last.effective_damping, 3, ""),
        (r"$E$", first.energy / _MEGA, last.energy / _MEGA, 0, "kN m"),
        (r"$T_{\mathrm{max}}$", first.peak_temperature, last.peak_temperature, 0, "°C"),
    ]
    cycles = f"cycle 1 → {last.number}:   " if last.number > 1 else "cycle 1:   "
    numbers = ",   ".join(
        f"{symbol} {number(one, decimals)}"
        + (f" → {number(other, decimals)}" if last.number > 1 else "")
        + f" {unit}".rstrip()
        for symbol, one, other, decimals, unit in pairs
    )
    head.text(0.012, 0.18, cycles + numbers, va="center")


# The loops of several tests beside each other, after Figures 6 and 8 of Li et al. (2020).


_MOST_COLUMNS = 4
#: Names beyond the first go above pressure and speed, so that they stay clear of the next panel; beyond the second they are cut.
_SHORT_NAME, _LONGEST_NAME = 6, 24
#: Colour and line of each model, in their order.
LINES: "tuple[tuple[str, Any], ...]" = ((BLUE, "-"), (OCHRE, (0, (4, 1.5))), (RED, (0, (1.2, 1.2))))


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
    columns = min(_MOST_COLUMNS, math.ceil(math.sqrt(len(tests))))
    rows = math.ceil(len(tests) / columns)
    panel = (PAGE_WIDTH - 0.6) / max(columns, 2)
    with style():
        figure = Figure(
            figsize=(min(PAGE_WIDTH, panel * columns + 0.9), 0.55 + rows * (0.8 * panel + 0.22)),
            layout="constrained",
        )
        axes: Any = figure.subplots(rows, columns, squeeze=False)
        panels: list[Axes] = list(axes.flat)
        several = len(runs) > 1
        first = next(iter(runs.values()))
        shows: ColourQuantity = (
            "temperature" if any(colour_quantity(test) == "temperature" for test in first) else "time"
        )
        norm = _shared_range(first, shows)
        for one, test in zip(panels, tests, strict=False):
            if test[0].test.name in measured:
                draw_measured(one, measured[test[0].test.name])
            if several:
                draw_first_cycles(one, test)
            else:
                plot_loop(test[0], one, colour=shows, norm=norm, colour_bar=False, thin=0.7)
            name_panel(one, test[0])
        for one in panels[len(tests) :]:
            one.set_axis_off()
        _finish(figure, program, runs, measured, axes, norm, shows)
    return figure


def draw_first_cycles(axes: "Axes", tests: "Sequence[Loops]") -> None:
    """Draw the first cycle of a test with every model."""
    for test, (colour, line) in zip(tests, cycle(LINES), strict=False):
        part = test.time <= test.cycle_times[min(1, test.cycle_times.size - 1)] * (1.0 + 1e-9)
        axes.plot(
            quantity("displacement").display(test.displacement[part]),
            quantity("force").display(test.force[part]),
            color=colour,
            linestyle=line,
            linewidth=0.9,
        )
    draw_cross(axes)


def name_panel(axes: "Axes", test: "Loops") -> None:
    """Write what a panel shows above it."""
    pressure = float(np.mean(test.load)) / test.bearing.slider_area
    name = drawable(test.test.name)
    name = name if len(name) <= _LONGEST_NAME else f"{name[: _LONGEST_NAME - 1]}…"
    gap = " " if len(name) <= _SHORT_NAME else "\n"
    words = f"{name}:{gap}{pressure:.0f} N/mm², {test.test.waveform.peak_velocity:.0f} mm/s"
    axes.set_title(words, loc="left", parse_math=False, size=6.2)
    calm_ticks(axes, 3, 5)
    axes.set_xlabel("")
    axes.set_ylabel("")


def model_handles(names: "Sequence[str]", *, with_measured: bool) -> list[Line2D]:
    """Return the lines of a legend of models."""
    handles = [
        Line2D([], [], color=colour, linestyle=line, label=name)
        for name, (colour, line) in zip(names, cycle(LINES), strict=False)
    ]
    return [*handles, Line2D([], [], color=GREY, label="measured")] if with_measured else handles


def _shared_range(loops: "Sequence[Loops]", shows: ColourQuantity) -> Normalize:
    ranges = [colour_range(test, shows) for test in loops]
    return Normalize(min(float(r.vmin or 0.0) for r in ranges), max(float(r.vmax or 0.0) for r in ranges))


def _finish(
    figure: Figure,
    program: "Program",
    runs: "Mapping[str, Sequence[Loops]]",
    measured: "Mapping[str, Measurement]",
    axes: Any,
    norm: Normalize,
    shows: ColourQuantity,
) -> None:
    figure.supxlabel(quantity("displacement").label, fontsize=8)
    figure.supylabel(quantity("force").label, fontsize=8)
    first = next(iter(runs.values()))[0]
    title = f"{drawable(program.name)},  {drawable(first.bearing.name)}"
    if len(runs) > 1:
        figure.suptitle(f"{title}:  first cycles", fontsize=8.5, x=0.01, ha="left", parse_math=False)
        figure.legend(
            handles=model_handles(list(runs), with_measured=bool(measured)),
            loc="upper right",
            ncols=4,
            frameon=False,
        )
        return
    figure.suptitle(
        f"{title},  {first.friction_law.name},  {first.heating.name} heating",
        fontsize=8.5,
        x=0.01,
        ha="left",
        parse_math=False,
    )
    colours = warm_colours() if shows == "temperature" else time_colours()
    bar: Any = figure.colorbar(ScalarMappable(norm, colours), ax=axes, pad=0.015, aspect=40, fraction=0.03)
    finish_colour_bar(bar, quantity(shows).label)
