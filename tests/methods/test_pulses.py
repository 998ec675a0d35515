"""What counts as a pulse of the ground velocity."""

import numpy as np
import pytest

from dcfp.errors import InputError
from dcfp.methods import Pulses, find_pulses
from dcfp.methods.li_2020 import predict_from_pulses
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_motion
from dcfp.motion.synthetic import harmonic, mavroeidis_papageorgiou, ricker
from dcfp.motion.treatment import resample

NAMES = ["KNA", "NCC", "LPG", "IVD"]


@pytest.fixture(scope="module", params=NAMES)
def motion(request: pytest.FixtureRequest) -> GroundMotion:
    """A record that begins and ends without acceleration, so that more silence does not bend its last straight line."""
    record = load_motion(request.param)
    return GroundMotion(np.pad(record.acceleration, 1), record.time_step, record.name)


def largest_change(pulses: Pulses) -> float:
    return predict_from_pulses(pulses).largest.displacement_change


# ----- what changes nothing -----


@pytest.mark.parametrize("threshold", [0.05, 0.2])
def test_a_mirrored_record_has_the_mirrored_pulses(motion: GroundMotion, threshold: float) -> None:
    there, back = find_pulses(motion, threshold), find_pulses(motion.scaled(-1.0), threshold)
    np.testing.assert_array_equal(there.times, back.times)
    np.testing.assert_array_equal(there.velocities, -back.velocities)
    one, other = predict_from_pulses(there), predict_from_pulses(back)
    np.testing.assert_array_equal(one.displacement_change, other.displacement_change)
    assert one.largest.displacement_change > 0.0


@pytest.mark.parametrize(("before", "after"), [(700, 0), (0, 700), (331, 17)])
def test_silence_before_and_after_changes_nothing(motion: GroundMotion, before: int, after: int) -> None:
    longer = GroundMotion(np.pad(motion.acceleration, (before, after)), motion.time_step)
    there, padded = find_pulses(motion), find_pulses(longer)
    np.testing.assert_array_equal(there.velocities, padded.velocities)
    np.testing.assert_allclose(padded.times - before * motion.time_step, there.times, rtol=0.0, atol=1e-12)
    assert largest_change(padded) == pytest.approx(largest_change(there), rel=1e-11)


@pytest.mark.parametrize("factor", [2, 5])
@pytest.mark.parametrize("threshold", [0.05, 0.2])
def test_samples_along_the_same_straight_lines_change_nothing(
    motion: GroundMotion, factor: int, threshold: float
) -> None:
    there, finer = find_pulses(motion, threshold), find_pulses(resample(motion, factor), threshold)
    np.testing.assert_allclose(finer.times, there.times, rtol=0.0, atol=1e-8)
    np.testing.assert_allclose(finer.velocities, there.velocities, rtol=0.0, atol=1e-9 * motion.peak_velocity)
    assert largest_change(finer) == pytest.approx(largest_change(there), rel=1e-8)


@pytest.mark.parametrize("offset", [0, 1, 2, 3])
@pytest.mark.parametrize(
    "motion",
    [
        mavroeidis_papageorgiou(600.0, 0.8, 2.5, phase=1.0, time_step=0.0025),
        mavroeidis_papageorgiou(500.0, 1.3, 3.0, time_step=0.0025),
        ricker(500.0, 0.7, time_step=0.0025),
    ],
    ids=["one-sided", "three cycles", "Ricker"],
)
def test_every_fourth_sample_gives_the_same_within_a_hundredth(motion: GroundMotion, offset: int) -> None:
    """Wherever the first of the samples is; the formulas are smooth at 0.01 s, so that little is lost."""
    fewer = GroundMotion(motion.acceleration[offset::4], 4.0 * motion.time_step)
    there, coarse = find_pulses(motion), find_pulses(fewer)
    assert coarse.count == there.count > 0
    np.testing.assert_allclose(
        coarse.velocities, there.velocities, rtol=0.0, atol=2e-3 * motion.peak_velocity
    )
    assert largest_change(coarse) == pytest.approx(largest_change(there), rel=1e-2)


# ----- simple records -----


