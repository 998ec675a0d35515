"""A calculation as a workbook for spreadsheets: peaks, inputs, methods, conditions, histories, provenance."""

import math
from dataclasses import asdict
from typing import TYPE_CHECKING, Any, cast

from dcfp.errors import InputError
from dcfp.exchange.sheet import COUNT, Formats, Head, Sheet, sheet_names
from dcfp.methods.method import Information
from dcfp.present.tables import group_names
from dcfp.schema.citations import citations_of
from dcfp.schema.quantities import quantity
from dcfp.study.scenario import OF_ONE_DIRECTION
from dcfp.version import version

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from pathlib import Path

    from dcfp.analysis.response import RigidResponse
    from dcfp.inference import Case
    from dcfp.schema.declared import Declared
    from dcfp.study.scenario import Calculation, ScenarioResult
    from dcfp.system import Bearing

SUMMARY, INPUTS, CHECKS, METHODS, CONDITIONS = (
    "Summary",
    "Inputs",
    "Checks",
    "Predictions and codes",
    "Conditions",
)
PROVENANCE = "Provenance"
#: A cell is what it is: what a user named must not become a formula or a link.
_OPTIONS = {"strings_to_formulas": False, "strings_to_urls": False, "strings_to_numbers": False}


def write_workbook(path: "Path", calculation: "Calculation") -> None:
    """Write a workbook with every result of a calculation.

    Parameters
    ----------
    path
        File to write.
    calculation
        By `dcfp.study.scenario.calculate`.

    Raises
    ------
    InputError
        If the package XlsxWriter is not installed.
    """
    title = calculation.scenario.title
    book = _new_book(path)
    book.set_properties(
        {"title": title, "author": calculation.scenario.heading.author, "comments": f"dcfp {version()}"}
    )
    formats = Formats(book)
    cases = group_names([one.response for one in calculation.results])
    of_codes = () if calculation.in_plane else (METHODS, CONDITIONS)
    fixed = (SUMMARY, INPUTS, CHECKS, *of_codes, PROVENANCE)
    sheets = {name: Sheet(book, formats, name, title) for name in fixed[:-1]}
    _write_summary(sheets[SUMMARY], calculation, cases)
    _write_inputs(sheets[INPUTS], calculation, cases)
    _write_checks(sheets[CHECKS], calculation, cases)
    if of_codes:
        _write_methods(sheets[METHODS], calculation, cases)
        _write_conditions(sheets[CONDITIONS], calculation, cases)
    for name, one in zip(sheet_names(cases, fixed), calculation.results, strict=True):
        _write_histories(Sheet(book, formats, name, title), book, one.response)
    _write_provenance(Sheet(book, formats, PROVENANCE, title), calculation)
    book.close()


def _new_book(path: "Path") -> Any:
    try:
        from xlsxwriter import Workbook
    except ImportError as error:
        msg = "a workbook needs the package XlsxWriter; install it with pip install 'dcfp[excel]'."
        raise InputError(msg) from error
    return Workbook(str(path), _OPTIONS)


# ----- peaks: one line for each case -----

#: Not of the structure, but of the computer.
_LEFT_OUT = ("elapsed_s",)
_FEW = {"energy_residual": "0.0E+00"}


