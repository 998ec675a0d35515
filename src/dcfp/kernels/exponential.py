"""The exponential of a negative number, in line.

A call into the mathematical library waits for itself and makes the compiled code put aside all that it has at hand; in
the march, where each step waits for a coefficient of friction, that is a twentieth of the time.
"""

import math

import numpy as np

from dcfp.kernels._jit import kernel

_PARTS = 128  # of one; a power of two
_LARGEST = 700.0
_WHOLE = np.exp(-np.arange(_LARGEST + 1.0))
_PART = np.exp(-np.arange(_PARTS) / _PARTS)
#: A number so large that what is added to it loses its fraction.
_NO_FRACTION = 1.5 * 2.0**52


@kernel
def fading(x: float) -> float:
    """Return exp(-x), within three units of the last place; quick for x from 0 to 700."""
    if not 0.0 <= x < _LARGEST:
        return math.exp(-x)
    nearest = (_PARTS * x + _NO_FRACTION) - _NO_FRACTION
    n = int(nearest)
    r = nearest * (1.0 / _PARTS) - x
    square = r * r
    near = (1.0 + r) + square * ((0.5 + r * (1.0 / 6.0)) + square * (1.0 / 24.0 + r * (1.0 / 120.0)))
    return (_WHOLE[n // _PARTS] * _PART[n % _PARTS]) * near
