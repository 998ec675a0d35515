"""The sheet of peaks: one line for each case."""

from dataclasses import asdict
from typing import TYPE_CHECKING

from dcfp.exchange.excel.sheet import Head, Sheet, shown_unit
from dcfp.present.tables.responses import COLUMNS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.study.scenario import Calculation

#: Not of the structure, but of the computer.
_LEFT_OUT = ("elapsed_s",)
_FEW = {"energy_residual": "0.0E+00"}


def write_summary(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
    """Write the peaks of every case, how each analysis ended, and what is to be known of it."""
    scenario = calculation.scenario
    sheet.heading(scenario.title)
    for name, words in asdict(scenario.heading).items():
        if words:
            sheet.note(f"{name.capitalize()}: {words}")
    model = scenario.model
    sheet.note(
        f"Bearing: {model.bearing.name}; friction: {model.friction.name}; heating: {model.heating.name}."
    )
    sheet.skip()
    columns = [column for column in COLUMNS if column.key not in _LEFT_OUT]
    numbers = [Head(one.name, shown_unit(one.unit), 12, _FEW.get(one.key, "")) for one in columns]
    heads = [Head("Case", width=18), Head("Record", width=14), *numbers, Head("Status", width=18)]
    rows = [
        [case, row["record"], *(row[column.key] for column in columns), row["status"]]
        for case, row in zip(cases, calculation.summary, strict=True)
    ]
    sheet.table(heads, rows, frozen=2)
    _write_words(sheet, [(head.label, column.words) for head, column in zip(numbers, columns, strict=True)])
    _write_remarks(sheet, calculation, cases)


def _write_words(sheet: Sheet, columns: "Sequence[tuple[str, str]]") -> None:
    sheet.skip()
    for label, words in columns:
        sheet.note(f"{label}: {words}")


def _write_remarks(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
    remarks = {
        f"{case}: {remark}": None
        for case, one in zip(cases, calculation.results, strict=True)
        for remark in one.case.remarks
    }
    if not remarks:
        return
    sheet.skip()
    sheet.heading("Remarks")
    for remark in remarks:
        sheet.note(remark)
