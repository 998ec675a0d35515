"""What the data must span for a parameter to be determined, and the sentence where they do not."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.inference.identification.fit import Fit
from dcfp.inference.identification.parameters import Constants, parameter
from dcfp.inference.identification.samples import Samples

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
