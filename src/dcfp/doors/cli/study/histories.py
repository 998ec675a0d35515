"""The response history analysis behind one case of a study: made again in a moment, with its histories and its figure."""

import argparse
import json
from pathlib import Path

from dcfp.doors.cli import options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser
from dcfp.doors.cli.study.reading import add_selection, values_of_pairs


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument("study", metavar="STUDY.toml", help="the study file")
    add_selection(parser)
    options.add_output(parser)


def run(chosen: argparse.Namespace) -> int:
    """Analyse the case and show it."""
    outputs = Outputs.checked(chosen, [Path(chosen.study)])
    from dcfp.analysis.response import remarks_on
    from dcfp.doors.cli.response_table import print_responses
    from dcfp.study import read_study
    from dcfp.study.assessment.single import numbered_cases, response_at

    plan = read_study(chosen.study).plan
    response = response_at(plan, values_of_pairs(numbered_cases(plan), chosen.at))
    outputs.write([response])
    if chosen.json:
        rows = [{**response.summary(), "remarks": remarks_on(response)}]
        print(json.dumps(rows, indent=2, allow_nan=False))
    else:
        print_responses([response])
    return 0
