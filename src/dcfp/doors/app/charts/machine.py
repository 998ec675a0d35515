"""Friction by cycle of the tests, and their measures."""

from collections.abc import Sequence
from operator import attrgetter

import numpy as np

from dcfp.analysis.rig import Loops
from dcfp.doors.app.charts.look import BLUE, OCHRE, axis, legend, line, simple
from dcfp.doors.app.elements import Cell, Head, Options
from dcfp.doors.app.thinning import points
from dcfp.doors.app.units import Units
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import DEGC, KN_M, KN_PER_MM, MM, N_MM, N_PER_MM, NONE, PERCENT

#: Cycles that are drawn with a mark each.
_FEW = 40


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


#: What is told of a cycle.
_CYCLE = (
    Quantity("cycle", "number of the cycle", NONE, head="Cycle", decimals=0, get=attrgetter("number")),
    Quantity("largest", "largest displacement", MM, head="d+", decimals=1, get=attrgetter("largest")),
    Quantity("least", "least displacement", MM, head="d−", decimals=1, get=attrgetter("least")),
    Quantity("keff", "effective stiffness", N_PER_MM, KN_PER_MM, head="k_eff", decimals=3, get=attrgetter("effective_stiffness")),
    Quantity("beta", "effective damping", PERCENT, head="β_eff", decimals=1, get=attrgetter("effective_damping")),
    Quantity("k_d", "post-yield stiffness", N_PER_MM, KN_PER_MM, head="k_post", decimals=3, get=attrgetter("post_yield_stiffness")),
    Quantity("energy", "energy of the cycle", N_MM, KN_M, head="Energy", decimals=1, get=attrgetter("energy")),
    Quantity("mu_0", "coefficient at zero displacement", NONE, head="µ at zero", decimals=4, get=attrgetter("friction")),
    Quantity("mu", "coefficient of the loop", NONE, head="µ of loop", decimals=4, get=attrgetter("loop_friction")),
    Quantity("T_max", "highest temperature", DEGC, head="T_max", decimals=0, get=attrgetter("peak_temperature")),
)  # fmt: skip


def cycle_head(units: Units) -> list[Head]:
    """Return the heads of the table of measures."""
    return [Head("Test", number=False), *units.heads(_CYCLE)]


def cycle_rows(tests: Sequence[Loops], units: Units) -> list[list[Cell | str]]:
    """Return a row for each cycle of each test."""
    return [
        [test.test.name, *(units.text(one, cycle) for one in _CYCLE)]
        for test in tests
        for cycle in test.cycles
    ]
