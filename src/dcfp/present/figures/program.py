"""The figure of a test program: a sheet of one test, the loops of many tests, or the dependencies of friction after Figures 3, 4 and 7 of Li et al. (2020)."""

from itertools import cycle
from typing import TYPE_CHECKING, Any, NamedTuple, TypeGuard

import numpy as np
from matplotlib.figure import Figure

from dcfp.errors import InputError
from dcfp.present.figures.drawing import draw_cross
from dcfp.present.figures.overviews import LINES, model_handles, plot_tests
from dcfp.present.figures.sheets import draw_measured, plot_test
from dcfp.present.figures.style import GREY, INK, PAGE_WIDTH, RED, calm_ticks, drawable, style
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.analysis.rig import Loops, Measurement, Program


def plot_program(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> "Figure":
    """Draw what fits the program, on a new figure.

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
    if dependency_tests(program) is not None:
        return plot_dependency(program, runs, measured)
    return plot_tests(program, runs, measured)


class DependencyTests(NamedTuple):
    """Places of the tests in a program that show what friction depends on."""

    velocity: int
    pressures: tuple[int, ...]


def dependency_tests(program: "Program") -> DependencyTests | None:
    """Return which tests of a program are for the velocity and which for the pressure; None where either is missing."""
    velocity = [i for i, test in enumerate(program.tests) if test.purpose == "velocity dependency"]
    pressures = [i for i, test in enumerate(program.tests) if test.purpose == "pressure dependency"]
    return DependencyTests(velocity[0], tuple(pressures)) if velocity and len(pressures) > 1 else None


def plot_dependency(
    program: "Program", runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]"
) -> Figure:
    """Draw the factors of pressure and velocity, the friction at zero displacement over time, and the loops of the fast test.

    Parameters
    ----------
    program
        With tests for ``velocity dependency`` and ``pressure dependency``.
    runs
        Its tests by the name of the model.
    measured
        Measured tests by the name of the test that they belong to.
    """
    places = dependency_tests(program)
    if places is None:
        msg = f"{program.name} has no tests for both 'velocity dependency' and 'pressure dependency'."
        raise InputError(msg)
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, 5.4), layout="constrained")
        axes: Any = figure.subplots(2, 2)
        _draw_pressure(axes[0, 0], places, runs, measured)
        _draw_velocity(axes[0, 1], places, runs, measured)
        _draw_friction(axes[1, 0], places, runs, measured)
        _draw_loops(axes[1, 1], places, runs, measured)
        first = next(iter(runs.values()))[0]
        figure.suptitle(
            f"{drawable(program.name)},  {drawable(first.bearing.name)},  {first.friction_law.name}",
            fontsize=8.5,
            x=0.01,
            ha="left",
            parse_math=False,
        )
        handles = model_handles(list(runs), with_measured=bool(measured))
        figure.legend(handles=handles, loc="upper right", ncols=4, frameon=False)
    return figure


def _friction_in(history: "Loops | Measurement", number: int) -> float:
    """Return the friction at zero displacement in a cycle, or in the last there is; where the temperature is known, as if it were cold."""
    place = min(number, len(history.cycles)) - 1
    friction = history.cycles[place].friction
    if not _is_loops(history):
        return friction
    first, last = history.cycle_times[place], history.cycle_times[place + 1]
    times = history.crossings[:, 0]
    inside = times[(times > 0.99 * first) & (times < first + 0.98 * (last - first))]
    heat = history.friction_law.temperature_factor(np.interp(inside, history.time, history.temperature))
    return friction / float(np.mean(heat))


def _is_loops(history: "Loops | Measurement") -> "TypeGuard[Loops]":
    return hasattr(history, "friction_law")


def _reduced(
    histories: "Sequence[Loops | Measurement | None]", reference: int, number: int
) -> list[tuple[int, float]]:
    """Return the place and the friction of each history over that of the reference."""
    base = histories[reference]
    if base is None:
        return []
    scale = _friction_in(base, number)
    return [(i, _friction_in(h, number) / scale) for i, h in enumerate(histories) if h is not None]


def _measured_in_order(
    program: "Sequence[Loops]", measured: "Mapping[str, Measurement]"
) -> "list[Measurement | None]":
    return [measured.get(test.test.name) for test in program]


def _draw_pressure(
    axes: "Axes",
    places: DependencyTests,
    runs: "Mapping[str, Sequence[Loops]]",
    measured: "Mapping[str, Measurement]",
) -> None:
    first = next(iter(runs.values()))
    pressures = [float(test.load.mean()) / test.bearing.slider_area for test in first]
    middle = sorted(places.pressures, key=lambda i: pressures[i])[len(places.pressures) // 2]
    law = first[0].friction_law
    sigma = np.linspace(0.5 * min(pressures), 1.25 * max(pressures), 200)
    curve = law.pressure_factor(sigma) / law.pressure_factor(pressures[middle])
    axes.plot(sigma, curve, color=INK, linewidth=1.0, label=r"$\gamma$ of the law")
    for histories, colour in _all(runs, measured, first):
        for i, ratio in _reduced(histories, middle, 2):
            if i in places.pressures:
                axes.plot(
                    pressures[i], ratio, marker="o", markersize=4, color=colour, linestyle="none", alpha=0.85
                )
    axes.set_xlabel("pressure on the slider [N/mm²]")
    axes.set_ylabel(rf"$\mu\,/\,\mu$ at {pressures[middle]:.0f} N/mm²")
    axes.set_title("(a) pressure: slow tests, reduced by their heat", loc="left")
    axes.set_ylim(0.0, 1.15 * float(curve.max()))
    axes.legend(loc="lower left")
    calm_ticks(axes, 6, 5)


def _draw_velocity(
    axes: "Axes",
    places: DependencyTests,
    runs: "Mapping[str, Sequence[Loops]]",
    measured: "Mapping[str, Measurement]",
) -> None:
    first = next(iter(runs.values()))
    law = first[0].friction_law
    fastest = first[places.velocity].test.waveform.peak_velocity
    share = min(first[0].bearing.shares) if law.speed_is_of_surface else 1.0
    speed = np.linspace(0.0, 1.1 * fastest, 300)
    curve = law.velocity_factor(speed * share) / law.velocity_factor(fastest * share)
    axes.plot(speed, curve, color=INK, linewidth=1.0, label=r"$\alpha$ of the law")
    pressure = float(first[places.velocity].load[0])
    same = [i for i in places.pressures if abs(float(first[i].load[0]) / pressure - 1.0) < 0.01]
    for histories, colour in _all(runs, measured, first):
        for i, ratio in _reduced(histories, places.velocity, 1):
            if i == places.velocity or i in same:
                at = first[i].test.waveform.peak_velocity
                axes.plot(at, ratio, marker="o", markersize=4, color=colour, linestyle="none", alpha=0.85)
    axes.set_xlabel("relative velocity [mm/s]")
    axes.set_ylabel(rf"$\mu\,/\,\mu$ at {fastest:.0f} mm/s")
    axes.set_title("(b) velocity: first cycle, reduced by its heat", loc="left")
    axes.set_ylim(0.0, 1.3)
    axes.legend(loc="lower right")
    calm_ticks(axes, 6, 5)


def _draw_friction(
    axes: "Axes",
    places: DependencyTests,
    runs: "Mapping[str, Sequence[Loops]]",
    measured: "Mapping[str, Measurement]",
) -> None:
    first = next(iter(runs.values()))
    for histories, colour in _all(runs, measured, first):
        fast = histories[places.velocity]
        if fast is not None:
            time, friction = _at_zero(fast)
            axes.plot(time, friction, marker="o", markersize=3.5, linewidth=0.7, color=colour)
    # late: the package of bearings imports the kernels
    from dcfp.system.friction.constant import NOMINAL_COEFFICIENT

    axes.axhline(NOMINAL_COEFFICIENT, color=RED, linewidth=0.7, linestyle=(0, (5, 3)))
    axes.text(0.985, 1.08 * NOMINAL_COEFFICIENT, r"$\mu_n = 0.043$, tests of Li et al.", color=RED, ha="right", va="bottom",
              transform=axes.get_yaxis_transform())  # fmt: skip
    axes.set_xlim(left=0.0)
    axes.set_ylim(0.0, 1.25 * first[0].friction_law.reference)
    axes.set_xlabel(quantity("time").label)
    axes.set_ylabel(r"$\mu$ at zero displacement")
    axes.set_title(f"(c) {first[places.velocity].test.name}: friction at zero displacement", loc="left")
    calm_ticks(axes, 6, 5)


def _at_zero(history: "Loops | Measurement") -> "tuple[np.ndarray, np.ndarray]":
    crossings = history.crossings
    return crossings[:, 0], np.abs(crossings[:, 1]) / crossings[:, 2]


def _draw_loops(
    axes: "Axes",
    places: DependencyTests,
    runs: "Mapping[str, Sequence[Loops]]",
    measured: "Mapping[str, Measurement]",
) -> None:
    tests = [loops[places.velocity] for loops in runs.values()]
    name = tests[0].test.name
    if name in measured:
        draw_measured(axes, measured[name])
    for test, (colour, line) in zip(tests, cycle(LINES), strict=False):
        shown = (test.displacement, test.force)
        axes.plot(
            *(quantity(n).display(v) for n, v in zip(("displacement", "force"), shown, strict=True)),
            color=colour,
            linestyle=line,
            linewidth=0.8,
        )
    _mark_second_cycle(axes, tests[0])
    draw_cross(axes)
    axes.set_xlabel(quantity("displacement").label)
    axes.set_ylabel(quantity("force").label)
    axes.set_title(f"(d) {name}: loops, c and d in the second cycle", loc="left")
    calm_ticks(axes, 5, 5)


def _mark_second_cycle(axes: "Axes", test: "Loops") -> None:
    """Mark the points at zero displacement from which the nominal coefficient is taken."""
    if test.cycle_times.size < 3:
        return
    crossings = test.crossings
    slack = 1e-9 * test.time[-1]
    inside = (crossings[:, 0] >= test.cycle_times[1] - slack) & (
        crossings[:, 0] < test.cycle_times[2] - slack
    )
    for (_, force, _), letter in zip(crossings[inside], "cd", strict=False):
        height = float(quantity("force").display(force))
        axes.plot(0.0, height, marker="o", markersize=4, color=INK, linestyle="none", zorder=4)
        axes.annotate(
            letter,
            (0.0, height),
            xytext=(4, 4 if height > 0.0 else -9),
            textcoords="offset points",
            weight="bold",
        )


def _all(
    runs: "Mapping[str, Sequence[Loops]]", measured: "Mapping[str, Measurement]", first: "Sequence[Loops]"
) -> "list[tuple[Sequence[Loops | Measurement | None], str]]":
    """Return the histories of every model and of the measured tests, with their colours."""
    found: list[tuple[Sequence[Loops | Measurement | None], str]] = [
        (loops, colour) for loops, (colour, _) in zip(runs.values(), cycle(LINES), strict=False)
    ]
    return [*found, (_measured_in_order(first, measured), GREY)] if measured else found
