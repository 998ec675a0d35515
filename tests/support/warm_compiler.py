"""Compile nothing worth mentioning: the first function takes half a second, whatever it is, and what forks from here need not wait for it."""

import numba


@numba.njit("float64(float64)")
def _nothing(value: float) -> float:
    return value
