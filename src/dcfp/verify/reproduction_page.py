"""The reproduction as one page that needs no other file."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from dcfp.present.report.document import Cell, Drawing, Section, Table, cells, words
from dcfp.present.report.forms import page_with
from dcfp.schema.check import Verdict
from dcfp.verify.reproduction import Finding
from dcfp.version import version

if TYPE_CHECKING:
    from dcfp.present.figures.li_2020 import PaperFigure

_SIGNS = {True: "as printed", False: "differs", None: "not comparable"}


def reproduction_page(
    findings: Sequence[Finding],
    figures: "Sequence[PaperFigure]",
    records: Sequence[str],
    missing: Sequence[str],
) -> str:
    """Return the page as HTML.

    Parameters
    ----------
    findings
        Of the paper and ours.
    figures
        In the form of the paper's.
    records
        Names of the records that were analysed.
    missing
        Names of those of the paper that were not there.
    """
    agreed = sum(one.agrees is True for one in findings)
    lacking = (
        f" Not at hand are {', '.join(missing)}; ranges and means of the paper are of all eight records."
    )
    head = cells("Finding", "Printed", "Ours", "100 components of FEMA P-695", "")
    rows = [row for one in findings for row in _rows(one)]
    return page_with(
        "Energy-based prediction of the displacement of DCFP bearings, made again",
        (
            words("Li et al. (2020), section 6. Applied Sciences 10(15), 5259, doi:10.3390/app10155259"),
            words(
                f"Records: {', '.join(records)}, each at a PGV of 0.25, 0.50, 0.75 and 1.00 m/s, under the paper's bearing with its friction law"
                f" and simplified heating.{lacking if missing else ''} Made by dcfp {version()} with dcfp reproduce."
            ),
        ),
        (
            Section(
                "Findings",
                (
                    words(
                        f"{agreed} of {len(findings)} are found as printed. Where ours differs, the line says by how much and why."
                    ),
                    Table(head, tuple(rows), "lllll", (1.0,) * 5),
                ),
            ),
            Section(
                "Figures",
                (words("In the form of the paper's, with its numbers."), *map(_drawing, figures)),
            ),
        ),
    )


def _rows(finding: Finding) -> tuple[tuple[Cell, ...], ...]:
    """Return what is found in one row, and why it is so in another one below it."""
    found = cells(f"{finding.name}\n{finding.place}", finding.paper, finding.ours, finding.hundred)
    sign = Cell((_SIGNS[finding.agrees],), Verdict.of(finding.agrees))
    why = "\n".join([finding.words, *(str(one) for one in finding.outside)])
    return (*found, sign), (Cell((why,), span=5),)


def _drawing(figure: "PaperFigure") -> Drawing:
    title = f"Figure {figure.number}. {figure.title}"
    return Drawing(lambda: figure.figure, title, f"{title}. {figure.words}")
