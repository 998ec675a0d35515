"""Comparisons of predictions with analyses, predictions, and what methods of codes say, as rows with units in their names, for JSON and CSV."""

from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.present.tables.columns import Column, table_text
from dcfp.schema.check import COLUMNS
from dcfp.schema.table import Table

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.inference import Case, Setting
    from dcfp.inference.calibration import Intervals
    from dcfp.inference.case import Quantity, View
    from dcfp.inference.forecast import Forecast
    from dcfp.inference.held_out import Refit
    from dcfp.inference.intervals import Coverage
    from dcfp.inference.statistics import Scatter
    from dcfp.methods import Prediction, Pulses
    from dcfp.methods.panel import Panel
    from dcfp.methods.result import Answer


def case_objects(cases: "Sequence[Case]", setting: "Setting") -> list[dict[str, Any]]:
    """Return an object for each record and PGV, ready for JSON; what is not known is None."""
    from dcfp.inference.forecast import setting_remarks  # late: it imports the kernels

    return [
        {
            "record": case.record,
            "event": case.event,
            "pgv_m_s": round(case.pgv / 1e3, 12),
            "friction": setting.friction.name,
            "heating": setting.heating.name,
            "analysis": _known(case.analysed.whole),
            "governing_swing": _swing(case),
            "governing_pulse": None
            if case.analysed.pulse is None
            else pulse_object(case.pulses, case.analysed.pulse),
            "predictions": [
                {
                    "method": view[0].value,
                    "basis": view[1].value,
                    **_known(said),
                    "ratios": _ratios(case, view),
                }
                for view, said in case.predicted.items()
                if view[1].value != "spectrum"
            ],
            "codes": [answer_object(said) for said in case.answers.values()],
            "remarks": [*case.remarks, *setting_remarks(case.pgv, setting)],
        }
        for case in cases
    ]


def _outside(cases: "Sequence[Case]", method: str) -> int | None:
    """Return in how many cases a method is outside of its limits; None where it is not one of a code, or no limits are known."""
    said = [case.answers[method] for case in cases if method in case.answers]
    return sum(one.valid is False for one in said) if any(one.conditions for one in said) else None


def scatter_objects(
    found: "dict[tuple[View, Quantity], Scatter]", cases: "Sequence[Case]"
) -> list[dict[str, Any]]:
    """Return an object for each method, basis and quantity."""
    return [
        {
            "method": view[0].value,
            "basis": view[1].value,
            "quantity": quantity.name,
            "cases": one.number,
            "without_prediction": one.without,
            "share_below_analysis": _number(one.below),
            "least": _number(one.least),
            "largest": _number(one.largest),
            "median": _number(one.median),
            "bias": _number(one.bias),
            "dispersion": _number(one.dispersion),
            "outside_of_limits": _outside(cases, view[0].value),
        }
        for (view, quantity), one in found.items()
    ]


def held_out_object(
    coverages: "dict[tuple[View | None, Quantity], Coverage]", refits: "Sequence[Refit]"
) -> dict[str, Any]:
    """Return coverage of intervals and refitted constants, ready for JSON."""
    return {
        "coverage": [
            {
                "method": "PGV only" if view is None else view[0].value,
                "quantity": quantity.name,
                "mean": one.mean,
                "p05": one.low,
                "p95": one.high,
                "width": one.width,
                "splits": one.splits,
            }
            for (view, quantity), one in coverages.items()
        ],
        "refits": [
            {
                "method": one.method.value,
                "constants_from": one.words,
                "kg_ave_mm_s2": one.constants.average_slope,
                "eps": one.constants.fall_ratio,
                "zeta": one.constants.change_ratio,
                "bias": one.bias,
                "dispersion": one.dispersion,
            }
            for one in refits
        ],
    }


def cases_csv(cases: "Sequence[Case]") -> str:
    """Return a line for each record, PGV and method, the analysis among them."""
    columns = [Column(key, key) for key in ("record", "event", "pgv_m_s", "method", "basis")]
    columns += [*value_columns(), Column("verdict", "verdict")]
    rows: list[dict[str, Any]] = []
    for case in cases:
        head: dict[str, Any] = {
            "record": case.record,
            "event": case.event,
            "pgv_m_s": round(case.pgv / 1e3, 12),
        }
        rows.append({**head, "method": "analysis", "basis": "", **_known(case.analysed.whole), "verdict": ""})
        rows += [
            {
                **head,
                "method": view[0].value,
                "basis": view[1].value,
                **_known(said),
                "verdict": case.answers[view[0].value].verdict if view[0].value in case.answers else "",
            }
            for view, said in case.predicted.items()
        ]
    return table_text(columns, rows)


