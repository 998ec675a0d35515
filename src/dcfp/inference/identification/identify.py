"""From measured tests to a law of friction."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from dcfp.analysis.rig import Measurement, read_measurement
from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.identification.fit import (
    PARAMETERS,
    REFERENCES,
    Fit,
    Samples,
    fit_law,
    in_order,
    parameter,
    remarks_on,
    residuals_of,
    unit_of,
    value_of,
    with_values,
)
from dcfp.inference.identification.friction_history import FrictionHistory, friction_history
from dcfp.inference.identification.result import Estimate, Held, Identification, predict
from dcfp.schema.parameters import refuse_other
from dcfp.system import Heating, NoHeating, System, SystemLike
from dcfp.system.friction import FittedFriction

#: What is fitted where nothing else is asked for, as far as the data determine it.
DEFAULT = ("mu_0", "pressure_exponent", "speed_drop", "speed_rate", "temperature_rate")


def identify(
    tests: Sequence[Measurement | str | Path],
    bearing: SystemLike = None,
    heating: Heating | str | None = None,
    *,
    fit: Sequence[str] | None = None,
    fixed: Mapping[str, float] | None = None,
    law: FittedFriction | None = None,
    held_out: Sequence[Measurement | str | Path] = (),
) -> Identification:
    """Fit the law of friction to measured tests.

    Parameters
    ----------
    tests, held_out
        Each, or its file, with force and load, from plates at the ambient temperature of `heating`: to fit,
        and to predict by the law that was found.
    bearing, heating
        That was tested, whose pressure is not used, and the model; by default the simplified one.
    fit, fixed
        Names of `PARAMETERS` to fit, by default those of `DEFAULT` as far as the data determine them; and
        values of others by their names.
    law
        Where the search starts, and what is neither fitted nor fixed; by default that of Li et al. (2020).

    Returns
    -------
    Identification
        The law, and how sure it is. The intervals come from leaving out one stroke after another
        (`jackknife`).

    Raises
    ------
    InputError
        If a measurement lacks what is needed, or the data cannot determine what was asked for.

    Notes
    -----
    Of 400 synthetic tests with white noise, 93 to 97 % of the 95 % intervals of each parameter contained the truth
    (``docs/virtual_tests.md``), and the mean estimates were within 0.2 standard errors of it. With noise in which
    neighbouring samples have a correlation of 0.9 it was 91 to 96 % of 200, and 0.3 standard errors; with 40 samples a
    cycle in place of 400, 90 to 94 %.
    """
    given = dict(fixed or {})
    start = with_values(System.of(bearing, law or FittedFriction(), heating), given)
    measured, others = _measurements(tests), _measurements(held_out)
    if not measured:
        msg = "An identification needs at least one test."
        raise InputError(msg)
    names = [test.name for test in (*measured, *others)]
    for name in names:
        if names.count(name) > 1:
            msg = f"Two tests have the name {name!r}; each may be given once, to fit or to hold out."
            raise InputError(msg)
    histories = [friction_history(test, start) for test in measured]
    held_histories = [friction_history(test, start) for test in others]
    ambient = start.heating.ambient
    samples = Samples.of(histories, ambient)
    if fit is None:
        found, reasons = _fit_determinable(samples, start, [name for name in DEFAULT if name not in given])
    else:
        found, reasons = _fit_asked(samples, start, fit, given), {}
    fitted = with_values(start, {name: found.values[name] for name in found.names})
    # only the rise of the temperatures depends on the conductivity, as its reciprocal
    ratio = start.heating.conductivity / fitted.heating.conductivity
    temperatures = [ambient + ratio * (history.temperature - ambient) for history in histories]
    return Identification(
        system=_with_tests(fitted, histories),
        estimates=_estimates(found),
        held=_held(fitted, found.names, given, reasons),
        correlation=found.jackknife.correlation,
        blocks=found.jackknife.blocks,
        histories=tuple(histories),
        temperatures=tuple(temperatures),
        residuals=residuals_of(histories, temperatures, samples, found),
        predictions=tuple(predict(history, fitted) for history in held_histories),
        remarks=(_given(start.heating), *remarks_on(histories, samples, found)),
    )


def _measurements(tests: Sequence[Measurement | str | Path]) -> list[Measurement]:
    """Return measured tests, from their files unless they are at hand."""
    refuse_other(tests, (list, tuple), "tests", "a list of measured tests or of their files")
    found = [read_measurement(one) if isinstance(one, (str, Path)) else one for one in tests]
    for one in found:
        refuse_other(one, Measurement, "a test", "a Measurement or its file")
    return found


def _given(heating: Heating) -> str:
    plates = f"conductivity {heating.conductivity:g} N/(s degC), diffusivity {heating.diffusivity:g} mm2/s"
    return (
        f"The intervals are for noise alone: they take the {heating.name} heating model ({plates}) for right. With another one the temperature rate"
        " can change by a quarter, and the others with it; fit with each to see."
    )


def _with_tests(system: System, histories: Sequence[FrictionHistory]) -> System:
    """Return the system with the range of the tests that its law rests on."""
    ranges: dict[str, tuple[float, float]] = {}
    for name in ("pressure", "speed"):
        values = np.concatenate([getattr(history, name)[history.used] for history in histories])
        ranges[f"tested_{name}"] = (float(values.min()), float(values.max()))
    law: Any = system.friction
    return replace(system, friction=replace(law, **ranges, tested_ambient=system.heating.ambient))


def _estimates(found: Fit) -> tuple[Estimate, ...]:
    estimates: list[Estimate] = []
    errors, halves = found.jackknife.standard_error.tolist(), found.jackknife.half_width.tolist()
    for name, error, half in zip(found.names, errors, halves, strict=True):
        one, value = PARAMETERS[name], found.values[name]
        if one.is_scale:
            factor = float(np.exp(half / value))
            lower, upper = value / factor, value * factor
        else:
            lower, upper = value - half, value + half
        estimates.append(Estimate(name, value, error, max(lower, one.least), min(upper, one.most)))
    return tuple(estimates)


def _held(
    system: System, fitted: Sequence[str], fixed: Mapping[str, float], reasons: Mapping[str, str]
) -> tuple[Held, ...]:
    why = {**reasons, **dict.fromkeys(fixed, "fixed as asked for")}
    names = [name for name in (*PARAMETERS, *REFERENCES) if name not in fitted]
    return tuple(Held(name, value_of(system, name), why.get(name, "not asked for")) for name in names)


#: Pressures that differ by less than that are one [-].
_SAME_PRESSURE = 1.1
#: Correlation of two estimates above which they are said to go together [-].
_GO_TOGETHER = 0.9


@dataclass(frozen=True)
class _Need:
    """What a parameter needs: a quantity, its name in words, how far it must range, and the test that would help."""

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


def _fit_asked(samples: Samples, system: System, fit: Sequence[str], fixed: Mapping[str, float]) -> Fit:
    """Fit the parameters that were asked for, or say which of them the data cannot determine."""
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


def _fit_determinable(
    samples: Samples, system: System, candidates: Sequence[str]
) -> tuple[Fit, dict[str, str]]:
    """Fit those of the candidates that the data determine, and return why the others are not."""
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
    """Return why the samples cannot determine a parameter along with others, and the ways out; or None."""
    need, rate = _NEEDS.get(name), "temperature_rate"
    if need is None:
        return None
    if need is _HEAT and isinstance(system.heating, NoHeating):
        return f"without a heating model the temperature is the same throughout; choose the simplified or the precise one (heating), or {_fix(name)}"
    if name == "conductivity" and rate in names:
        return (
            "where every test starts at the same temperature it acts only through its ratio to temperature_rate; fix one of the two"
            f" (fix {name}=VALUE or fix {rate}=VALUE)"
        )
    if name == "conductivity" and value_of(system, rate) == 0.0:
        return (
            "with a temperature_rate of zero nothing depends on it; give that its value"
            f" (fix {rate}=VALUE), or {_fix(name)}"
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
    fix = _fix(name) if cause == name else f"fix {cause} (fix {cause}=VALUE)"
    return f"{need.spans(samples)}; add tests over a wider range of {need.words}, or {fix}"


def _fix(name: str) -> str:
    return f"fix it (fix {name}=VALUE)"