def _write_summary(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
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
    columns = [
        one
        for one in calculation.quantities.values()
        if one.stored and one.is_number and one.key not in _LEFT_OUT
    ]
    numbers = [
        Head(one.title, one.unit.text if one.unit.has_dimension else "–", 12, _FEW.get(one.key, ""))
        for one in columns
    ]
    heads = [Head("Case", width=18), Head("Record", width=14), *numbers, Head("Status", width=18)]
    rows = [
        [case, row["record"], *(row[column.key] for column in columns), row["status"]]
        for case, row in zip(cases, calculation.summary, strict=True)
    ]
    sheet.table(heads, rows, frozen=2)
    sheet.skip()
    for head, column in zip(numbers, columns, strict=True):
        sheet.note(f"{head.label}: {column.words}")
    of_cases = [
        f"{case}: {remark}"
        for case, one in zip(cases, calculation.results, strict=True)
        for remark in one.response.remarks
    ]
    sheet.remarks([*((OF_ONE_DIRECTION,) if calculation.in_plane else ()), *of_cases])


# ----- inputs and provenance -----

_INPUTS = (Head("Quantity", width=40), Head("Value", width=22), Head("Unit", width=12))
_MOTIONS = (
    Head("Record", width=16, get="name"),
    Head("PGV", "mm/s", get="peak_velocity"),
    Head("PGA", "mm/s2", get="peak_acceleration"),
    Head("Time step", "s", number_format="0.0000", get="time_step"),
    Head("Values", number_format=COUNT, get=lambda motion: len(motion.acceleration)),
    Head("Event", width=22, get="origin.event"),
    Head("Station", width=22, get="origin.station"),
    Head("Component", width=14, get="origin.component"),
    Head("Source", width=26, get="origin.source"),
    Head("Format", width=14, get="origin.file_format"),
    Head("Processing in the source", width=26, get="origin.processing"),
    Head("Treatment", width=26, get=lambda motion: "; ".join(motion.treatment) or "none"),
    Head("SHA-256 of time step and acceleration", width=34, get="digest"),
)


def _write_inputs(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
    """Write everything that the results come from."""
    model, nominal = calculation.scenario.model, calculation.nominal
    sheet.heading("Bearing")
    sheet.table(_INPUTS, [*_constants(model.bearing), *_derived(model.bearing)])
    for title, part in (("Friction law", model.friction), ("Heating model", model.heating)):
        sheet.skip()
        sheet.heading(f"{title}: {part.name}")
        sheet.table(_INPUTS, _constants(part))
    sheet.skip()
    if not calculation.in_plane:
        sheet.heading("Nominal coefficient for predictions and codes")
        sheet.table(_INPUTS, [["mu_n", nominal.value, "–"]])
        sheet.note(f"From: {nominal.source}.")
        sheet.skip()
    sheet.heading("Ground motions as they shake the bearing")
    rows = [
        [case, *(head.of(one.motion) for head in _MOTIONS)]
        for case, one in zip(cases, calculation.results, strict=True)
    ]
    sheet.table((Head("Case", width=18), *_MOTIONS), rows)
    for column, head in enumerate(_INPUTS):  # the tables above need more room than that of the motions
        sheet.page.set_column(column, column, head.width)


def _constants(thing: "Declared") -> list[list[object]]:
    """Return words, value and unit of every parameter, in its declared unit."""
    rows: list[list[object]] = []
    for parameter, value in thing.rows():
        written = "not given" if value is None or value == "" else parameter.written(value)
        several = cast("list[object]", written) if isinstance(written, list) else [written]
        for number, one in enumerate(several, 1):
            label = f"{parameter.words} {number}" if len(several) > 1 else parameter.words
            rows.append([label, one, parameter.unit.name])
    return rows


def _derived(bearing: "Bearing") -> list[list[object]]:
    return [
        ["effective radius", bearing.effective_radius, "mm"],
        ["vertical force", bearing.vertical_force, "N"],
        ["mass", bearing.mass, "t"],
        ["restoring stiffness", bearing.restoring_stiffness, "N/mm"],
        ["period of the pendulum", bearing.period, "s"],
    ]


def _write_provenance(sheet: Sheet, calculation: "Calculation") -> None:
    """Write version, settings, sources and the scenario itself."""
    study, model = calculation.scenario.study, calculation.scenario.model
    settings = study.settings
    records = dict.fromkeys(motion.origin.citation for motion in calculation.scenario.motions)
    rows: list[list[object]] = [
        ["Made with", f"dcfp {version()}"],
        ["Vertical force", calculation.vertical_force],
        ["Longest step", "that of the record" if settings.step is None else f"{settings.step:g} s"],
        ["Tail", "until no more sliding can come" if settings.tail is None else f"{settings.tail:g} s"],
        ["Tolerance of the friction", settings.tolerance],
        *(["Citation", line] for line in citations_of(model.friction.citation, "li_2020")),
        *(["Citation of records", line] for line in records if line),
        *([["Scenario", study.text]] if study.text else []),
    ]
    sheet.heading("Provenance")
    sheet.skip()
    sheet.table((Head("What", width=26), Head("Which", width=100)), rows)
    sheet.skip()
    sheet.note(
        "Every number is as it was calculated; formats only say how many digits are shown. There are no formulas."
    )


# ----- predictions and codes, and the conditions of each code -----

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
_CHECKS = (
    Head("Condition", width=44, get="name"),
    Head("Verdict", width=12, get="verdict.value"),
    Head("Found", width=24, get="found"),
    Head("Limit", width=24, get="limit"),
    Head("Source", width=34, get="source"),
    Head("Confirmed in the source", width=14, get=lambda check: "yes" if check.confirmed else "unconfirmed"),
)
_CONDITIONS = (Head("Case", width=18), Head("Code", width=26), *_CHECKS)
#: Of a prediction, which has no conditions.
_NO_CONDITIONS = "–"


def _write_methods(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
    """Write what every prediction and every code says of every case, with its verdict, and each sentence on them once."""
    sheet.heading("Predictions and codes beside the analysis")
    sheet.note(
        "Where a method has no y_max of its own, its dy stands for it. A verdict is that on the method's own conditions; they are on the next sheet."
    )
    sheet.skip()
    results = list(zip(cases, calculation.results, strict=True))
    sheet.table(_METHODS, [[name, *row] for name, one in results for row in _answers(one)], frozen=2)
    notes: list[str] = []
    for one in calculation.results:
        notes += calculation.methods.remarks(one.motion.peak_velocity)
        for said in one.codes.values():
            sentences = (*(f"not confirmed: {words}." for words in said.unconfirmed), *said.remarks)
            notes += [f"{said.method}: {sentence}" for sentence in sentences]
    sheet.remarks(notes)


def _answers(one: "ScenarioResult") -> "Iterator[list[object]]":
    """Yield the cells of the analysis, of each prediction and of each code, without the case."""
    case, response = one.case, one.response
    if case is None:
        return
    whole = case.analysed.whole
    energies = (whole.input_velocity, whole.hysteretic_velocity, whole.total_velocity)
    shear = response.peak_force / response.bearing.vertical_force
    yield [
        "analysis", "record", response.status.value, response.peak_displacement, 1.0,
        whole.displacement_change, *energies, shear, None, None,
    ]  # fmt: skip
    for variant, said in case.predicted.items():
        if variant.method in case.codes:
            continue
        energies = (said.input_velocity, said.hysteretic_velocity, said.total_velocity)
        yield [
            variant.method, variant.information.value, _NO_CONDITIONS, said.bound, _ratio(said.bound, case),
            said.displacement_change, *energies, None, None, None,
        ]  # fmt: skip
    for said in case.codes.values():
        yield [
            said.method, Information.SPECTRUM.value, said.verdict, said.displacement, _ratio(said.displacement, case),
            None, None, None, None, said.base_shear, said.period, said.damping,
        ]  # fmt: skip


def _ratio(displacement: float, case: "Case") -> float | None:
    analysed = case.analysed.whole.bound
    return displacement / analysed if analysed > 0.0 and math.isfinite(displacement) else None


def _write_conditions(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
    """Write the conditions of every code for every case."""
    sheet.heading("Conditions under which the methods of codes may be used")
    sheet.skip()
    rows = [
        [name, said.method, *(head.of(one) for head in _CHECKS)]
        for name, result in zip(cases, calculation.results, strict=True)
        for said in result.codes.values()
        for one in said.conditions
    ]
    sheet.table(_CONDITIONS, rows, frozen=3)
    if rows:
        sheet.page.autofilter(sheet.row - len(rows) - 1, 0, sheet.row - 1, len(_CONDITIONS) - 1)


def _write_checks(sheet: Sheet, calculation: "Calculation", cases: "Sequence[str]") -> None:
    """Write what every analysis ought to keep to, and whether it does."""
    sheet.heading("Checks of the analyses")
    sheet.skip()
    rows = [
        [name, *(head.of(one) for head in _CHECKS)]
        for name, result in zip(cases, calculation.results, strict=True)
        for one in result.response.checks
    ]
    sheet.table((_CONDITIONS[0], *_CHECKS), rows, frozen=2)


# ----- histories of each case: the loop of force and displacement, and the displacement over time; in the plane the path of displacement too -----

#: Most samples that a sheet has; of a longer history it has every second, third, ...
MOST_SAMPLES = 20_000
_TIME, _DISPLACEMENT, _FORCE = "time", "displacement", "force"
_X, _Y = f"{_DISPLACEMENT}_x", f"{_DISPLACEMENT}_y"
_OF_ALL = ("friction", "temperature", "input_energy", "hysteretic_energy")
_HISTORIES = ("ground_acceleration", "ground_velocity", _DISPLACEMENT, "velocity", _FORCE, *_OF_ALL)
_PLANE_HISTORIES = (
    "ground_acceleration_x", "ground_acceleration_y", "ground_velocity_x", "ground_velocity_y", _X, _Y, _DISPLACEMENT,
    "velocity", "force_x", "force_y", _FORCE, *_OF_ALL,
)  # fmt: skip
#: What is drawn over what.
_CHARTS = ((_DISPLACEMENT, _FORCE), (_TIME, _DISPLACEMENT))
_PLANE_CHARTS = ((_X, _Y), (_TIME, _DISPLACEMENT), (_X, "force_x"), (_Y, "force_y"))
#: Size of a chart [pixels], of one that is a map, and rows that it covers.
_SIZE, _MAP, _ROWS = {"width": 720, "height": 420}, {"width": 470, "height": 420}, 22


def _write_histories(sheet: Sheet, book: Any, response: "RigidResponse") -> None:
    """Write the histories of one analysis with charts beside them."""
    in_plane = _X in response.histories
    names, charts = (_PLANE_HISTORIES, _PLANE_CHARTS) if in_plane else (_HISTORIES, _CHARTS)
    every = max(1, math.ceil(response.time.size / MOST_SAMPLES))
    sheet.heading(f"{response.motion.name}, PGV {response.motion.peak_velocity / 1e3:.4g} m/s")
    kept = "every sample" if every == 1 else f"one sample in {every} of {response.time.size}"
    sheet.note(
        f"Histories: {kept}; the peaks on the summary are those of the analysis itself, also between samples."
    )
    told = {_TIME: quantity(_TIME)} | {name: response.histories[name] for name in names}
    columns = {_TIME: response.time} | {name: told[name].of(response) for name in names}
    heads = [Head(one.words, one.shown.name, 13) for one in told.values()]
    values = [told[name].display(one)[::every].tolist() for name, one in columns.items()]
    first = sheet.row + 1
    sheet.table(heads, zip(*values, strict=True), frozen=1)
    last = sheet.row - 1
    place = list(columns)
    right = len(place) + 1
    for number, (x, y) in enumerate(charts):
        chart = _chart(book, sheet.name, heads, (place.index(x), place.index(y)), (first, last))
        if (x, y) == (_X, _Y):  # as long in both directions
            _draw_to_scale(chart, heads, response.peak_displacement)
        sheet.page.insert_chart(first + number * _ROWS, right, chart)
    # on paper the charts; the numbers would be pages of their own by the hundred
    sheet.page.print_area(0, right, first + len(charts) * _ROWS, right + 12)


def _chart(book: Any, name: str, heads: list[Head], columns: tuple[int, int], rows: tuple[int, int]) -> Any:
    """Return a chart of one column over another; `rows` are the first and the last."""
    chart = book.add_chart({"type": "scatter", "subtype": "straight"})
    along, up = (heads[column] for column in columns)
    x, y = ([name, rows[0], column, rows[1], column] for column in columns)
    chart.add_series({"categories": x, "values": y, "line": {"width": 1.0}})
    chart.set_title(
        {"name": f"{up.text} over {along.text}", "name_font": {"size": 11, "bold": False}, "overlay": False}
    )
    chart.set_x_axis(_axis(along))
    chart.set_y_axis(_axis(up))
    chart.set_legend({"none": True})
    chart.set_size(_SIZE)
    return chart


def _axis(head: Head, **limits: float) -> dict[str, object]:
    # at the edge, for both quantities go through zero
    grid = {"visible": True, "line": {"width": 0.25, "color": "#BFBFBF"}}
    return {"name": head.label, "label_position": "low", "major_gridlines": grid, **limits}


def _draw_to_scale(chart: Any, heads: list[Head], reach: float) -> None:
    """Give a chart of a path the same limits in both directions, of which `reach` is the farthest [mm], on an area that is about as wide as it is high."""
    step = 10.0 ** math.floor(math.log10(max(reach, 1.0)))
    end = step * math.ceil(max(reach, 1.0) / step)
    x, y = (head for head in heads if head.text.endswith((" x", " y")) and head.unit == "mm")
    chart.set_x_axis(_axis(x, min=-end, max=end))
    chart.set_y_axis(_axis(y, min=-end, max=end))
    chart.set_size(_MAP)
