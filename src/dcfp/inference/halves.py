"""Halves of a set of records, of which no earthquake is in both."""

from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

#: Splits that a coverage or a refit is judged by, and where their random numbers start.
SPLITS, SEED = 200, 2020


def halves(events: Sequence[str], splits: int = SPLITS, seed: int = SEED) -> Iterator[NDArray[np.bool_]]:
    """Yield random halves of cases: True where a case is for training, False where it is held out.

    Components and stations of one earthquake resemble each other, so that an earthquake goes into one half as a whole.
    Earthquakes are taken in random order until half of the cases is reached.

    Parameters
    ----------
    events
        The earthquake of each case.
    splits
        How many.
    seed
        Of the random numbers; the same seed gives the same halves.
    """
    numbers = np.random.default_rng(seed)
    names, of_case, sizes = np.unique(np.asarray(events), return_inverse=True, return_counts=True)
    for _ in range(splits):
        order = numbers.permutation(names.size)
        before = np.cumsum(sizes[order]) - sizes[order]
        chosen = np.zeros(names.size, dtype=np.bool_)
        chosen[order] = before < 0.5 * sizes.sum()
        yield chosen[of_case]
