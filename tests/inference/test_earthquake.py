"""Whether two records are of one earthquake."""

import numpy as np
import pytest

from dcfp.inference.case import is_known, is_same_record, same_earthquake
from dcfp.motion.ground_motion import GroundMotion, Origin


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        ("Northridge 1994", "Northridge 1994", True),
        ("Northridge, 1/17/1994", "Northridge 1994", True),
        (
            "1995/01/17 05:46:00",
            "Kobe, Japan 1995",
            True,
        ),  # a date only: one too many rather than one too few
        ("Kocaeli, Turkey 1999", "Duzce, Turkey 1999", False),  # the country is not the name
        ("Chi-Chi, Taiwan 1999", "Hector Mine 1999", False),
        ("Northridge 1994", "Northridge 1987", False),
        ("mine", "Northridge 1994", False),
        ("2011/03/11 14:46:00", "Kobe, Japan 1995", False),
    ],
)
def test_events(one: str, other: str, same: bool) -> None:
    assert same_earthquake(one, other) is same
    assert same_earthquake(other, one) is same


def test_a_year_is_what_makes_an_earthquake_known() -> None:
    motion = GroundMotion(np.zeros(2), 1.0, origin=Origin(event="Kobe 1995"))
    assert is_known(motion)
    assert not is_known(GroundMotion(np.zeros(2), 1.0, origin=Origin(event="number 19951")))


def test_the_same_samples_at_another_scale_and_sign() -> None:
    values = np.random.default_rng(3).standard_normal(500)
    motion = GroundMotion(values, 0.01)
    assert is_same_record(motion, GroundMotion(np.round(-3.7 * values, 4), 0.01))
    assert not is_same_record(motion, GroundMotion(np.roll(values, 1), 0.01))
    assert not is_same_record(motion, GroundMotion(values[:-1], 0.01))
    assert not is_same_record(motion, GroundMotion(np.zeros(500), 0.01))
