"""From periods and damping to what the kernel of the oscillators takes."""

from functools import lru_cache
from itertools import pairwise

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.kernels import oscillators as k
from dcfp.motion.ground_motion import GroundMotion

#: Periods of a spectrum unless others are asked for [s].
PERIODS = freeze(np.geomspace(0.05, 10.0, 200))
#: Ratio of critical damping unless another is asked for [-].
DAMPING = 0.05
#: Steps in a period, below which the record's own step is divided: with them the largest displacement is within 0.7 % of that with many
#: more in the worst of 20 000 cases, and within 0.002 % in half of them.
_STEPS_IN_PERIOD = 10
#: Steps in a period from which on the largest displacement is looked for at the samples alone; in the worst of those cases it is within 0.25 %.
_SLOW = 100
#: Number of oscillators that a processor takes at once; what does not fill it costs as if it did.
_AT_ONCE = 8
#: Angle in a step up to which the response is summed as a series of so many terms, to the last digit.
_SERIES, _TERMS = 0.5, 16
#: Least and longest period [s].
SHORTEST, LONGEST = 0.01, 100.0


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
    damped = omega * np.sqrt(1.0 - damping**2)
    fade = np.exp(-damping * omega * step)
    sine, cosine = fade * np.sin(damped * step), fade * np.cos(damped * step)
    rows = np.empty((k.COEFFICIENTS, omega.size))
    # free vibration from a displacement and from a velocity
    rows[k.UU] = cosine + damping * omega / damped * sine
    rows[k.UV] = sine / damped
    rows[k.VU] = -(omega**2) * rows[k.UV]
    rows[k.VV] = cosine - damping * omega / damped * sine
    # response to an acceleration of one, and to one that grows from zero to one over the step
    risen = 1.0 - rows[k.UU]
    constant, growing = _series(omega * step, damping)
    slow = omega * step < _SERIES
    rows[k.UA] = -np.where(slow, constant, risen) / omega**2
    ramp = 1.0 - (rows[k.UV] + 2.0 * damping / omega * risen) / step
    rows[k.UC] = -np.where(slow, growing, ramp) / omega**2
    rows[k.VA] = -rows[k.UV]
    rows[k.VC] = rows[k.UA] / step
    rows[k.SQUARE] = omega**2
    rows[k.DAMPING] = 2.0 * damping * omega
    return freeze(rows)


def _series(angle: FloatArray, damping: float) -> tuple[FloatArray, FloatArray]:
    """Return omega squared times the response to a constant and to a growing acceleration [-], where the closed form would cancel.

    `angle` is omega times the step. The impulse response is a power series whose coefficients follow from the equation of motion.
    """
    constant, growing = np.zeros_like(angle), np.zeros_like(angle)
    before, one = 0.0, 1.0  # coefficients of the powers n - 1 and n
    power = angle**2
    for n in range(1, _TERMS):
        constant += one * power / (n + 1)
        growing += one * power / ((n + 1) * (n + 2))
        before, one = one, -(2.0 * damping * n * one + before) / (n * (n + 1))
        power = power * angle
    return constant, growing


def pieces(motion: GroundMotion, periods: FloatArray) -> list[tuple[slice, int]]:
    """Return groups of periods, and into how many parts the record's step is divided for each.

    The step must be short beside the period for the largest displacement to be seen, and need not be shorter for the others. A group
    ends where the processor's registers are full, so that some periods get a finer step than they need. A group of zero parts is of periods so
    long that its largest displacement is seen at the samples themselves.
    """
    least = np.ceil(_STEPS_IN_PERIOD * motion.time_step / periods * (1.0 - 1e-12))
    parts = (2 ** np.ceil(np.log2(np.maximum(least, 1.0)))).astype(np.int64)
    parts[periods >= _SLOW * motion.time_step] = 0
    ends = -(-(np.flatnonzero(np.diff(parts)) + 1) // _AT_ONCE) * _AT_ONCE
    edges = [0, *np.unique(ends[ends < periods.size]).tolist(), periods.size]
    return [(slice(a, b), int(parts[a])) for a, b in pairwise(edges)]
