"""``dcfp spectrum``: elastic response and input energy spectra of records."""

import argparse
from itertools import groupby

import numpy as np

from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Page, each, grid
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.methods.spectra import input_energy_spectrum
from dcfp.methods.spectra.of_record import ORDINATES, PERIODS, Ordinates, ordinates
from dcfp.methods.uang_bertero_1988 import LARGEST_INPUT, largest_input
from dcfp.motion.load import motion_of
from dcfp.schema.table import Table

#: Periods of the table [s]; the data have all.
_SHOWN = (0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0)
_LEGEND = (
    "S_v, S_a: pseudo-velocity and pseudo-acceleration; V_E: equivalent velocity of the relative, abs. of the absolute input energy, each the largest at any time"
    " (Uang and Bertero 1988); t_D: 5 to 95 % of the Arias intensity.",
    "Fajfar: sqrt(2 E/m) of E/m = 2.2 t_D^0.5 PGA PGV, after Fajfar, Vidic and Fischinger (1989), unconfirmed.",
)


def run(chosen: argparse.Namespace) -> Answer:
    """Make the spectra of every record at every PGV."""
    # a vertical motion has a spectrum, too
    records = inputs.load_records(chosen, vertical=True)
    singles = [motion_of(one, vertical=True) for one in records]
    motions = inputs.scaled(singles, chosen.pgv)
    periods = PERIODS if chosen.periods is None else np.array(chosen.periods)
    spectra = each("records", motions, lambda motion: input_energy_spectrum(motion, periods, chosen.damping))
    every = [one for motion, found in zip(motions, spectra, strict=True) for one in ordinates(motion, found)]
    table = Table(tuple(ORDINATES), every)
    largest = Table(
        tuple(LARGEST_INPUT), [largest_input(motion) for motion in motions if motion.peak_acceleration > 0.0]
    )

    def page() -> Page:
        shown = every if chosen.periods is not None else _nearest(every)
        lines = [("Damping", f"{100.0 * chosen.damping:g} %")]
        maxima = ("Largest input energies over the periods, at a damping of 5 %:", grid(largest))
        return Page([lines, grid(Table(table.columns, shown), repeated=2), maxima], _LEGEND)

    return Answer(
        lambda: {"damping": chosen.damping, "spectra": table.objects(), "maxima": largest.objects()},
        page,
        lambda part, kind: table.csv(),
        drawn("motions.plot_spectra", spectra, [motion.peak_velocity for motion in motions]),
    )


def _nearest(every: list[Ordinates]) -> list[Ordinates]:
    """Return of each motion the ordinates nearest to the periods that are shown."""
    found: list[Ordinates] = []
    for _, members in groupby(every, key=lambda one: id(one.motion)):
        own = list(members)
        periods = np.array([one.period for one in own])
        found += [own[place] for place in sorted({int(np.argmin(np.abs(periods - T))) for T in _SHOWN})]
    return found
