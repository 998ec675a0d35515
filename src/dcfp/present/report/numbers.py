"""Every number of a report, ready for JSON."""

from dataclasses import asdict
from typing import Any

from dcfp.analysis.response import remarks_on
from dcfp.kernels._jit import source_digest
from dcfp.present.report.checks import checks_of
from dcfp.present.report.digits import DECIMALS
from dcfp.present.report.document import Formula
from dcfp.present.report.references import sources_of
from dcfp.present.report.versions import versions
from dcfp.present.tables.comparisons import case_objects
from dcfp.study.scenario import Calculation, Result
from dcfp.version import version

_KILO, _MEGA = 1e3, 1e6


def numbers_of(calculation: Calculation, formulas: tuple[Formula, ...]) -> dict[str, Any]:
    """Return the numbers of a report.

    Parameters
    ----------
    calculation
        The results; ``cases`` has an object for each, with the keys of ``dcfp respond --json`` and of ``dcfp compare --json``.
    formulas
        Those that are worked out in the report.
    """
    scenario = calculation.scenario
    model = scenario.model
    digests = {motion.name: motion.digest for motion in scenario.study.motions}
    compared = case_objects([one.case for one in calculation.results], calculation.setting)
    return {
        "title": scenario.title,
        "report": asdict(scenario.heading),
        "version": version(),
        "kernels_sha256": source_digest(),
        "versions": versions(),
        "decimals": DECIMALS,
        "bearing": asdict(model.bearing)
        | {
            "vertical_force_N": model.bearing.vertical_force,
            "mass_t": model.bearing.mass,
            "restoring_stiffness_N_mm": model.bearing.restoring_stiffness,
            "period_s": model.bearing.period,
        },
        "friction_law": repr(model.friction),
        "heating_model": repr(model.heating),
        "settings": asdict(scenario.study.settings),
        "nominal_friction": calculation.nominal.value,
        "nominal_friction_source": calculation.nominal.source,
        "cases": [
            _case(one, row, found) | {"record_sha256": digests[one.motion.name]}
            for one, row, found in zip(calculation.results, calculation.summary, compared, strict=True)
        ],
        "formulas": [one.as_numbers() for one in formulas],
        "references": list(sources_of(calculation)),
    }


def energies_of(result: Result) -> dict[str, float]:
    """Return the energies at the end of an analysis [kN m], and the residual of their balance over the largest input [-]."""
    energy = result.response.energy
    ends = {
        "input": energy.input,
        "hysteretic": energy.hysteretic,
        "strain": energy.strain,
        "kinetic": energy.kinetic,
        "absolute_input": energy.absolute_input,
        "residual": energy.residual,
    }
    return {f"{name}_kN_m": float(values[-1]) / _MEGA for name, values in ends.items()} | {
        "largest_residual_over_largest_input": energy.relative_residual
    }


def _case(one: Result, row: dict[str, Any], compared: dict[str, Any]) -> dict[str, Any]:
    motion = one.motion
    return {
        **compared,
        **row,
        "remarks": remarks_on(one.response),
        "pga_m_s2": motion.peak_acceleration / _KILO,
        "scaled_record_sha256": motion.digest,
        "record_origin": asdict(motion.origin),
        "record_treatment": list(motion.treatment),
        "energies": energies_of(one),
        "checks": [
            {"of": check.of, **asdict(check.condition), "verdict": check.condition.verdict.value}
            for check in checks_of(one)
        ],
    }
