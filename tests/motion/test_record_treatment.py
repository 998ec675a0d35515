"""Treatment: what each step takes away, and that it is written down."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.treatment import (
    high_pass,
    remove_leading_mean,
    remove_linear_acceleration,
    remove_linear_velocity,
    remove_mean,
    resample,
)

values = arrays(np.float64, st.integers(2, 60), elements=st.floats(-1e4, 1e4))


def motion(acceleration, time_step=0.01):
    return GroundMotion(np.asarray(acceleration, dtype=float), time_step, "test")


@given(acceleration=values, offset=st.floats(-1e3, 1e3))
def test_mean_of_the_beginning(acceleration, offset):
    quiet = np.concatenate([np.zeros(20), acceleration])
    treated = remove_leading_mean(motion(quiet + offset), 0.2)
    np.testing.assert_allclose(treated.acceleration, quiet, atol=1e-8)
    assert treated.treatment == ("mean of the first 0.2 s removed",)


@given(acceleration=values)
def test_mean(acceleration):
    assert abs(remove_mean(motion(acceleration)).acceleration.mean()) < 1e-8


@given(acceleration=values, offset=st.floats(-1e3, 1e3), slope=st.floats(-1e3, 1e3))
def test_a_line_in_acceleration_leaves_no_trace(acceleration, offset, slope):
    plain = motion(acceleration)
    tilted = motion(acceleration + offset + slope * plain.time)
    np.testing.assert_allclose(
        remove_linear_acceleration(tilted).acceleration,
        remove_linear_acceleration(plain).acceleration,
        atol=1e-7,
    )


@given(acceleration=values, slope=st.floats(-1e3, 1e3))
def test_a_line_in_velocity_leaves_no_trace(acceleration, slope):
    np.testing.assert_allclose(
        remove_linear_velocity(motion(acceleration + slope)).acceleration,
        remove_linear_velocity(motion(acceleration)).acceleration,
        atol=1e-7,
    )


@given(acceleration=values, factor=st.integers(1, 7))
@settings(deadline=None)
def test_resampling_keeps_the_motion(acceleration, factor):
    old = motion(acceleration)
    new = resample(old, factor)
    assert new.time_step == pytest.approx(old.time_step / factor)
    assert new.duration == pytest.approx(old.duration)
    for name in ("acceleration", "velocity", "displacement"):
        np.testing.assert_allclose(getattr(new, name)[::factor], getattr(old, name), rtol=1e-9, atol=1e-7)


def sine(frequency):
    time = np.arange(20000) * 0.01
    return motion(1000.0 * np.sin(2 * np.pi * frequency * time))


def test_high_pass_is_zero_phase_and_halves_at_the_corner():
    corner = 0.5
    middle = slice(8000, 12000)
    for frequency in (0.25, 0.5, 1.0, 4.0):
        old = sine(frequency)
        new = high_pass(old, corner, order=2, keep_margins=False)
        # Twice through a Butterworth filter of order two, made digital with a bilinear transform.
        ratio = np.tan(np.pi * corner * 0.01) / np.tan(np.pi * frequency * 0.01)
        expected = old.acceleration[middle] / (1.0 + ratio**4)
        np.testing.assert_allclose(new.acceleration[middle], expected, atol=0.5)


def test_high_pass_ends_at_rest_with_its_margins():
    random = np.random.default_rng(1)
    old = remove_mean(motion(np.cumsum(random.normal(size=4000))))
    new = high_pass(old, 0.2)
    assert new.duration == pytest.approx(old.duration + 1.5 * 2 / 0.2, abs=0.03)
    assert abs(new.velocity[-1]) < 1e-3 * new.peak_velocity
    assert "margins of 7.5 s kept" in new.treatment[-1]
    assert high_pass(old, 0.2, keep_margins=False).acceleration.size == old.acceleration.size


def test_steps_add_up_and_the_origin_stays():
    old = sine(1.0)
    new = resample(high_pass(remove_leading_mean(old, 1.0), 0.1), 2)
    assert len(new.treatment) == 3
    assert new.origin == old.origin
    assert old.treatment == ()


@pytest.mark.parametrize(
    "call",
    [
        lambda m: remove_leading_mean(m, 0.0),
        lambda m: remove_leading_mean(m, -1.0),
        lambda m: remove_leading_mean(m, 1e9),
        lambda m: remove_leading_mean(m, float("nan")),
        lambda m: high_pass(m, 0.0),
        lambda m: high_pass(m, 50.0),
        lambda m: high_pass(m, float("nan")),
        lambda m: high_pass(m, 1e-12),
        lambda m: high_pass(m, 1.0, order=0),
        lambda m: high_pass(m, 1.0, order=11),
        lambda m: resample(m, 0),
        lambda m: resample(m, 10**9),
        lambda m: resample(m, 1.5),
    ],
)
def test_bad_parameters(call):
    with pytest.raises(InputError, match="test: "):
        call(motion(np.ones(100)))


@pytest.mark.parametrize("points", [2, 3, 5])
def test_the_shortest_motions_can_be_filtered(points):
    assert np.isfinite(high_pass(motion(np.ones(points)), 10.0).acceleration).all()
