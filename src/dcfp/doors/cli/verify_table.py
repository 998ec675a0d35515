"""The table of `dcfp verify`."""

from collections.abc import Sequence
from itertools import groupby
from typing import Any

from rich.console import Console

from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks

_VERDICTS = {True: "ok", False: "FAILED", None: "skipped"}


def print_checks(checks: Sequence[Any]) -> None:
    """Print a table for each group of checks, and how many passed, failed and were skipped."""
    verdicts = [check.passed for check in checks]
    with page() as out:
        for group, members in groupby(checks, key=lambda check: check.group):
            _print_group(out, group, list(members))
        out.print(
            f"{verdicts.count(True)} passed, {verdicts.count(False)} failed, {verdicts.count(None)} skipped; "
            "dcfp verify --json has a note on each check"
        )


def _print_group(out: Console, group: str, checks: list[Any]) -> None:
    table = new_table(["Check"], ["Computed", "Expected"], ["Unit", "Difference", "Allowed", "Result"])
    for check in checks:
        cells = [check.name, _shown(check.computed), _shown(check.expected), check.unit]
        add_row(table, [*cells, check.difference, check.tolerance, _VERDICTS[check.passed]])
    out.print(group, style="bold")
    out.print(table)
    sources = dict.fromkeys(check.source for check in checks if check.source)
    if sources:
        print_labelled(out, [("Against", "; ".join(sources))])
    print_remarks(out, [f"{check.name}: {check.note}" for check in checks if check.note and not check.passed])
    out.print()


def _shown(value: float | None) -> str:
    return "" if value is None else f"{value:.6g}"
