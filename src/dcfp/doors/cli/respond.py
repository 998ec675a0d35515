"""Response history analysis of a rigid structure on a friction pendulum bearing."""

import argparse
import json
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli import inputs, options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser
from dcfp.errors import InputError
from dcfp.files import DATA_EXTENSIONS

if TYPE_CHECKING:
    from dcfp.analysis import Response
    from dcfp.motion.ground_motion import GroundMotion
    from dcfp.study.scenario import Calculation

#: Formats of --out besides those of `dcfp.files`: a script for OpenSees, a workbook.
_SCRIPT, _WORKBOOK = ".py", ".xlsx"
#: Frames of the plates' temperature that a NetCDF file or a figure holds, about.
FRAMES = 200


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    options.add_records(parser, "+", "name of a record (dcfp records lists them) or a file, FILE::COMPONENT")
    options.add_treatment(parser)
    options.add_bearing(parser)
    options.add_integration(parser)
    options.add_output(
        parser,
        "results as NetCDF (.nc) or CSV (.csv; of several analyses the peaks only), with predictions and codes as a workbook (.xlsx),"
        " or one analysis as a script that runs with openseespy alone (.py)",
    )


def run(chosen: argparse.Namespace) -> int:
    """Analyse every record at every PGV."""
    inputs.record_names(chosen)
    outputs = Outputs.checked(chosen, inputs.input_files(chosen), (*DATA_EXTENSIONS, _WORKBOOK, _SCRIPT))
    # late, so that a slip in the command is answered at once
    from dcfp.analysis.response import remarks_on
    from dcfp.doors.cli.response_table import print_responses

    model = inputs.model(chosen)
    records = inputs.load_motions(chosen)
    motions = inputs.scaled(records, chosen.pgv)
    _refuse_several_scripts(outputs.data, len(motions))
    responses = _analyse(motions, model, chosen)
    outputs.write(responses, partial(_write_data, responses, records, chosen))
    if chosen.json:
        rows = [{**response.summary(), "remarks": remarks_on(response)} for response in responses]
        print(json.dumps(rows, indent=2, allow_nan=False))
    else:
        print_responses(responses)
    return 0


def _refuse_several_scripts(path: Path | None, count: int) -> None:
    if path is not None and path.suffix.lower() == _SCRIPT and count != 1:
        msg = f"{path}: a script is of one record at one PGV, not of {count} analyses; give one, or write .xlsx, .nc or .csv."
        raise InputError(msg)


def _write_data(
    responses: "list[Response]",
    records: "list[GroundMotion]",
    chosen: argparse.Namespace,
    part: Path,
    kind: str,
) -> None:
    from dcfp.files import write_data

    if kind == _SCRIPT:
        from dcfp.exchange import opensees_script

        one = responses[0]
        script = opensees_script(one.motion, one.bearing, one.friction_law, one.heating)
        part.write_text(script, encoding="utf-8")
    elif kind == _WORKBOOK:
        from dcfp.exchange import write_workbook

        write_workbook(part, _calculation(records, responses[0], chosen))
    else:
        write_data(part, responses, kind)


def _calculation(
    records: "list[GroundMotion]", response: "Response", chosen: argparse.Namespace
) -> "Calculation":
    """Return the same analyses with predictions and codes beside them."""
    from dcfp.study import Settings, Study
    from dcfp.study.scenario import Scenario, calculate
    from dcfp.system import System

    pgvs = [] if chosen.pgv is None else [1e3 * pgv for pgv in chosen.pgv]
    study = Study(
        records,
        {"pgv": pgvs} if pgvs else {},
        model=System(response.bearing, response.friction_law, response.heating),
        title=", ".join(motion.name for motion in records),
        settings=Settings(**_settings(chosen)),
    )
    return calculate(Scenario(study))


def _settings(chosen: argparse.Namespace) -> dict[str, Any]:
    return {
        name: value for name in ("step", "tail", "tolerance") if (value := getattr(chosen, name)) is not None
    }


def _analyse(
    motions: "list[GroundMotion]", model: "inputs.System", chosen: argparse.Namespace
) -> "list[Response]":
    from dcfp.analysis import respond
    from dcfp.doors.cli.progress import progress

    settings = _settings(chosen)
    responses: list[Response] = []
    with progress("analyses", len(motions)) as advance:
        for motion in motions:
            every = _profile_interval(motion, model, chosen)
            responses.append(
                respond(motion, model.bearing, model.friction, model.heating, profile_every=every, **settings)
            )
            advance()
    return responses


def _profile_interval(
    motion: "GroundMotion", model: "inputs.System", chosen: argparse.Namespace
) -> int | None:
    wanted = str(chosen.out or "").lower().endswith(".nc") or chosen.plot is not None
    if model.heating.name != "precise" or not wanted:
        return None
    step = motion.time_step if chosen.step is None else min(chosen.step, motion.time_step)
    return max(1, round(motion.duration / step / FRAMES))
