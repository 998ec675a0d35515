"""What an analysis or a test assumes and what it ought to keep to, each checked once: remarks, reports and the page all read these checks."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.motion.measures import DRIFT_THRESHOLD, baseline_drift
from dcfp.schema.check import Check, Verdict, at_most
from dcfp.schema.formulas import true_minus, typeset
from dcfp.schema.registry import Registry

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from dcfp.analysis.response import RigidResponse
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
OF_RESPONSE: "Registry[Callable[[RigidResponse], Iterable[Check]]]" = Registry("check of a response")


def _capacity(response: "RigidResponse") -> list[Check]:
    bearing, found = response.bearing, response.peak_displacement
    capacity, note = bearing.displacement_capacity, bearing.capacity_note
    name, words = "largest displacement within the capacity", f"{_fixed(found)} mm"
    if capacity is None:
        return [Check(name, Verdict.NOT_KNOWN, words, "no capacity given", "scenario")]
    remark = (
        f"{response.name}: the displacement of {found:.0f} mm exceeds the capacity of {capacity:.0f} mm"
        f"{f' ({note})' if note else ''}."
    )
    # as the status of the analysis has it, to the last digit
    verdict, limit = Verdict.of(found <= capacity), f"at most {_short(capacity)} mm"
    return [_judged(name, verdict, words, limit, note or "capacity of the scenario", remark)]


def _angle(response: "RigidResponse") -> list[Check]:
    found, far = response.peak_displacement, LARGEST_ANGLE * response.bearing.effective_radius
    remark = (
        f"{response.name}: the displacement of {found:.0f} mm exceeds {far:.0f} mm, half of the effective radius,"
        " where the pendulum's force is no longer linear and a plate is hardly as large."
    )
    name = "largest displacement in the linear range of the pendulum"
    limit = f"at most {_fixed(far)} mm, half of the effective radius"
    return [_judged(name, at_most(found, far), f"{_fixed(found)} mm", limit, remark=remark)]


def _rest(response: "RigidResponse") -> list[Check]:
    found = "at rest" if response.rests else "still moving"
    limit = "no sliding can come any more"
    remark = f"{response.name}: it still moves at the end, so the residual displacement is not final."
    return [_judged("at rest at the end", Verdict.of(response.rests), found, limit, "analysis", remark)]


def _residual(response: "RigidResponse") -> list[Check]:
    most = float(response.friction[-1]) * response.bearing.effective_radius
    found = response.residual_displacement
    name = "residual displacement one that friction can hold"
    words = f"{_fixed(found)} mm of {_fixed(most)} mm"
    limit = "at most the coefficient of friction at the end times the effective radius"
    return [Check(name, at_most(abs(found), most), words, limit, "mechanics; no code's limit is set")]


def _energy(response: "RigidResponse") -> list[Check]:
    found, most = response.energy.relative_residual, LARGEST_RESIDUAL
    name = "energy balance, residual over the largest input"
    limit = f"at most {_power(most)}"
    return [Check(name, at_most(found, most), _power(found), limit, "Li et al. (2020), Eq. (6)")]


def _baseline(response: "RigidResponse") -> list[Check]:
    drift, most = baseline_drift(response.motion), DRIFT_THRESHOLD
    name = "baseline of the record: velocity at its end over PGV"
    found, limit = f"{100.0 * drift:.1f} %", f"at most {100.0 * most:.0f} %"
    # what is to be said of it, the motion says itself
    return [Check(name, at_most(drift, most), found, limit, "hundred records of FEMA P-695")]


def _sliding(result: "Result") -> list[Check]:
    if not result.velocity.any():
        return []
    found = "it slides" if result.slides else "it never slides"
    remark = f"{result.name}: it never slides, so that forces, stiffness and friction are those of spring (b) alone."
    return [
        _judged("it slides", Verdict.of(result.slides), found, "friction is that of sliding", remark=remark)
    ]


def _law(result: "Result") -> list[Check]:
    law = result.friction_law
    if not law.caution:
        return []
    remark = f"Friction law {law.name}: {law.caution}"
    return [
        Check("friction law without reservations", Verdict.NOT_KNOWN, law.name, "", law.name, remark=remark)
    ]


def _tests(result: "Result") -> list[Check]:
    """Return checks of speed, pressure and temperature against the tests behind the law; the first that is not met has the remark on all of them."""
    law, tested = result.friction_law, result.friction_law.tests()
    pressure = result.load / result.bearing.slider_area
    speed, ambient = result.peak_velocity, result.heating.ambient
    low, high = float(pressure.min()), float(pressure.max())
    at = f"{_short(low)} N/mm²" if low == high else f"{low:.4g} to {high:.4g} N/mm²"
    limits: list[str | None] = [None, None, None]
    beyond: list[list[str]] = [[], [], []]
    if tested is not None:
        fastest, (least, most) = tested.speed[1], tested.pressure
        limits[:2] = f"at most {_short(fastest)} mm/s", f"{_short(least)} to {_short(most)} N/mm²"
        if speed > fastest * (1.0 + SLACK):
            beyond[0].append(f"faster than {fastest:.4g} mm/s")
        if high > most * (1.0 + SLACK):
            beyond[1].append(f"above {most:.4g} N/mm2")
        if low < least * (1.0 - SLACK):
            beyond[1].append(f"below {least:.4g} N/mm2")
    if tested is not None and tested.ambient is not None:
        limits[2] = f"{_short(tested.ambient)} ± {_short(LARGEST_AMBIENT_CHANGE)} °C"
        if abs(ambient - tested.ambient) > LARGEST_AMBIENT_CHANGE:
            beyond[2].append(f"on plates of {ambient:g} °C at the start, not {tested.ambient:g} °C")
    source = "no tests known of this law" if tested is None else tested.source
    words = ", ".join(one for some in beyond for one in some)
    remark = f"{result.name}: outside of the tests behind the law {law.name} ({source}): {words}."
    names = ("speed within", "pressure within", "temperature at the start as in")
    checks: list[Check] = []
    for name, found, limit, some in zip(
        names, (f"{_fixed(speed)} mm/s", at, f"{_short(ambient)} °C"), limits, beyond, strict=True
    ):
        of_law = f"{name} the tests" + (" of the friction law" if name.endswith("within") else "")
        verdict = Verdict.of(None if limit is None else not some)
        said = remark if some and all(one.verdict is not Verdict.NOT_MET for one in checks) else ""
        checks.append(Check(of_law, verdict, found, limit or "not known", source, remark=said))
    hottest = f"{_fixed(result.peak_temperature)} °C"
    limit = "the temperatures of the tests are not given"
    name = "temperature of the contact within the tests"
    return [*checks, Check(name, Verdict.NOT_KNOWN, hottest, limit, source)]


def _spring(result: "Result") -> list[Check]:
    stretch = float((result.friction * result.load / result.bearing.elastic_stiffness).max())
    remark = (
        f"{result.name}: spring (b) is soft, it stretches {stretch:.1f} mm before sliding; the heat of friction is taken"
        " from the whole relative velocity, so temperatures are uncertain."
    )
    name, verdict = "spring (b) stiff: its stretch before sliding", at_most(stretch, LARGEST_YIELD_RADIUS)
    limit = f"at most {_short(LARGEST_YIELD_RADIUS)} mm"
    said = "" if result.heating.name == "none" else remark
    return [_judged(name, verdict, f"{stretch:.2f} mm", limit, remark=said)]


def _plates(result: "Result") -> list[Check]:
    if result.plate_temperatures.shape[1] == 1:
        return []
    ratio = _largest_ratio(result)
    apart, most = 100.0 * (ratio - 1.0), 100.0 * (LARGEST_RATIO - 1.0)
    remark = (
        f"{result.name}: the coefficients of the two plates differ by up to {apart:.0f} %, but the travel"
        " is shared as with equal ones."
    )
    name, verdict = "coefficients of the two plates alike", at_most(ratio, LARGEST_RATIO)
    return [_judged(name, verdict, f"{apart:.0f} % apart", f"at most {most:.0f} %", remark=remark)]


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
    forgotten = f"{result.name}: the motion is longer than {result.memory:.0f} s; heat from longer ago fades too fast in the model."
    met = age <= LONGEST_HALF_SPACE and not result.cooled
    limit = f"at most {_short(LONGEST_HALF_SPACE)} s"
    checks = [_judged(name, Verdict.of(met), found, limit, remark=remark if result.slides else "")]
    if age > result.memory:
        name, limit = "heat remembered by the model: duration", f"at most {result.memory:.0f} s"
        said = forgotten if result.slides else ""
        checks.append(_judged(name, Verdict.NOT_MET, found, limit, remark=said))
    return checks


for _check in (_capacity, _angle, _rest, _residual, _energy, _baseline):
    OF_RESPONSE.add(_check.__name__.strip("_"), _check)
for _of_model in (_sliding, _law, _tests, _spring, _plates, _half_space):
    OF_MODEL.add(_of_model.__name__.strip("_"), _of_model)


def _judged(
    name: str, verdict: Verdict, found: str, limit: str, source: str = _MODEL, remark: str = ""
) -> Check:
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
    return typeset(value, 1)


def _short(value: float) -> str:
    return true_minus(f"{value:.10g}")


def _power(value: float) -> str:
    return true_minus(f"{value:.1e}") if value else "0"
