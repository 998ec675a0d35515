"""Least squares fit of the law to the samples of sliding: what it leaves unexplained, and what the data must span for a parameter to be determined."""

from collections.abc import Callable, Mapping, Sequence
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
        return f"without a heating model the temperature is the same throughout; choose the simplified or the precise one (heating), or {_fix(name)}"
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
    return f"fix {name}=VALUE"
