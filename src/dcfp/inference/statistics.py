"""How far predictions are from the analysis: ratios, their range, bias and scatter."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray
from dcfp.inference.case import Case
from dcfp.methods.method import Information, Variant, variants
from dcfp.methods.pulses import NOTHING, PREDICTION_QUANTITIES, value_of
from dcfp.schema.quantities import Quantity


@dataclass(frozen=True)
class Scatter:
    """Ratios of prediction to analysis.

    Attributes
    ----------
    number
        Of cases that are measured.
    without
        Cases in which nothing was predicted: no pulse was found, or nothing moves by the method. They are in none of the measures but `below`.
    below
        Share of all cases in which the prediction is below the analysis, nothing predicted among them [-].
    least, largest, median
        Of the ratios [-].
    bias
        Geometric mean of the ratios [-].
    dispersion
        Standard deviation of their natural logarithms [-].
    """

    number: int
    without: int
    below: float
    least: float
    largest: float
    median: float
    bias: float
    dispersion: float


def ratios(cases: Iterable[Case], variant: Variant, quantity: Quantity) -> FloatArray:
    """Return prediction over analysis [-], shape (cases,): zero or not a number where nothing was predicted."""
    pairs = [
        (
            value_of(case.predicted.get(variant, NOTHING), quantity),
            value_of(case.analysed.beside(variant.information), quantity),
        )
        for case in cases
    ]
    predicted, analysed = np.array(pairs, dtype=np.float64).reshape(-1, 2).T
    return np.divide(predicted, analysed, out=np.full(predicted.size, np.nan), where=analysed > 0.0)


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

    What does not know the analysis is measured on the cases in which each of the methods of prediction foresees a motion, so that none is spared the cases that
    another must bear; what is informed, on its own.
    """
    found: dict[tuple[Variant, Quantity], Scatter] = {}
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
            found[variant, quantity] = scatter(one, None if informed else common)
    return {
        (variant, quantity): found[variant, quantity]
        for variant in variants()
        for quantity in quantities
        if (variant, quantity) in found
    }


def displacement_over_change(cases: Iterable[Case]) -> FloatArray:
    """Return y_max over dy_max of the analyses [-], shape (cases,)."""
    whole = [case.analysed.whole for case in cases]
    return np.array([one.bound / one.displacement_change for one in whole if one.displacement_change > 0.0])
