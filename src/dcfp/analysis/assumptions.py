"""What an analysis or a test assumes and what it ought to keep to, each checked once: remarks, reports and the page all read these checks."""

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dcfp.motion.measures import DRIFT_THRESHOLD, baseline_drift
from dcfp.schema.check import Check, Verdict, at_most
from dcfp.schema.formulas import number
from dcfp.schema.registry import Registry

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from dcfp.analysis.response import Response
    from dcfp.analysis.result import Result

#: Displacement over the effective radius up to which the pendulum's force is linear within some percent [-].
LARGEST_ANGLE = 0.5
#: Elongation of spring (b) before sliding above which heat and motion depend on how the two are split [mm].
LARGEST_YIELD_RADIUS = 1.0
#: Ratio of two plates' coefficients up to which they share the travel as their radii.
LARGEST_RATIO = 1.1
#: Time since the plates were cold up to which a plate is as good as a half-space [s]: where one of 50 mm is 1 % warmer after a constant flux.
LONGEST_HALF_SPACE = 196.0
#: How far the temperature at the start may be from that of the tests without a remark [degC].
LARGEST_AMBIENT_CHANGE = 15.0
#: Largest residual of the energy balance over the largest input energy [-]; an analysis closes to rounding, about 1e-14.
LARGEST_RESIDUAL = 1e-9
#: How far beyond a law's tested range an analysis may go, relative [-].
SLACK = 0.01
_MODEL = "assumption of the model"

#: Assumptions of every result, and of the analysis of a rigid structure, by name: each gives checks, with a remark where one is not met.
OF_MODEL: "Registry[Callable[[Result], Iterable[Check]]]" = Registry("assumption")
OF_RESPONSE: "Registry[Callable[[Response], Iterable[Check]]]" = Registry("check of a response")


# Of a response.


def _capacity(response: "Response") -> list[Check]:
    bearing, found = response.bearing, response.peak_displacement
    capacity = bearing.displacement_capacity
    if capacity is None:
        source, limit, beyond = "scenario", "no capacity given", False
    else:
        source = bearing.capacity_note or "capacity of the scenario"
        limit, beyond = f"at most {_short(capacity)} mm", found > capacity
    note = f" ({bearing.capacity_note})" if bearing.capacity_note else ""
    remark = f"{response.name}: the displacement of {found:.0f} mm exceeds the capacity of {capacity or 0.0:.0f} mm{note}."
    # as the status of the analysis has it, to the last digit
    verdict = Verdict.of(None if capacity is None else not beyond)
    name = "largest displacement within the capacity"
    return [Check(name, verdict, f"{_fixed(found)} mm", limit, source, remark=remark if beyond else "")]


def _angle(response: "Response") -> list[Check]:
    found, far = response.peak_displacement, LARGEST_ANGLE * response.bearing.effective_radius
    return [
        _judged(
            "largest displacement in the linear range of the pendulum",
            at_most(found, far),
            f"{_fixed(found)} mm",
            f"at most {_fixed(far)} mm, half of the effective radius",
            _MODEL,
            f"{response.name}: the displacement of {found:.0f} mm exceeds {far:.0f} mm, half of the effective radius,"
            " where the pendulum's force is no longer linear and a plate is hardly as large.",
        )
    ]


def _rest(response: "Response") -> list[Check]:
    return [
        _judged(
            "at rest at the end",
            Verdict.of(response.rests),
            "at rest" if response.rests else "still moving",
            "no sliding can come any more",
            "analysis",
            f"{response.name}: it still moves at the end, so the residual displacement is not final.",
        )
    ]


def _residual(response: "Response") -> list[Check]:
    most = float(response.friction[-1]) * response.bearing.effective_radius
    found = response.residual_displacement
    return [
        Check(
            "residual displacement one that friction can hold",
            at_most(abs(found), most),
            f"{_fixed(found)} mm of {_fixed(most)} mm",
            "at most the coefficient of friction at the end times the effective radius",
            "mechanics; no code's limit is set",
        )
    ]


