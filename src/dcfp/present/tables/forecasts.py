"""Predictions as rows with units in their names, for JSON and CSV."""

from typing import TYPE_CHECKING, Any

from dcfp.present.tables.columns import Column, table_text

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.inference.calibration import Intervals
    from dcfp.inference.case import Setting, View
    from dcfp.inference.forecast import Forecast
    from dcfp.methods import Prediction, Pulses

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
