"""A sheet for each case: histories, the loop of force and displacement, and the displacement over time."""

import math
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from dcfp.analysis.response import PEAKS
from dcfp.exchange.excel.sheet import Head, Sheet, shown_unit
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.analysis import Response
    from dcfp.arrays import FloatArray
    from dcfp.study.scenario import Calculation


#: Most samples that a sheet has; of a longer history it has every second, third, ...
MOST_SAMPLES = 20_000
_TIME, _DISPLACEMENT, _FORCE = "time", "displacement", "force"
_NAMES = (
    _TIME,
    "ground_acceleration",
    "ground_velocity",
    _DISPLACEMENT,
    "velocity",
    _FORCE,
    "friction",
    "temperature",
)
_ENERGIES = ("input_energy", "hysteretic_energy")
#: Size of a chart [pixels], and rows that it covers.
_SIZE, _ROWS = {"width": 720, "height": 420}, 22


def write_histories(sheet: Sheet, book: Any, response: "Response") -> None:
    """Write the histories of one analysis with two charts beside them."""
    every = max(1, math.ceil(response.time.size / MOST_SAMPLES))
    sheet.heading(f"{response.motion.name}, PGV {response.motion.peak_velocity / 1e3:.4g} m/s")
    kept = "every sample" if every == 1 else f"one sample in {every} of {response.time.size}"
    sheet.note(
        f"Histories: {kept}; the peaks on the summary are those of the analysis itself, also between samples."
    )
    columns = {name: values[::every] for name, values in _histories(response).items()}
    heads = [Head(quantity(name).words, _unit(name), 13) for name in columns]
    first = sheet.row + 1
    sheet.table(heads, list(zip(*(values.tolist() for values in columns.values()), strict=True)), frozen=1)
    last = sheet.row - 1
    place = list(columns)
    right = len(place) + 1
    for number, (x, y) in enumerate(((_DISPLACEMENT, _FORCE), (_TIME, _DISPLACEMENT))):
        chart = _chart(book, sheet.name, heads, (place.index(x), place.index(y)), (first, last))
        sheet.page.insert_chart(first + number * _ROWS, right, chart)
    # on paper the charts; the numbers would be pages of their own by the hundred
    sheet.page.print_area(0, right, first + 2 * _ROWS, right + 12)


def _histories(response: "Response") -> "dict[str, FloatArray]":
    """Return the histories in the units in which they are shown."""
    of_energy = {"input_energy": response.energy.input, "hysteretic_energy": response.energy.hysteretic}
    found: dict[str, FloatArray] = {name: getattr(response, name) for name in _NAMES}
    found |= {name: of_energy[name] for name in _ENERGIES}
    return {name: quantity(name).display(values) for name, values in found.items()}


def _unit(name: str) -> str:
    return quantity(name).shown.name


def _chart(book: Any, name: str, heads: list[Head], columns: tuple[int, int], rows: tuple[int, int]) -> Any:
    """Return a chart of one column over another; `rows` are the first and the last."""
    chart = book.add_chart({"type": "scatter", "subtype": "straight"})
    along, up = (heads[column] for column in columns)
    x, y = ([name, rows[0], column, rows[1], column] for column in columns)
    chart.add_series({"categories": x, "values": y, "line": {"width": 1.0}})
    chart.set_title(
        {"name": f"{up.text} over {along.text}", "name_font": {"size": 11, "bold": False}, "overlay": False}
    )
    # axes at the edge, for both quantities go through zero
    grid = {"visible": True, "line": {"width": 0.25, "color": "#BFBFBF"}}
    chart.set_x_axis({"name": along.label, "label_position": "low", "major_gridlines": grid})
    chart.set_y_axis({"name": up.label, "label_position": "low", "major_gridlines": grid})
    chart.set_legend({"none": True})
    chart.set_size(_SIZE)
    return chart


# The sheet of peaks: one line for each case.


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
    columns = [one for one in PEAKS.values() if one.stored and one.is_number and one.key not in _LEFT_OUT]
    numbers = [Head(one.title, shown_unit(one.unit.udunits), 12, _FEW.get(one.key, "")) for one in columns]
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
