"""Which parameters the data determine: what they must span, and the sentence with the ways out where they do not."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.identification.fit import Fit, fit_law
from dcfp.inference.identification.samples import PARAMETERS, Samples, in_order, parameter, unit_of, value_of
from dcfp.system import NoHeating, System

#: Pressures that differ by less than that are one [-].
_SAME_PRESSURE = 1.1
#: Correlation of two estimates above which they are said to go together [-].
_GO_TOGETHER = 0.9


@dataclass(frozen=True)
class _Need:
    """What a parameter needs: a quantity of the samples and its name in words, how far it must range, and the test that would help."""

    quantity: str
    words: str
    least: float  # ratio of the largest to the smallest [-]; of the rise of the temperature their difference [degC]
    help: str
    levels: int = 1  # of pressure

    def spans(self, samples: Samples) -> str:
        """Return in words what the quantity spans."""
        least, most = _range(getattr(samples, self.quantity), samples)
        if self is _HEAT:
            return f"the tests heat the contact by {max(least, 0.0):.3g} to {most:.3g} degC"
        if self is _SPEED:
            return f"the speeds of the tests span {least:.3g} to {most:.3g} mm/s"
        if most < 1.02 * least:
            return f"every test has a pressure of {0.5 * (least + most):.3g} N/mm2"
        return f"the pressures of the tests are {_levels(samples)} from {least:.3g} to {most:.3g} N/mm2"

    def is_met(self, samples: Samples) -> bool:
        """Return whether that is enough."""
        low, high = _range(getattr(samples, self.quantity), samples)
        is_wide = high - low >= self.least if self is _HEAT else high >= self.least * low
        return is_wide and _levels(samples) >= self.levels


_PRESSURE = _Need("pressure", "pressures", 1.1, "add a test at another pressure")
_FLOOR = _Need(
    "pressure",
    "pressures",
    2.0,
    "add tests, so that there are three pressures over a factor of two",
    levels=3,
)
_SPEED = _Need("speed", "speeds", 3.0, "add a test at another speed")
_HEAT = _Need("rise", "temperatures", 5.0, "add a faster or longer test, which heats up more")
_NEEDS: Mapping[str, _Need] = {
    "pressure_exponent": _PRESSURE,
    "pressure_floor": _FLOOR,
    "speed_drop": _SPEED,
    "speed_rate": _SPEED,
    "temperature_rate": _HEAT,
    "conductivity": _HEAT,
}


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


def fit_asked(samples: Samples, system: System, fit: Sequence[str], fixed: Mapping[str, float]) -> Fit:
    """Fit the parameters that were asked for.

    Raises
    ------
    InputError
        If the data cannot determine them.
    """
    names = in_order(parameter(name).name for name in fit)
    if not names:
        msg = "Name at least one parameter to fit."
        raise InputError(msg)
    for name in names:
        if name in fixed:
            msg = f"The {name} is both to be fitted and fixed at {fixed[name]:g}; choose one."
            raise InputError(msg)
        reason = _why_not(name, names, samples, system)
        if reason is not None:
            msg = f"The data cannot determine {name}: {reason}."
            raise InputError(msg)
    found = fit_law(samples, system, names)
    poor = _poorest(found)
    if poor is not None:
        msg = f"The data cannot determine {poor[0]}: {poor[1]}; {_way_out(poor[0], found, samples)}."
        raise InputError(msg)
    return found


def fit_determinable(
    samples: Samples, system: System, candidates: Sequence[str]
) -> tuple[Fit, dict[str, str]]:
    """Fit those of the candidates that the data determine; return why the others are not.

    Raises
    ------
    InputError
        If there are none.
    """
    reasons: dict[str, str] = {}
    names = list(candidates)
    for name in candidates:
        reason = _why_not(name, names, samples, system)
        if reason is not None:
            names.remove(name)
            reasons[name] = reason
    if not names:
        msg = "Everything is fixed; leave at least one parameter to fit."
        raise InputError(msg)
    found = fit_law(samples, system, in_order(names))
    while (poor := _poorest(found)) is not None:
        name, why = poor
        if name == "mu_0":  # that is what a fit is for: hold what makes it uncertain
            other = _companion(name, found)
            if other is None:
                msg = f"The data cannot determine mu_0, the only parameter that is left to fit: {why}; look at the sign and the unit of the force and at its noise."
                raise InputError(msg)
            name, why = other, f"with it mu_0 is not determined ({why})"
        names.remove(name)
        reasons[name] = f"{why}; {_way_out(name, found, samples)}"
        if not names:
            msg = f"The data determine none of the parameters that are left to fit; {name}: {reasons[name]}."
            raise InputError(msg)
        found = fit_law(samples, system, in_order(names))
    return found, reasons


def _why_not(name: str, names: Sequence[str], samples: Samples, system: System) -> str | None:
    """Return why the samples cannot determine a parameter along with others, and the ways out; None where nothing speaks against it."""
    need, rate = _NEEDS.get(name), "temperature_rate"
    if need is None:
        return None
    if need is _HEAT and isinstance(system.heating, NoHeating):
        return f"without a heating model the temperature is the same throughout; choose the simplified or the precise one (heating), or {_fix(name)}"
    if name == "conductivity" and rate in names:
        return (
            "where every test starts at the same temperature it acts only through its ratio to temperature_rate; fix one of the two"
            f" ({_option(name)} or {_option(rate)})"
        )
    if name == "conductivity" and value_of(system, rate) == 0.0:
        return (
            "with a temperature_rate of zero nothing depends on it; give that its value"
            f" ({_option(rate)}), or {_fix(name)}"
        )
    if need.is_met(samples):
        return None
    return f"{need.spans(samples)}; {need.help}, or {_fix(name)}"


def _poorest(fit: Fit) -> tuple[str, str] | None:
    """Return which parameter is determined worst, if its interval is too long to be of use, and why."""
    if fit.jackknife.lost is not None:
        name = fit.names[fit.jackknife.lost]
        others = ", ".join(other for other in fit.names if other != name)
        return name, f"its effect cannot be told from that of {others}"
    halves = dict(zip(fit.names, fit.jackknife.half_width.tolist(), strict=True))
    excess: dict[str, float] = {}
    for name, half in halves.items():
        one = PARAMETERS[name]
        excess[name] = (half / fit.values[name] if one.is_scale else half) / one.worth
    worst = max(excess, key=lambda name: excess[name])
    if not excess[worst] > 1.0:
        return None
    text = (
        f"its 95 % interval would be {fit.values[worst]:.3g} ± {halves[worst]:.2g} {unit_of(worst)}".strip()
    )
    other = _companion(worst, fit)
    if other is not None:
        relation = float(fit.jackknife.correlation[fit.names.index(worst), fit.names.index(other)])
        if abs(relation) > _GO_TOGETHER:
            text += f", for it goes with {other} (correlation {relation:.3f})"
    return worst, text


def _companion(name: str, fit: Fit) -> str | None:
    """Return the parameter whose estimate goes most with that of another, which is to be kept."""
    others = [other for other in fit.names if other != name]
    relation = fit.jackknife.correlation[fit.names.index(name)]
    return max(others, key=lambda other: abs(relation[fit.names.index(other)])) if others else None


def _way_out(name: str, fit: Fit, samples: Samples) -> str:
    """Return what the samples span, and what would determine a parameter better."""
    cause = name
    if name not in _NEEDS:  # mu_0 is poor where what it goes with is
        cause = _companion(name, fit) or name
    need = _NEEDS.get(cause, _SPEED)
    fix = _fix(name) if cause == name else f"fix {cause} ({_option(cause)})"
    return f"{need.spans(samples)}; add tests over a wider range of {need.words}, or {fix}"


def _fix(name: str) -> str:
    return f"fix it ({_option(name)})"


def _option(name: str) -> str:
    return f"fix {name}=VALUE"
