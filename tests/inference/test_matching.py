"""Which pulse a swing belongs to."""

import numpy as np
import pytest

from dcfp.analysis import respond
from dcfp.analysis.swings import Swing, swings_of
from dcfp.inference.case import governing_pulse
from dcfp.methods import Pulses, find_pulses, march_through_pulses
from dcfp.motion.load import load_motion
from dcfp.motion.synthetic import mavroeidis_papageorgiou
from dcfp.system import LI_2020, Li2020, SimplifiedHeating

#: Changes of 300, -500, 400 and -350 mm/s, to peaks at 1, 2, 3 and 4 s.
PULSES = Pulses(np.arange(6.0), np.array([0.0, 300.0, -200.0, 200.0, -150.0, 0.0]))


def swing(start: float, end: float, change: float) -> Swing:
    return Swing(start, end, change, 0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("start", "end", "change", "pulse"),
    [
        (0.5, 1.4, -50.0, 0),  # the ground rises to its peak at 1 s, the structure stays behind
        (1.4, 2.3, 50.0, 1),
        (0.5, 3.5, -50.0, 2),  # of the two rises the larger
        (0.5, 4.5, 50.0, 1),  # of the two falls the larger
        (1.0, 1.2, -50.0, 0),  # a peak at the very start
        (0.8, 1.0, -50.0, 0),  # or end
        (0.5, 1.4, 50.0, None),  # wrong sign
        (0.2, 0.9, -50.0, 0),  # caught up before the peak, all of it in the rise
        (-0.3, 0.5, -50.0, 0),  # most of it in the rise
        (-0.6, 0.5, -50.0, None),  # the smaller part in the rise, and no peak within
        (1.1, 1.9, -50.0, None),  # all of it in the fall
        (5.5, 6.0, -50.0, None),  # after all of them
        (4.9, 5.1, -50.0, None),  # where the ground comes to rest is no pulse's own peak
        (0.5, 1.4, 0.0, None),  # no swing at all
    ],
)
def test_the_pulse_has_its_peak_within_the_swing_and_the_other_sign(
    start: float, end: float, change: float, pulse: int | None
) -> None:
    assert governing_pulse(swing(start, end, change), PULSES) == pulse
    assert governing_pulse(swing(start, end, -change), PULSES.scaled(-1.0)) == pulse


def test_without_pulses_there_is_none() -> None:
    for number in (0, 1, 2):
        pulses = Pulses(np.arange(float(number)), np.arange(float(number)))
        assert governing_pulse(swing(0.0, 10.0, -50.0), pulses) is None


@pytest.mark.parametrize("phase", [0.0, 1.0, 2.0, np.pi])
def test_the_swing_of_the_largest_pulse_is_ascribed_to_it(phase: float) -> None:
    """A near-fault pulse has one swing that matters; the march, which knows its cause, names the same."""
    motion = mavroeidis_papageorgiou(600.0, 0.7, 2.0, phase=phase)
    pulses = find_pulses(motion, 0.05)
    largest = swings_of(respond(motion)).largest
    assert largest is not None
    assert abs(largest.change) > 50.0
    march = march_through_pulses(pulses, LI_2020, Li2020(), SimplifiedHeating())
    assert governing_pulse(largest, pulses) == march.leg is not None


@pytest.mark.parametrize("name", ["KNA", "NCC", "LPG", "IVD"])
def test_most_large_swings_of_a_record_have_a_pulse(name: str) -> None:
    motion = load_motion(name).scaled_to_pgv(500.0)
    pulses, swings = find_pulses(motion), swings_of(respond(motion))
    large = np.flatnonzero(np.abs(swings.changes) > 0.5 * np.abs(swings.changes).max())
    found = [governing_pulse(swings[int(i)], pulses) for i in large]
    assert governing_pulse(swings[int(np.argmax(np.abs(swings.changes)))], pulses) is not None
    known = [pulse for pulse in found if pulse is not None]
    assert len(known) > 0.7 * len(found)
    assert known == sorted(set(known))  # a pulse causes one swing
