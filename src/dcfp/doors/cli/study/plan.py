"""How many analyses a study has and how long they will take, from some that are timed; nothing is written."""

import argparse
import json
from dataclasses import asdict
from typing import TYPE_CHECKING

from dcfp.doors.cli.parser import Parser, whole_number

if TYPE_CHECKING:
    from dcfp.study import Plan
    from dcfp.study.work import Projection

_MINUTE, _HOUR = 60.0, 3600.0


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument("study", metavar="STUDY.toml", help="study file; dcfp study new writes one")
    parser.add_argument(
        "--threads",
        type=whole_number(1, 1024),
        metavar="N",
        help="analyses at the same time; by default one for each processor",
    )
    parser.add_argument("--json", action="store_true", help="one JSON document on standard output")


def run(chosen: argparse.Namespace) -> int:
    """Time some analyses and print what all of them come to."""
    from dcfp.analysis.batch import available_threads
    from dcfp.study import read_study
    from dcfp.study.work import project

    plan = read_study(chosen.study).plan
    threads = chosen.threads or available_threads()
    found = project(plan, threads)
    if chosen.json:
        document = {"dimensions": plan.sizes, "threads": threads, **asdict(found)}
        print(json.dumps(document, indent=2, allow_nan=False))
    else:
        _print(plan, threads, found)
    return 0


def _print(plan: "Plan", threads: int, found: "Projection") -> None:
    from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled

    table = new_table(["Factor"], ["Values", "From", "To"])
    for name, values in [*plan.study.factors.items(), *plan.samples.items()]:
        numbers = [value for value in values if not isinstance(value, str)]
        ends = (
            [f"{min(numbers):.6g}", f"{max(numbers):.6g}"] if numbers else [str(values[0]), str(values[-1])]
        )
        add_row(table, [name, str(len(values)), *ends])
    sizes = " × ".join(f"{size} {name}" for name, size in plan.sizes.items())
    with page() as out:
        print_labelled(
            out,
            [
                ("Study", plan.study.title),
                ("Analyses", f"{found.analyses:,} = {sizes}, in {found.blocks:,} blocks"),
                (
                    "Time",
                    f"about {duration(found.duration)}: {found.rate:,.0f} analyses/s on {threads} threads, from {found.tried:,} that were"
                    " timed",
                ),
                ("Results", f"{found.size / 1e6:,.3g} MB before they are compressed"),
            ],
        )
        out.print()
        out.print(table)


def duration(seconds: float) -> str:
    """Return a time in the unit that suits it."""
    if seconds < _MINUTE:
        return f"{seconds:.1f} s"
    if seconds < _HOUR:
        return f"{seconds / _MINUTE:.1f} min"
    return f"{seconds / _HOUR:.1f} h"