def _swing(case: "Case") -> dict[str, float] | None:
    swing = case.analysed.swing
    if swing is None:
        return None
    return {
        "start_s": swing.start,
        "end_s": swing.end,
        "dy_mm": swing.change,
        "V_dE_mm_s": swing.input_velocity,
        "V_dEr_mm_s": swing.net_input_velocity,
        "V_dEhr_mm_s": swing.hysteretic_velocity,
    }


def _ratios(case: "Case", view: "View") -> dict[str, float | None]:
    from dcfp.inference.case import QUANTITIES
    from dcfp.inference.statistics import ratios

    return {quantity.name: _number(float(ratios([case], view, quantity)[0])) for quantity in QUANTITIES}


def _known(prediction: "Prediction") -> dict[str, float | None]:
    return {key: _number(value) for key, value in values(prediction).items()}


def _number(value: float | None) -> float | None:
    return None if value is None or not np.isfinite(value) else value


# What methods of codes say.


def answer_object(said: "Answer") -> dict[str, Any]:
    """Return an answer with its verdict, its conditions and its iteration, ready for JSON."""
    return {
        "method": said.method,
        "displacement_mm": said.displacement,
        "base_shear_over_weight": said.base_shear,
        "effective_period_s": said.period,
        "effective_damping": said.damping,
        "within_limits": said.valid if said.conditions else None,
        "verdict": said.verdict,
        "conditions": Table(COLUMNS, said.conditions).objects(),
        "iteration": [
            {
                "displacement_mm": one.displacement,
                "period_s": one.period,
                "damping": one.damping,
                "reduction": one.reduction,
            }
            for one in said.steps
        ],
        "unconfirmed": list(said.unconfirmed),
        "remarks": list(said.remarks),
    }


def panel_object(panel: "Panel") -> dict[str, Any]:
    """Return what every method says of one demand, ready for JSON."""
    return {
        "name": panel.name,
        "pgv_m_s": None if panel.pgv is None else round(panel.pgv / 1e3, 12),
        "friction": panel.pendulum.friction,
        "radius_mm": panel.pendulum.radius,
        "analysis": None
        if panel.displacement is None
        else {"displacement_mm": panel.displacement, "base_shear_over_weight": panel.base_shear},
        "answers": [answer_object(said) for said in panel.answers.values()],
        "without_solution": list(panel.missing),
        "remarks": list(panel.remarks),
    }


def panels_csv(panels: "Sequence[Panel]") -> str:
    """Return a line for each demand and method, the analysis among them."""
    columns = [
        Column("name", "name"),
        Column("pgv_m_s", "pgv", "m s-1"),
        Column("method", "method"),
        Column("displacement_mm", "displacement", "mm"),
        Column("base_shear_over_weight", "base_shear_over_weight", "1"),
        Column("effective_period_s", "effective_period", "s"),
        Column("effective_damping", "effective_damping", "1"),
        Column("verdict", "verdict"),
    ]
    rows: list[dict[str, Any]] = []
    for panel in panels:
        said = panel_object(panel)
        head = {"name": said["name"], "pgv_m_s": said["pgv_m_s"]}
        if said["analysis"] is not None:
            blank = {"effective_period_s": None, "effective_damping": None, "verdict": ""}
            rows.append({**head, "method": "analysis", **said["analysis"], **blank})
        rows += [{**head, **answer} for answer in said["answers"]]
    return table_text(columns, rows)


# Predictions.


_WORDS = ("record", "pgv_m_s", "method", "basis")
_KEYS = ("dy_mm", "y_mm", "V_dE_mm_s", "V_dEhr_mm_s", "V_E_mm_s")
_PLACES = ("pulse_start_s", "pulse_peak_s", "pulse_end_s")
_ENDS = ("low", "median", "high")
_INTERVALS = tuple(f"{key}_{end}" for key in _KEYS for end in _ENDS)
_UNITS = {"m_s": "m s-1", "mm_s": "mm s-1", "mm": "mm", "s": "s"}


def forecast_objects(forecasts: "Sequence[Forecast]", setting: "Setting") -> list[dict[str, Any]]:
    """Return an object for each record and PGV, ready for JSON."""
    return [
        {
            "record": None if one.motion is None else one.motion.name,
            "pgv_m_s": round(one.pgv / 1e3, 12),
            "friction": setting.friction.name,
            "heating": setting.heating.name,
            "nominal_friction": setting.constants.nominal_friction,
            "pulses": None if one.pulses is None else one.pulses.count,
            "predictions": [_prediction_object(one, view) for view in one.predicted],
            "interval_from_pgv": _interval_object(one.intervals.get(None)),
            "remarks": list(one.remarks),
        }
        for one in forecasts
    ]


