"""The findings and figures of Li et al. (2020), section 6, made again and put beside what the paper prints."""

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli import options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks
from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.motion.ground_motion import GroundMotion
    from dcfp.present.figures.li_2020 import PaperFigure
    from dcfp.verify.reproduction import Analyses, Finding

#: Whether a finding is as printed.
_SIGNS = {True: "", False: "differs", None: "not comparable"}
#: PGV of a file over the printed one, from which on it is said that they differ [-].
_SAME = 0.02


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument(
        "files",
        nargs="*",
        metavar="NAME=FILE",
        help="a record of the paper that does not come with the package, where you have it: JKB, TC1, TSD or TIM and its file",
    )
    options.add_output(
        parser, "one page with findings and figures (.html)", "all figures on one sheet as .png, .pdf or .svg"
    )


def run(chosen: argparse.Namespace) -> int:
    """Make the analyses, the findings and the figures."""
    files = _files(chosen.files)
    outputs = Outputs.checked(
        chosen, [Path(file.rpartition("::")[0] or file) for file in files.values()], (".html",)
    )
    # late, so that a slip in the command is answered at once
    from dcfp.doors.cli.progress import progress
    from dcfp.motion.named import MISSING
    from dcfp.verify.reproduction import analyse, findings_of, number_of, paper_motions

    motions = paper_motions(_loaded(files))
    with progress("analyses", number_of(len(motions))) as advance:
        analyses = analyse(motions, advance)
    findings = findings_of(analyses)
    missing = [name for name in MISSING if name not in files]
    remarks = _remarks(motions)
    _write(analyses, findings, [motion.name for motion in motions], missing, outputs)
    if chosen.json:
        print(json.dumps(_document(findings, motions, missing, remarks), indent=2, allow_nan=False))
    else:
        _print(findings, motions, missing, remarks)
    return 0


def _files(words: list[str]) -> dict[str, str]:
    from dcfp.motion.named import MISSING

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


def _loaded(files: dict[str, str]) -> "list[GroundMotion]":
    from dataclasses import replace

    from dcfp.motion.load import load_motion

    return [replace(load_motion(file), name=name) for name, file in files.items()]


def _remarks(motions: "list[GroundMotion]") -> list[str]:
    from dcfp.motion.measures import baseline_warning
    from dcfp.motion.named import MISSING

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


def _write(
    analyses: "Analyses", findings: "list[Finding]", records: list[str], missing: list[str], outputs: Outputs
) -> None:
    drawn: list[PaperFigure] = []

    def figures() -> "list[PaperFigure]":
        from dcfp.present.figures.li_2020 import paper_figures  # late: Matplotlib takes long to import

        if not drawn:
            loops = {
                (case.record, case.pgv): (case.response, precise)
                for case, precise in zip(analyses.cases, analyses.precise, strict=True)
                if case.response is not None
            }
            drawn.extend(paper_figures(analyses.cases, loops))
        return drawn

    def data(part: Path, kind: str) -> None:
        from dcfp.verify.reproduction_page import reproduction_page

        del kind
        part.write_text(reproduction_page(findings, figures(), records, missing), encoding="utf-8")

    def figure(part: Path, form: str) -> None:
        from dcfp.present.figures import save_figure
        from dcfp.present.figures.overview import contact_sheet

        save_figure(
            contact_sheet([(f"Figure {one.number}. {one.title}", one.figure) for one in figures()]),
            part,
            form,
        )

    outputs.write_with(data, figure)


def _document(
    findings: "list[Finding]", motions: "list[GroundMotion]", missing: list[str], remarks: list[str]
) -> dict[str, object]:
    return {
        "records": [motion.name for motion in motions],
        "missing_records": missing,
        "findings": [
            {
                "name": one.name,
                "place": one.place,
                "paper": one.paper,
                "ours": one.ours,
                "hundred_components": one.hundred or None,
                "agrees": one.agrees,
                "words": one.words,
                "outside": [
                    {
                        "record": case.record,
                        "pgv_m_s": case.pgv / 1e3,
                        "ratio": case.ratio,
                        "words": case.words,
                    }
                    for case in one.outside
                ],
            }
            for one in findings
        ],
        "remarks": remarks,
    }


def _print(
    findings: "list[Finding]", motions: "list[GroundMotion]", missing: list[str], remarks: list[str]
) -> None:
    table = new_table(["Finding"], [], ["Printed", "Ours", "100 components", ""])
    notes: list[str] = []
    for one in findings:
        add_row(
            table,
            [f"{one.name} ({one.place})", one.paper, one.ours, one.hundred, _SIGNS[one.agrees]],
        )
        if not one.agrees:
            notes.append(f"{one.name}: {one.words}")
        notes += [f"{one.name}, {case}" for case in one.outside]
    with page() as out:
        print_labelled(
            out,
            [
                ("Paper", "Li et al. (2020), section 6, at PGV 0.25, 0.50, 0.75 and 1.00 m/s"),
                ("Records", ", ".join(motion.name for motion in motions)),
                ("Not at hand", ", ".join(missing) or "none"),
            ],
        )
        out.print()
        out.print(table)
        print_remarks(out, [*notes, *remarks])
