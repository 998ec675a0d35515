"""``dcfp predict`` of stations: displacement and energy in the plane."""

import argparse
from collections.abc import Sequence

from dcfp.analysis.integration import usual_heating
from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Block, Page, grid, grouped, progress
from dcfp.doors.cli.outputs import Answer
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
from dcfp.methods.nodes import TOLERANCE
from dcfp.methods.plane_march import NAME
from dcfp.motion.station import Station
from dcfp.system import System

#: What the columns are, what the methods are, and what there is not.
NOTES = (
    "y_max: largest displacement in the plane; dy: largest change of displacement from one peak to the next, in whatever direction; V_E: equivalent velocity sqrt(2E/m)"
    " of all the energy put in; T: highest temperature of the contact.",
    f"{NAME}: of our own, along straight legs between nodes of the ground velocity that both directions share; {DIRECTIONS}: the march of each direction by itself, root of the sum"
    " of the squares, for comparison.",
    "The methods of Li et al. (2020) are of one direction.",
)


def run(chosen: argparse.Namespace, stations: Sequence[Station]) -> Answer:
    """Predict every station at every PGV."""
    for option in ("threshold", "plot"):
        if getattr(chosen, option):
            msg = f"--{option} is for a single component; a station is predicted without it. Choose one component, such as {stations[0].x.name}, or leave it out."
            raise InputError(msg)
    system = inputs.system(chosen, usual_heating(stations))
    moved = inputs.scaled(stations, chosen.pgv)
    known = _calibrations(moved, system) if chosen.interval else {}
    forecasts = [
        one
        for station in moved
        for one in forecast_station(station, system, calibration=known.get(_pgv(station)))
    ]
    law, heating = system.friction, system.heating
    above = [
        ("Bearing", str(system.bearing)),
        (
            "Friction",
            f"{law.name}, reference coefficient {law.reference:g}, heating {heating.name} from {heating.ambient:g} °C",
        ),
        (
            "Ground",
            f"straight legs that the ground velocity leaves by {TOLERANCE:g} PGV of the resultant, then fitted",
        ),
    ]
    told = grouped((one.station.name, remark) for one in forecasts for remark in one.remarks)
    return Answer(
        lambda: station_objects(forecasts),
        lambda: _page(above, forecasts, told),
        lambda part, kind: station_lines(forecasts).csv(),
    )


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


def _calibrations(stations: Sequence[Station], system: System) -> dict[float, list[StationCase]]:
    wanted = list(dict.fromkeys(_pgv(one) for one in stations))
    with progress("analyses for the intervals", len(wanted) * len(calibration_stations())) as advance:
        return {pgv: station_cases(pgv, system, report=advance) for pgv in wanted}
