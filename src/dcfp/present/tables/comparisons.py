"""Comparisons of predictions with analyses as rows, for JSON and CSV."""

from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.present.tables.answers import answer_object
from dcfp.present.tables.columns import Column, table_text
from dcfp.present.tables.forecasts import pulse_object, value_columns, values

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.inference import Case, Setting
    from dcfp.inference.case import Quantity, View
    from dcfp.inference.held_out import Refit
    from dcfp.inference.intervals import Coverage
    from dcfp.inference.statistics import Scatter
    from dcfp.methods import Prediction


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
