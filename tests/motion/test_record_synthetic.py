"""Synthetic motions: peaks and residuals of their formulas."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dcfp.errors import InputError
from dcfp.motion.synthetic import harmonic, mavroeidis_papageorgiou, ricker

positive = st.floats(0.05, 20.0)
amplitudes = st.floats(1.0, 5000.0)
relaxed = settings(deadline=None, max_examples=50)


@given(amplitude=amplitudes, period=positive, cycles=st.integers(1, 10))
@relaxed
def test_harmonic_from_rest(amplitude, period, cycles):
    motion = harmonic(amplitude, period, cycles)
    assert motion.peak_acceleration == pytest.approx(amplitude, rel=1e-6)
    assert motion.peak_velocity == pytest.approx(amplitude * period / math.pi, rel=3e-4)
    assert motion.duration == pytest.approx(cycles * period)
    assert abs(motion.velocity[-1]) < 1e-9 * motion.peak_velocity


@given(amplitude=amplitudes, period=positive, ramp=st.floats(0.1, 2.0))
@relaxed
def test_ramps_begin_and_end_gently(amplitude, period, ramp):
    motion = harmonic(amplitude, period, 4.0, phase=math.pi / 2, ramp=ramp)
    assert motion.acceleration[0] == 0.0
    assert abs(motion.acceleration[-1]) < 1e-6 * amplitude
    assert motion.peak_acceleration <= amplitude


@given(peak=amplitudes, frequency=positive)
@relaxed
def test_ricker_velocity(peak, frequency):
    motion = ricker(peak, frequency)
    assert motion.peak_velocity == pytest.approx(peak, rel=3e-4)
    assert motion.velocity.min() == pytest.approx(-2.0 * math.exp(-1.5) * peak, rel=1e-3)
    assert abs(motion.velocity[-1]) < 1e-9 * peak
    assert abs(motion.displacement[-1]) < 1e-9 * peak / frequency


@given(peak=amplitudes, frequency=positive)
@relaxed
def test_ricker_acceleration(peak, frequency):
    motion = ricker(peak, frequency, quantity="acceleration")
    assert motion.peak_acceleration == pytest.approx(peak, rel=1e-9)
    assert abs(motion.velocity[-1]) < 1e-9 * peak / frequency
    assert abs(motion.displacement[-1]) < 1e-9 * peak / frequency**2


@given(amplitude=amplitudes, frequency=positive, oscillation=st.floats(1.01, 6.0))
@relaxed
def test_peak_velocity_of_the_pulse(amplitude, frequency, oscillation):
    motion = mavroeidis_papageorgiou(amplitude, frequency, oscillation)
    assert motion.peak_velocity == pytest.approx(amplitude, rel=1e-3)


@given(
    amplitude=amplitudes,
    frequency=positive,
    oscillation=st.floats(1.01, 6.0),
    phase=st.floats(-math.pi, math.pi),
    delay=st.floats(0.0, 3.0),
)
@relaxed
def test_velocity_and_residual_displacement_of_the_pulse(amplitude, frequency, oscillation, phase, delay):
    centre = 0.5 * oscillation / frequency + delay
    motion = mavroeidis_papageorgiou(
        amplitude,
        frequency,
        oscillation,
        phase=phase,
        peak_time=centre,
        duration=2.0 * centre,
        time_step=1e-3 / frequency,
    )
    time = motion.time - centre
    inside = np.abs(time) <= 0.5 * oscillation / frequency
    velocity = np.where(
        inside,
        0.5
        * amplitude
        * (1.0 + np.cos(2 * math.pi * frequency / oscillation * time))
        * np.cos(2 * math.pi * frequency * time + phase),
        0.0,
    )
    np.testing.assert_allclose(motion.velocity, velocity, atol=1e-4 * amplitude)
    shape = math.sin(math.pi * oscillation) / (1.0 - oscillation**2)
    expected = amplitude * math.cos(phase) * shape / (2.0 * math.pi * frequency)
    assert motion.displacement[-1] == pytest.approx(
        expected, abs=3e-4 * amplitude * (1.0 + delay * frequency) / frequency
    )
    assert motion.peak_velocity <= amplitude * (1.0 + 1e-4)


@pytest.mark.parametrize(("oscillation", "phase"), [(2.0, 0.0), (1.5, math.pi / 2)])
def test_whole_oscillation_or_odd_phase_leaves_no_displacement(oscillation, phase):
    motion = mavroeidis_papageorgiou(1000.0, 0.5, oscillation, phase=phase, time_step=1e-3)
    assert motion.displacement[-1] == pytest.approx(0.0, abs=1e-2)
    assert abs(mavroeidis_papageorgiou(1000.0, 0.5, 1.5).displacement[-1]) > 100.0


def test_parameters_are_in_the_origin():
    text = mavroeidis_papageorgiou(800.0, 0.5, 2.0, phase=0.3).origin.source
    for word in ("800 mm/s", "0.5 Hz", "gamma = 2", "nu = 0.3"):
        assert word in text


@pytest.mark.parametrize(
    "call",
    [
        lambda: harmonic(0.0, 1.0, 1.0),
        lambda: harmonic(1.0, -1.0, 1.0),
        lambda: harmonic(1.0, 1.0, float("nan")),
        lambda: harmonic(1.0, 1.0, 1.0, phase=float("inf")),
        lambda: harmonic(1.0, 1.0, 1.0, ramp=0.6),
        lambda: harmonic(1.0, 1.0, 1.0, time_step=0.0),
        lambda: harmonic(1.0, 1.0, 1e12),
        lambda: ricker(1.0, 0.0),
        lambda: ricker(1.0, 1.0, quantity="displacement"),
        lambda: mavroeidis_papageorgiou(1.0, 1.0, 1.0),
        lambda: mavroeidis_papageorgiou(1.0, 1.0, float("nan")),
        lambda: mavroeidis_papageorgiou(1.0, 1.0, 2.0, peak_time=0.5),
        lambda: mavroeidis_papageorgiou(1.0, 1.0, 2.0, duration=1.5),
        lambda: mavroeidis_papageorgiou(1.0, 1.0, 2.0, time_step=1e-12),
    ],
)
def test_bad_parameters(call):
    with pytest.raises(InputError):
        call()
