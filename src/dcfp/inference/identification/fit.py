"""Least squares fit of the law to the samples of sliding."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import lmfit
import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import AnalysisError
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.inference.identification.intervals import Jackknife, jackknife
from dcfp.inference.identification.result import ResidualStatistics
from dcfp.inference.identification.samples import PARAMETERS, Constants, LawAtSamples, Samples, parameter

#: Times that the scatter of each test is taken from the residuals and the fit repeated.
_ROUNDS = 2
#: Least scatter of a test over the coefficient, below which weights would tell of rounding errors [-].
_LEAST_SCATTER = 1e-6


@dataclass(frozen=True, eq=False)
class Fit:
    """A least squares fit.

    Attributes
    ----------
    names
        Of the parameters that were free.
    values
        Of every parameter.
    jackknife
        How sure the free ones are.
    fitted
        Coefficient by the law at each sample [-].
    residual
        Measured less fitted [-].
    scatter
        Root mean square of the residuals of each test [-].
    """

    names: tuple[str, ...]
    values: dict[str, float]
    jackknife: Jackknife
    fitted: FloatArray
    residual: FloatArray
    scatter: FloatArray


def fit_law(samples: Samples, constants: Constants, names: Sequence[str]) -> Fit:
    """Fit the parameters `names` to the samples; the others are those of `constants`.

    The squares of the residuals are weighted by the scatter of each test, which two rounds of the fit find; the solver is that of
    lmfit, a trust region within the limits of the parameters, with exact derivatives.

    Raises
    ------
    AnalysisError
        If the solver does not end.
    """
    law = LawAtSamples(samples, constants)
    start = {one.name: constants.value(one.name) for one in PARAMETERS}
    if "mu_0" in names:
        shape = law({**start, "mu_0": 1.0})
        start["mu_0"] = float(np.clip(np.median(samples.coefficient / shape), 1e-3, 0.9))
    tests = int(samples.test.max()) + 1
    values = _solve(law, samples.coefficient, np.ones(samples.test.size), start, names)
    for _ in range(_ROUNDS):
        scatter = _scatter(samples, samples.coefficient - law(values), tests)
        weight = 1.0 / scatter[samples.test]
        values = _solve(law, samples.coefficient, weight, values, names)
    fitted, slopes = law.derivatives(values, names)
    residual = samples.coefficient - fitted
    scatter = _scatter(samples, residual, tests)
    weight = 1.0 / scatter[samples.test]
    return Fit(
        names=tuple(names),
        values=values,
        jackknife=jackknife(slopes * weight[:, None], residual * weight, samples.block),
        fitted=fitted,
        residual=residual,
        scatter=scatter,
    )


def _scatter(samples: Samples, residual: FloatArray, tests: int) -> FloatArray:
    """Return the root mean square of the residuals of each test [-]."""
    squares = np.bincount(samples.test, residual**2, minlength=tests)
    least = _LEAST_SCATTER * float(np.median(samples.coefficient))
    return np.maximum(np.sqrt(squares / np.bincount(samples.test, minlength=tests)), least)


def _solve(
    law: LawAtSamples,
    measured: FloatArray,
    weight: FloatArray,
    start: Mapping[str, float],
    names: Sequence[str],
) -> dict[str, float]:
    """Return the values of the parameters at the least sum of weighted squares."""
    free: Any = lmfit.Parameters()
    for name, value in start.items():
        one = parameter(name)
        free.add(name, value=value, min=one.least, max=one.most, vary=name in names)

    def residual(parameters: Any) -> FloatArray:
        return (law(parameters.valuesdict()) - measured) * weight

    def slopes(parameters: Any) -> FloatArray:
        return law.derivatives(parameters.valuesdict(), names)[1] * weight[:, None]

    # lmfit takes roots of a covariance that may be singular, and would warn; `jackknife` says how sure the estimates are
    with np.errstate(invalid="ignore", divide="ignore"):
        solved: Any = lmfit.Minimizer(residual, free).least_squares(
            jac=slopes, x_scale="jac", ftol=1e-12, xtol=1e-10, gtol=1e-12
        )
    if not solved.success:
        msg = f"The fit of {', '.join(names)} does not end ({solved.message}); fix one of them."
        raise AnalysisError(msg)
    return {name: float(value) for name, value in solved.params.valuesdict().items()}


# What the law leaves unexplained, and what must be known of it.


#: Length of a block over that of the correlation of the residuals, below which the intervals may be too short [-].
_LEAST_BLOCK = 4.0
#: Mean residual over the standard error of a stroke's mean, above which the law is said to miss a test [-].
_MISSES = 5.0
#: And over the coefficient [-].
_LEAST_MISS = 0.01


def residuals_of(
    histories: Sequence[FrictionHistory],
    temperatures: Sequence[FloatArray],
    samples: Samples,
    found: Fit,
) -> tuple[ResidualStatistics, ...]:
    """Return the statistics of each test, of which `temperatures` [degC] are those with the conductivity that was found."""
    rows: list[ResidualStatistics] = []
    for i, (history, temperature) in enumerate(zip(histories, temperatures, strict=True)):
        own = samples.test == i
        residual, scatter = found.residual[own], float(found.scatter[i])
        rows.append(
            ResidualStatistics(
                name=history.name,
                samples=int(residual.size),
                left_out=int(history.used.size - residual.size),
                scatter=scatter,
                bias=float(residual.mean()),
                relative_scatter=scatter / float(samples.coefficient[own].mean()),
                correlation=_correlation(residual, 1),
                pressure=float(samples.pressure[own].mean()),
                peak_speed=float(samples.speed[own].max()),
                peak_temperature=float(temperature[history.used].max()),
                speed_window=history.speed_window,
                load_window=history.load_window,
            )
        )
    return tuple(rows)


def remarks_on(histories: Sequence[FrictionHistory], samples: Samples, found: Fit) -> tuple[str, ...]:
    """Return what must be known of a fit."""
    remarks: list[str] = []
    for name in found.names:
        one = parameter(name)
        span = one.most - one.least
        for limit in (one.least, one.most):
            if abs(found.values[name] - limit) < 1e-6 * span and not (one.is_scale and limit == one.least):
                remarks.append(f"{name} is at its limit of {limit:g}: its interval is not to be trusted.")
    for i, history in enumerate(histories):
        own = samples.test == i
        residual = found.residual[own]
        sizes = np.unique(samples.block[own], return_counts=True)[1]
        length = _correlation_length(residual, int(sizes.max()))
        if length * _LEAST_BLOCK > float(np.median(sizes)):
            remarks.append(
                f"{history.name}: the residuals stay alike for {length} samples, and the intervals come from blocks of {np.median(sizes):.0f}:"
                " they may be too short."
            )
        miss = abs(float(residual.mean()))
        means = np.bincount(samples.block[own], residual)[np.unique(samples.block[own])] / sizes
        spread = float(np.std(means)) / np.sqrt(sizes.size)
        if miss > _MISSES * spread and miss > _LEAST_MISS * float(samples.coefficient[own].mean()):
            remarks.append(
                f"{history.name}: the law misses the mean coefficient of this test by {float(residual.mean()):+.4f}; its form, the bearing or the"
                " temperature at the start may not be those of the test."
            )
    return tuple(remarks)


def _correlation(residual: FloatArray, lag: int) -> float:
    """Return the correlation of residuals so many samples apart [-]; zero where there are none."""
    square = float(residual @ residual)
    return float(residual[lag:] @ residual[:-lag]) / square if square > 0.0 and lag < residual.size else 0.0


def _correlation_length(residual: FloatArray, longest: int) -> int:
    """Return after how many samples the correlation has fallen below 1/e."""
    lag = 1
    while lag < longest and _correlation(residual, lag) > np.exp(-1.0):
        lag = lag + 1 if lag < 20 else int(1.2 * lag)
    return lag
