"""Response history analysis of a rigid structure on a friction pendulum bearing."""

import argparse
import json
from typing import TYPE_CHECKING, Any

from dcfp.cli import inputs, options
from dcfp.cli.outputs import Outputs
from dcfp.cli.parser import Parser

if TYPE_CHECKING:
    from dcfp.record.ground_motion import GroundMotion
    from dcfp.response import Response

#: Frames of the plates' temperature that a NetCDF file or a figure holds, about.
FRAMES = 200


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    options.add_records(parser, "+", "name of a record (dcfp records lists them) or a file, FILE::COMPONENT")
    options.add_treatment(parser)
    options.add_bearing(parser)
    options.add_integration(parser)
    options.add_output(parser)


def run(chosen: argparse.Namespace) -> int:
    """Analyse every record at every PGV."""
    inputs.record_names(chosen)
    outputs = Outputs.checked(chosen, inputs.input_files(chosen))
    # late, so that a slip in the command is answered at once
    from dcfp.cli.remarks import remarks_on
    from dcfp.cli.response_table import print_responses

    model = inputs.model(chosen)
    motions = inputs.scaled(inputs.load_motions(chosen), chosen.pgv)
    responses = _analyse(motions, model, chosen)
    outputs.write(responses)
    if chosen.json:
        rows = [{**response.summary(), "remarks": remarks_on(response)} for response in responses]
        print(json.dumps(rows, indent=2, allow_nan=False))
    else:
        print_responses(responses)
    return 0


def _analyse(
    motions: "list[GroundMotion]", model: "inputs.Model", chosen: argparse.Namespace
) -> "list[Response]":
    from dcfp.cli.progress import progress
    from dcfp.response import respond

    settings: dict[str, Any] = {
        name: value for name in ("step", "tail", "tolerance") if (value := getattr(chosen, name)) is not None
    }
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
    motion: "GroundMotion", model: "inputs.Model", chosen: argparse.Namespace
) -> int | None:
    wanted = str(chosen.out or "").lower().endswith(".nc") or chosen.plot is not None
    if model.heating.name != "precise" or not wanted:
        return None
    step = motion.time_step if chosen.step is None else min(chosen.step, motion.time_step)
    return max(1, round(motion.duration / step / FRAMES))
