"""How often intervals from one half of the earthquakes hold the cases of the other."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.case import Case
from dcfp.inference.conditional import Experience, Regression
from dcfp.inference.statistics import errors, interval
from dcfp.methods.method import Variant
from dcfp.methods.prediction import Methods
from dcfp.schema.quantities import Quantity

#: Splits that a coverage is judged by, and where their random numbers start.
SPLITS, SEED = 200, 2020


@dataclass(frozen=True)
class Coverage:
    """How often intervals from one half of the earthquakes hold the cases of the other [-].

    `low` and `high` are the splits at 5 and 95 %; the width is the upper over the lower end, geometric mean
    [-].
    """

    mean: float
    low: float
    high: float
    width: float
    splits: int


def coverage(
    groups: Iterable[Sequence[Case]],
    variant: Variant | None,
    quantity: Quantity,
    methods: Methods | None = None,
) -> Coverage:
    """Return how well intervals from half of the earthquakes cover the other half.

    Parameters
    ----------
    groups
        The same records at one PGV after the other.
    variant, quantity
        As in `errors`.
    methods
        By which the cases were predicted, for intervals that know the spectrum of each record; None for those from all others alike.

    Raises
    ------
    InputError
        If there is no case, a half has too few, or nothing is left for the other half.
    """
    groups = list(groups)
    if not groups:
        msg = "A coverage needs at least one group of cases."
        raise InputError(msg)
    known = [_Group.of(cases, variant, quantity, methods) for cases in groups]
    inside: list[float] = []
    widths: list[float] = []
    for training in grouped_splits(known[0].events):
        held_out = [group.held_out(training) for group in known]
        if sum(one.size for one, _ in held_out) == 0:
            msg = "A coverage needs cases of several earthquakes, none of them more than half of the cases."
            raise InputError(msg)
        inside.append(float(np.concatenate([one for one, _ in held_out]).mean()))
        widths.append(float(np.mean([width for _, width in held_out])))
    covered = np.array(inside)
    low, high = np.quantile(covered, [0.05, 0.95])
    return Coverage(
        float(covered.mean()), float(low), float(high), math.exp(float(np.mean(widths))), covered.size
    )


@dataclass(frozen=True, eq=False)
class _Group:
    """The cases of one PGV: how far a method is off, their earthquakes, and what is known of them, shape (cases, columns), where that counts."""

    errors: FloatArray
    events: list[str]
    known: FloatArray | None

    @classmethod
    def of(
        cls, cases: Sequence[Case], variant: Variant | None, quantity: Quantity, methods: Methods | None
    ) -> "_Group":
        known = None if methods is None else Experience.of_cases(cases, methods).of_quantity(quantity)
        return cls(errors(cases, variant, quantity), [case.event for case in cases], known)

    def held_out(self, training: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], float]:
        """Return which of the cases that are not for training are inside of their intervals, and the mean width of these in logarithms."""
        there = np.isfinite(self.errors)
        learnt, judged = training & there, ~training & there
        values = self.errors[judged]
        regression = None
        if self.known is not None:
            names = [event for event, one in zip(self.events, learnt, strict=True) if one]
            regression = Regression.of(self.errors[learnt], self.known[learnt], names)
        if regression is None or self.known is None:
            part = interval(self.errors[learnt])
            low, high = np.full((2, values.size), [[math.log(part.low)], [math.log(part.high)]])
        else:
            low, _, high = regression.ends(self.known[judged])
        width = float(np.mean(high - low)) if values.size else 0.0
        return (low <= values) & (values <= high), width


def grouped_splits(
    events: Sequence[str], splits: int = SPLITS, seed: int = SEED
) -> Iterator[NDArray[np.bool_]]:
    """Yield random halves of cases by their earthquakes: True where a case is for training, False where it is held out.

    Components and stations of one earthquake resemble each other, so that an earthquake goes into one half as
    a whole. Earthquakes are taken in random order until half of the cases is reached.

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