def _energy(response: "Response") -> list[Check]:
    found = response.energy.relative_residual
    return [
        Check(
            "energy balance, residual over the largest input",
            at_most(found, LARGEST_RESIDUAL),
            _power(found),
            f"at most {_power(LARGEST_RESIDUAL)}",
            "Li et al. (2020), Eq. (6)",
        )
    ]


def _baseline(response: "Response") -> list[Check]:
    drift = baseline_drift(response.motion)
    return [
        Check(  # what is to be said of it, the motion says itself
            "baseline of the record: velocity at its end over PGV",
            at_most(drift, DRIFT_THRESHOLD),
            f"{100.0 * drift:.1f} %",
            f"at most {100.0 * DRIFT_THRESHOLD:.0f} %",
            "hundred records of FEMA P-695",
        )
    ]


# Of every result.


def _sliding(result: "Result") -> list[Check]:
    if not result.velocity.any():
        return []
    return [
        _judged(
            "it slides",
            Verdict.of(result.slides),
            "it slides" if result.slides else "it never slides",
            "friction is that of sliding",
            _MODEL,
            f"{result.name}: it never slides, so that forces, stiffness and friction are those of spring (b) alone.",
        )
    ]


def _law(result: "Result") -> list[Check]:
    law = result.friction_law
    if not law.caution:
        return []
    remark = f"Friction law {law.name}: {law.caution}"
    return [
        Check("friction law without reservations", Verdict.NOT_KNOWN, law.name, "", law.name, remark=remark)
    ]


def _tested(result: "Result") -> list[Check]:
    """Return checks of speed, pressure and temperature against the tests behind the law; the first that is not met has the remark on all of them."""
    law = result.friction_law
    tested = law.tests()
    speed, ambient = result.peak_velocity, result.heating.ambient
    pressure = result.load / result.bearing.slider_area
    low, high = float(pressure.min()), float(pressure.max())
    source = "no tests known of this law" if tested is None else tested.source
    checks = [
        Check("speed within the tests of the friction law", Verdict.NOT_KNOWN, f"{_fixed(speed)} mm/s", "not known", source),
        Check(
            "pressure within the tests of the friction law", Verdict.NOT_KNOWN,
            f"{_short(low)} N/mm²" if low == high else f"{low:.4g} to {high:.4g} N/mm²", "not known", source,
        ),
        Check("temperature at the start as in the tests", Verdict.NOT_KNOWN, f"{_short(ambient)} °C", "not known", source),
    ]  # fmt: skip
    beyond: list[str] = []
    if tested is not None:
        least, most = tested.pressure
        faster = speed > tested.speed[1] * (1.0 + SLACK)
        above, below = high > most * (1.0 + SLACK), low < least * (1.0 - SLACK)
        beyond += [f"faster than {tested.speed[1]:.4g} mm/s"] if faster else []
        beyond += [f"above {most:.4g} N/mm2"] if above else []
        beyond += [f"below {least:.4g} N/mm2"] if below else []
        checks[0] = replace(checks[0], verdict=Verdict.of(not faster), limit=f"at most {_short(tested.speed[1])} mm/s")  # fmt: skip
        checks[1] = replace(checks[1], verdict=Verdict.of(not (above or below)), limit=f"{_short(least)} to {_short(most)} N/mm²")  # fmt: skip
        if tested.ambient is not None:
            colder = abs(ambient - tested.ambient) > LARGEST_AMBIENT_CHANGE
            beyond += (
                [f"on plates of {ambient:g} °C at the start, not {tested.ambient:g} °C"] if colder else []
            )
            limit = f"{_short(tested.ambient)} ± {_short(LARGEST_AMBIENT_CHANGE)} °C"
            checks[2] = replace(checks[2], verdict=Verdict.of(not colder), limit=limit)
    if beyond:
        first = next(i for i, one in enumerate(checks) if one.verdict is Verdict.NOT_MET)
        remark = (
            f"{result.name}: outside of the tests behind the law {law.name} ({source}): {', '.join(beyond)}."
        )
        checks[first] = replace(checks[first], remark=remark)
    hottest = f"{_fixed(result.peak_temperature)} °C"
    limit = "the temperatures of the tests are not given"
    return [*checks, Check("temperature of the contact within the tests", Verdict.NOT_KNOWN, hottest, limit, source)]  # fmt: skip


