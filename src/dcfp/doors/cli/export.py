"""Write a scenario for another program: a script for OpenSees, a workbook for spreadsheets, or NetCDF and CSV."""

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser
from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.study.scenario import Calculation, Scenario

EXTENSIONS = (".py", ".xlsx", ".nc", ".csv")


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument(
        "scenario",
        metavar="SCENARIO.toml",
        help="study file of one bearing: records, intensities, bearing (dcfp study new writes one)",
    )
    parser.add_argument(
        "--out",
        metavar="FILE",
        required=True,
        help="file to write: .py runs with openseespy alone (of one record and intensity), .xlsx is a workbook, .nc and .csv hold the analyses",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    parser.add_argument("--json", action="store_true", help="one JSON document on standard output")


def run(chosen: argparse.Namespace) -> int:
    """Write the file."""
    outputs = Outputs.checked(chosen, [Path(chosen.scenario)], EXTENSIONS)
    from dcfp.study.scenario import read_scenario

    scenario = read_scenario(chosen.scenario)
    script = _script(scenario) if Path(chosen.out).suffix.lower() == ".py" else None
    calculation = _calculation(scenario)
    outputs.write_with(lambda part, kind: _write(part, kind, script, calculation), lambda _, __: None)
    if chosen.json:
        print(json.dumps({"file": chosen.out, "analyses": calculation.summary}, indent=2, allow_nan=False))
    else:
        print(f"{chosen.out}: written.")
    return 0


def _script(scenario: "Scenario") -> str:
    from dcfp.exchange import opensees_script

    if len(scenario.motions) != 1:
        msg = (
            f"a script is of one record at one intensity, but the scenario has {len(scenario.motions)} analyses;"
            " leave one in it, or write .xlsx."
        )
        raise InputError(msg)
    model = scenario.model
    return opensees_script(scenario.motions[0], model.bearing, model.friction, model.heating)


def _calculation(scenario: "Scenario") -> "Calculation":
    from dcfp.doors.cli.progress import progress
    from dcfp.study.scenario import calculate

    with progress("analyses", len(scenario.motions)) as advance:
        return calculate(scenario, advance)


def _write(part: Path, kind: str, script: str | None, calculation: "Calculation") -> None:
    from dcfp.exchange import write_workbook
    from dcfp.files import write_data

    if script is not None:
        part.write_text(script, encoding="utf-8")
    elif kind == ".xlsx":
        write_workbook(part, calculation)
    else:
        write_data(part, [one.response for one in calculation.results], kind)
