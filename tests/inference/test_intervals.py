"""Halves by earthquake, the quantile rule, intervals and their coverage."""

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dcfp.errors import InputError
from dcfp.inference.coverage import SPLITS, coverage, grouped_splits
from dcfp.inference.statistics import errors, fewest, interval, quantile
from dcfp.methods import Prediction
from dcfp.methods.li_2020.constants import PULSE
from dcfp.methods.method import Information, Variant
from dcfp.methods.pulses import CHANGE, DISPLACEMENT, TOTAL

VIEW = Variant(PULSE, Information.BLIND)
SEARCH = settings(max_examples=100, deadline=None, derandomize=True)
event_lists = st.lists(st.sampled_from("abcdefghij"), min_size=1, max_size=60)


# ----- halves -----


@SEARCH
@given(events=event_lists, seed=st.integers(0, 2**32 - 1))
def test_no_earthquake_is_in_both_halves(events: list[str], seed: int) -> None:
    largest = max(events.count(event) for event in events)
    for training in grouped_splits(events, 5, seed):
        inside = {event for event, chosen in zip(events, training, strict=True) if chosen}
        outside = {event for event, chosen in zip(events, training, strict=True) if not chosen}
        assert not inside & outside
        # half is reached, and by no more than the last earthquake passed
        assert 0.5 * len(events) <= training.sum() < 0.5 * len(events) + largest


def test_the_same_seed_gives_the_same_halves_and_another_does_not() -> None:
    events = list("aabbbcddefgghhij")
    first, again, other = (np.array(list(grouped_splits(events, seed=seed))) for seed in (1, 1, 2))
    assert first.shape == (SPLITS, len(events))
    np.testing.assert_array_equal(first, again)
    assert (first != other).any()


def test_every_earthquake_is_about_as_often_in_either_half() -> None:
    part = np.mean(list(grouped_splits([str(i) for i in range(20)], 2000)), axis=0)
    assert part.min() > 0.45
    assert part.max() < 0.55


# ----- quantile -----


@pytest.mark.parametrize("number", [19, 30, 57])
@pytest.mark.parametrize("part", [0.05, 0.3, 0.5, 0.95])
def test_the_next_value_is_below_the_quantile_as_often_as_it_says(number: int, part: float) -> None:
    """Of uniform numbers the chance to be below x is x, so the mean of the quantile is the part itself; 20000 samples leave 4 sigma."""
    samples = np.random.default_rng(7).random((20_000, number))
    mean = np.mean([quantile(sample, part) for sample in samples])
    sigma = np.sqrt(part * (1.0 - part) / (number + 2.0) / 20_000)
    assert mean == pytest.approx(part, abs=4.0 * sigma)


@pytest.mark.parametrize(("number", "rank"), [(19, 1), (39, 2), (99, 5)])
def test_whole_ranks_are_values_of_the_sample(number: int, rank: int) -> None:
    values = np.random.default_rng(3).standard_normal(number)
    assert quantile(values, 0.05) == np.sort(values)[rank - 1]
    assert quantile(values, 0.95) == pytest.approx(np.sort(values)[-rank], rel=1e-12)


@SEARCH
@given(
    values=st.lists(st.floats(-1e3, 1e3), min_size=1, max_size=40),
    parts=st.tuples(st.floats(0.0, 1.0), st.floats(0.0, 1.0)),
)
def test_quantiles_are_within_the_sample_and_in_order(
    values: list[float], parts: tuple[float, float]
) -> None:
    low, high = (quantile(np.array(values), part) for part in sorted(parts))
    assert min(values) <= low <= high <= max(values)
    assert -quantile(-np.array(values), parts[0]) == pytest.approx(
        quantile(np.array(values), 1.0 - parts[0]), abs=1e-9
    )


# ----- intervals -----


def test_an_interval_is_a_factor_about_the_prediction() -> None:
    off = np.log(np.geomspace(0.5, 2.0, fewest()))
    one, other = interval(off), interval(off, 80.0)
    assert (one.low, one.median, one.high) == pytest.approx((0.5, 1.0, 2.0))
    assert (other.low, other.median, other.high) == pytest.approx((40.0, 80.0, 160.0))
    assert one.cases == fewest()


