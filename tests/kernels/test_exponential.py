"""The exponential in line against the library's."""

import math

import numpy as np

from dcfp.kernels.sum_of_exponentials import exp_neg


def test_it_is_the_exponential_to_three_units_of_the_last_place():
    values = np.concatenate((np.linspace(0.0, 700.0, 20_011), np.geomspace(1e-12, 700.0, 5_003)))
    ours = np.array([exp_neg(value) for value in values])
    np.testing.assert_allclose(ours, np.exp(-values), rtol=3.0 * np.finfo(float).eps)


def test_outside_its_table_it_is_the_librarys():
    assert exp_neg(0.0) == 1.0
    assert exp_neg(-2.5) == math.exp(2.5)
    assert exp_neg(720.0) == math.exp(-720.0)
    assert exp_neg(1e4) == 0.0
    assert math.isnan(exp_neg(math.nan))
