"""Least squares fit of the law to the samples of sliding, how sure its estimates are, and what it leaves unexplained."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import lmfit
import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from dcfp.arrays import FloatArray
from dcfp.errors import AnalysisError
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.inference.identification.result import CONFIDENCE, ResidualStatistics
from dcfp.inference.identification.samples import PARAMETERS, LawAtSamples, Samples, value_of
from dcfp.system import System

#: Times that the scatter of each test is taken from the residuals and the fit repeated.
_ROUNDS = 2
#: Least scatter of a test over the coefficient, below which weights would tell of rounding errors [-].
_LEAST_SCATTER = 1e-6
#: Condition of scaled normal equations above which they determine nothing.
_LARGEST_CONDITION = 1e12
#: Length of a block over that of the correlation of the residuals, below which the intervals may be too short [-].
_LEAST_BLOCK = 4.0
#: Mean residual over the standard error of a stroke's mean, above which the law is said to miss a test [-], and over the coefficient [-].
_MISSES, _LEAST_MISS = 5.0, 0.01


@dataclass(frozen=True, eq=False)
class Jackknife:
    """Spread of least squares estimates.

    Attributes
    ----------
    covariance
        Of the estimates, shape (parameters, parameters); infinite where a block alone determines one.
    freedom
        Degrees of freedom of each variance, shape (parameters,).
    blocks
        Number of blocks.
    lost
        Number of the parameter that cannot be told from the others, where there is one.
    """

    covariance: FloatArray
    freedom: FloatArray
    blocks: int
    lost: int | None = None

    @property
    def standard_error(self) -> FloatArray:
        """Standard errors of the estimates."""
        return np.sqrt(np.diag(self.covariance))

    @property
    def half_width(self) -> FloatArray:
        """Half of the length of the 95 % intervals."""
        return np.asarray(student.ppf(0.5 + 0.5 * CONFIDENCE, self.freedom)) * self.standard_error

    @property
    def correlation(self) -> FloatArray:
        """Correlation of the estimates."""
        error = self.standard_error
        with np.errstate(invalid="ignore"):
            return np.clip(self.covariance / np.outer(error, error), -1.0, 1.0)


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
    residual
        Measured less fitted [-].
    scatter
        Root mean square of the residuals of each test [-].
    """

    names: tuple[str, ...]
    values: dict[str, float]
    jackknife: Jackknife
    residual: FloatArray
    scatter: FloatArray


def fit_law(samples: Samples, system: System, names: Sequence[str]) -> Fit:
    """Fit the parameters `names` to the samples; the others are those of the system's law and heating model.

    The squares of the residuals are weighted by the scatter of each test, which two rounds of the fit find; the solver is that of
    lmfit, a trust region within the limits of the parameters, with exact derivatives.

    Raises
    ------
    AnalysisError
        If the solver does not end.
    """
    law, measured = LawAtSamples(samples, system), samples.coefficient
    values = {name: value_of(system, name) for name in PARAMETERS}
    if "mu_0" in names:
        shape = law({**values, "mu_0": 1.0})
        values["mu_0"] = float(np.clip(np.median(measured / shape), 1e-3, 0.9))
    scatter = np.ones(int(samples.test.max()) + 1)
    for _ in range(_ROUNDS + 1):
        values = _solve(law, measured, 1.0 / scatter[samples.test], values, names)
        scatter = _scatter(samples, measured - law(values))
    weight = 1.0 / scatter[samples.test]
    fitted, slopes = law.derivatives(values, names)
    residual = measured - fitted
    return Fit(
        names=tuple(names),
        values=values,
        jackknife=jackknife(slopes * weight[:, None], residual * weight, samples.block),
        residual=residual,
        scatter=scatter,
    )


def _scatter(samples: Samples, residual: FloatArray) -> FloatArray:
    """Return the root mean square of the residuals of each test [-]."""
    least = _LEAST_SCATTER * float(np.median(samples.coefficient))
    return np.maximum(np.sqrt(np.bincount(samples.test, residual**2) / np.bincount(samples.test)), least)


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
        one = PARAMETERS[name]
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


