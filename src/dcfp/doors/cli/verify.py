"""``dcfp verify``: what is checked against what, and by how much it differs."""

import argparse
from itertools import groupby
from typing import TYPE_CHECKING

from rich.text import Text

from dcfp.doors.cli.console import Block, Page, grid
from dcfp.doors.cli.outputs import Answer
from dcfp.doors.cli.progress import progress
from dcfp.schema.table import Table
from dcfp.verify import CHECKS, run_checks

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def run(chosen: argparse.Namespace) -> Answer:
    """Run the checks that come with the package; one that fails makes the status 1."""
    with progress("checks", None) as advance:
        checks = run_checks(chosen.full, lambda check: advance())
    table = Table(tuple(CHECKS), checks)
    verdicts = [check.passed for check in checks]

    def page() -> Page:
        blocks: list[Block] = []
        for group, members in groupby(checks, key=lambda check: check.of):
            own = list(members)
            blocks.append((Text(group, style="bold"), grid(Table(table.columns, own))))
            sources = dict.fromkeys(check.source for check in own if check.source)
            blocks += [[("Against", "; ".join(sources))]] if sources else []
        blocks.append(
            f"{verdicts.count(True)} passed, {verdicts.count(False)} failed, {verdicts.count(None)} skipped; "
            "dcfp verify --json has a note on each check"
        )
        return Page(
            blocks, [f"{check.name}: {check.remark}" for check in checks if check.remark and not check.passed]
        )

    def figure() -> "Figure":
        from dcfp.present.figures import plot_checks  # late: Matplotlib takes long to import

        return plot_checks(checks)

    return Answer(
        table.objects, page, lambda part, kind: table.csv(), figure, status=1 if False in verdicts else 0
    )
