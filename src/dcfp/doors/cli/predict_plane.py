"""``dcfp predict`` of stations: displacement and energy in the plane."""

import argparse
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Block, Page, grid, grouped, progress
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.errors import InputError
from dcfp.inference.plane_forecast import (
    BY_SPECTRUM,
    DIRECTIONS,
    SET,
    PlaneForecast,
    StationCase,
    calibration_stations,
    forecast_station,
    station_cases,
    station_interval_lines,
    station_lines,
    station_objects,
)
from dcfp.methods.directions import DIRECTIONS as PARTS
from dcfp.methods.plane_march import NAME
from dcfp.methods.prediction import Methods
from dcfp.motion.station import Station

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: What the columns are, what the methods are, and what there is not.
NOTES = (
    "y_max: largest displacement in the plane; dy: largest change of displacement from one peak to the next, in whatever direction; V_E: equivalent velocity sqrt(2E/m)"
    " of all the energy put in; T: highest temperature of the contact.",
    f"{NAME}: of our own, along straight legs between nodes of the ground velocity that both directions share; {DIRECTIONS}: the march of each direction by itself, root of the sum"
    " of the squares, for comparison.",
    f"The methods of Li et al. (2020) are of one direction: those of pulses are put to {PARTS} directions, and what is told is of the one with the largest dy, from x towards y; the design method has the PGV"
    " of the resultant. That is ours; over FEMA P-695 with the bearing of the paper dy is 1.3 to 2.1 times the y_max in the plane in the mean.",
)


def run(
    chosen: argparse.Namespace,
    stations: Sequence[Station],
    methods: Methods,
    above: list[tuple[str, str]],
) -> Answer:
    """Predict every station at every PGV; `above` stands above the tables."""
    moved = inputs.scaled(stations, chosen.pgv)
    figure = figure_of(chosen, moved, methods)
    known = _calibrations(moved, methods) if chosen.interval else {}
    forecasts = [
        one for station in moved for one in forecast_station(station, methods, known.get(_pgv(station)))
    ]
    told = grouped((one.station.name, remark) for one in forecasts for remark in one.remarks)
    return Answer(
        lambda: station_objects(forecasts),
        lambda: _page(above, forecasts, told),
        lambda part, kind: station_lines(forecasts).csv(),
        figure,
    )


def figure_of(
    chosen: argparse.Namespace, moved: Sequence[Station], methods: Methods
) -> "Callable[[], Figure]":
    """Return what draws the one station at one PGV; more are refused where a figure is asked for."""
    if chosen.plot and len(moved) > 1:
        msg = f"--plot draws one station at one PGV, not {len(moved)}; name one, such as {moved[0].name}, and one --pgv, or leave it out."
        raise InputError(msg)
    return drawn("plane_prediction.plot_plane_prediction", moved[0], methods)


def _page(above: list[tuple[str, str]], forecasts: Sequence[PlaneForecast], told: Sequence[str]) -> Page:
    said = [one for one in forecasts if one.method != BY_SPECTRUM]
    blocks: list[Block] = [above, grid(station_lines(said), 2)]
    notes = [*told, *NOTES]
    if any(one.intervals for one in forecasts):
        blocks.append(grid(station_interval_lines(forecasts), 2))
        notes.append(
            f"Intervals hold 90 % of analyses of this bearing in the plane: from {SET} at the same PGV."
        )
    return Page(blocks, notes)


def _pgv(station: Station) -> float:
    """PGV of the resultant [mm/s], the same for all that were scaled to the same."""
    return float(f"{station.peak_velocity:.9g}")


def _calibrations(stations: Sequence[Station], methods: Methods) -> dict[float, list[StationCase]]:
    wanted = list(dict.fromkeys(_pgv(one) for one in stations))
    with progress("analyses for the intervals", len(wanted) * len(calibration_stations())) as advance:
        return {pgv: station_cases(pgv, methods, advance) for pgv in wanted}
