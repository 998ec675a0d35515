"""``dcfp predict`` of stations: displacement and energy in the plane."""

import argparse
from collections.abc import Sequence

from dcfp.analysis.integration import usual_heating
from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Page, grid, grouped
from dcfp.doors.cli.outputs import Answer
from dcfp.errors import InputError
from dcfp.inference.plane_forecast import (
    DIRECTIONS,
    NO_INTERVAL,
    forecast_station,
    station_lines,
    station_objects,
)
from dcfp.methods.nodes import TOLERANCE
from dcfp.methods.plane_march import NAME
from dcfp.motion.station import Station

#: What the columns are, what the methods are, and what there is not.
NOTES = (
    "y_max: largest displacement in the plane; dy: largest change of displacement from one peak to the next, in whatever direction; V_E: equivalent velocity sqrt(2E/m)"
    " of all the energy put in; T: highest temperature of the contact.",
    f"{NAME}: of our own, along straight legs between nodes of the ground velocity that both directions share; {DIRECTIONS}: the march of each direction by itself, root of the sum"
    " of the squares, for comparison: over FEMA P-695 0.91 times the analysis with a dispersion of 0.22, the march in the plane 1.00 and 0.05.",
    NO_INTERVAL,
)


def run(chosen: argparse.Namespace, stations: Sequence[Station]) -> Answer:
    """Predict every station at every PGV."""
    for option in ("interval", "threshold", "plot"):
        if getattr(chosen, option):
            msg = f"--{option} is for a single component; a station is predicted without it. Choose one component, such as {stations[0].x.name}, or leave it out."
            raise InputError(msg)
    system = inputs.system(chosen, usual_heating(stations))
    moved = inputs.scaled(stations, chosen.pgv)
    forecasts = [one for station in moved for one in forecast_station(station, system)]
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
        lambda: Page([above, grid(station_lines(forecasts), 2)], [*told, *NOTES]),
        lambda part, kind: station_lines(forecasts).csv(),
    )
