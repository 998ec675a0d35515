"""Array types that the whole package shares."""

from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

FloatArray: TypeAlias = NDArray[np.float64]
IntArray: TypeAlias = NDArray[np.intp]


def freeze(array: NDArray[np.floating[Any]]) -> FloatArray:
    """Return a contiguous read-only float copy, so that a result cannot be changed by accident."""
    copy = np.array(array, dtype=np.float64, order="C")
    copy.flags.writeable = False
    return copy