def _stiff_spring(result: "Result") -> list[Check]:
    stretch = float((result.friction * result.load / result.bearing.elastic_stiffness).max())
    remark = (
        f"{result.name}: spring (b) is soft, it stretches {stretch:.1f} mm before sliding; the heat of friction is taken"
        " from the whole relative velocity, so temperatures are uncertain."
    )
    return [
        _judged(
            "spring (b) stiff: its stretch before sliding",
            at_most(stretch, LARGEST_YIELD_RADIUS),
            f"{stretch:.2f} mm",
            f"at most {_short(LARGEST_YIELD_RADIUS)} mm",
            _MODEL,
            "" if result.heating.name == "none" else remark,
        )
    ]


def _equal_plates(result: "Result") -> list[Check]:
    if result.plate_temperatures.shape[1] == 1:
        return []
    ratio = _largest_ratio(result)
    return [
        _judged(
            "coefficients of the two plates alike",
            at_most(ratio, LARGEST_RATIO),
            f"{100.0 * (ratio - 1.0):.0f} % apart",
            f"at most {100.0 * (LARGEST_RATIO - 1.0):.0f} %",
            _MODEL,
            f"{result.name}: the coefficients of the two plates differ by up to {100.0 * (ratio - 1.0):.0f} %, but the travel"
            " is shared as with equal ones.",
        )
    ]


def _half_space(result: "Result") -> list[Check]:
    age, heating = result.heat_age, result.heating
    name, found = "plates as endlessly thick: duration", f"{age:.1f} s"
    if heating.name == "none" or heating.thickness is not None:
        limit = "no heating" if heating.name == "none" else "thickness is taken into account"
        return [Check(name, Verdict.MET, found, limit, _MODEL)]
    remark = (
        f"{result.name}: so long after the plates were cold their thickness counts, but they are taken as endlessly thick; give their thickness"
        " and what their back does."
    )
    met = age <= LONGEST_HALF_SPACE and not result.cooled
    limit = f"at most {_short(LONGEST_HALF_SPACE)} s"
    checks = [_judged(name, Verdict.of(met), found, limit, _MODEL, remark if result.slides else "")]
    if age > result.memory:
        forgotten = f"{result.name}: the motion is longer than {result.memory:.0f} s; heat from longer ago fades too fast in the model."
        limit = f"at most {result.memory:.0f} s"
        name = "heat remembered by the model: duration"
        checks.append(
            _judged(name, Verdict.NOT_MET, found, limit, _MODEL, forgotten if result.slides else "")
        )
    return checks


for _name, _check in {
    "capacity": _capacity, "angle": _angle, "rest": _rest, "residual": _residual, "energy": _energy, "baseline": _baseline,
}.items():  # fmt: skip
    OF_RESPONSE.add(_name, _check)
for _name, _of_model in {
    "sliding": _sliding, "law": _law, "tests": _tested, "spring": _stiff_spring, "plates": _equal_plates, "half-space": _half_space,
}.items():  # fmt: skip
    OF_MODEL.add(_name, _of_model)


def _judged(name: str, verdict: Verdict, found: str, limit: str, source: str, remark: str) -> Check:
    """Return a check that has its remark only where it is not met."""
    return Check(name, verdict, found, limit, source, remark=remark if verdict is Verdict.NOT_MET else "")


def _largest_ratio(result: "Result") -> float:
    law, pressure = result.friction_law, result.load / result.bearing.slider_area
    speed, temperatures = np.abs(result.velocity), result.plate_temperatures
    first, second = (
        law.coefficient(pressure, speed * (share if law.speed_is_of_surface else 1.0), temperatures[:, i])
        for i, share in enumerate(result.bearing.shares)
    )
    ratio = first / second
    return float(max(ratio.max(), (1.0 / ratio).max()))


def _fixed(value: float) -> str:
    return number(value, 1).replace("-", "−")


def _short(value: float) -> str:
    return f"{value:.10g}".replace("-", "−")


def _power(value: float) -> str:
    return f"{value:.1e}".replace("-", "−") if value else "0"
