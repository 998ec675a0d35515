"""What is predicted of stations beside the analysis in the plane."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from dcfp.analysis.plane_history import analyse_plane
from dcfp.inference.plane_forecast import (
    COMPARED,
    PlaneForecast,
    forecast_station,
    peaks_of,
    station_lines,
    station_objects,
)
from dcfp.inference.statistics import ratio, scatter
from dcfp.inference.told import SCATTER, Measured
from dcfp.methods.method import Variant
from dcfp.methods.prediction import Methods
from dcfp.methods.pulses import PREDICTION_QUANTITIES
from dcfp.motion.station import Station
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import NONE


@dataclass(frozen=True, eq=False)
class StationComparison:
    """A station at one PGV: what the analysis in the plane gives, as a forecast that knows all, and what is predicted."""

    analysed: PlaneForecast
    forecasts: Sequence[PlaneForecast]
    remarks: Sequence[str]  #: of the analysis and the predictions


def compare_station(station: Station, methods: Methods) -> StationComparison:
    """Analyse a station in the plane, and predict it as `forecast_station` does."""
    response = analyse_plane(station, methods.system)
    analysed = PlaneForecast(
        station, methods.system, "analysis", peaks_of(response), peak_temperature=response.peak_temperature
    )
    forecasts = forecast_station(station, methods)
    told = dict.fromkeys([*response.all_remarks, *(remark for one in forecasts for remark in one.remarks)])
    return StationComparison(analysed, forecasts, tuple(told))


class _Line(NamedTuple):
    """A forecast, or the analysis itself, beside the analysis."""

    forecast: PlaneForecast
    analysed: PlaneForecast


def _of_forecast(quantity: Quantity) -> Quantity:
    def get(one: _Line) -> Any:
        return quantity.of(one.forecast)

    return replace(quantity, get=get)


def _of_ratio(quantity: Quantity) -> Quantity:
    def get(one: _Line) -> float | None:
        if one.forecast is one.analysed:
            return None
        return ratio(one.forecast.prediction, one.analysed.prediction, quantity)

    name = quantity.head or quantity.title
    words = f"{name} over that of the analysis"
    return Quantity(f"{quantity.title}_ratio", words, NONE, decimals=2, head=f"{name}\nratio", get=get)


def comparison_lines(cases: Sequence[StationComparison]) -> Table:
    """Return a line for the analysis of each station and PGV, and one for each prediction with its ratios to it."""
    columns = tuple(_of_forecast(one) for one in station_lines([], with_intervals=False).columns)
    lines = [_Line(one, case.analysed) for case in cases for one in (case.analysed, *case.forecasts)]
    return Table((*columns, *map(_of_ratio, COMPARED)), lines)


def comparison_scatter(cases: Sequence[StationComparison]) -> Table:
    """Return the measures of the ratios of each method and quantity, over all cases."""
    told: dict[tuple[Variant, Quantity], list[float]] = {}
    for case in cases:
        for one in case.forecasts:
            for quantity in COMPARED:
                of_analysis = ratio(one.prediction, case.analysed.prediction, quantity)
                told.setdefault((Variant(one.method, one.basis), quantity), []).append(of_analysis)
    rows = [
        Measured(*key, scatter(np.array(ratios)))
        for key, ratios in told.items()
        if any(map(math.isfinite, ratios))
    ]
    return Table(tuple(SCATTER), rows)


def comparison_objects(cases: Sequence[StationComparison]) -> list[dict[str, Any]]:
    """Return an object for each station and PGV, ready for JSON: the analysis, the predictions with their ratios to it, and what a reader must know."""
    found: list[dict[str, Any]] = []
    for case in cases:
        (told,) = station_objects(case.forecasts)
        del told["interval_from_spectrum"]
        for prediction, one in zip(told["predictions"], case.forecasts, strict=True):
            ratios = {kind.title: ratio(one.prediction, case.analysed.prediction, kind) for kind in COMPARED}
            del prediction["interval"]
            prediction["ratios"] = {
                name: value if math.isfinite(value) else None for name, value in ratios.items()
            }
        (analysis,) = Table(tuple(PREDICTION_QUANTITIES.values()), [case.analysed.prediction]).objects()
        analysis["temperature_max_degC"] = case.analysed.peak_temperature
        found.append(told | {"analysis": analysis, "remarks": list(case.remarks)})
    return found
