"""The sheets of predictions and codes, and of the conditions of each code."""

import math
from typing import TYPE_CHECKING

from dcfp.exchange.excel.sheet import Head, Sheet
from dcfp.methods.method import Information

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dcfp.inference import Case
    from dcfp.study.scenario import Calculation, ScenarioResult

_METHODS = (
    Head("Case", width=18),
    Head("Method", width=30),
    Head("It knows", width=12),
    Head("Verdict", width=30),
    Head("y_max", "mm"),
    Head("y_max over analysis", "–", number_format="0.00"),
    Head("dy", "mm"),
    Head("V_dE", "mm/s"),
    Head("V_dEhr", "mm/s"),
    Head("V_E", "mm/s"),
    Head("F over W", "–"),
    Head("Effective period", "s"),
    Head("Effective damping", "–"),
)
_CONDITIONS = (
    Head("Case", width=18),
    Head("Code", width=26),
    Head("Condition", width=44),
    Head("Verdict", width=12),
    Head("Found", width=24),
    Head("Limit", width=24),
    Head("Source", width=34),
    Head("Confirmed in the source", width=14),
)
#: Of a prediction, which has no conditions.
_NO_CONDITIONS = "–"


def write_methods(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
    """Write what every prediction and every code says of every case, with its verdict."""
    sheet.heading("Predictions and codes beside the analysis")
    sheet.note(
        "Where a method has no y_max of its own, its dy stands for it. A verdict is that on the method's own conditions; they are on the next sheet."
    )
    sheet.skip()
    rows = [
        row
        for name, one in zip(cases, calculation.results, strict=True)
        for row in (_analysis(name, one), *_predictions(name, one.case), *_codes(name, one.case))
    ]
    sheet.table(_METHODS, rows, frozen=2)
    _write_notes(sheet, calculation)


def _write_notes(sheet: Sheet, calculation: "Calculation") -> None:
    """Write what is to be known of the methods, each sentence once."""
    notes: dict[str, None] = {}
    for one in calculation.results:
        notes |= dict.fromkeys(calculation.methods.remarks(one.case.pgv))
        for said in one.case.codes.values():
            sentences = (*(f"not confirmed: {words}." for words in said.unconfirmed), *said.remarks)
            notes |= dict.fromkeys(f"{said.method}: {sentence}" for sentence in sentences)
    if notes:
        sheet.skip()
        sheet.heading("Remarks")
    for note in notes:
        sheet.note(note)


def _analysis(name: str, one: "ScenarioResult") -> list[object]:
    whole = one.case.analysed.whole
    response = one.response
    shear = response.peak_force / response.bearing.vertical_force
    energies = (whole.input_velocity, whole.hysteretic_velocity, whole.total_velocity)
    return [
        name, "analysis", "record", response.status.value, response.peak_displacement, 1.0,
        whole.displacement_change, *energies, shear, None, None,
    ]  # fmt: skip


def _predictions(name: str, case: "Case") -> "Iterator[list[object]]":
    for variant, said in case.predicted.items():
        if variant.method in case.codes:
            continue
        energies = (said.input_velocity, said.hysteretic_velocity, said.total_velocity)
        yield [
            name, variant.method, variant.information.value, _NO_CONDITIONS, said.bound, _ratio(said.bound, case),
            said.displacement_change, *energies, None, None, None,
        ]  # fmt: skip


def _codes(name: str, case: "Case") -> "Iterator[list[object]]":
    for said in case.codes.values():
        yield [
            name, said.method, Information.SPECTRUM.value, said.verdict, said.displacement, _ratio(said.displacement, case),
            None, None, None, None, said.base_shear, said.period, said.damping,
        ]  # fmt: skip


def _ratio(displacement: float, case: "Case") -> float | None:
    analysed = case.analysed.whole.bound
    return displacement / analysed if analysed > 0.0 and math.isfinite(displacement) else None


def write_conditions(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
    """Write the conditions of every code for every case."""
    sheet.heading("Conditions under which the methods of codes may be used")
    sheet.skip()
    rows = [
        [
            name, said.method, one.name, one.verdict.value, one.found, one.limit, one.source,
            "yes" if one.confirmed else "unconfirmed",
        ]
        for name, result in zip(cases, calculation.results, strict=True)
        for said in result.case.codes.values()
        for one in said.conditions
    ]  # fmt: skip
    sheet.table(_CONDITIONS, rows, frozen=3)
    if rows:
        sheet.page.autofilter(sheet.row - len(rows) - 1, 0, sheet.row - 1, len(_CONDITIONS) - 1)