def forecasts_csv(forecasts: "Sequence[Forecast]") -> str:
    """Return a line for each record, PGV and method; an interval that was not asked for leaves its cells empty."""
    columns = [Column(key, key) for key in _WORDS]
    columns += [*value_columns(), *(Column(key, key.removesuffix("_s"), _unit(key)) for key in _PLACES)]
    columns += [Column(key, _without_unit(key), _unit(key)) for key in _INTERVALS]
    rows = [_flat(one, view) for one in forecasts for view in one.predicted]
    rows += [_flat_from_pgv(one) for one in forecasts if None in one.intervals]
    return table_text(columns, rows)


def value_columns() -> list[Column]:
    """Return the columns of the quantities of a prediction."""
    return [Column(key, _without_unit(key), _unit(key)) for key in _KEYS]


def values(prediction: "Prediction") -> dict[str, float | None]:
    """Return the quantities of a prediction by their keys; None where it has none."""
    return {
        "dy_mm": prediction.displacement_change,
        "y_mm": prediction.displacement,
        "V_dE_mm_s": prediction.input_velocity,
        "V_dEhr_mm_s": prediction.hysteretic_velocity,
        "V_E_mm_s": prediction.total_velocity,
    }


def _prediction_object(one: "Forecast", view: "View") -> dict[str, Any]:
    method, basis = view
    place = one.governing.get(view)
    return {
        "method": method.value,
        "basis": basis.value,
        **values(one.predicted[view]),
        "pulse": None if place is None or one.pulses is None else pulse_object(one.pulses, place),
        "interval": _interval_object(one.intervals.get(view)),
    }


def pulse_object(pulses: "Pulses", place: int) -> dict[str, float]:
    """Return what a pulse is, its number counted from zero."""
    return {
        "start_s": float(pulses.starts[place]),
        "peak_s": float(pulses.peaks[place]),
        "end_s": float(pulses.ends[place]),
        "dvg_mm_s": float(pulses.changes[place]),
        "kg_mm_s2": float(pulses.mean_accelerations[place]),
        "kg_next_mm_s2": float(pulses.next_mean_accelerations[place]),
    }


def _interval_object(intervals: "Intervals | None") -> dict[str, Any] | None:
    if intervals is None:
        return None
    return {
        quantity.key: {"low": one.low, "median": one.median, "high": one.high, "cases": one.cases}
        for quantity, one in intervals.items()
    }


def _flat(one: "Forecast", view: "View") -> dict[str, object]:
    method, basis = view
    place = one.governing.get(view)
    pulse = {} if place is None or one.pulses is None else pulse_object(one.pulses, place)
    return {
        **_head(one),
        "method": method.value,
        "basis": basis.value,
        **values(one.predicted[view]),
        **{place: pulse.get(place.removeprefix("pulse_")) for place in _PLACES},
        **_flat_intervals(one.intervals.get(view)),
    }


def _flat_from_pgv(one: "Forecast") -> dict[str, object]:
    return {
        **_head(one),
        "method": "analyses of other records",
        "basis": "PGV only",
        **dict.fromkeys((*_KEYS, *_PLACES)),
        **_flat_intervals(one.intervals[None]),
    }


def _head(one: "Forecast") -> dict[str, object]:
    return {"record": None if one.motion is None else one.motion.name, "pgv_m_s": round(one.pgv / 1e3, 12)}


def _flat_intervals(intervals: "Intervals | None") -> dict[str, Any]:
    flat: dict[str, Any] = dict.fromkeys(_INTERVALS)
    for quantity, one in (intervals or {}).items():
        flat |= {f"{quantity.key}_{end}": getattr(one, end) for end in _ENDS}
    return flat


def _unit(key: str) -> str:
    stem = key.rpartition("_")[0] if key.endswith(_ENDS) else key
    return next(unit for ending, unit in _UNITS.items() if stem.endswith(f"_{ending}"))


def _without_unit(key: str) -> str:
    """Return a key without its unit: ``"dy_mm_low"`` is ``"dy_low"``."""
    stem, end = (key.rpartition("_")[0], f"_{key.rpartition('_')[2]}") if key.endswith(_ENDS) else (key, "")
    return next(stem.removesuffix(f"_{unit}") for unit in _UNITS if stem.endswith(f"_{unit}")) + end