def jackknife(slopes: FloatArray, residual: FloatArray, block: NDArray[np.int64]) -> Jackknife:
    r"""Return the covariance of least squares estimates by leaving out one block of samples after another.

    .. math:: \mathrm{Cov} = \frac{G - 1}{G} \sum_g d_g d_g^T, \quad d_g = (J^T J - J_g^T J_g)^{-1} J_g^T r_g

    Parameters
    ----------
    slopes, residual
        J and r at the solution, weighted, shapes (n, parameters) and (n,).
    block
        Number of the block of each sample, from zero without gaps, shape (n,).

    Notes
    -----
    :math:`d_g` is the change of the estimates when block g is left out, to first order. Within a block errors may depend on each
    other and differ in size as they like; from block to block they must not. This is the estimator CR3 for clustered errors (Bell and McCaffrey 2002), which
    is not too small in the mean where blocks weigh unequally. The degrees of freedom for Student's t follow from the part :math:`\tau_g^2` that each block has in the variance if
    all errors are alike, :math:`\nu = (\sum \tau_g^2)^2 / \sum \tau_g^4` (Satterthwaite).
    """
    blocks, count = int(block.max()) + 1, int(slopes.shape[1])
    size = np.sqrt((slopes**2).sum(axis=0))
    size[size == 0.0] = 1.0
    order = np.argsort(block, kind="stable")
    bounds = np.searchsorted(block[order], np.arange(blocks))
    scaled = slopes[order] / size
    parts: list[FloatArray] = [part.T @ part for part in np.split(scaled, bounds[1:])]
    own: FloatArray = np.array(parts)
    pull: FloatArray = np.add.reduceat(scaled * residual[order, None], bounds, axis=0)
    whole: FloatArray = own.sum(axis=0)
    left: FloatArray = whole - own
    weakest = int(np.argmax(np.linalg.cond(left)))
    if not np.linalg.cond(left[weakest]) < _LARGEST_CONDITION:
        # the parameter that the equations tell least of; of several the last
        direction: FloatArray = np.abs(np.linalg.eigh(left[weakest])[1][:, 0])
        lost = int(np.flatnonzero(direction > 0.9 * direction.max())[-1])
        return Jackknife(np.full((count, count), np.inf), np.ones(count), blocks, lost)
    change = np.asarray(np.linalg.solve(left, pull[:, :, None])[:, :, 0], dtype=np.float64)
    covariance: FloatArray = (blocks - 1) / blocks * change.T @ change
    inverse = np.asarray(np.linalg.inv(whole), dtype=np.float64)
    share: FloatArray = np.einsum("ij,gjk,ki->gi", inverse, own, inverse)
    freedom = np.asarray(share.sum(axis=0) ** 2 / (share**2).sum(axis=0))
    return Jackknife(covariance / np.outer(size, size), freedom, blocks)


# What the law leaves unexplained, and what must be known of it.


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
        one = PARAMETERS[name]
        span = one.most - one.least
        for limit in (one.least, one.most):
            if abs(found.values[name] - limit) < 1e-6 * span and not (one.is_scale and limit == one.least):
                remarks.append(f"{name} is at its limit of {limit:g}: its interval is not to be trusted.")
    for i, history in enumerate(histories):
        own = samples.test == i
        residual = found.residual[own]
        blocks, sizes = np.unique(samples.block[own], return_counts=True)
        length = _correlation_length(residual, int(sizes.max()))
        if length * _LEAST_BLOCK > float(np.median(sizes)):
            remarks.append(
                f"{history.name}: the residuals stay alike for {length} samples, and the intervals come from blocks of {np.median(sizes):.0f}:"
                " they may be too short."
            )
        miss = abs(float(residual.mean()))
        means = np.bincount(samples.block[own], residual)[blocks] / sizes
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
