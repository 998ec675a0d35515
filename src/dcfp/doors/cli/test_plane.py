"""``dcfp test`` of a program whose tests go in two directions: measures of every lap."""

import argparse
from collections.abc import Sequence
from dataclasses import replace

from dcfp.analysis.integration import DEFAULT
from dcfp.analysis.rig import PlaneLoops, Program, run_in_the_plane
from dcfp.analysis.rig.plane_loops import LAPS
from dcfp.analysis.rig.run import paper_models
from dcfp.analysis.rig.virtual_test import objects_of, rounds_of
from dcfp.doors.cli.console import Page, grid, progress
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.doors.cli.test import head_lines, legend_of, remarks_of, shown_of
from dcfp.errors import InputError
from dcfp.present.tables import write_tests
from dcfp.schema.table import Table
from dcfp.system import PreciseHeating, System

_LEGEND = (
    "d: largest displacement; F_max: largest resultant force; E: work over the lap; mu: E over the load and the path;"
    " T: contact at the end of the lap and at its hottest, and the hottest point of the plates so far"
)


def run(chosen: argparse.Namespace, program: Program, system: System) -> Answer:
    """Run the tests of a program in the plane."""
    for option in ("measured", "checks"):
        if getattr(chosen, option):
            msg = f"--{option} is for tests in one direction; {program.name} goes in two."
            raise InputError(msg)
    if chosen.heating is None and chosen.bearing is None:
        system = system.changed({"heating": PreciseHeating.name})
    models = paper_models(system) if chosen.compare else {system.heating.name: system}
    finely = DEFAULT.tolerance if chosen.tolerance is None else chosen.tolerance
    with progress("tests", len(program.tests) * len(models)) as advance:
        runs = [
            run_in_the_plane(program, model, tolerance=finely, report=advance) for model in models.values()
        ]
    loops = [test for tests in runs for test in tests]
    side_by_side = [test for tests in zip(*runs, strict=True) for test in tests]
    return Answer(
        lambda: objects_of(rounds_of(loops), LAPS),
        lambda: _page(program, side_by_side, ", ".join(models), compared=len(models) > 1),
        lambda part, kind: write_tests(part, loops, kind),
        drawn("plane_tests.plot_plane_program", program, loops),
    )


def _page(program: Program, loops: Sequence[PlaneLoops], heating: str, *, compared: bool) -> Page:
    """Return the measures of every lap; of several models below one another, with the name of each."""
    laps = [lap for test in loops for lap in shown_of(rounds_of([test]))]
    columns = [
        replace(one, printed=True, head="Heating") if compared and one.key == "heating" else one
        for one in LAPS
    ]
    table = grid(Table(tuple(columns), laps))
    return Page(
        [head_lines(program, loops[0], heating), table], [legend_of(_LEGEND, loops), *remarks_of(loops)]
    )
