"""Designs and distributions."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from dcfp.study import Choice, Normal, Sampling, Uniform

UNIT = {"mu": Uniform(0.0, 1.0), "radius": Uniform(0.0, 1.0), "lambda": Uniform(0.0, 1.0)}


@given(st.integers(2, 60), st.integers(0, 2**31))
def test_a_latin_hypercube_has_one_point_in_every_part_of_every_factor(count: int, seed: int) -> None:
    for values in Sampling(UNIT, count, seed=seed).values().values():
        assert sorted((values * count).astype(int).tolist()) == list(range(count))


@pytest.mark.parametrize("method", ["latin-hypercube", "sobol", "saltelli"])
def test_a_seed_gives_the_same_design_and_another_another(method: str) -> None:
    one, same, other = (Sampling(UNIT, 16, method, seed).values() for seed in (1, 1, 2))
    for name in UNIT:
        assert np.array_equal(one[name], same[name])
        assert not np.array_equal(one[name], other[name])


def test_a_sobol_design_has_one_point_in_every_part_of_a_power_of_two() -> None:
    for values in Sampling(UNIT, 64, "sobol").values().values():
        assert sorted((values * 64).astype(int).tolist()) == list(range(64))


def test_saltelli_changes_one_factor_at_a_time() -> None:
    """Base sample A, then A with each column of B, then B: what the indices are made from (Saltelli et al. 2010)."""
    values = np.array(list(Sampling(UNIT, 8, "saltelli").values().values())).T
    assert values.shape == (8 * (3 + 2), 3)
    for first, *mixed, last in values.reshape(8, 5, 3):
        for column, one in enumerate(mixed):
            expected = first.copy()
            expected[column] = last[column]
            assert np.array_equal(one, expected)


PROBABILITIES = np.linspace(0.01, 0.99, 33)


@pytest.mark.parametrize(
    ("ours", "theirs"),
    [
        (Uniform(2.0, 6.0), stats.uniform(2.0, 4.0)),
        (Uniform(2.0, 6.0, logarithmic=True), stats.loguniform(2.0, 6.0)),
        (Normal(20.0, 5.0), stats.norm(20.0, 5.0)),
        (Normal(0.075, 0.2, logarithmic=True), stats.lognorm(s=0.2, scale=0.075)),
    ],
)
def test_quantiles_are_those_of_scipy(ours, theirs) -> None:
    assert ours.at(PROBABILITIES) == pytest.approx(theirs.ppf(PROBABILITIES), rel=1e-12)


def test_a_choice_takes_each_value_as_often() -> None:
    drawn = Choice(("a", "b", "c")).at((np.arange(9) + 0.5) / 9)
    assert drawn.tolist() == ["a"] * 3 + ["b"] * 3 + ["c"] * 3
