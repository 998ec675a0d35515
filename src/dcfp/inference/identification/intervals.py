"""How sure estimates are, whatever the errors of neighbouring samples have in common."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from dcfp.arrays import FloatArray
from dcfp.inference.identification.fit import Fit
from dcfp.inference.identification.samples import Constants, Samples, parameter

#: Probability that an interval contains the truth.
CONFIDENCE = 0.95
#: Condition of scaled normal equations above which they determine nothing.
_LARGEST_CONDITION = 1e12


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
        lost = _least_told(left[weakest])
        unknown: FloatArray = np.full((count, count), np.inf)
        freedom: FloatArray = np.full(count, 1.0)
        return Jackknife(unknown, freedom, blocks, lost)
    change = np.asarray(np.linalg.solve(left, pull[:, :, None])[:, :, 0], dtype=np.float64)
    covariance: FloatArray = (blocks - 1) / blocks * change.T @ change
    inverse = np.asarray(np.linalg.inv(whole), dtype=np.float64)
    share: FloatArray = np.einsum("ij,gjk,ki->gi", inverse, own, inverse)
    freedom = np.asarray(share.sum(axis=0) ** 2 / (share**2).sum(axis=0))
    return Jackknife(covariance / np.outer(size, size), freedom, blocks)


def _least_told(equations: FloatArray) -> int:
    """Return the number of the parameter that normal equations tell least of; of several the last."""
    direction: FloatArray = np.abs(np.linalg.eigh(equations)[1][:, 0])
    return int(np.flatnonzero(direction > 0.9 * direction.max())[-1])


# What the data must span for a parameter to be determined, and the sentence where they do not.


#: Least ratio of pressures, of pressures for the floor, and of speeds [-]; least range of temperature [degC].
_PRESSURES, _PRESSURES_OF_FLOOR, _SPEEDS, _TEMPERATURES = 1.1, 2.0, 3.0, 5.0
#: Pressures that differ by less than that are one [-].
_SAME_PRESSURE = 1.1
#: Correlation of two estimates above which they are said to go together [-].
_GO_TOGETHER = 0.9


@dataclass(frozen=True)
class _Need:
    """What a parameter needs: the quantity, what it spans in words, whether that is enough, and the test that would help."""

    quantity: str
    spans: Callable[[Samples], str]
    is_met: Callable[[Samples], bool]
    help: str


def _range(values: FloatArray, samples: Samples) -> tuple[float, float]:
    """Return between what limits the tests are, but for a twentieth of the samples of each at either end."""
    parts = [np.quantile(values[samples.test == i], (0.05, 0.95)) for i in np.unique(samples.test)]
    return float(min(part[0] for part in parts)), float(max(part[1] for part in parts))


def _levels(samples: Samples) -> int:
    """Count the pressures, in tests or within them, that differ."""
    means = np.sort(np.bincount(samples.block, samples.pressure) / np.bincount(samples.block))
    count, last = 0, 0.0
    for mean in means.tolist():
        if mean > _SAME_PRESSURE * last:
            count, last = count + 1, mean
    return count


def _pressures(samples: Samples) -> str:
    least, most = _range(samples.pressure, samples)
    if most < 1.02 * least:
        return f"every test has a pressure of {0.5 * (least + most):.3g} N/mm2"
    return f"the pressures of the tests are {_levels(samples)} from {least:.3g} to {most:.3g} N/mm2"


def _speeds(samples: Samples) -> str:
    least, most = _range(samples.speed, samples)
    return f"the speeds of the tests span {least:.3g} to {most:.3g} mm/s"


def _temperatures(samples: Samples) -> str:
    least, most = _range(samples.rise, samples)
    return f"the tests heat the contact by {max(least, 0.0):.3g} to {most:.3g} degC"


def _ratio(values: Callable[[Samples], FloatArray], least: float) -> Callable[[Samples], bool]:
    def is_met(samples: Samples) -> bool:
        low, high = _range(values(samples), samples)
        return high >= least * low

    return is_met


def _heats(samples: Samples) -> bool:
    low, high = _range(samples.rise, samples)
    return high - low >= _TEMPERATURES


_PRESSURE = _Need(
    "pressures", _pressures, _ratio(lambda s: s.pressure, _PRESSURES), "add a test at another pressure"
)
_FLOOR = _Need(
    "pressures",
    _pressures,
    lambda s: _levels(s) >= 3 and _ratio(lambda s: s.pressure, _PRESSURES_OF_FLOOR)(s),
    "add tests, so that there are three pressures over a factor of two",
)
_SPEED = _Need("speeds", _speeds, _ratio(lambda s: s.speed, _SPEEDS), "add a test at another speed")
_HEAT = _Need("temperatures", _temperatures, _heats, "add a faster or longer test, which heats up more")
_NEEDS: Mapping[str, _Need] = {
    "pressure_exponent": _PRESSURE,
    "pressure_floor": _FLOOR,
    "speed_drop": _SPEED,
    "speed_rate": _SPEED,
    "temperature_rate": _HEAT,
    "conductivity": _HEAT,
}


def why_not(name: str, names: Sequence[str], samples: Samples, constants: Constants) -> str | None:
    """Return why the samples cannot determine a parameter along with others, and the ways out; None where nothing speaks against it."""
    need = _NEEDS.get(name)
    if need is None:
        return None
    if need is _HEAT and constants.heating.name == "none":
        return f"without a heating model the temperature is the same throughout; choose --heating simplified or precise, or {_fix(name)}"
    if name == "conductivity" and "temperature_rate" in names:
        return (
            "where every test starts at the same temperature it acts only through its ratio to temperature_rate; fix one of the two"
            f" ({_option(name)} or {_option('temperature_rate')})"
        )
    if name == "conductivity" and constants.law.temperature_rate == 0.0:
        return (
            "with a temperature_rate of zero nothing depends on it; give that its value"
            f" ({_option('temperature_rate')}), or {_fix(name)}"
        )
    if need.is_met(samples):
        return None
    return f"{need.spans(samples)}; {need.help}, or {_fix(name)}"


def poorest(fit: Fit) -> tuple[str, str] | None:
    """Return which parameter is determined worst, if its interval is too long to be of use, and why."""
    if fit.jackknife.lost is not None:
        name = fit.names[fit.jackknife.lost]
        others = ", ".join(other for other in fit.names if other != name)
        return name, f"its effect cannot be told from that of {others}"
    halves = zip(fit.names, fit.jackknife.half_width.tolist(), strict=True)
    excess = {name: _size(fit, name, half) / parameter(name).worth for name, half in halves}
    worst = max(excess, key=lambda name: excess[name])
    return (worst, _why_poor(worst, fit)) if excess[worst] > 1.0 else None


def _size(fit: Fit, name: str, half: float) -> float:
    """Return half of the length of an interval, over the estimate of a parameter that is a scale."""
    return half / fit.values[name] if parameter(name).is_scale else half


def companion(name: str, fit: Fit) -> str | None:
    """Return the parameter whose estimate goes most with that of another, which is to be kept."""
    others = [other for other in fit.names if other != name]
    relation = fit.jackknife.correlation[fit.names.index(name)]
    return max(others, key=lambda other: abs(relation[fit.names.index(other)])) if others else None


def _why_poor(name: str, fit: Fit) -> str:
    place = fit.names.index(name)
    unit = parameter(name).unit
    half = float(fit.jackknife.half_width[place])
    text = f"its 95 % interval would be {fit.values[name]:.3g} ± {half:.2g}{f' {unit}' if unit else ''}"
    other = companion(name, fit)
    if other is not None:
        relation = float(fit.jackknife.correlation[place, fit.names.index(other)])
        if abs(relation) > _GO_TOGETHER:
            text += f", for it goes with {other} (correlation {relation:.3f})"
    return text


def way_out(name: str, fit: Fit, samples: Samples) -> str:
    """Return what the samples span, and what would determine a parameter better."""
    cause = name
    if name not in _NEEDS:  # mu_0 is poor where what it goes with is
        cause = companion(name, fit) or name
    need = _NEEDS.get(cause, _SPEED)
    fix = _fix(name) if cause == name else f"fix {cause} ({_option(cause)})"
    return f"{need.spans(samples)}; add tests over a wider range of {need.quantity}, or {fix}"


def _fix(name: str) -> str:
    return f"fix it ({_option(name)})"


def _option(name: str) -> str:
    return f"--fix {name}=VALUE"