def test_a_smaller_part_needs_a_narrower_interval() -> None:
    off = np.random.default_rng(1).standard_normal(50)
    half, most = interval(off, covered=0.5), interval(off, covered=0.9)
    assert most.low < half.low < half.median < half.high < most.high


def test_what_is_no_number_does_not_count_and_too_few_are_refused() -> None:
    off = np.concatenate((np.linspace(-1.0, 1.0, fewest()), [np.nan, np.inf, -np.inf]))
    assert interval(off).cases == fewest()
    with pytest.raises(InputError, match=r"^An interval needs at least 19 cases to rest on, not 18\.$"):
        interval(off[1:])
    with pytest.raises(InputError, match="199 cases"):
        interval(off, covered=0.99)


def test_errors_are_logarithms_of_analysis_over_prediction(make_case) -> None:
    two = Prediction(2.0, 2.0, 2.0, displacement=3.0)
    cases = [
        make_case(two, Prediction(1.0, 1.0, 1.0)),
        make_case(two, Prediction(0.0, 0.0, 0.0)),  # nothing moves by the method
        make_case(two, Prediction(np.nan, np.nan, np.nan)),
        make_case(two),  # nothing said
        make_case(Prediction(0.0, 0.0, 0.0), Prediction(1.0, 1.0, 1.0)),  # nothing to be compared with
    ]
    found = errors(cases, VIEW, CHANGE)
    assert found[0] == pytest.approx(np.log(2.0))
    assert np.isnan(found[1:]).all()
    # the change of displacement stands for the largest displacement
    assert errors(cases, VIEW, DISPLACEMENT)[0] == pytest.approx(np.log(3.0))
    assert np.isnan(errors(cases, VIEW, TOTAL)).all()
    alone = errors(cases, None, CHANGE)
    np.testing.assert_allclose(alone[:4], np.log(2.0))
    assert np.isnan(alone[4])


# ----- coverage -----


def test_intervals_cover_what_they_say(lognormal) -> None:
    """Twenty sets of 120 cases, of which each half is nine tenths within the interval from the other, but for chance."""
    found = [coverage([lognormal(120, seed)], VIEW, CHANGE) for seed in range(20)]
    assert np.mean([one.mean for one in found]) == pytest.approx(0.9, abs=0.01)
    # 90 % of a lognormal lie within exp(2 1.645 0.4)
    assert np.median([one.width for one in found]) == pytest.approx(np.exp(2.0 * 1.645 * 0.4), rel=0.1)
    for one in found:
        assert one.low <= one.mean <= one.high
        assert one.splits == SPLITS


def test_a_wrong_prediction_does_not_change_how_well_its_errors_are_known(lognormal) -> None:
    """The interval knows the bias: a prediction too large by a factor is as good as one that is right."""
    right = lognormal(60, 1)
    tenfold = [replace(case, predicted={VIEW: Prediction(1e3, 1e3, 1e3)}) for case in right]
    one, other = (coverage([cases], VIEW, CHANGE) for cases in (right, tenfold))
    assert one.mean == pytest.approx(other.mean)
    assert one.width == pytest.approx(other.width)


def test_groups_are_covered_each_with_its_own_interval(lognormal) -> None:
    """Two PGVs of which the second is off by a factor of a thousand: pooled they could not be covered by narrow intervals."""
    first, second = lognormal(60, 1), lognormal(60, 2)
    far = [replace(case, predicted={VIEW: Prediction(0.1, 0.1, 0.1)}) for case in second]
    both = coverage([first, far], VIEW, CHANGE)
    assert both.width < 10.0
    assert both.mean == pytest.approx(0.9, abs=0.05)


def test_the_training_half_must_be_enough(lognormal) -> None:
    with pytest.raises(InputError, match="at least 19 cases"):
        coverage([lognormal(30, 1)], VIEW, CHANGE)
    assert next(islice(grouped_splits([str(i) for i in range(30)]), 1)).sum() == 15


def test_a_coverage_needs_several_earthquakes(lognormal) -> None:
    cases = lognormal(60, 5)
    with pytest.raises(InputError, match="group"):
        coverage([], VIEW, CHANGE)
    one = [replace(case, event="one") for case in cases]
    with pytest.raises(InputError, match="several earthquakes"):
        coverage([one], VIEW, CHANGE)
