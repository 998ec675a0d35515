"""Sliding isolators by the Italian code: NTC 2018, section 11.9.8, Eq. (11.9.9)."""

from collections.abc import Sequence

import numpy as np

from dcfp.analysis.rig.codes.prototype import criterion
from dcfp.analysis.rig.loops import Loops
from dcfp.schema.check import Check

CODE = "NTC 2018"
LEAST_CYCLES = 5
LARGEST_DEVIATION = 0.25


def judge(loops: Sequence[Loops]) -> list[Check]:
    """Return how far the friction of each cycle after the first is from that of the third, in tests of five cycles or more.

    The code asks for these cycles at the maximum displacement; in endurance tests, at a smaller one, the limit is an indication.
    """
    found: list[Check] = []
    for test in loops:
        friction = [c.loop_friction for c in test.cycles]
        if test.test.role in ("maximum", "endurance") and len(friction) >= LEAST_CYCLES:
            found.append(
                criterion(
                    CODE,
                    "11.9.8",
                    test.test.name,
                    "friction of each cycle after the first within 25 % of the third's (asked for at the maximum displacement)",
                    float(np.max(np.abs(np.array(friction[1:]) / friction[2] - 1.0))),
                    LARGEST_DEVIATION,
                    confirmed=True,
                )
            )
    return found
