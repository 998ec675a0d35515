"""``dcfp spectrum``: elastic response and input energy spectra of records, and response spectra of stations over all directions."""

import argparse
from collections.abc import Sequence
from itertools import groupby
from typing import TypeVar

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Page, each, grid
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.methods.spectra import input_energy_spectrum
from dcfp.methods.spectra.of_record import ORDINATES, PERIODS, Ordinates, ordinates
from dcfp.methods.spectra.of_station import (
    STATION_ORDINATES,
    StationOrdinates,
    station_ordinates,
    station_spectrum,
)
from dcfp.methods.uang_bertero_1988 import LARGEST_INPUT, largest_input
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station, stations_of
from dcfp.motion.station_measures import station_remarks
from dcfp.schema.table import Table

#: Periods of the table [s]; the data have all.
_SHOWN = (0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0)
_LEGEND = (
    "S_v, S_a: pseudo-velocity and pseudo-acceleration; V_E: equivalent velocity of the relative, abs. of the absolute input energy, each the largest at any time"
    " (Uang and Bertero 1988); t_D: 5 to 95 % of the Arias intensity.",
    "Fajfar: sqrt(2 E/m) of E/m = 2.2 t_D^0.5 PGA PGV, after Fajfar, Vidic and Fischinger (1989), unconfirmed.",
)
_STATION_LEGEND = (
    "In m/s² pseudo-accelerations, in mm the spectral displacement; RotD50, RotD100: median and largest of the displacements in 180 directions, for each period by itself (Boore 2010); SRSS and geom. mean: of x and y, which depend on"
    " how the instrument stood; direction: that of RotD100, from x towards y.",
)

Told = TypeVar("Told", Ordinates, StationOrdinates)


def run(chosen: argparse.Namespace) -> Answer:
    """Make the spectra of every record at every PGV."""
    # a vertical motion has a spectrum, too
    records = inputs.load_records(chosen, vertical=True)
    periods = PERIODS if chosen.periods is None else np.array(chosen.periods)
    stations = stations_of(records)
    if stations:
        return _of_stations(chosen, inputs.scaled(stations, chosen.pgv), periods)
    singles = [one for one in records if isinstance(one, GroundMotion)]
    return _of_motions(chosen, inputs.scaled(singles, chosen.pgv), periods)


def _of_motions(chosen: argparse.Namespace, motions: Sequence[GroundMotion], periods: FloatArray) -> Answer:
    spectra = each("records", motions, lambda motion: input_energy_spectrum(motion, periods, chosen.damping))
    every = [one for motion, found in zip(motions, spectra, strict=True) for one in ordinates(motion, found)]
    table = Table(tuple(ORDINATES), every)
    largest = Table(
        tuple(LARGEST_INPUT), [largest_input(motion) for motion in motions if motion.peak_acceleration > 0.0]
    )

    def page() -> Page:
        shown = every if chosen.periods is not None else _nearest(every)
        maxima = ("Largest input energies over the periods, at a damping of 5 %:", grid(largest))
        return Page([_lines(chosen), grid(Table(table.columns, shown), repeated=2), maxima], _LEGEND)

    return Answer(
        lambda: {"damping": chosen.damping, "spectra": table.objects(), "maxima": largest.objects()},
        page,
        lambda part, kind: table.csv(),
        drawn("motions.plot_spectra", spectra, [motion.peak_velocity for motion in motions]),
    )


def _of_stations(chosen: argparse.Namespace, stations: Sequence[Station], periods: FloatArray) -> Answer:
    spectra = each("stations", stations, lambda station: station_spectrum(station, periods, chosen.damping))
    every = [
        one
        for station, found in zip(stations, spectra, strict=True)
        for one in station_ordinates(station, found)
    ]
    table = Table(tuple(STATION_ORDINATES), every)

    def page() -> Page:
        shown = every if chosen.periods is not None else _nearest(every)
        remarks = [remark for station in stations for remark in station_remarks(station)]
        blocks = [_lines(chosen), grid(Table(table.columns, shown), repeated=2)]
        return Page(blocks, [*remarks, *_STATION_LEGEND])

    return Answer(
        lambda: {"damping": chosen.damping, "spectra": table.objects()},
        page,
        lambda part, kind: table.csv(),
        drawn("stations.plot_station_spectra", spectra, [station.peak_velocity for station in stations]),
    )


def _lines(chosen: argparse.Namespace) -> list[tuple[str, str]]:
    return [("Damping", f"{100.0 * chosen.damping:g} %")]


def _nearest(every: Sequence[Told]) -> list[Told]:
    """Return of each motion the ordinates nearest to the periods that are shown."""
    found: list[Told] = []
    for _, members in groupby(every, key=lambda one: id(one.motion)):
        own = list(members)
        periods = np.array([one.period for one in own])
        found += [own[place] for place in sorted({int(np.argmin(np.abs(periods - T))) for T in _SHOWN})]
    return found
