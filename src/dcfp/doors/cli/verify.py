"""``dcfp verify``: what is checked against what, and by how much it differs; and ``dcfp reproduce``: the findings and figures of Li et al. (2020), section 6."""

import argparse
from collections.abc import Sequence
from dataclasses import replace
from functools import cache, partial
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING

from rich.text import Text

from dcfp.doors.cli.console import Block, Page, grid, progress
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_horizontal
from dcfp.motion.measures import baseline_warning, refuse_a_drift
from dcfp.motion.named import MISSING
from dcfp.motion.treatment import treated
from dcfp.schema.table import Table
from dcfp.verify import CHECKS, reproduction, run_checks
from dcfp.verify.paper_records import find_paper_records


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

    return Answer(
        table.objects,
        page,
        lambda part, kind: table.csv(),
        drawn("plot_checks", checks),
        status=1 if False in verdicts else 0,
    )


if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from dcfp.present.figures.li_2020 import PaperFigure

#: PGV of a file over the printed one, from which on it is said that they differ [-].
_SAME = 0.02


def reproduce(chosen: argparse.Namespace) -> Answer:
    """Make the analyses, the findings and the figures."""
    files = {name.upper(): file for name, file in chosen.files.items()}
    for name in files:
        if name not in MISSING:
            msg = f"{name} is no record of the paper that has to be supplied; these are {', '.join(MISSING)}."
            raise InputError(msg)
    treat = partial(treated, baseline=chosen.baseline, corner=chosen.high_pass)
    found = None if chosen.records is None else find_paper_records(Path(chosen.records), treat)
    own: dict[str, GroundMotion] = {} if found is None else dict(found.motions)
    own |= {name: replace(treat(load_horizontal(file)), name=name) for name, file in files.items()}
    for motion in own.values():
        refuse_a_drift(motion)
    motions = reproduction.paper_motions(list(own.values()))
    with progress("analyses", reproduction.number_of(len(motions))) as advance:
        analyses = reproduction.analyse(motions, advance)
    findings = reproduction.findings_of(analyses)
    missing = [name for name in MISSING if name not in own]
    names = [motion.name for motion in motions]
    remarks = _remarks(motions)
    if found is not None:
        choices = [words for name, words in found.choices.items() if name not in files]
        remarks = [*choices, *found.left_out, *remarks]
    table = Table(tuple(reproduction.FINDINGS), findings)

    @cache
    def figures() -> "list[PaperFigure]":
        from dcfp.present.figures.li_2020 import paper_figures  # late: Matplotlib takes long to import

        loops = {
            (case.record, case.pgv): (case.response, precise)
            for case, precise in zip(analyses.cases, analyses.precise, strict=True)
            if case.response is not None
        }
        return paper_figures(analyses.cases, loops)

    def sheet() -> "Figure":
        from dcfp.present.figures.li_2020 import contact_sheet

        return contact_sheet(figures())

    lines = [
        ("Paper", "Li et al. (2020), section 6, at PGV 0.25, 0.50, 0.75 and 1.00 m/s"),
        ("Records", ", ".join(names)),
        ("Not at hand", ", ".join(missing) or "none"),
    ]
    notes: list[str] = []
    for one in findings:
        notes += [] if one.agrees or one.basis is reproduction.Basis.OURS else [f"{one.name}: {one.words}"]
        notes += [f"{one.name}, {case}" for case in one.outside]
    return Answer(
        lambda: {
            "records": names,
            "missing_records": missing,
            "findings": table.objects(),
            "remarks": remarks,
        },
        lambda: Page([lines, grid(table)], [*notes, *remarks]),
        lambda part, kind: reproduction.reproduction_page(findings, figures(), names, missing, remarks),
        sheet,
    )


def _remarks(motions: Sequence[GroundMotion]) -> list[str]:
    """Say of the records that were supplied how their PGV compares with the printed one, what was done to them, and whether they drift."""
    remarks: list[str] = []
    for motion in motions:
        if motion.name in MISSING:
            remarks.append(_against_table(motion, MISSING[motion.name].peak_velocity))
            remarks += [f"{motion.name}: {'; '.join(motion.treatment)}."] if motion.treatment else []
        warning = baseline_warning(motion)
        remarks += [warning] if warning else []
    return remarks


def _against_table(motion: GroundMotion, printed: float) -> str:
    said = f"{motion.name}: the PGV of the file is {motion.peak_velocity / 1e3:.3f} m/s, and {printed / 1e3:.3f} m/s in the paper's Table 3"
    differs = abs(motion.peak_velocity / printed - 1.0) > _SAME
    return f"{said}; it may be another component or treatment." if differs else f"{said}."
