"""Intervals about a prediction, from how far it is off in other earthquakes at the same PGV."""

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.case import Case
from dcfp.inference.statistics import ratios
from dcfp.methods.method import Variant
from dcfp.methods.pulses import value_of
from dcfp.schema.quantities import Quantity

#: Part of the cases that an interval is to cover [-].
COVERED = 0.9


def fewest(covered: float = COVERED) -> int:
    """Return how many cases an interval needs to rest on: as many that the outermost two can be its ends.

    `covered` is the part of the cases that it is to cover [-].
    """
    return math.ceil(2.0 / (1.0 - covered) - 1e-9) - 1


@dataclass(frozen=True)
class Interval:
    """Where the analysis will be found.

    Attributes
    ----------
    low, median, high
        In the unit of the quantity; `low` and `high` leave as many cases below as above, 5 % by default.
    cases
        How many cases it rests on.
    """

    low: float
    median: float
    high: float
    cases: int


@dataclass(frozen=True)
class Coverage:
    """How often intervals from one half of the earthquakes hold the cases of the other.

    Attributes
    ----------
    mean
        Part of the held-out cases inside, mean of all splits [-].
    low, high
        The same in the splits at 5 and 95 % of their order [-].
    width
        Upper over lower end of an interval, geometric mean [-].
    splits
        Number of splits.
    """

    mean: float
    low: float
    high: float
    width: float
    splits: int


def quantile(values: FloatArray, part: float) -> float:
    """Return the quantile that the next value will be below with a probability of `part` [-].

    That is the value of rank part (n + 1) among n, with straight lines in between; of fewer than the rank needs, the outermost.
    """
    ordered = np.sort(values)
    rank = min(max(part * (ordered.size + 1), 1.0), float(ordered.size))
    return float(np.interp(rank, np.arange(1, ordered.size + 1), ordered))


def errors(cases: Sequence[Case], variant: Variant | None, quantity: Quantity) -> FloatArray:
    """Return the logarithm of analysis over prediction [-], shape (cases,); not a number where nothing was predicted.

    Without a `variant` the prediction is one: what is returned is the logarithm of the analysis itself, as for an interval from the PGV alone.
    """
    if variant is None:
        found = np.array([value_of(case.analysed.whole, quantity) for case in cases])
        return np.log(found, out=np.full(found.size, np.nan), where=found > 0.0)
    found = ratios(cases, variant, quantity)
    return -np.log(found, out=np.full(found.size, np.nan), where=found > 0.0)


def interval(errors: FloatArray, predicted: float = 1.0, covered: float = COVERED) -> Interval:
    """Return the interval about a prediction, from how far others were off.

    Parameters
    ----------
    errors
        Of other cases [-], as the function of that name returns them; those that are no number do not count.
    predicted
        The prediction, in the unit of the quantity.
    covered
        Part of the cases that the interval is to cover [-].

    Raises
    ------
    InputError
        If there are too few of them.
    """
    known = errors[np.isfinite(errors)]
    if known.size < fewest(covered):
        msg = f"An interval needs at least {fewest(covered)} cases to rest on, not {known.size}."
        raise InputError(msg)
    low, median, high = (
        predicted * math.exp(quantile(known, part))
        for part in (0.5 * (1.0 - covered), 0.5, 0.5 * (1.0 + covered))
    )
    return Interval(low, median, high, known.size)


def coverage(groups: Iterable[Sequence[Case]], variant: Variant | None, quantity: Quantity) -> Coverage:
    """Return how well intervals from half of the earthquakes cover the other half.

    Parameters
    ----------
    groups
        The same records at one PGV after the other.
    variant, quantity
        As in `errors`.

    Raises
    ------
    InputError
        If there is no case, a half has too few, or nothing is left for the other half.
    """
    known = [(errors(cases, variant, quantity), [case.event for case in cases]) for cases in groups]
    if not known:
        msg = "A coverage needs at least one group of cases."
        raise InputError(msg)
    inside: list[float] = []
    widths: list[float] = []
    for training in grouped_splits(known[0][1]):
        hits = held_out = 0
        for values, _ in known:
            there = np.isfinite(values)
            part = interval(values[training & there])
            logarithms = values[~training & there]
            hits += int(((math.log(part.low) <= logarithms) & (logarithms <= math.log(part.high))).sum())
            held_out += logarithms.size
            widths.append(math.log(part.high / part.low))
        if held_out == 0:
            msg = "A coverage needs cases of several earthquakes, none of them more than half of the cases."
            raise InputError(msg)
        inside.append(hits / held_out)
    covered = np.array(inside)
    low, high = np.quantile(covered, [0.05, 0.95])
    return Coverage(
        float(covered.mean()), float(low), float(high), math.exp(float(np.mean(widths))), covered.size
    )


# Splits of a set of records in halves, of which no earthquake is in both.


#: Splits that a coverage or a refit is judged by, and where their random numbers start.
SPLITS, SEED = 200, 2020


def grouped_splits(
    events: Sequence[str], splits: int = SPLITS, seed: int = SEED
) -> Iterator[NDArray[np.bool_]]:
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
