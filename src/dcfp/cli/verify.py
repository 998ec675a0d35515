"""What is checked against what, and by how much it differs."""

import argparse
import json
from dataclasses import asdict
from typing import Any

from dcfp.cli import options
from dcfp.cli.parser import Parser


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument("--full", action="store_true", help="also the checks that take minutes")
    options.add_output(parser, data=False, figure=False)


def run(chosen: argparse.Namespace) -> int:
    """Run the checks that come with the package; one that fails makes the status 1."""
    from dcfp.cli.progress import progress
    from dcfp.verification import run_checks

    with progress("checks", None) as advance:
        checks: list[Any] = run_checks(chosen.full, lambda check: advance())
    if chosen.json:
        print(json.dumps([asdict(check) for check in checks], indent=2))
    else:
        from dcfp.cli.verify_table import print_checks

        print_checks(checks)
    return 1 if any(check.passed is False for check in checks) else 0
