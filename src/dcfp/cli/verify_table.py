"""The table of `dcfp verify`."""

from collections.abc import Sequence
from itertools import groupby
from typing import Any

from dcfp.cli.tables import add_row, console, new_table, print_labelled, print_remarks

_VERDICTS = {True: "ok", False: "FAILED", None: "skipped"}


def print_checks(checks: Sequence[Any]) -> None:
    """Print a table for each group of checks, and how many passed, failed and were skipped."""
    out = console()
    for group, members in groupby(checks, key=lambda check: check.group):
        rows = list(members)
        table = new_table(["Check"], ["Computed", "Expected"], ["Unit", "Difference", "Allowed", "Result"])
        for check in rows:
            add_row(
                table,
                [
                    check.name,
                    _shown(check.computed),
                    _shown(check.expected),
                    check.unit,
                    check.difference,
                    check.tolerance,
                    _VERDICTS[check.passed],
                ],
            )
        out.print(group, style="bold")
        out.print(table)
        sources = dict.fromkeys(check.source for check in rows if check.source)
        print_labelled(out, [("Source", source) for source in sources])
        print_remarks(out, [f"{check.name}: {check.note}" for check in rows if check.note])
        out.print()
    verdicts = [check.passed for check in checks]
    out.print(
        f"{verdicts.count(True)} passed, {verdicts.count(False)} failed, {verdicts.count(None)} skipped"
    )


def _shown(value: float | None) -> str:
    return "" if value is None else f"{value:.6g}"
