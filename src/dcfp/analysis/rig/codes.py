"""Prototype tests that codes ask for, what the codes want of their results, and the property factors that they show.

ASCE/SEI 7-16, sections 17.8.2 and 17.8.4: order, displacements and cycles agree with the tests of Li et al. (2020), Table 2, which follow the same
standard; the limits of 17.8.4 are *unconfirmed*, from memory of the standard, whose text could not be read. EN 15129, section 8.3.4, is
*unconfirmed* as a whole for the same reason. NTC 2018, section 11.9.8, Eq. (11.9.9), has no sequence of its own.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Annotated, NamedTuple

import numpy as np

from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.program import PROTOTYPE_TESTS, Program, RigTest, VerticalLoad
from dcfp.analysis.rig.waveform import Sine
from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.check import Check, Verdict
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import KN_M, KN_PER_MM, MM, N_PER_MM2, NONE, SECOND

#: Minimum of the total maximum displacement over the maximum displacement [-]: ASCE/SEI 7, section 17.5.3.5.
LEAST_TOTAL = 1.15


@declared
class PrototypeDesign(Declared):
    """Design values of an isolation system.

    Parameters
    ----------
    displacement
        Maximum displacement: D_M of ASCE/SEI 7, d_bd of EN 15129 [mm].
    total_displacement
        With torsion, D_TM [mm]; by default 1.15 times the displacement, the least that ASCE/SEI 7 allows.
    least_load, largest_load
        Smallest and largest vertical load over the average one [-]; by default those of Li et al. (2020), Table 2, T10 and T11.
    wind_displacement
        Amplitude of the wind cycles [mm]; by default that of Li et al. (2020), Table 2, T02.
    endurance_cycles
        Cycles at 0.75 D_M, at least 10: 30 S_M1 / (S_MS B_M); by default the 20 of Li et al. (2020), Table 2, T12.
    """

    noun = "a design"

    displacement: Annotated[float, Parameter("maximum displacement D_M or d_bd", MM, 1.0, 1e4)]
    period: Annotated[float, Parameter("effective period at that displacement", SECOND, 0.1, 100.0)]
    pressure: Annotated[float, Parameter("pressure on the slider", N_PER_MM2, 0.0, above=True)] = 60.0
    total_displacement: Annotated[
        float | None,
        Parameter("maximum displacement with torsion", MM, 1.0, 1e4, more="default 1.15 times the displacement"),
    ] = None  # fmt: skip
    least_load: Annotated[float, Parameter("smallest over the average load", NONE, 0.0, above=True)] = 0.5
    largest_load: Annotated[float, Parameter("largest over the average load", NONE, 0.0, above=True)] = 1.5
    wind_displacement: Annotated[float, Parameter("amplitude of the wind cycles", MM, 0.0, above=True)] = 10.0
    endurance_cycles: Annotated[int, Parameter("number of endurance cycles", NONE, 1)] = 20

    def check_relations(self) -> None:
        """Refuse a total displacement below the displacement."""
        if self.total < self.displacement:
            msg = f"The total displacement, {self.total:g} mm, must not be below the displacement, {self.displacement:g} mm."
            raise InputError(msg)

    @property
    def total(self) -> float:
        """Total maximum displacement [mm]."""
        if self.total_displacement is None:
            return LEAST_TOTAL * self.displacement
        return self.total_displacement

    def test(
        self,
        name: str,
        amplitude: float,
        cycles: float,
        purpose: str,
        role: str,
        *,
        load: float = 1.0,
        velocity: float | None = None,
    ) -> RigTest:
        """Return a test by a sine at the effective period, or with a peak velocity [mm/s], under a factor of the average load [-]; it starts on cold plates."""
        peak = 2.0 * math.pi * amplitude / self.period if velocity is None else velocity
        vertical = VerticalLoad((load * self.pressure,))
        return RigTest(name, Sine(amplitude, peak, cycles), vertical, purpose=purpose, role=role)


@dataclass(frozen=True)
class PrototypeTests:
    """The prototype tests of a code: title and source of their program, the tests of a design, and what the code wants of their results."""

    title: str
    source: str
    tests: Callable[[PrototypeDesign], Sequence[RigTest]]
    judge: Callable[[Sequence[Loops]], list[Check]]


def prototype_program(code: str, design: PrototypeDesign) -> Program:
    """Return the prototype tests of a code for a design.

    Raises
    ------
    InputError
        If there is no such code.
    """
    found = PROTOTYPE_TESTS.find(code)
    return Program(found.title, tuple(found.tests(design)), found.source, code=code)


def judge_tests(program: Program, loops: Sequence[Loops]) -> list[Check]:
    """Return what the code of a program wants of its tests, with what NTC 2018 wants; nothing for a program of no code.

    Raises
    ------
    InputError
        If there is no such code.
    """
    return [*PROTOTYPE_TESTS.find(program.code).judge(loops), *_ntc_2018(loops)] if program.code else []


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


def _of_cycles(test: Loops, measure: str) -> FloatArray:
    return np.array([getattr(cycle, measure) for cycle in test.cycles])


# ASCE/SEI 7-16: displacements over D_M of item 2 (a), wind cycles, displacement and cycles of item 4.
INCREMENTS = (0.25, 0.5, 0.67, 1.0)
WIND_CYCLES = 20
ENDURANCE_DISPLACEMENT, LEAST_ENDURANCE_CYCLES = 0.75, 10
#: Limits of 17.8.4, unconfirmed: scatter of k_eff over the cycles of one displacement, change of k_eff and fall of beta_eff over item 4 [-].
LARGEST_SCATTER, LARGEST_STIFFNESS_CHANGE, LARGEST_DAMPING_FALL = 0.15, 0.20, 0.20


def _asce_2016_tests(design: PrototypeDesign) -> list[RigTest]:
    """Return the sequence of 17.8.2.2 (items 1, 2 (a), 3 and 4 (a)) and 17.8.2.5; the wind force of item 1 is replaced by a displacement."""
    d, cycles = design.displacement, max(LEAST_ENDURANCE_CYCLES, design.endurance_cycles)
    return [
        design.test("1 wind", design.wind_displacement, WIND_CYCLES, "item 1", "wind"),
        *(design.test(f"2 {part:g} D_M", part * d, 3, "item 2 (a)", "increment") for part in INCREMENTS),
        design.test("3 D_M", d, 3, "item 3", "maximum"),
        design.test("4 0.75 D_M", ENDURANCE_DISPLACEMENT * d, cycles, "item 4 (a)", "endurance"),
        design.test("5 least load", design.total, 1, "17.8.2.5", "stability", load=design.least_load),
        design.test("5 largest load", design.total, 1, "17.8.2.5", "stability", load=design.largest_load),
    ]


def _asce_2016(loops: Sequence[Loops]) -> list[Check]:
    """Return what 17.8.4 wants of the tests that have a role; endurance tests in a row are one, as in Li et al. (2020), Table 2."""
    code, found = "ASCE/SEI 7-16", list[Check]()
    for test in loops:
        if test.test.role:
            slope = float(_of_cycles(test, "post_yield_stiffness").min()) / 1e3
            words = "force grows with displacement: least post-yield stiffness"
            found.append(criterion(code, "17.8.4 (1)", test.name, words, slope, 0.0, "kN/mm", at_least=True))
        if test.test.role in ("increment", "maximum"):
            stiffness = _of_cycles(test, "effective_stiffness")
            scatter = float(np.abs(stiffness / stiffness.mean() - 1.0).max())
            words = f"k_eff of each cycle within {100.0 * LARGEST_SCATTER:.0f} % of the mean of the cycles (as in the edition of 2010)"
            found.append(criterion(code, "17.8.4 (3)", test.name, words, scatter, LARGEST_SCATTER))
    enduring = [test for test in loops if test.test.role == "endurance"]
    if not enduring:
        return found
    name = " + ".join(test.name for test in enduring)
    stiffness, damping = (
        np.concatenate([_of_cycles(test, measure) for test in enduring])
        for measure in ("effective_stiffness", "effective_damping")
    )
    change = float(np.abs(stiffness / stiffness[0] - 1.0).max())
    fall = float(1.0 - damping.min() / damping[0])
    words = f"k_eff changes by at most {100.0 * LARGEST_STIFFNESS_CHANGE:.0f} % of the first cycle's"
    found.append(criterion(code, "17.8.4 (4)", name, words, change, LARGEST_STIFFNESS_CHANGE))
    words = f"beta_eff falls by at most {100.0 * LARGEST_DAMPING_FALL:.0f} % of the first cycle's"
    return [*found, criterion(code, "17.8.4 (6)", name, words, fall, LARGEST_DAMPING_FALL)]


# EN 15129, unconfirmed: peak velocity of the benchmark tests [mm/s], displacements over d_bd and roles of the dynamic tests, cycles of all.
BENCHMARK_VELOCITY, CYCLES_EACH = 50.0, 3
DYNAMIC = {"D1": (0.25, "increment"), "D2": (0.5, "increment"), "D3": (1.0, "maximum")}
#: How far stiffness and energy may be from the design values [-], unconfirmed.
LARGEST_DEVIATION = 0.15


def _en_15129_tests(design: PrototypeDesign) -> list[RigTest]:
    """Return benchmark, dynamic, and seismic tests under the largest and smallest load, and the benchmark again."""
    d, n = design.displacement, CYCLES_EACH
    peak = 2.0 * math.pi * d / design.period
    return [
        design.test("P1", d, n, "benchmark", "increment", velocity=BENCHMARK_VELOCITY),
        *(
            design.test(name, part * d, n, f"dynamic, {part:g} d_bd", role, velocity=peak)
            for name, (part, role) in DYNAMIC.items()
        ),
        design.test("E1", d, n, "seismic, largest load", "stability", load=design.largest_load),
        design.test("E2", d, n, "seismic, least load", "stability", load=design.least_load),
        design.test("P2", d, n, "benchmark again", "increment", velocity=BENCHMARK_VELOCITY),
    ]


def _en_15129(loops: Sequence[Loops]) -> list[Check]:
    """Return how far restoring stiffness and energy are from the design values.

    The design stiffness is N / R. The design friction is the mean over the cycles of the test at the full displacement and speed; with it the energy of
    the dynamic tests under the same load and speed is judged.
    """
    found: list[Check] = []
    full = next((test for test in loops if test.test.role == "maximum"), None)
    for test in loops:
        restoring = _of_cycles(test, "post_yield_stiffness") * test.bearing.effective_radius
        deviation = float(np.abs(restoring / _of_cycles(test, "load") - 1.0).max())
        words = "restoring stiffness of each cycle within 15 % of N / R"
        found.append(criterion("EN 15129", "8.3.4", test.name, words, deviation, LARGEST_DEVIATION))
        if full is not None and test.name in DYNAMIC:
            friction = float(_of_cycles(full, "loop_friction").mean())
            deviation = float(np.abs(_of_cycles(test, "loop_friction") / friction - 1.0).max())
            words = f"energy of each cycle within 15 % of that of a friction of {friction:.4f}, the mean of {full.name}"
            found.append(criterion("EN 15129", "8.3.4", test.name, words, deviation, LARGEST_DEVIATION))
    return found


LEAST_CYCLES, LARGEST_FRICTION_CHANGE = 5, 0.25


def _ntc_2018(loops: Sequence[Loops]) -> list[Check]:
    """Return how far the friction of each cycle after the first is from that of the third, in tests of five cycles or more.

    The code asks for these cycles at the maximum displacement; in endurance tests, at a smaller one, the limit is an indication.
    """
    words = "friction of each cycle after the first within 25 % of the third's (asked for at the maximum displacement)"
    found: list[Check] = []
    for test in loops:
        friction = _of_cycles(test, "loop_friction")
        if test.test.role in ("maximum", "endurance") and friction.size >= LEAST_CYCLES:
            change = float(np.abs(friction[1:] / friction[2] - 1.0).max())
            limit = LARGEST_FRICTION_CHANGE
            found.append(criterion("NTC 2018", "11.9.8", test.name, words, change, limit, confirmed=True))
    return found


for _code, _title, _source, _tests, _judge in (
    ("asce7-16", "ASCE/SEI 7-16 prototype tests", "ASCE/SEI 7-16, sections 17.8.2.2 and 17.8.2.5", _asce_2016_tests, _asce_2016),
    ("en15129", "EN 15129 type tests", "EN 15129, section 8.3.4, unconfirmed", _en_15129_tests, _en_15129),
):  # fmt: skip
    PROTOTYPE_TESTS.add(_code, PrototypeTests(_title, _source, _tests, _judge))


# Property modification factors that tests show: ASCE/SEI 7-16, section 17.2.8.4. Which cycle counts as the last is *unconfirmed*, so the last
# of three and that of the endurance tests are given.

#: Cycles on which nominal properties rest.
NOMINAL_CYCLES = 3


class PropertyFactor(NamedTuple):
    """How much one property of the bearing changes in the tests.

    Attributes
    ----------
    upper, lower, first_over_third
        lambda_test,max and lambda_test,min: the first and the last of three cycles at the maximum displacement over their mean, and one over the other [-].
    enduring
        The last cycle of the endurance tests over their own first three's mean [-]; None where there are none.
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