def test_a_pure_sine() -> None:
    """The velocity is A T / 2 pi sin(2 pi t / T), so that the slopes are 4 PGV / T."""
    amplitude, period, cycles = 2000.0, 1.6, 3
    pulses = find_pulses(harmonic(amplitude, period, cycles, phase=0.5 * np.pi))
    pgv = amplitude * period / (2.0 * np.pi)
    # from rest, over six peaks, to the end
    expected = period * np.array([0.0, 0.25, 0.75, 1.25, 1.75, 2.25, 2.75, 3.0])
    np.testing.assert_allclose(pulses.times, expected, rtol=0.0, atol=1e-9)
    np.testing.assert_allclose(
        pulses.velocities, pgv * np.array([0, 1, -1, 1, -1, 1, -1, 0]), atol=3e-4 * pgv
    )
    assert pulses.count == 6
    slope = 4.0 * pgv / period
    np.testing.assert_allclose(pulses.mean_accelerations, slope * np.array([1, -1, 1, -1, 1, -1]), rtol=3e-4)
    np.testing.assert_allclose(pulses.next_mean_accelerations[:5], pulses.mean_accelerations[1:])


def test_a_silent_record_has_no_pulses() -> None:
    pulses = find_pulses(GroundMotion(np.zeros(50), 0.01))
    assert pulses.count == 0
    assert pulses.times.size == 0
    largest = predict_from_pulses(pulses).largest
    assert (largest.displacement_change, largest.input_velocity, largest.hysteretic_velocity) == (
        0.0,
        0.0,
        0.0,
    )


def test_a_ground_that_only_sets_off_has_peaks_but_no_pulse() -> None:
    pulses = find_pulses(GroundMotion(np.array([0.0, 100.0, 100.0, 0.0]), 0.5))
    assert pulses.velocities.tolist() == [0.0, 100.0]
    assert pulses.count == 0


def test_a_peak_between_two_samples_is_found_there() -> None:
    pulses = find_pulses(GroundMotion(np.array([0.0, 300.0, -100.0, 0.0]), 1.0))
    assert pulses.times[1] == 1.75
    assert pulses.velocities[1] == 150.0 + 0.5 * 300.0 * 0.75


def test_pulses_are_scaled_with_their_motion(motion: GroundMotion) -> None:
    direct, after = find_pulses(motion.scaled(0.5)), find_pulses(motion).scaled(0.5)
    np.testing.assert_array_equal(direct.times, after.times)
    np.testing.assert_allclose(direct.velocities, after.velocities, rtol=1e-12)


# ----- refusals -----


@pytest.mark.parametrize("factor", [0.0, np.nan, -np.inf])
def test_a_factor_that_scales_nothing_is_refused(factor: float) -> None:
    pulses = find_pulses(harmonic(1000.0, 1.0, 2.0))
    with pytest.raises(InputError, match=r"^Pulses can be scaled by a finite number other than zero, not by"):
        pulses.scaled(factor)


@pytest.mark.parametrize("threshold", [0.0, -0.1, 1.01, np.nan, np.inf])
def test_a_threshold_out_of_range_is_refused(threshold: float) -> None:
    with pytest.raises(
        InputError, match=r"^The threshold of a pulse must be a number above 0 and up to 1, not .*\.$"
    ):
        find_pulses(harmonic(1000.0, 1.0, 2.0), threshold)


@pytest.mark.parametrize(
    ("times", "velocities", "words"),
    [
        ([0.0, 1.0], [0.0, 1.0, 0.0], "as many times as velocities, not 2 and 3"),
        ([0.0, 1.0, 1.0], [0.0, 1.0, 0.0], "must be finite and increase"),
        ([0.0, 1.0, np.nan], [0.0, 1.0, 0.0], "must be finite and increase"),
        ([0.0, 1.0, 2.0], [0.0, np.inf, 0.0], "velocities be finite"),
        ([0.0, 1.0, 2.0], [0.0, 1.0, 2.0], "up and down in turn"),
        ([0.0, 1.0, 2.0], [0.0, 0.0, 1.0], "up and down in turn"),
    ],
)
def test_peaks_that_are_none_are_refused(times: list[float], velocities: list[float], words: str) -> None:
    with pytest.raises(InputError, match=words):
        Pulses(np.array(times), np.array(velocities))
