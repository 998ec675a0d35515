"""``dcfp reproduce``: the findings and figures of Li et al. (2020), section 6, beside what the paper prints."""

import argparse
from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from typing import TYPE_CHECKING

from dcfp.doors.cli.console import Page, grid
from dcfp.doors.cli.outputs import Answer
from dcfp.doors.cli.progress import progress
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_motion
from dcfp.motion.measures import baseline_warning
from dcfp.motion.named import MISSING
from dcfp.schema.table import Table
from dcfp.verify.reproduction import FINDINGS, analyse, findings_of, number_of, paper_motions

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from dcfp.present.figures.li_2020 import PaperFigure

#: PGV of a file over the printed one, from which on it is said that they differ [-].
_SAME = 0.02


def run(chosen: argparse.Namespace) -> Answer:
    """Make the analyses, the findings and the figures."""
    files = _files(chosen.files)
    motions = paper_motions([replace(load_motion(file), name=name) for name, file in files.items()])
    with progress("analyses", number_of(len(motions))) as advance:
        analyses = analyse(motions, advance)
    findings = findings_of(analyses)
    missing = [name for name in MISSING if name not in files]
    names = [motion.name for motion in motions]
    remarks = _remarks(motions)
    table = Table(tuple(FINDINGS), findings)

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

    def html() -> str:
        from dcfp.verify.reproduction_page import reproduction_page

        return reproduction_page(findings, figures(), names, missing)

    lines = [
        ("Paper", "Li et al. (2020), section 6, at PGV 0.25, 0.50, 0.75 and 1.00 m/s"),
        ("Records", ", ".join(names)),
        ("Not at hand", ", ".join(missing) or "none"),
    ]
    notes: list[str] = []
    for one in findings:
        notes += [] if one.agrees else [f"{one.name}: {one.words}"]
        notes += [f"{one.name}, {case}" for case in one.outside]
    return Answer(
        lambda: {
            "records": names,
            "missing_records": missing,
            "findings": table.objects(),
            "remarks": remarks,
        },
        lambda: Page([lines, grid(table)], [*notes, *remarks]),
        lambda part, kind: html(),
        sheet,
    )


def _files(words: Sequence[str]) -> dict[str, str]:
    found: dict[str, str] = {}
    for word in words:
        name, mark, file = word.partition("=")
        if not mark or name.upper() not in MISSING or not file:
            msg = f"{word!r} is no record of the paper with its file; write for example JKB=kobe.csv::NS, for {', '.join(MISSING)}."
            raise InputError(msg)
        if name.upper() in found:
            msg = f"{name.upper()} is given twice; one file belongs to it."
            raise InputError(msg)
        found[name.upper()] = file
    return found


def _remarks(motions: Sequence[GroundMotion]) -> list[str]:
    remarks: list[str] = []
    for motion in motions:
        printed = MISSING[motion.name].peak_velocity if motion.name in MISSING else None
        if printed is not None and abs(motion.peak_velocity / printed - 1.0) > _SAME:
            remarks.append(
                f"{motion.name}: the PGV of the file is {motion.peak_velocity / 1e3:.3f} m/s, and {printed / 1e3:.3f} m/s in the paper's"
                " Table 3; it may be another component or treatment."
            )
        warning = baseline_warning(motion)
        remarks += [warning] if warning else []
    return remarks
