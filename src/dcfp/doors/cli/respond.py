"""``dcfp respond``: response history analysis of a rigid structure on a bearing."""

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.analysis import Response
from dcfp.analysis.half_cycles import half_cycle_table
from dcfp.analysis.integration import NOTHING, PLATES, Integration, usual_heating
from dcfp.analysis.response_history import analyse_record
from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Page, each_that_can, grid, grouped
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.errors import AnalysisError, InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import motion_remarks
from dcfp.motion.station import Station, stations_of
from dcfp.present.tables import write_responses
from dcfp.schema.table import Table
from dcfp.system import System

if TYPE_CHECKING:
    from dcfp.analysis.response import RigidResponse
    from dcfp.study.scenario import Calculation

#: A script for OpenSees, and a workbook.
SCRIPT, WORKBOOK = ".py", ".xlsx"


def run(chosen: argparse.Namespace) -> Answer:
    """Analyse every record at every PGV."""
    records: Sequence[GroundMotion | Station] = inputs.load_records(chosen)
    stations = stations_of(records)
    system = inputs.system(chosen, usual_heating(records))
    kind = Path(chosen.out or "").suffix.lower()
    if chosen.rotate is not None and stations:
        records = [one.rotated(chosen.rotate) for one in stations]
    for option in () if stations else ("rotate", "vertical"):
        if getattr(chosen, option) not in (None, False):
            msg = f"--{option} is for stations; a single component has no other direction."
            raise InputError(msg)
    if chosen.half_cycles is not None:
        _check_half_cycles(stations, kind)
    motions = inputs.scaled(records, chosen.pgv, allow_drift=True)
    if kind == SCRIPT and len(motions) != 1:
        msg = f"{chosen.out}: a script is of one record at one PGV, not of {len(motions)} analyses; give one, or write .xlsx, .nc or .csv."
        raise InputError(msg)
    integration = Integration(**inputs.given(chosen, Integration))
    # the temperature of the plates where it is drawn or written
    keep = PLATES if kind == ".nc" or chosen.plot is not None else NOTHING
    responses, failures = each_that_can(
        "analyses",
        motions,
        lambda motion: analyse_record(motion, system, integration, vertical=chosen.vertical, keep=keep),
    )

    if chosen.half_cycles is not None:
        return _of_half_cycles([one for one in responses if isinstance(one, Response)], chosen, failures)

    def workbook() -> "Calculation":
        if failures:
            msg = f"{failures[0]} A workbook holds every analysis, so none is written; leave this one out, or write .nc or .csv."
            raise AnalysisError(msg)
        return calculated(chosen, records, system, integration, responses)

    return answer_of(responses, workbook, vertical=chosen.vertical, failures=failures)


def calculated(
    chosen: argparse.Namespace,
    records: Sequence[GroundMotion | Station],
    system: System,
    integration: Integration,
    responses: "Sequence[RigidResponse]",
) -> "Calculation":
    """Return all that is calculated of records as they are read, whose analyses are at hand."""
    from dcfp.study import Study  # late: workbooks are rare
    from dcfp.study.scenario import Scenario, calculate

    intensities = {"pgv": chosen.pgv} if chosen.pgv else {}
    title = ", ".join(motion.name for motion in records)
    study = Study(
        records, intensities, model=system, title=title, settings=integration, vertical=chosen.vertical
    )
    return calculate(Scenario(study), responses=responses)


def write_analyses(
    part: Path,
    kind: str,
    responses: "Sequence[RigidResponse]",
    calculated: "Callable[[], Calculation] | None",
    *,
    vertical: bool = False,
    alone: bool | None = None,
) -> str | None:
    """Write one analysis as a script for OpenSees, a workbook of what is calculated, or analyses as data."""
    from dcfp.exchange import opensees_script, write_workbook  # late: scripts and workbooks are rare

    if kind == SCRIPT:
        return opensees_script(responses[0].motion, responses[0].system, vertical=vertical)
    if kind == WORKBOOK and calculated is not None:
        write_workbook(part, calculated())
    else:
        write_responses(part, responses, kind, alone=alone)
    return None


def answer_of(
    responses: "Sequence[RigidResponse]",
    calculated: "Callable[[], Calculation] | None" = None,
    *,
    vertical: bool = False,
    failures: Sequence[AnalysisError] = (),
) -> Answer:
    """Return what is told of analyses and of those that failed, with what a workbook has beside them where one may be wanted."""
    alone = len(responses) + len(failures) == 1
    of_several = "plot_overview" if isinstance(responses[0], Response) else "plane.plot_orbits"
    return Answer(
        lambda: [{**one.summary(), "remarks": one.all_remarks} for one in responses],
        lambda: _page(responses),
        lambda part, kind: write_analyses(part, kind, responses, calculated, vertical=vertical, alone=alone),
        drawn("figure_of", responses[0]) if alone else drawn(of_several, responses),
        failures=failures,
    )


def _check_half_cycles(stations: Sequence[Station], kind: str) -> None:
    if stations:
        msg = "--half-cycles is for single components: in the plane the slider need not stop between two turns, and Eqs (15), (16) are of the moments when it does."
        raise InputError(msg)
    if kind not in ("", ".csv"):
        msg = f"Half cycles are written as .csv, not as {kind}; give --out FILE.csv, or leave out --half-cycles."
        raise InputError(msg)


def _of_half_cycles(
    responses: Sequence[Response], chosen: argparse.Namespace, failures: Sequence[AnalysisError]
) -> Answer:
    """Return what is told of the half cycles of analyses."""
    table = half_cycle_table(responses, chosen.half_cycles)
    none = [] if table.results else [f"No half cycle is of {chosen.half_cycles:g} mm or more."]
    remarks = [
        *none,
        f"Half cycles of at least {chosen.half_cycles:g} mm, from one peak of displacement to the next. dE: the most that the ground puts in since the start;"
        " dEr, dEhr, dEsr: put in, dissipated and left in the springs over the whole half cycle, so that dEr = dEhr + dEsr, Eq. (15), and nearly dEhr, Eq. (16); V: sqrt(2E/m) of each.",
        *grouped((one.motion.name, remark) for one in responses for remark in one.remarks),
    ]
    figure = answer_of(responses).figure
    return Answer.of_table(table, None, remarks, figure=figure, failures=failures)


def _page(responses: "Sequence[RigidResponse]") -> Page:
    first = responses[0]
    lines = [
        ("Bearing", str(first.bearing)),
        ("Friction", f"{first.friction_law.name}, reference coefficient {first.friction_law.reference:g}"),
        ("Heating", f"{first.heating.name}, from {first.heating.ambient:g} °C"),
    ]
    # the scale of a motion is left out, for it shows in its PGV
    remarks = grouped(
        (one.motion.name, remark)
        for one in responses
        for remark in (*motion_remarks(one.motion, with_scale=False), *one.remarks)
    )
    return Page([lines, grid(Table(tuple(first.quantities.values()), responses))], remarks)
