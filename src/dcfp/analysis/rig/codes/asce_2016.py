"""Prototype tests and their adequacy: ASCE/SEI 7-16, sections 17.8.2 and 17.8.4.

The order, displacements and cycles of the sequence agree with the tests of Li et al. (2020), Table 2, which follow the same standard. The limits of
17.8.4 are *unconfirmed*: they are from memory of the standard, its text could not be read.
"""

import math
from collections.abc import Sequence

import numpy as np

from dcfp.analysis.rig.codes.prototype import PrototypeDesign, criterion
from dcfp.analysis.rig.loops import Loops
from dcfp.analysis.rig.measures import Cycle
from dcfp.analysis.rig.program import Program, RigTest
from dcfp.analysis.rig.waveform import Sine
from dcfp.schema.check import Check

CODE = "ASCE/SEI 7-16"
#: Displacements over D_M of item 2 (a).
INCREMENTS = (0.25, 0.5, 0.67, 1.0)
WIND_CYCLES = 20
LEAST_ENDURANCE_CYCLES = 10
ENDURANCE_DISPLACEMENT = 0.75
#: Limits of 17.8.4, unconfirmed: scatter of k_eff over the cycles of one displacement, change of k_eff and fall of beta_eff over item 4 [-].
LARGEST_SCATTER = 0.15
LARGEST_STIFFNESS_CHANGE = 0.20
LARGEST_DAMPING_FALL = 0.20


def prototype_program(design: PrototypeDesign) -> Program:
    """Return the sequence of 17.8.2.2 (items 1, 2 (a), 3 and 4 (a)) and 17.8.2.5, sine waves at the effective period.

    Every test starts on cold plates; the wind force of item 1 is replaced by a displacement.
    """

    def wave(displacement: float, cycles: int) -> Sine:
        return Sine(displacement, 2.0 * math.pi * displacement / design.period, cycles)

    d = design.displacement
    endurance = max(LEAST_ENDURANCE_CYCLES, design.endurance_cycles)
    tests = [
        RigTest(
            "1 wind",
            wave(design.wind_displacement, WIND_CYCLES),
            design.load(),
            purpose="item 1",
            role="wind",
        ),
        *(
            RigTest(
                f"2 {part:g} D_M", wave(part * d, 3), design.load(), purpose="item 2 (a)", role="increment"
            )
            for part in INCREMENTS
        ),
        RigTest("3 D_M", wave(d, 3), design.load(), purpose="item 3", role="maximum"),
        RigTest(
            "4 0.75 D_M",
            wave(ENDURANCE_DISPLACEMENT * d, endurance),
            design.load(),
            purpose="item 4 (a)",
            role="endurance",
        ),
        RigTest(
            "5 least load",
            wave(design.total, 1),
            design.load(design.least_load),
            purpose="17.8.2.5",
            role="stability",
        ),
        RigTest(
            "5 largest load",
            wave(design.total, 1),
            design.load(design.largest_load),
            purpose="17.8.2.5",
            role="stability",
        ),
    ]
    source = "ASCE/SEI 7-16, sections 17.8.2.2 and 17.8.2.5"
    return Program("ASCE/SEI 7-16 prototype tests", tuple(tests), source, code="asce7-16")


def judge(loops: Sequence[Loops]) -> list[Check]:
    """Return what 17.8.4 wants of the tests that have a role; endurance tests in a row are one, as in Li et al. (2020), Table 2."""
    found: list[Check] = []
    for test in loops:
        if test.test.role:
            found.append(_grows(test.test.name, test.cycles))
        if test.test.role in ("increment", "maximum"):
            found.append(_scatters(test.test.name, test.cycles))
    enduring = [test for test in loops if test.test.role == "endurance"]
    if enduring:
        name = " + ".join(test.test.name for test in enduring)
        found += _endures(name, [cycle for test in enduring for cycle in test.cycles])
    return found


def _grows(test: str, cycles: Sequence[Cycle]) -> Check:
    slope = float(np.min([c.post_yield_stiffness for c in cycles])) / 1e3
    words = "force grows with displacement: least post-yield stiffness"
    return criterion(CODE, "17.8.4 (1)", test, words, slope, 0.0, "kN/mm", at_least=True)


def _scatters(test: str, cycles: Sequence[Cycle]) -> Check:
    stiffness = np.array([c.effective_stiffness for c in cycles])
    scatter = float(np.max(np.abs(stiffness / stiffness.mean() - 1.0)))
    words = f"k_eff of each cycle within {100.0 * LARGEST_SCATTER:.0f} % of the mean of the cycles (as in the edition of 2010)"
    return criterion(CODE, "17.8.4 (3)", test, words, scatter, LARGEST_SCATTER)


def _endures(test: str, cycles: Sequence[Cycle]) -> list[Check]:
    stiffness = np.array([c.effective_stiffness for c in cycles])
    damping = np.array([c.effective_damping for c in cycles])
    change = float(np.max(np.abs(stiffness / stiffness[0] - 1.0)))
    fall = float(1.0 - np.min(damping) / damping[0])
    stiffness_words = (
        f"k_eff changes by at most {100.0 * LARGEST_STIFFNESS_CHANGE:.0f} % of the first cycle's"
    )
    damping_words = f"beta_eff falls by at most {100.0 * LARGEST_DAMPING_FALL:.0f} % of the first cycle's"
    return [
        criterion(CODE, "17.8.4 (4)", test, stiffness_words, change, LARGEST_STIFFNESS_CHANGE),
        criterion(CODE, "17.8.4 (6)", test, damping_words, fall, LARGEST_DAMPING_FALL),
    ]