#: Properties of a cycle by what they are called, with their units.
_PROPERTIES = {
    "friction of the loop": ("loop_friction", NONE),
    "effective stiffness": ("effective_stiffness", KN_PER_MM),
    "effective damping": ("effective_damping", NONE),
    "energy per cycle": ("energy", KN_M),
}


def property_factors(loops: Sequence[Loops]) -> list[PropertyFactor]:
    """Return the factors of the tests; an empty list where none has the role of the maximum with three cycles or more."""
    largest = [t for t in loops if t.test.role == "maximum" and len(t.cycles) >= NOMINAL_CYCLES]
    if not largest:
        return []
    enduring = [test for test in loops if test.test.role == "endurance"]
    factors: list[PropertyFactor] = []
    for name, (measure, unit) in _PROPERTIES.items():
        values = unit.shown(_of_cycles(largest[0], measure)[:NOMINAL_CYCLES]).tolist()
        many = [value for test in enduring for value in unit.shown(_of_cycles(test, measure)).tolist()]
        nominal, early = sum(values) / len(values), many[:NOMINAL_CYCLES]
        factors.append(
            PropertyFactor(
                name=name,
                nominal=nominal,
                unit=unit.heading.strip("[]"),
                upper=values[0] / nominal,
                lower=values[-1] / nominal,
                first_over_third=values[0] / values[-1],
                enduring=many[-1] * len(early) / sum(early) if len(many) > NOMINAL_CYCLES else None,
                tests=(largest[0].name, *(test.name for test in enduring)),
            )
        )
    return factors
