"""Measures against quadrature on a fine grid, scaling laws, and cases that can be done by hand."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import (
    arias_intensity,
    baseline_drift,
    baseline_warning,
    cumulative_absolute_velocity,
    measure,
    significant_duration,
)
from dcfp.motion.treatment import resample

values = arrays(np.float64, st.integers(2, 40), elements=st.integers(-500, 500).map(float))


def motion(acceleration, time_step=0.02):
    return GroundMotion(np.asarray(acceleration, dtype=float), time_step, "test")


@given(acceleration=values)
@settings(deadline=None)
def test_against_quadrature(acceleration):
    record = motion(acceleration)
    fine = resample(record, 400)
    square = np.trapezoid(fine.acceleration**2, dx=fine.time_step)
    assert arias_intensity(record) == pytest.approx(np.pi / 2 / STANDARD_GRAVITY * square, rel=1e-3, abs=1e-9)
    absolute = np.trapezoid(np.abs(fine.acceleration), dx=fine.time_step)
    assert cumulative_absolute_velocity(record) == pytest.approx(absolute, rel=1e-4, abs=1e-9)


@given(acceleration=values, factor=st.integers(2, 5))
@settings(deadline=None)
def test_resampling_changes_nothing(acceleration, factor):
    coarse, fine = measure(motion(acceleration)), measure(resample(motion(acceleration), factor))
    for name in ("arias_intensity_m_s", "cumulative_absolute_velocity_m_s"):
        assert fine[name] == pytest.approx(coarse[name], rel=1e-9, abs=1e-15)
    # A flat stretch of the integral of the squared acceleration may be reached a little earlier or later.
    assert fine["significant_duration_s"] == pytest.approx(coarse["significant_duration_s"], abs=1e-5)


@given(acceleration=values, factor=st.floats(0.1, 10.0))
def test_scaling(acceleration, factor):
    one, other = measure(motion(acceleration)), measure(motion(acceleration).scaled(-factor))
    assert other["pga_m_s2"] == pytest.approx(factor * one["pga_m_s2"])
    assert other["arias_intensity_m_s"] == pytest.approx(factor**2 * one["arias_intensity_m_s"])
    assert other["cumulative_absolute_velocity_m_s"] == pytest.approx(
        factor * one["cumulative_absolute_velocity_m_s"]
    )
    assert other["baseline_drift"] == pytest.approx(one["baseline_drift"])


def test_constant_acceleration_by_hand():
    record = motion(np.full(101, 100.0))
    assert arias_intensity(record) == pytest.approx(np.pi / 2 / STANDARD_GRAVITY * 100.0**2 * 2.0)
    assert significant_duration(record) == pytest.approx(0.9 * 2.0)
    assert significant_duration(record, 0.25, 0.75) == pytest.approx(1.0)
    assert cumulative_absolute_velocity(record) == pytest.approx(200.0)
    assert baseline_drift(record) == 1.0


def test_one_step_through_zero_by_hand():
    """From -100 to 300 mm/s2 in 0.02 s: two triangles of 5 and 15 ms."""
    record = motion([-100.0, 300.0])
    assert cumulative_absolute_velocity(record) == pytest.approx(0.5 * (100 * 0.005 + 300 * 0.015))


def test_significant_duration_within_one_step():
    """The squared acceleration of a ramp from zero grows with the cube of time."""
    record = motion([0.0, 100.0])
    assert significant_duration(record) == pytest.approx(0.02 * (np.cbrt(0.95) - np.cbrt(0.05)))


def test_a_motion_of_zeros():
    measures = measure(motion(np.zeros(5)))
    names = ("arias_intensity_m_s", "significant_duration_s", "baseline_drift")
    assert [measures[name] for name in names] == [0.0, 0.0, 0.0]
    assert baseline_warning(motion(np.zeros(5))) is None


@pytest.mark.parametrize(
    ("start", "end"), [(0.5, 0.5), (0.9, 0.1), (-0.1, 0.5), (0.1, 1.1), (float("nan"), 1.0)]
)
def test_bad_fractions(start, end):
    with pytest.raises(InputError, match="fractions"):
        significant_duration(motion([1.0, 2.0]), start, end)


def test_warning_names_the_record_and_the_drift():
    assert baseline_warning(motion(np.ones(10))).startswith("test: the ground still moves at 100 % of PGV")
