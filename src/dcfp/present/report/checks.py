"""What is checked of every analysis, each with what was found, what is allowed, and who says so."""

from dataclasses import replace

import numpy as np

from dcfp.analysis import Response
from dcfp.motion.measures import DRIFT_THRESHOLD, baseline_drift
from dcfp.present.report.document import powered, short, written
from dcfp.schema.check import Check, Verdict, at_most
from dcfp.study.scenario import Result
from dcfp.system.validity import (
    LARGEST_AMBIENT_CHANGE,
    LARGEST_ANGLE,
    LARGEST_YIELD_RADIUS,
    LONGEST_HALF_SPACE,
)

#: Largest residual of the energy balance over the largest input energy [-]; an analysis closes to rounding, about 1e-14.
LARGEST_RESIDUAL = 1e-9
#: How far beyond the tests a law may be used without a remark, as in the remarks of an analysis [-].
_SLACK = 1.01
_MODEL = "assumption of the model"


ANALYSIS = "analysis"


def label_of(result: Result) -> str:
    """Return the name of a case: the record and the PGV."""
    return f"{result.motion.name}, {written('pgv_m_s', result.motion.peak_velocity / 1e3)} m/s"


def checks_of(result: Result) -> tuple[Check, ...]:
    """Return every check of a case: those of the analysis, then the conditions of each code."""
    of_analysis = [replace(one, of=ANALYSIS) for one in analysis_checks(result.response)]
    of_codes = [
        replace(one, of=name) for name, said in result.case.answers.items() for one in said.conditions
    ]
    return (*of_analysis, *of_codes)


def analysis_checks(response: Response) -> tuple[Check, ...]:
    """Return the checks of an analysis."""
    return (
        _capacity(response),
        _angle(response),
        Check(
            "at rest at the end",
            Verdict.MET if response.rests else Verdict.NOT_MET,
            "at rest" if response.rests else "still moving",
            "no sliding can come any more",
            "analysis",
        ),
        _residual(response),
        _energy(response),
        *_tests(response),
        _yield_radius(response),
        _half_space(response),
        _baseline(response),
    )


def _capacity(response: Response) -> Check:
    capacity, found = response.bearing.displacement_capacity, response.peak_displacement
    return Check(
        "largest displacement within the capacity",
        # as the status of the analysis has it, to the last digit
        Verdict.NOT_KNOWN if capacity is None else (Verdict.MET if found <= capacity else Verdict.NOT_MET),
        f"{written('y_max_mm', found)} mm",
        "no capacity given" if capacity is None else f"at most {short(capacity)} mm",
        "scenario" if capacity is None else response.bearing.capacity_note or "capacity of the scenario",
    )


def _angle(response: Response) -> Check:
    far = LARGEST_ANGLE * response.bearing.effective_radius
    return Check(
        "largest displacement in the linear range of the pendulum",
        at_most(response.peak_displacement, far),
        f"{written('y_max_mm', response.peak_displacement)} mm",
        f"at most {written('y_max_mm', far)} mm, half of the effective radius",
        _MODEL,
    )


def _residual(response: Response) -> Check:
    most = float(response.friction[-1]) * response.bearing.effective_radius
    return Check(
        "residual displacement one that friction can hold",
        at_most(abs(response.residual_displacement), most),
        f"{written('residual_mm', response.residual_displacement)} mm of {written('residual_mm', most)} mm",
        "at most the coefficient of friction at the end times the effective radius",
        "mechanics; no code's limit is set",
    )


def _energy(response: Response) -> Check:
    found = response.energy.relative_residual
    return Check(
        "energy balance, residual over the largest input",
        at_most(found, LARGEST_RESIDUAL),
        powered(found),
        f"at most {powered(LARGEST_RESIDUAL)}",
        "Li et al. (2020), Eq. (6)",
    )


def _tests(response: Response) -> tuple[Check, ...]:
    tested = response.friction_law.tests()
    pressure, ambient = response.bearing.pressure, response.heating.ambient
    speed, highest = response.peak_velocity, response.peak_temperature
    source = "no tests known of this law" if tested is None else tested.source
    found = (f"{written('v_max_mm_s', speed)} mm/s", f"{short(pressure)} N/mm²", f"{short(ambient)} °C")
    names = (
        "speed within the tests of the friction law",
        "pressure within the tests of the friction law",
        "temperature at the start as in the tests",
    )
    limits, verdicts = ["not known"] * 3, [Verdict.NOT_KNOWN] * 3
    if tested is not None:
        low, high = tested.pressure
        limits[0], verdicts[0] = (
            f"at most {short(tested.speed[1])} mm/s",
            at_most(speed, _SLACK * tested.speed[1]),
        )
        inside = low / _SLACK <= pressure <= high * _SLACK
        limits[1] = f"{short(low)} to {short(high)} N/mm²"
        verdicts[1] = Verdict.MET if inside else Verdict.NOT_MET
        if tested.ambient is not None:
            limits[2] = f"{short(tested.ambient)} ± {short(LARGEST_AMBIENT_CHANGE)} °C"
            verdicts[2] = at_most(abs(ambient - tested.ambient), LARGEST_AMBIENT_CHANGE)
    return (
        *(
            Check(name, verdict, value, limit, source)
            for name, verdict, value, limit in zip(names, verdicts, found, limits, strict=True)
        ),
        Check(
            "temperature of the contact within the tests",
            Verdict.NOT_KNOWN,
            f"{written('temperature_max_degC', highest)} °C",
            "the temperatures of the tests are not given",
            source,
        ),
    )


def _yield_radius(response: Response) -> Check:
    bearing = response.bearing
    radius = float(np.max(response.friction)) * bearing.vertical_force / bearing.elastic_stiffness
    return Check(
        "spring (b) stiff: its stretch before sliding",
        at_most(radius, LARGEST_YIELD_RADIUS),
        f"{radius:.2f} mm",
        f"at most {short(LARGEST_YIELD_RADIUS)} mm",
        _MODEL,
    )


def _half_space(response: Response) -> Check:
    duration = float(response.time[-1])
    heating = response.heating
    name, found = "plates as endlessly thick: duration", f"{duration:.1f} s"
    if heating.name == "none" or heating.thickness is not None:
        limit = "no heating" if heating.name == "none" else "thickness is taken into account"
        return Check(name, Verdict.MET, found, limit, _MODEL)
    return Check(
        name, at_most(duration, LONGEST_HALF_SPACE), found, f"at most {short(LONGEST_HALF_SPACE)} s", _MODEL
    )


def _baseline(response: Response) -> Check:
    drift = baseline_drift(response.motion)
    return Check(
        "baseline of the record: velocity at its end over PGV",
        at_most(drift, DRIFT_THRESHOLD),
        f"{100.0 * drift:.1f} %",
        f"at most {100.0 * DRIFT_THRESHOLD:.0f} %",
        "hundred records of FEMA P-695",
    )
