"""What is checked against what, and by how much it differs."""

import argparse
import json
from pathlib import Path
from typing import Any

from dcfp.doors.cli import options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument("--full", action="store_true", help="also the checks that take minutes")
    options.add_output(
        parser, "every check as CSV (.csv)", "differences over what is allowed as .png, .pdf or .svg"
    )


def run(chosen: argparse.Namespace) -> int:
    """Run the checks that come with the package; one that fails makes the status 1."""
    outputs = Outputs.checked(chosen, data_extensions=(".csv",))
    # late, so that a slip in the command is answered at once
    from dcfp.doors.cli.progress import progress
    from dcfp.verify import run_checks

    with progress("checks", None) as advance:
        checks: list[Any] = run_checks(chosen.full, lambda check: advance())
    outputs.write_with(
        lambda part, kind: _write_table(part, checks), lambda part, form: _write_figure(part, checks, form)
    )
    if chosen.json:
        from dcfp.schema.table import Table
        from dcfp.verify import CHECKS

        print(json.dumps(Table(CHECKS, checks).objects(), indent=2))
    else:
        from dcfp.doors.cli.test_table import print_verification

        print_verification(checks)
    return 1 if any(check.passed is False for check in checks) else 0


def _write_table(path: Path, checks: list[Any]) -> None:
    from dcfp.schema.table import Table
    from dcfp.verify import CHECKS

    columns = {one.key: one for one in CHECKS}
    names = (
        "group", "name", "computed", "expected", "unit", "difference", "tolerance", "ratio", "passed", "note", "source",
    )  # fmt: skip
    text = Table(tuple(columns[name] for name in names), checks).csv()
    path.write_text(text, encoding="utf-8")


def _write_figure(path: Path, checks: list[Any], form: str) -> None:
    from dcfp.present.figures import plot_checks, save_figure  # late: Matplotlib takes long to import

    save_figure(plot_checks(checks), path, form)
