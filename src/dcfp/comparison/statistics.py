"""How far predictions are from the analysis: ratios, their range, bias and scatter."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.comparison.case import VIEWS, Case, View
from dcfp.comparison.quantities import CHANGE, DISPLACEMENT, HYSTERETIC, INPUT, QUANTITIES, TOTAL, Quantity
from dcfp.prediction import NOTHING, Prediction

_VALUES: dict[Quantity, Callable[[Prediction], float | None]] = {
    CHANGE: lambda prediction: prediction.displacement_change,
    DISPLACEMENT: lambda prediction: prediction.bound,
    INPUT: lambda prediction: prediction.input_velocity,
    HYSTERETIC: lambda prediction: prediction.hysteretic_velocity,
    TOTAL: lambda prediction: prediction.total_velocity,
}


@dataclass(frozen=True)
class Scatter:
    """Ratios of prediction to analysis.

    Attributes
    ----------
    number
        Of cases with a ratio.
    without
        Cases in which nothing was predicted: no pulse was found, or nothing moves by the method. They are in none of the measures below.
    least, largest, median
        Of the ratios [-].
    bias
        Geometric mean of the ratios [-].
    dispersion
        Standard deviation of their natural logarithms [-].
    """

    number: int
    without: int
    least: float
    largest: float
    median: float
    bias: float
    dispersion: float


def value_of(prediction: Prediction, quantity: Quantity) -> float:
    """Return a quantity of a prediction; not a number where it has none."""
    value = _VALUES[quantity](prediction)
    return np.nan if value is None else value


def ratios(cases: Iterable[Case], view: View, quantity: Quantity) -> FloatArray:
    """Return prediction over analysis [-], shape (cases,): zero or not a number where nothing was predicted."""
    _, basis = view
    pairs = [
        (
            value_of(case.predicted.get(view, NOTHING), quantity),
            value_of(case.analysed.beside(basis), quantity),
        )
        for case in cases
    ]
    predicted, analysed = np.array(pairs, dtype=np.float64).reshape(-1, 2).T
    return np.divide(predicted, analysed, out=np.full(predicted.size, np.nan), where=analysed > 0.0)


def scatter(values: FloatArray) -> Scatter:
    """Return the measures of ratios [-]."""
    good = values[np.isfinite(values) & (values > 0.0)]
    without = values.size - good.size
    if good.size == 0:
        return Scatter(0, without, *([np.nan] * 5))
    logarithms = np.log(good)
    return Scatter(
        number=good.size,
        without=without,
        least=float(good.min()),
        largest=float(good.max()),
        median=float(np.median(good)),
        bias=float(np.exp(logarithms.mean())),
        dispersion=float(logarithms.std(ddof=1)) if good.size > 1 else 0.0,
    )


def scatters(cases: Sequence[Case]) -> dict[tuple[View, Quantity], Scatter]:
    """Return the measures of every view and every quantity that it predicts."""
    found: dict[tuple[View, Quantity], Scatter] = {}
    for view in VIEWS:
        for quantity in QUANTITIES:
            values = ratios(cases, view, quantity)
            if np.isfinite(values).any():
                found[view, quantity] = scatter(values)
    return found


def displacement_over_change(cases: Iterable[Case]) -> FloatArray:
    """Return y_max over dy_max of the analyses [-], shape (cases,)."""
    whole = [case.analysed.whole for case in cases]
    return np.array([one.bound / one.displacement_change for one in whole if one.displacement_change > 0.0])
