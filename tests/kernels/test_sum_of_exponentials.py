"""The sum of exponentials against the kernel that they stand for."""

import itertools
import math

import numpy as np
import pytest

from dcfp.kernels.sum_of_exponentials import (
    MODES,
    RATE_RATIO,
    accumulate,
    fill_decay,
    fill_weights,
    half_space_modes,
    total,
)

RATES, WEIGHTS, STATE, STEP = 0, 1, 2, 3
BOUND = 2.0 * math.sqrt(2.0) * math.exp(-(math.pi**2) / math.log(RATE_RATIO))


def cold_rows():
    rates, weights, instant = half_space_modes()
    rows = np.zeros((6, MODES))
    rows[RATES], rows[WEIGHTS] = rates, weights
    return rows, instant


@pytest.mark.parametrize(
    ("first", "last", "allowed"), [(6e-3, 20.0, 1.02 * BOUND), (4e-3, 100.0, 2.7e-4), (100.0, 300.0, 1e-3)]
)
def test_modes_sum_to_the_half_order_kernel_within_the_stated_bound(first, last, allowed):
    rates, weights, _ = half_space_modes()
    times = np.geomspace(first, last, 2000)
    modes = (weights * np.exp(-rates * times[:, None])).sum(axis=1)
    error = np.abs(modes * np.sqrt(times) - 1.0)
    assert error.max() < allowed
    assert error.max() > 0.3 * BOUND  # the bound is tight, not generous


def test_the_bound_is_that_of_the_trapezoidal_rule():
    assert pytest.approx(2.1e-4, rel=0.05) == BOUND


@pytest.mark.parametrize("step", [1e-9, 1e-5, 1e-3, 0.01, 0.5])
def test_decay_by_squaring_is_the_exponential(step):
    rows, _ = cold_rows()
    fill_decay(rows, RATES, step, STEP)
    np.testing.assert_allclose(rows[STEP], np.exp(-rows[RATES] * step), rtol=2e-6, atol=1e-12)


@pytest.mark.parametrize("step", [1e-6, 1e-3, 0.01])
def test_constant_flux_heats_as_the_square_root_of_time(step):
    rows, instant = cold_rows()
    fill_decay(rows, RATES, step, STEP)
    fill_weights(rows, RATES, WEIGHTS, step, STEP)
    steps = 4000
    for _ in range(steps):
        accumulate(rows, STEP, STATE, 1.0, 1.0)
    rise = total(rows, STATE) + instant
    assert rise == pytest.approx(2.0 * math.sqrt(steps * step), rel=2e-4)


def test_rising_flux_heats_as_the_three_halves_power_of_time():
    rows, instant = cold_rows()
    step, steps = 0.01, 500
    fill_decay(rows, RATES, step, STEP)
    fill_weights(rows, RATES, WEIGHTS, step, STEP)
    for i in range(steps):
        accumulate(rows, STEP, STATE, i * step, (i + 1) * step)
    time = steps * step
    assert total(rows, STATE) + instant * time == pytest.approx(4.0 / 3.0 * time**1.5, rel=1e-4)


def test_steps_of_any_partition_give_the_same_heat():
    time = 0.37

    def heat(parts):
        rows, _ = cold_rows()
        edges = np.concatenate(([0.0], np.cumsum(parts) / np.sum(parts) * time))
        for start, end in itertools.pairwise(edges):
            fill_decay(rows, RATES, end - start, STEP)
            fill_weights(rows, RATES, WEIGHTS, end - start, STEP)
            accumulate(rows, STEP, STATE, 3.0 - 2.0 * start, 3.0 - 2.0 * end)
        return total(rows, STATE)

    whole = heat([1.0])
    assert heat(np.random.default_rng(1).uniform(0.01, 1.0, 77)) == pytest.approx(whole, rel=1e-7)
    assert heat([1e-7, 1.0, 1e-9]) == pytest.approx(whole, rel=1e-7)
