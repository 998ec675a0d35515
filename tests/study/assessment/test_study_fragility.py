"""Fragilities: the interval fit against SciPy and against known parameters, and what cannot be fitted."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import CensoredData, lognorm

from dcfp.errors import InputError
from dcfp.study.assessment import fragility
from dcfp.study.assessment.fragility_fit import (
    can_be_fitted,
    drawn_counts,
    first_exceedance,
    fit_lognormal,
    lognormal_probability,
)
from dcfp.study.assessment.selection import remarks_of

GRID = np.array([0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0])


def intervals(values: np.ndarray, grid: np.ndarray = GRID) -> tuple[np.ndarray, np.ndarray]:
    """Return between which intensities values lie."""
    place = np.searchsorted(grid, values)
    return np.concatenate(([0.0], grid))[place], np.concatenate((grid, [np.inf]))[place]


def fitted(lower: np.ndarray, upper: np.ndarray) -> tuple[float, float]:
    median, dispersion = fit_lognormal(lower, upper, np.ones((1, lower.size)))
    return float(median[0]), float(dispersion[0])


# ----- the fit -----


@pytest.mark.parametrize("seed", range(5))
def test_the_fit_is_that_of_scipy(seed):
    values = 1.1 * np.exp(0.45 * np.random.default_rng(seed).standard_normal(44))
    lower, upper = intervals(values)
    left, right = lower == 0.0, np.isinf(upper)
    data = CensoredData(
        left=upper[left], right=lower[right], interval=np.column_stack((lower, upper))[~left & ~right]
    )
    shape, _, scale = lognorm.fit(data, floc=0.0)
    # SciPy stops when its simplex is 1e-4 wide
    assert fitted(lower, upper) == pytest.approx((scale, shape), rel=1e-3)


def test_known_parameters_come_back():
    """10000 values: the standard errors are beta / sqrt(n) = 0.004 of ln(theta) and about 0.7 % of beta; four of each are allowed."""
    values = 0.9 * np.exp(0.4 * np.random.default_rng(1).standard_normal(10_000))
    median, dispersion = fitted(*intervals(values))
    assert median == pytest.approx(0.9, rel=4.0 * 0.004)
    assert dispersion == pytest.approx(0.4, rel=4.0 * 0.009)


def test_no_other_parameters_are_more_likely():
    lower, upper = intervals(np.exp(0.5 * np.random.default_rng(3).standard_normal(30)))
    median, dispersion = fitted(lower, upper)

    def likelihood(theta: float, beta: float) -> float:
        return float(
            np.log(
                lognormal_probability(upper, theta, beta) - lognormal_probability(lower, theta, beta)
            ).sum()
        )

    best = likelihood(median, dispersion)
    for by_median in (-1e-3, 0.0, 1e-3):
        for by_dispersion in (-1e-3, 0.0, 1e-3):
            assert likelihood(median * (1.0 + by_median), dispersion * (1.0 + by_dispersion)) <= best + 1e-9


@settings(max_examples=60, derandomize=True)
@given(
    seed=st.integers(0, 10_000),
    number=st.integers(4, 60),
    theta=st.floats(0.3, 1.8),
    beta=st.floats(0.05, 1.2),
    scale=st.floats(1e-3, 1e6),
)
def test_the_fit_is_finite_where_it_should_be_and_knows_no_unit(seed, number, theta, beta, scale):
    lower, upper = intervals(theta * np.exp(beta * np.random.default_rng(seed).standard_normal(number)))
    weights = np.ones((1, number))
    median, dispersion = fit_lognormal(lower, upper, weights)
    assert np.isfinite(median[0]) == np.isfinite(dispersion[0]) == can_be_fitted(lower, upper, weights)[0]
    if np.isfinite(median[0]):
        assert dispersion[0] > 0.0
        other, same = fit_lognormal(scale * lower, scale * upper, weights)
        assert other[0] == pytest.approx(scale * median[0], rel=1e-6)
        assert same[0] == pytest.approx(dispersion[0], rel=1e-6)


def test_weights_are_repetitions():
    lower, upper = intervals(np.array([0.4, 0.6, 0.9, 1.3, 1.8]))
    weights = np.array([[2.0, 1.0, 3.0, 0.0, 1.0]])
    repeated = np.repeat(np.arange(5), weights[0].astype(int))
    expected = fitted(lower[repeated], upper[repeated])
    median, dispersion = fit_lognormal(lower, upper, weights)
    assert (median[0], dispersion[0]) == pytest.approx(expected, rel=1e-9)


# ----- the intervals -----


def test_a_record_is_between_two_intensities_or_beyond_an_end():
    values = np.array([[5.0, 6.0, 7.0], [1.0, 6.0, 2.0], [1.0, 2.0, 3.0], [1.0, np.nan, 6.0], [np.nan] * 3])
    found = first_exceedance(np.array([1.0, 2.0, 3.0]), values, 4.0)
    np.testing.assert_array_equal(found.lower, [0.0, 1.0, 3.0, 1.0])
    np.testing.assert_array_equal(found.upper, [1.0, 2.0, np.inf, 3.0])
    assert found.returns == 1


def test_what_is_at_the_capacity_does_not_exceed_it():
    found = first_exceedance(np.array([1.0, 2.0]), np.array([[4.0, 4.1]]), 4.0)
    assert (found.lower[0], found.upper[0]) == (1.0, 2.0)


def test_a_record_at_the_capacity_is_not_counted_among_those_beyond_it(build):
    study = build({"record": 8, "pgv": [200.0, 400.0, 600.0]}, strength=np.linspace(0.5, 1.5, 8))
    values = study["peak_displacement"].to_numpy()
    found = fragility(study, float(values[3, 1]), draws=10)
    np.testing.assert_array_equal(found["fraction"][0], (values > values[3, 1]).mean(axis=0))
    assert float(found["fraction"][0, 1]) == 0.5


# ----- the whole -----


@pytest.mark.slow
def test_the_fragility_of_a_study_is_that_of_its_formula(build):
    """y = 0.1 e pgv^1.2 reaches the capacity at pgv = (capacity / (0.1 e))^(1/1.2): median of 10 capacity, to the 1/1.2, and a dispersion of that of e over 1.2."""
    strength = np.exp(0.36 * np.random.default_rng(8).standard_normal(2000))
    study = build({"record": 2000, "pgv": np.arange(200.0, 2401.0, 200.0)}, strength=strength)
    found = fragility(study, 600.0, draws=10)
    theta, beta = 6000.0 ** (1.0 / 1.2), 0.36 / 1.2
    # four standard errors of 2000 records
    assert float(found["median"][0]) == pytest.approx(theta, rel=4.0 * beta / np.sqrt(2000.0))
    assert float(found["dispersion"][0]) == pytest.approx(beta, rel=4.0 / np.sqrt(4000.0))


def test_curve_fractions_and_bounds_belong_together(records):
    found = fragility(records, [300.0, 600.0, 900.0])
    assert (np.diff(found["median"]) > 0.0).all()
    curve = found["probability"].to_numpy()
    assert (np.diff(curve, axis=1) >= 0.0).all()
    assert (curve[:, 0] == 0.0).all()
    low, high = found["probability_bound"].transpose("bound", ...).to_numpy()
    assert (low <= high).all()
    for name in ("median", "dispersion"):
        ends = found[f"{name}_bound"].to_numpy()
        assert ((ends[:, 0] < found[name]) & (found[name] < ends[:, 1])).all()
    values = records["peak_displacement"].isel(radius=0).to_numpy()
    np.testing.assert_allclose(found["fraction"].sel(capacity=600.0), (values > 600.0).mean(axis=0))
    # the curve is at one half where the median is
    middle = np.interp(float(found["median"][1]), found["pgv_of_curve"], curve[1])
    assert middle == pytest.approx(0.5, abs=2e-4)
    # and within what 40 records can say of what is observed
    at = np.interp(found["pgv"], found["pgv_of_curve"], curve[1])
    assert np.abs(at - found["fraction"].to_numpy()[1]).max() < 0.15


def test_the_same_seed_gives_the_same_bounds_and_another_does_not(records):
    first, again, other = (fragility(records, seed=seed)["median_bound"] for seed in (1, 1, 2))
    assert first.identical(again)
    assert (first != other).any()


def test_whole_earthquakes_are_drawn():
    counts = drawn_counts(np.array(["b", "a", "b", "c"]), 50, 1)
    assert (counts[0] == 1.0).all()
    np.testing.assert_array_equal(counts[:, 0], counts[:, 2])
    np.testing.assert_array_equal(counts[:, 0] + counts[:, 1] + counts[:, 3], np.full(51, 3.0))


def test_components_of_one_earthquake_make_it_less_sure(build, strengths):
    """Each of 10 records twice says no more than once, which the draws of earthquakes know, and draws of records do not."""
    doubled = np.repeat(strengths[:10], 2)
    grid = {"record": 20, "pgv": np.arange(200.0, 2401.0, 200.0)}
    events = [f"E{i // 2}" for i in range(20)]

    def width(**more) -> float:
        low, high = fragility(build(grid, strength=doubled, **more))["median_bound"].to_numpy()[0]
        return float(np.log(high / low))

    assert width(events=events) == pytest.approx(np.sqrt(2.0) * width(), rel=0.1)


def test_further_dispersions_are_added_in_squares_and_leave_the_median(records):
    alone, both = fragility(records), fragility(records, further_dispersions={"design": 0.2, "model": 0.3})
    assert float(both["median"][0]) == float(alone["median"][0])
    assert float(both["dispersion"][0]) == float(alone["dispersion"][0])
    expected = np.sqrt(float(alone["dispersion"][0]) ** 2 + 0.2**2 + 0.3**2)
    assert float(both["total_dispersion"][0]) == pytest.approx(expected)
    assert both.attrs["further_dispersions"] == "design 0.2, model 0.3"
    curve = lognormal_probability(both["pgv_of_curve"].to_numpy(), float(both["median"][0]), expected)
    np.testing.assert_allclose(both["probability"][0], curve)


def test_the_capacity_is_that_of_the_study_unless_another_is_given(records):
    assert fragility(records)["capacity"].item() == 600.0
    assert fragility(records, 700.0)["capacity"].item() == 700.0


def test_one_capacity_without_a_fit_leaves_the_others(records):
    found = fragility(records, [600.0, 9000.0])
    assert np.isfinite(found["median"]).to_numpy().tolist() == [True, False]
    assert any(
        "9000 mm: none of the 40 records exceeds it up to 2 m/s" in remark for remark in remarks_of(found)
    )


def test_few_earthquakes_have_no_bounds(records):
    study = records.isel(record=slice(6))
    found = fragility(study)
    assert np.isfinite(found["median"][0])
    assert np.isnan(found["median_bound"]).all()
    assert any("cannot be said from 3 earthquakes" in remark for remark in remarks_of(found))


def test_what_is_done_and_what_is_not_is_said(records):
    said = fragility(records).attrs["remarks"]
    assert "the same records are used at every intensity" in said
    assert "SSF" in said


def test_records_that_return_are_counted(records):
    study = records.copy(deep=True)
    study["peak_displacement"][4, 9, 0] = 1.0
    assert any(
        "1 of the records exceed it and are within it again" in one for one in remarks_of(fragility(study))
    )


@pytest.mark.parametrize(
    ("change", "options", "told"),
    [
        ({}, {"capacity": 1e5}, "none of the 40 records exceeds it up to 2 m/s, which is only a lower bound"),
        ({}, {"capacity": 1.0}, "all of the 40 records exceed it at 0.2 m/s, the lowest intensity, already"),
        ({"pgv": [0, 9]}, {"capacity": 300.0}, "too far apart to see a dispersion between 0.2 m/s and 2 m/s"),
        ({"record": [0, 1, 2]}, {}, "needs at least 4 records, and here are 3"),
        ({}, {"capacity": -600.0}, "must be a positive number, not -600"),
        ({}, {"capacity": []}, "at least one capacity"),
        ({}, {"quantity": "force_ratio"}, "A fragility of force_ratio needs a capacity"),
        ({}, {"confidence": 1.0}, "must lie between 0 and 1"),
        ({}, {"draws": 0}, "drawn at least once"),
        (
            {},
            {"further_dispersions": {"model": -0.1}},
            "The dispersion model must be zero or a positive number",
        ),
    ],
)
def test_what_cannot_be_fitted_is_said_in_one_sentence(records, change, options, told):
    with pytest.raises(InputError) as error:
        fragility(records.isel(change), **options)
    assert told in str(error.value)


def test_a_range_that_is_too_narrow_is_said(build):
    study = build({"record": 8, "pgv": [400.0, 401.0]}, strength=[0.5, 2.0] * 4)
    with pytest.raises(InputError, match=r"at the lowest intensity or not at all up to 0\.401 m/s; widen"):
        fragility(study, 140.0)


def test_a_study_without_a_capacity_needs_one(build, strengths):
    study = build({"record": 40, "pgv": [400.0, 800.0, 1200.0]}, strength=strengths, capacity=None)
    with pytest.raises(InputError, match="A fragility of peak_displacement needs a capacity"):
        fragility(study)
    assert np.isfinite(fragility(study, 300.0)["median"][0])
