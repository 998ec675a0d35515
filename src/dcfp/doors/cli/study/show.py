"""What is in a store: its dimensions, what is done, and the peaks by intensity."""

import argparse
import json

from dcfp.doors.cli.parser import Parser


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument("store", metavar="STORE", help="store of a study, or the NetCDF it was exported to")
    parser.add_argument("--json", action="store_true", help="one JSON document on standard output")


def run(chosen: argparse.Namespace) -> int:
    """Show a store."""
    from dcfp.doors.cli.study.summary import print_summary, summary_object
    from dcfp.study.results import open_store

    dataset = open_store(chosen.store)
    if chosen.json:
        print(json.dumps(summary_object(dataset), indent=2, allow_nan=False))
    else:
        print_summary(dataset, chosen.store)
    return 0
