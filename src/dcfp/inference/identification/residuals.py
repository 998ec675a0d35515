"""What the law leaves unexplained, and what must be known of it."""

from collections.abc import Sequence

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.inference.identification.fit import Fit
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.inference.identification.parameters import parameter
from dcfp.inference.identification.result import ResidualStatistics
from dcfp.inference.identification.samples import Samples

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
