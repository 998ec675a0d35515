"""Sizes of units against Pint, which has them from elsewhere."""

import numpy as np
import pytest

from dcfp.schema import units
from dcfp.schema.units import Unit, convert

UNITS = {name: one for name, one in vars(units).items() if isinstance(one, Unit) and one.has_dimension}


@pytest.mark.parametrize("name", UNITS)
def test_a_unit_is_as_large_as_pint_says(name: str) -> None:
    one = UNITS[name]
    values = np.array([-40.0, 0.0, 1.0, 180.0])
    expected = [convert(value, one.text, one.inner_unit, name) for value in values]
    np.testing.assert_allclose(one.inner(values), expected, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(one.shown(one.inner(values)), values, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("name", UNITS)
def test_what_may_be_meant_is_as_large_as_pint_says(name: str) -> None:
    for other, size in UNITS[name].meant:
        assert convert(1.0, other, UNITS[name], name) == pytest.approx(size, rel=1e-9)
