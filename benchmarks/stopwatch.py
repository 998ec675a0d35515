"""Times of several tasks, taken in turn so that a change of the machine's pace falls on all of them alike."""

from collections.abc import Callable, Sequence
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

Seconds = NDArray[np.float64]


def once(task: Callable[[], object]) -> float:
    """Return the time that a task takes [s]."""
    began = perf_counter()
    task()
    return perf_counter() - began


def in_turn(watches: Sequence[Callable[[], float]], rounds: int) -> Seconds:
    """Return the times [s] of each watch in each round, shape (watches, rounds).

    A watch runs its task once and returns how long that took. Two rounds before the first are not counted.
    """
    times = np.array([[watch() for watch in watches] for _ in range(rounds + 2)])
    return times[2:].T


def ratio(numerator: Seconds, denominator: Seconds) -> float:
    """Median over the rounds of the ratio of two times of the same round."""
    return float(np.median(numerator / denominator))


def microseconds(times: Seconds) -> float:
    """Median time [us]."""
    return 1e6 * float(np.median(times))
