"""Sliding isolators by the Italian code: NTC 2018, section 11.9.8, Eq. (11.9.9)."""

from collections.abc import Sequence

from dcfp.rig.codes.criterion import Criterion
from dcfp.rig.loops import Loops

CODE = "NTC 2018"
LEAST_CYCLES = 5
LARGEST_DEVIATION = 0.25


def judge(loops: Sequence[Loops]) -> list[Criterion]:
    """Return how far the friction of each cycle after the first is from that of the third, in tests of five cycles or more.

    The code asks for these cycles at the maximum displacement.
    """
    found: list[Criterion] = []
    for test in loops:
        friction = [c.loop_friction for c in test.cycles]
        if len(friction) >= LEAST_CYCLES:
            found.append(
                Criterion(
                    CODE,
                    "11.9.8",
                    test.test.name,
                    "friction of each cycle after the first within 25 % of the third's",
                    max(abs(f / friction[2] - 1.0) for f in friction[1:]),
                    LARGEST_DEVIATION,
                    confirmed=True,
                )
            )
    return found
