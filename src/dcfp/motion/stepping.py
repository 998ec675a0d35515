"""A ground motion as an analysis steps through it: followed by rest, and in finer steps."""

import math

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion

#: Longest free motion after the record that is waited for [s].
LONGEST_TAIL = 120.0
_SHORTEST_STEP = 1e-6


def check_step_and_tail(step: float | None, tail: float | None) -> None:
    """Refuse a longest step or a tail [s] that cannot be.

    Raises
    ------
    InputError
        If one of them is given and is out of range.
    """
    if tail is not None and not (math.isfinite(tail) and tail >= 0.0):
        msg = f"The tail must be zero or a positive number of seconds, not {tail!r}."
        raise InputError(msg)
    if step is not None and not (math.isfinite(step) and step >= _SHORTEST_STEP):
        msg = f"The step must be a positive number of seconds, at least a microsecond, not {step!r}."
        raise InputError(msg)


def with_tail(motion: GroundMotion, tail: float | None) -> FloatArray:
    """Return the acceleration [mm/s2] followed by none for `tail` [s], or for as long as may be waited."""
    samples = round((LONGEST_TAIL if tail is None else tail) / motion.time_step)
    return np.concatenate((motion.acceleration, np.zeros(samples)))


def parts_in(time_step: float, longest: float) -> int:
    """Return into how many parts a time step [s] is divided so that none is longer than `longest` [s]."""
    return max(1, math.ceil(time_step / longest * (1.0 - 1e-12)))


def refined(acceleration: FloatArray, parts: int) -> FloatArray:
    """Return the same piecewise linear motion with `parts` steps in place of one."""
    if parts <= 1:
        return acceleration
    change = np.diff(acceleration)
    fine = np.empty(change.size * parts + 1)
    for part in range(parts):
        fine[part:-1:parts] = acceleration[:-1] + change * (part / parts)
    fine[-1] = acceleration[-1]
    return fine
