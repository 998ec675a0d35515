"""``dcfp respond``: response history analysis of a rigid structure on a bearing."""

import argparse
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.analysis import Response
from dcfp.analysis.integration import NOTHING, PLATES, Integration
from dcfp.analysis.response import PEAKS
from dcfp.analysis.response_history import analyse
from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Page, grid, grouped
from dcfp.doors.cli.outputs import Answer
from dcfp.doors.cli.progress import progress
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import motion_remarks
from dcfp.present.tables import write_responses
from dcfp.schema.parameters import parameters
from dcfp.schema.table import Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from dcfp.study.scenario import Calculation

#: A script for OpenSees, and a workbook.
SCRIPT, WORKBOOK = ".py", ".xlsx"


def run(chosen: argparse.Namespace) -> Answer:
    """Analyse every record at every PGV."""
    system = inputs.system(chosen)
    records = inputs.load_motions(chosen)
    motions = inputs.scaled(records, chosen.pgv, allow_drift=True)
    kind = Path(chosen.out or "").suffix.lower()
    if kind == SCRIPT and len(motions) != 1:
        msg = f"{chosen.out}: a script is of one record at one PGV, not of {len(motions)} analyses; give one, or write .xlsx, .nc or .csv."
        raise InputError(msg)
    integration = _integration(chosen)
    keep = PLATES if kind == ".nc" or chosen.plot is not None else NOTHING
    responses: list[Response] = []
    with progress("analyses", len(motions)) as advance:
        for motion in motions:
            responses.append(analyse(motion, system, integration, keep=keep))
            advance()

    def data(part: Path, kind: str) -> None:
        if kind in (SCRIPT, WORKBOOK):
            _exchange(part, kind, records, responses[0], chosen)
        else:
            write_responses(part, responses, kind)

    return answer_of(responses, data)


def answer_of(responses: Sequence[Response], data: Callable[[Path, str], None]) -> Answer:
    """Return what is told of analyses, with what writes their files."""

    def figure() -> "Figure":
        from dcfp.present.figures import plot_overview, plot_response  # late: Matplotlib takes long to import

        return plot_response(responses[0]) if len(responses) == 1 else plot_overview(responses)

    return Answer(
        lambda: [{**one.summary(), "remarks": one.all_remarks} for one in responses],
        lambda: _page(responses),
        data,
        figure,
    )


def _page(responses: Sequence[Response]) -> Page:
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
    return Page([lines, grid(Table(tuple(PEAKS.values()), responses))], remarks)


def _exchange(
    part: Path, kind: str, records: list[GroundMotion], response: Response, chosen: argparse.Namespace
) -> None:
    """Write what another program reads."""
    from dcfp.exchange import opensees_script, write_workbook  # late: scripts and workbooks are rare

    if kind == SCRIPT:
        script = opensees_script(response.motion, response.system)
        part.write_text(script, encoding="utf-8")
    else:
        write_workbook(part, _calculation(records, response, chosen))


def _calculation(
    records: list[GroundMotion], response: Response, chosen: argparse.Namespace
) -> "Calculation":
    """Return the same analyses with predictions and codes beside them."""
    from dcfp.study import Study
    from dcfp.study.scenario import Scenario, calculate

    study = Study(
        records,
        {"pgv": chosen.pgv} if chosen.pgv else {},
        model=response.system,
        title=", ".join(motion.name for motion in records),
        settings=_integration(chosen),
    )
    return calculate(Scenario(study))


def _integration(chosen: argparse.Namespace) -> Integration:
    return Integration(**inputs.given(chosen, *parameters(Integration)))
