"""From periods and damping to what the kernel of the oscillators takes."""

from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
from scipy import linalg

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.kernels import oscillators as k
from dcfp.record.ground_motion import GroundMotion

#: Periods of a spectrum unless others are asked for [s].
PERIODS = freeze(np.geomspace(0.05, 10.0, 200))
#: Ratio of critical damping unless another is asked for [-].
DAMPING = 0.05
#: Steps in a period, below which the record's own step is divided: with them the largest displacement is within 0.7 % of that with many
#: more in the worst of 20 000 cases, and within 0.002 % in half of them.
_STEPS_IN_PERIOD = 10
#: Steps in a period from which on the largest displacement is looked for at the samples alone; in the worst of those cases it is within 0.25 %.
_SLOW = 100
#: Least and longest period [s].
SHORTEST, LONGEST = 0.01, 100.0

_linalg: Any = linalg


def checked(periods: FloatArray, damping: float) -> FloatArray:
    """Return periods as an array.

    Raises
    ------
    InputError
        If there is none, or one is out of range, or they do not increase, or the damping is not from 0 to below 1.
    """
    values = np.atleast_1d(np.asarray(periods, dtype=np.float64))
    if values.ndim != 1 or values.size == 0 or not np.isfinite(values).all():
        msg = "A spectrum needs a row of periods, each a finite number of seconds."
        raise InputError(msg)
    if values[0] < SHORTEST or values[-1] > LONGEST or (np.diff(values) <= 0.0).any():
        msg = (
            f"The periods of a spectrum must increase, from {SHORTEST:g} s at least to {LONGEST:g} s at most."
        )
        raise InputError(msg)
    if not 0.0 <= damping < 1.0:
        msg = f"The damping must be a ratio of critical damping from 0 to below 1, not {damping!r}."
        raise InputError(msg)
    return values


def coefficients(periods: FloatArray, damping: float, step: float) -> FloatArray:
    """Return the kernel's coefficients for a step [s], shape (COEFFICIENTS, periods): exact for an acceleration that is linear over it."""
    return _coefficients(periods.tobytes(), damping, step)


@lru_cache(maxsize=64)
def _coefficients(periods: bytes, damping: float, step: float) -> FloatArray:
    omega = 2.0 * np.pi / np.frombuffer(periods, dtype=np.float64)
    # u, v, the acceleration and its change over the step, which grows in from zero to one step's worth
    matrix = np.zeros((omega.size, 4, 4))
    matrix[:, 0, 1] = step
    matrix[:, 1, 0] = -(omega**2) * step
    matrix[:, 1, 1] = -2.0 * damping * omega * step
    matrix[:, 1, 2] = -step
    matrix[:, 2, 3] = 1.0
    over = np.asarray(_linalg.expm(matrix), dtype=np.float64)
    rows = np.empty((k.COEFFICIENTS, omega.size))
    rows[k.UU : k.VU] = over[:, 0, :].T
    rows[k.VU : k.SQUARE] = over[:, 1, :].T
    rows[k.SQUARE] = omega**2
    rows[k.DAMPING] = 2.0 * damping * omega
    return freeze(rows)


def pieces(motion: GroundMotion, periods: FloatArray) -> list[tuple[slice, int]]:
    """Return groups of periods, and into how many parts the record's step is divided for each.

    The step must be short beside the period for the largest displacement to be seen, and need not be shorter for the others. A group of
    zero parts is of periods so long that its largest displacement is seen at the samples themselves.
    """
    least = np.ceil(_STEPS_IN_PERIOD * motion.time_step / periods * (1.0 - 1e-12))
    parts = (2 ** np.ceil(np.log2(np.maximum(least, 1.0)))).astype(np.int64)
    parts[periods >= _SLOW * motion.time_step] = 0
    edges = [0, *(np.flatnonzero(np.diff(parts)) + 1).tolist(), periods.size]
    return [(slice(a, b), int(parts[a])) for a, b in pairwise(edges)]


def refined(acceleration: FloatArray, parts: int) -> FloatArray:
    """Return the same piecewise linear motion with `parts` steps in place of one."""
    if parts <= 1:
        return acceleration
    places = np.arange((acceleration.size - 1) * parts + 1) / parts
    return np.interp(places, np.arange(acceleration.size), acceleration)
