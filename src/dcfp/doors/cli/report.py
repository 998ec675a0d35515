"""A calculation report of a scenario, as PDF or as one page of HTML: inputs, formulas with numbers, results, checks and verdicts."""

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli.parser import Parser
from dcfp.files import check_outputs, known_extension, whole_files

if TYPE_CHECKING:
    from dcfp.present.report import Document

_PDF, _PAGE = ".pdf", (".html", ".htm")
#: Figures of a case.
_FIGURES = 2


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    parser.add_argument(
        "scenario",
        metavar="SCENARIO.toml",
        help="a bearing and its ground motions: a study file in which only record and intensity vary, with a table [report]",
    )
    parser.add_argument(
        "--out",
        metavar="FILE",
        help="the report as .pdf or .html; by default SCENARIO.pdf in the current folder",
    )
    parser.add_argument("--overwrite", action="store_true", help="replace a file that exists")
    parser.add_argument(
        "--json",
        action="store_true",
        help="the numbers of the report as one JSON document on standard output; a file is then written only with --out",
    )


def run(chosen: argparse.Namespace) -> int:
    """Calculate the scenario and write its report."""
    path = _output(chosen)
    if path is not None:
        check_outputs([path], overwrite=chosen.overwrite, inputs=[Path(chosen.scenario)])
        if path.suffix.lower() == _PDF:
            from dcfp.present.report.pdf import check_typst

            check_typst()
    # late, so that a slip in the command is answered at once
    from dcfp.doors.cli.progress import progress
    from dcfp.present.report import build_report
    from dcfp.study.scenario import calculate, read_scenario

    scenario = read_scenario(chosen.scenario)
    with progress("analyses", len(scenario.motions)) as advance:
        calculation = calculate(scenario, advance)
    document = build_report(calculation)
    if path is not None:
        _write(document, path, _FIGURES * len(calculation.results), overwrite=chosen.overwrite)
    if chosen.json:
        print(json.dumps(document.numbers, indent=2, allow_nan=False))
    elif path is not None:
        print(f"{path}: written.")
    return 0


def _output(chosen: argparse.Namespace) -> Path | None:
    if chosen.out is None:
        return None if chosen.json else Path(f"{Path(chosen.scenario).stem}{_PDF}")
    return known_extension(chosen.out, (_PDF, *_PAGE), "a report")


def _write(document: "Document", path: Path, figures: int, *, overwrite: bool) -> None:
    from dcfp.doors.cli.progress import progress
    from dcfp.present.report import page_of, pdf_of

    with whole_files([path], overwrite=overwrite) as (part,), progress("figures", figures) as advance:
        if path.suffix.lower() == _PDF:
            part.write_bytes(pdf_of(document, advance))
        else:
            part.write_text(page_of(document, advance), encoding="utf-8", newline="\n")
