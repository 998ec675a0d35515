"""Charts of the test machine: loops, and friction and temperature by cycle."""

from collections.abc import Sequence

import numpy as np

from dcfp.analysis.rig import Loops
from dcfp.analysis.rig.measures import Cycle
from dcfp.doors.app.charts.look import BLUE, GREEN, GREY, OCHRE, RED, axis, legend, line, simple
from dcfp.doors.app.elements import Cell, Head, Options
from dcfp.doors.app.thinning import kept, kept_of_path, points
from dcfp.doors.app.units import Units

_COLOURS = (BLUE, OCHRE, RED, GREEN, GREY)
#: Cycles that are drawn with a mark each.
_FEW = 40


def loops_chart(tests: Sequence[Loops], units: Units) -> Options:
    """Draw force against displacement of some tests."""
    series: list[Options] = []
    for number, test in enumerate(tests):
        y, force = units.length.of(test.displacement), units.force.of(test.force)
        place = kept_of_path(y, force)
        series.append(line(test.test.name, points(y[place], force[place]), _COLOURS[number % len(_COLOURS)]))
    return simple(
        axis(f"Displacement [{units.length.name}]", "x"),
        axis(f"Force [{units.force.name}]", "y"),
        series,
        tooltip={"show": False},
        legend=legend(show=len(tests) > 1),
        grid={"left": 58, "right": 20, "top": 34, "bottom": 42},
    )


def friction_chart(tests: Sequence[Loops]) -> Options:
    """Draw the coefficient at zero displacement and of the whole loop in each cycle, the tests one after another."""
    cycles = [cycle for test in tests for cycle in test.cycles]
    number = np.arange(1.0, len(cycles) + 1.0)
    at_zero = np.array([cycle.friction for cycle in cycles])
    whole = np.array([cycle.loop_friction for cycle in cycles])
    marks = {"showSymbol": len(cycles) <= _FEW, "symbol": "circle", "symbolSize": 6}
    return simple(
        axis("Cycle, all tests in order", "x", minInterval=1, min=0.5, max=len(cycles) + 0.5),
        axis("µ [–]", "y"),
        [
            line("at zero displacement", points(number, at_zero), BLUE, **marks),
            line("whole loop", points(number, whole), OCHRE, **marks),
        ],
        legend=legend(),
    )


def temperature_chart(tests: Sequence[Loops], units: Units) -> Options:
    """Draw the temperature of the contact over the time of each test."""
    series: list[Options] = []
    for number, test in enumerate(tests):
        hot = units.temperature.of(test.temperature)
        place = kept((hot,), 300)
        series.append(
            line(test.test.name, points(test.time[place], hot[place]), _COLOURS[number % len(_COLOURS)])
        )
    return simple(
        axis("Time in the test [s]", "x", scale=False),
        axis(f"Temperature [{units.temperature.name}]", "y"),
        series,
        legend=legend(show=len(tests) > 1, type="scroll", left=150),
    )


def cycle_head(units: Units) -> list[Head]:
    """Return the heads of the table of measures."""
    stiffness = f"{units.force.name}/{units.length.name}"
    return [
        Head("Test", number=False),
        Head("Cycle"),
        Head("d+", units.length.name),
        Head("d−", units.length.name),
        Head("k_eff", stiffness),
        Head("β_eff", "%"),
        Head("k_post", stiffness),
        Head("Energy", units.energy.name),
        Head("µ at zero", "–"),
        Head("µ of loop", "–"),
        Head("T_max", units.temperature.name),
    ]


def cycle_rows(tests: Sequence[Loops], units: Units) -> list[list[Cell | str]]:
    """Return a row for each cycle of each test."""
    return [[test.test.name, *_measures(cycle, units)] for test in tests for cycle in test.cycles]


def _measures(cycle: Cycle, units: Units) -> list[str]:
    stiffness = units.force.factor / units.length.factor
    energy = f"{cycle.energy * units.energy.factor:.1f}"
    return [
        f"{cycle.number}",
        units.length.text(cycle.largest),
        units.length.text(cycle.least),
        _known(cycle.effective_stiffness * stiffness, 3),
        _known(100.0 * cycle.effective_damping, 1),
        _known(cycle.post_yield_stiffness * stiffness, 3),
        energy,
        _known(cycle.friction, 4),
        _known(cycle.loop_friction, 4),
        units.temperature.text(cycle.peak_temperature),
    ]


def _known(value: float, decimals: int) -> str:
    return f"{value:.{decimals}f}" if np.isfinite(value) else "–"
