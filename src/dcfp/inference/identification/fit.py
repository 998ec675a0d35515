"""Least squares fit of the law to the samples of sliding."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import lmfit
import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import AnalysisError
from dcfp.inference.identification.intervals import Jackknife, jackknife
from dcfp.inference.identification.parameters import PARAMETERS, Constants, parameter
from dcfp.inference.identification.samples import LawAtSamples, Samples

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
