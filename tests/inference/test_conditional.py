"""Intervals that know the spectrum: the regression, its residuals by earthquake, and what is beyond the experience."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp.inference.conditional import Experience, Regression, of_record, of_spectrum
from dcfp.inference.coverage import coverage
from dcfp.inference.forecast import BY_SPECTRUM, cases_at, forecast
from dcfp.inference.statistics import errors
from dcfp.methods.prediction import Methods
from dcfp.methods.pulses import CHANGE, DISPLACEMENT, TOTAL
from dcfp.methods.spectra.of_record import response_spectrum
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_motion

SLOPE, SPREAD = np.array([0.8, -0.5]), 0.3


def of_earthquakes(number: int, seed: int, each: int = 3) -> tuple[np.ndarray, np.ndarray, list[str]]:
    """Errors that depend on two features, with a part that all components of an earthquake share."""
    numbers = np.random.default_rng(seed)
    events = np.repeat(np.arange(number), each)
    known = numbers.standard_normal((events.size, 2))
    shared = 0.5 * SPREAD * numbers.standard_normal(number)
    own = SPREAD * np.sqrt(0.75) * numbers.standard_normal(events.size)
    return 0.2 + known @ SLOPE + shared[events] + own, known, [str(one) for one in events]


def test_it_finds_what_explains_the_errors() -> None:
    found = Regression.of(*of_earthquakes(400, 1))
    assert found is not None
    np.testing.assert_allclose(found.coefficients, [0.2, *SLOPE], atol=0.06)
    assert found.cases == 1200


def test_a_new_earthquake_is_inside_at_least_as_often_as_it_says() -> None:
    inside: list[bool] = []
    for seed in range(150):
        errors, known, events = of_earthquakes(20, seed)
        regression = Regression.of(errors[:-3], known[:-3], events[:-3])
        assert regression is not None
        low, _, high = regression.ends(known[-3:])
        inside += list((low <= errors[-3:]) & (errors[-3:] <= high))
    assert 0.9 < np.mean(inside) < 0.98


def test_it_is_narrower_than_an_interval_that_does_not_know() -> None:
    errors, known, events = of_earthquakes(30, 3)
    regression = Regression.of(errors, known, events)
    assert regression is not None
    low, median, high = regression.ends(np.zeros((1, 2)))
    assert low < median < high
    assert high - low < 0.6 * (np.quantile(errors, 0.95) - np.quantile(errors, 0.05))


def test_it_is_wider_beyond_the_experience_and_says_how_far() -> None:
    errors, known, events = of_earthquakes(30, 4)
    regression = Regression.of(errors, known, events)
    assert regression is not None
    inside, edge = np.zeros(2), np.array([known[:, 0].max(), 0.0])
    beyond = edge + np.array([1.0, 0.0])
    assert not regression.beyond(np.stack((inside, edge))).any()
    np.testing.assert_allclose(regression.beyond(beyond), [1.0 / known[:, 0].std(), 0.0])
    widths = [np.log(one.high / one.low) for one in map(regression.interval, (inside, edge, beyond))]
    assert widths[0] < widths[1] < widths[2]
    assert widths[2] > 1.2 * widths[1]


def test_what_is_no_number_does_not_count_and_too_few_give_none() -> None:
    errors, known, events = of_earthquakes(12, 5)
    spoiled = errors.copy()
    spoiled[::7] = np.nan
    few = Regression.of(spoiled, known, events)
    assert few is not None
    assert few.cases == 36 - 6
    there = np.isfinite(spoiled)
    same = Regression.of(
        errors[there], known[there], [one for one, kept in zip(events, there, strict=True) if kept]
    )
    assert same is not None
    np.testing.assert_array_equal(few.coefficients, same.coefficients)
    assert Regression.of(errors[:15], known[:15], events[:15]) is None  # five earthquakes
    assert Regression.of(errors, known, ["one"] * 36) is None


def test_a_record_is_known_by_the_same_however_it_is_scaled_turned_round_or_padded() -> None:
    motion, periods = load_motion("NCC"), np.array([1.5, 4.0])
    known = of_record(motion, periods)
    zeros = np.zeros(300)
    longer = GroundMotion(np.concatenate((zeros, -motion.acceleration, zeros)), motion.time_step, "longer")
    np.testing.assert_allclose(of_record(motion.scaled_to_pgv(800.0), periods), known, rtol=1e-12, atol=1e-12)
    # the ramp from the zeros to the first sample is new
    np.testing.assert_allclose(of_record(longer, periods)[:2], known[:2], atol=2e-4)
    spectrum = response_spectrum(motion, np.geomspace(0.5, 8.0, 200))
    np.testing.assert_allclose(of_spectrum(spectrum, motion.peak_velocity, periods), known[:2], atol=2e-3)


@pytest.fixture(scope="module")
def at_half() -> list:
    return cases_at(500.0, Methods())


def test_a_record_gets_intervals_by_its_spectrum(at_half) -> None:
    methods = Methods()
    told = forecast(load_motion("NCC").scaled_to_pgv(500.0), methods, at_half)
    alone, by_spectrum = told.intervals[None], told.intervals[BY_SPECTRUM]
    # the energy of all the shaking depends on how long it lasts, which a record tells
    for quantity in (CHANGE, DISPLACEMENT, TOTAL):
        widths = [np.log(one[quantity].high / one[quantity].low) for one in (by_spectrum, alone)]
        assert widths[0] < widths[1]
    experience = Experience.of_cases(at_half, methods)
    short = of_record(load_motion("NCC"), experience.periods)[:2]
    assert experience.interval(errors(at_half, None, TOTAL), TOTAL, short) is None
    assert experience.interval(errors(at_half, None, CHANGE), CHANGE, short) is not None


def test_a_record_unlike_the_set_is_told_to_be_so(at_half) -> None:
    time = np.arange(0.0, 60.0, 0.02)
    slow = GroundMotion(np.sin(2.0 * np.pi * time / 7.0) * np.sin(np.pi * time / 60.0), 0.02, "slow")
    told = forecast(slow.scaled_to_pgv(500.0), Methods(), at_half)
    (remark,) = (one for one in told.remarks if "beyond the records" in one)
    assert "over the PGV of" in remark


@pytest.mark.slow
def test_the_spectrum_narrows_the_interval_and_it_still_holds(at_half) -> None:
    methods = Methods()
    knowing, alone = coverage([at_half], None, DISPLACEMENT, methods), coverage([at_half], None, DISPLACEMENT)
    assert 0.87 < knowing.mean < 0.96
    assert knowing.width < alone.width
    # without records at hand it is the interval of all
    bare = [replace(case, motion=None) for case in at_half]
    assert coverage([bare], None, DISPLACEMENT, methods) == alone
