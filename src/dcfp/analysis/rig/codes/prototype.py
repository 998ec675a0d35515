"""Prototype tests of codes: what they are made from, what a code wants of each, and the property factors that they show."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.measures import Cycle
from dcfp.analysis.rig.program import VerticalLoad
from dcfp.errors import InputError
from dcfp.schema.check import Check, Verdict
from dcfp.schema.checks import positive
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import NONE

#: Minimum of the total maximum displacement over the maximum displacement [-]: ASCE/SEI 7, section 17.5.3.5.
LEAST_TOTAL = 1.15


@dataclass(frozen=True)
class PrototypeDesign:
    """Design values of an isolation system.

    Parameters
    ----------
    displacement
        Maximum displacement: D_M of ASCE/SEI 7, d_bd of EN 15129 [mm].
    period
        Effective period at that displacement [s].
    pressure
        On the slider under the average load [N/mm2].
    total_displacement
        With torsion, D_TM [mm]; by default 1.15 times the displacement, the least that ASCE/SEI 7 allows.
    least_load, largest_load
        Smallest and largest vertical load over the average one [-]; by default those of Li et al. (2020), Table 2, T10 and T11.
    wind_displacement
        Amplitude of the wind cycles [mm]; by default that of Li et al. (2020), Table 2, T02.
    endurance_cycles
        Cycles at 0.75 D_M, at least 10: 30 S_M1 / (S_MS B_M); by default the 20 of Li et al. (2020), Table 2, T12.
    """

    displacement: float
    period: float
    pressure: float = 60.0
    total_displacement: float | None = None
    least_load: float = 0.5
    largest_load: float = 1.5
    wind_displacement: float = 10.0
    endurance_cycles: int = 20

    def __post_init__(self) -> None:
        positive(self.displacement, "design displacement", "mm")
        positive(self.period, "effective period", "s")
        positive(self.pressure, "pressure on the slider", "N/mm2")
        if self.total_displacement is not None:
            positive(self.total_displacement, "total displacement", "mm")
            if self.total_displacement < self.displacement:
                msg = f"The total displacement, {self.total_displacement:g} mm, must not be below the displacement, {self.displacement:g} mm."
                raise InputError(msg)
        positive(self.least_load, "smallest over the average load", "[-]")
        positive(self.largest_load, "largest over the average load", "[-]")
        positive(self.wind_displacement, "displacement of the wind cycles", "mm")
        positive(self.endurance_cycles, "number of cycles", "cycles")

    @property
    def total(self) -> float:
        """Total maximum displacement [mm]."""
        if self.total_displacement is None:
            return LEAST_TOTAL * self.displacement
        return self.total_displacement

    def load(self, factor: float = 1.0) -> VerticalLoad:
        """Return a constant load, as a factor of the average one [-]."""
        return VerticalLoad((factor * self.pressure,))


def criterion(
    code: str,
    clause: str,
    test: str,
    statement: str,
    value: float,
    limit: float,
    unit: str = "-",
    *,
    at_least: bool = False,
    confirmed: bool = False,
) -> Check:
    """Return whether a requirement of a code on a test holds: `value` must not exceed the limit, or where `at_least` not fall below it.

    What is not a finite number never does. A requirement that is not confirmed is from memory of the code.
    """
    met = math.isfinite(value) and (value >= limit if at_least else value <= limit)
    return Check(
        name=statement,
        verdict=Verdict.of(met),
        found=value,
        limit=limit,
        source=clause,
        confirmed=confirmed,
        of=code,
        subject=test,
        unit=unit,
        at_least=at_least,
    )


#: What is told of a requirement.
CRITERIA = [
    Quantity("code", "code that requires it", head="Code", get="of"),
    Quantity("clause", "where it stands", head="Clause", get="source"),
    Quantity("test", "name of the test", head="Test", get="subject"),
    Quantity("statement", "what must hold", head="What must hold", get="name"),
    Quantity("value", "what was found", NONE, decimals=3, head="Found\n", get="found"),
    Quantity("limit", "what is allowed", NONE, get="limit", printed=False),
    Quantity("Limit", "what is allowed", NONE, head="Limit\n", get=lambda one: f"{'≥' if one.at_least else '≤'} {one.limit:g}", stored=False),
    Quantity("unit", "unit of both", head="Unit", get="unit"),
    Quantity("at_least", "whether the limit is a lower one", get="at_least", printed=False),
    Quantity("confirmed", "whether it was read in the code", get="confirmed", printed=False),
    Quantity("passed", "whether it holds", get="passed", printed=False),
    Quantity("Result", "whether it holds", get=lambda one: ("ok" if one.passed else "NOT MET") + ("" if one.confirmed else " (unconfirmed limit)"), stored=False),
]  # fmt: skip


# Property modification factors that tests show: lambda_test of ASCE/SEI 7-16, section 17.2.8.4.
#
# A prototype test gives first-cycle properties that are higher than the three-cycle average, on which
# nominal design properties rest, and later ones that are lower, since the plates heat up. With a heated
# model both follow from the sequence of tests, before any is made:
#
# .. math:: \lambda_{test,max} = \frac{first\ cycle}{mean\ of\ three}, \qquad \lambda_{test,min} = \frac{last\ cycle}{mean\ of\ three}
#
# at the maximum displacement; the endurance test gives a lower one after many cycles. Which cycle counts as
# the last is *unconfirmed*, so both are given.


#: Cycles on which nominal properties rest.
NOMINAL_CYCLES = 3


@dataclass(frozen=True)
class PropertyFactor:
    """How much one property of the bearing changes in the tests.

    Attributes
    ----------
    name
        Of the property, in words.
    nominal
        Mean over the first three cycles at the maximum displacement, in `unit`.
    unit
        Its unit.
    upper
        lambda_test,max: the first of these cycles over the nominal value [-].
    lower
        lambda_test,min: the last of these cycles over the nominal value [-].
    first_over_third
        The first over the third of these cycles [-].
    enduring
        The last cycle of the endurance tests over their own first three's mean [-]; None where there are none.
    tests
        Names of the tests that it comes from.
    """

    name: str
    nominal: float
    unit: str
    upper: float
    lower: float
    first_over_third: float
    enduring: float | None
    tests: tuple[str, ...]


#: What is told of a factor.
FACTORS = [
    Quantity("name", "property", head="Property", get="name"),
    Quantity("nominal", "mean of the first three cycles", NONE, digits=4, head="nominal\n", get="nominal"),
    Quantity("unit", "unit of it", get="unit", printed=False),
    Quantity("upper", "first cycle over nominal", NONE, decimals=3, head="lambda_max\n", get="upper"),
    Quantity("lower", "last cycle over nominal", NONE, decimals=3, head="lambda_min\n", get="lower"),
    Quantity("first_over_third", "first over third cycle", NONE, decimals=3, head="1st/3rd\n", get="first_over_third"),
    Quantity("enduring", "last cycle of the endurance tests over nominal", NONE, decimals=3, head="after all\n", get="enduring"),
    Quantity("Unit", "unit of the nominal value", get="unit", stored=False),
    Quantity("tests", "tests that it comes from", get="tests", printed=False),
    Quantity("Tests", "tests that it comes from", get=lambda one: ", ".join(one.tests), stored=False),
]  # fmt: skip

_PROPERTIES: tuple[tuple[str, str, Callable[[Cycle], float]], ...] = (
    ("friction of the loop", "-", lambda cycle: cycle.loop_friction),
    ("effective stiffness", "kN/mm", lambda cycle: cycle.effective_stiffness / 1e3),
    ("effective damping", "-", lambda cycle: cycle.effective_damping),
    ("energy per cycle", "kN m", lambda cycle: cycle.energy / 1e6),
)


def property_factors(loops: Sequence[Loops]) -> list[PropertyFactor]:
    """Return the factors of the tests; an empty list where none has the role of the maximum with three cycles or more."""
    largest = [t for t in loops if t.test.role == "maximum" and len(t.cycles) >= NOMINAL_CYCLES]
    if not largest:
        return []
    first = largest[0]
    enduring = [t for t in loops if t.test.role == "endurance"]
    many = [cycle for test in enduring for cycle in test.cycles]
    names = (first.test.name, *(test.test.name for test in enduring))
    factors: list[PropertyFactor] = []
    for name, unit, of in _PROPERTIES:
        values = [of(cycle) for cycle in first.cycles[:NOMINAL_CYCLES]]
        nominal = sum(values) / len(values)
        late = None
        if len(many) > NOMINAL_CYCLES:
            early = many[:NOMINAL_CYCLES]
            late = of(many[-1]) * len(early) / sum(of(cycle) for cycle in early)
        factors.append(
            PropertyFactor(
                name=name,
                nominal=nominal,
                unit=unit,
                upper=values[0] / nominal,
                lower=values[-1] / nominal,
                first_over_third=values[0] / values[-1],
                enduring=late,
                tests=names,
            )
        )
    return factors
