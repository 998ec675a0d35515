"""The sheet that says what made the workbook, and whom to cite."""

from typing import TYPE_CHECKING

from dcfp.exchange.excel.sheet import Head, Sheet
from dcfp.schema.citations import citations_of
from dcfp.version import version

if TYPE_CHECKING:
    from dcfp.study.scenario import Calculation

_HEADS = (Head("What", width=26), Head("Which", width=100))


def write_provenance(sheet: Sheet, calculation: "Calculation") -> None:
    """Write version, settings, sources and the scenario itself."""
    study, model = calculation.scenario.study, calculation.scenario.model
    settings = study.settings
    records = {
        motion.origin.citation: None for motion in calculation.scenario.motions if motion.origin.citation
    }
    rows: list[list[object]] = [
        ["Made with", f"dcfp {version()}"],
        ["Longest step", "that of the record" if settings.step is None else f"{settings.step:g} s"],
        ["Tail", "until no more sliding can come" if settings.tail is None else f"{settings.tail:g} s"],
        ["Tolerance of the friction", settings.tolerance],
        *(["Citation", line] for line in citations_of(model.friction.citation, "li_2020")),
        *(["Citation of records", line] for line in records),
        *([["Scenario", study.text]] if study.text else []),
    ]
    sheet.heading("Provenance")
    sheet.skip()
    sheet.table(_HEADS, rows)
    sheet.skip()
    sheet.note(
        "Every number is as it was calculated; formats only say how many digits are shown. There are no formulas."
    )
