"""How far predictions are from the analysis: ratios, their bias and scatter; and intervals about a prediction, from other earthquakes at the same PGV."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.case import Case
from dcfp.methods.method import Information, Variant, variants
from dcfp.methods.pulses import NOTHING, PREDICTION_QUANTITIES, Prediction, value_of
from dcfp.schema.quantities import Quantity

#: Part of the cases that an interval is to cover [-].
COVERED = 0.9


@dataclass(frozen=True)
class Scatter:
    """Ratios of prediction to analysis [-], as `dcfp.inference.told.SCATTER` names their measures.

    Cases `without` a prediction (no pulse, or nothing moves) are in none of them but `below`, the share of
    all cases.
    """

    number: int
    without: int
    below: float
    least: float
    largest: float
    median: float
    bias: float
    dispersion: float


def ratio(predicted: Prediction, analysed: Prediction, quantity: Quantity) -> float:
    """Return prediction over analysis [-]: zero or not a number where nothing was predicted, not a number where nothing moves."""
    truth = value_of(analysed, quantity)
    return value_of(predicted, quantity) / truth if truth > 0.0 else math.nan


def ratios(cases: Iterable[Case], variant: Variant, quantity: Quantity) -> FloatArray:
    """Return the `ratio` of every case [-], shape (cases,)."""
    return np.array(
        [
            ratio(case.predicted.get(variant, NOTHING), case.analysed.beside(variant.information), quantity)
            for case in cases
        ],
        dtype=np.float64,
    )


def scatter(values: FloatArray, among: NDArray[np.bool_] | None = None) -> Scatter:
    """Return the measures of ratios [-], of those `among` a selection of the cases; what is not positive is no prediction."""
    predicted = np.isfinite(values) & (values > 0.0)
    chosen = values[predicted if among is None else predicted & among]
    without = int(values.size - predicted.sum())
    below = float(np.mean(~predicted | (values < 1.0))) if values.size else np.nan
    if chosen.size == 0:
        return Scatter(0, without, below, *([np.nan] * 5))
    logarithms = np.log(chosen)
    return Scatter(
        number=chosen.size,
        without=without,
        below=below,
        least=float(chosen.min()),
        largest=float(chosen.max()),
        median=float(np.median(chosen)),
        bias=float(np.exp(logarithms.mean())),
        dispersion=float(logarithms.std(ddof=1)) if chosen.size > 1 else 0.0,
    )


def scatters(cases: Sequence[Case]) -> dict[tuple[Variant, Quantity], Scatter]:
    """Return the measures of every method, with what it knows, and every quantity that it predicts.

    What does not know the analysis is measured on the cases in which all methods foresee a motion.
    """
    measured: dict[tuple[Variant, Quantity], Scatter] = {}
    quantities = tuple(PREDICTION_QUANTITIES.values())
    for quantity in quantities:
        values = {variant: ratios(cases, variant, quantity) for variant in variants()}
        known = {variant: one for variant, one in values.items() if np.isfinite(one).any()}
        blind = [
            np.isfinite(one) & (one > 0.0)
            for variant, one in known.items()
            if variant.information in (Information.BLIND, Information.PGV)
        ]
        common = np.logical_and.reduce(blind) if blind else None
        for variant, one in known.items():
            informed = variant.information is Information.INFORMED
            measured[variant, quantity] = scatter(one, None if informed else common)
    keys = [(variant, quantity) for variant in variants() for quantity in quantities]
    return {key: measured[key] for key in keys if key in measured}


def displacement_over_change(cases: Iterable[Case]) -> FloatArray:
    """Return y_max over dy_max of the analyses [-], shape (cases,)."""
    whole = [case.analysed.whole for case in cases]
    return np.array([one.bound / one.displacement_change for one in whole if one.displacement_change > 0.0])


def fewest(covered: float = COVERED) -> int:
    """Return how many cases an interval needs to rest on: as many that the outermost two can be its ends."""
    return math.ceil(2.0 / (1.0 - covered) - 1e-9) - 1


@dataclass(frozen=True)
class Interval:
    """Where the analysis will be found, in the unit of the quantity, and how many cases that rests on."""

    low: float
    median: float
    high: float
    cases: int


def quantile(values: FloatArray, part: float) -> float:
    """Return what the next value will be below with a probability of `part` [-]: the value of rank part (n + 1)."""
    ordered = np.sort(values)
    rank = min(max(part * (ordered.size + 1), 1.0), float(ordered.size))
    return float(np.interp(rank, np.arange(1, ordered.size + 1), ordered))


def errors(cases: Sequence[Case], variant: Variant | None, quantity: Quantity) -> FloatArray:
    """Return the logarithm of analysis over prediction [-], shape (cases,), or without a `variant` of the analysis itself.

    It is not a number where nothing was predicted.
    """
    if variant is None:
        found = np.array([value_of(case.analysed.whole, quantity) for case in cases])
    else:
        found = ratios(cases, variant, quantity)
    logarithms = np.log(found, out=np.full(found.size, np.nan), where=found > 0.0)
    return logarithms if variant is None else -logarithms


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
