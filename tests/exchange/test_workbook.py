"""The workbook: read again with another package, and compared with the JSON of the same scenario."""

import sys
import zipfile
from dataclasses import replace
from pathlib import Path

import numpy as np
import openpyxl
import pytest

import dcfp
from dcfp.errors import InputError
from dcfp.exchange import workbook, write_workbook
from dcfp.exchange.sheet import sheet_names
from dcfp.inference.told import case_objects
from dcfp.study import Study
from dcfp.study.scenario import Calculation, Heading, Scenario, calculate

EVIL = '=HYPERLINK("http://example.org","click")'


def thinned(name: str) -> dcfp.GroundMotion:
    """Return every third value of a record, which has thousands of lines in a workbook otherwise."""
    motion = dcfp.load_motion(name)
    return replace(motion, acceleration=motion.acceleration[::3], time_step=3.0 * motion.time_step)


def scenario(names: tuple[str, ...] = ("NCC", "KNA"), **changes) -> Scenario:
    records = [replace(thinned(known), name=name) for known, name in zip(("NCC", "KNA"), names, strict=True)]
    study = Study(
        records, {"pgv": changes.pop("pgvs", [250.0, 500.0])}, title=changes.pop("title", "Tower A")
    )
    return Scenario(study, Heading(project="Tower & Co", author="A. Engineer"))


def written(calculation: Calculation, path: Path) -> openpyxl.Workbook:
    write_workbook(path, calculation)
    return openpyxl.load_workbook(path)


@pytest.fixture(scope="module")
def calculation() -> Calculation:
    return calculate(scenario())


@pytest.fixture(scope="module")
def book(calculation: Calculation, tmp_path_factory: pytest.TempPathFactory) -> openpyxl.Workbook:
    return written(calculation, tmp_path_factory.mktemp("workbook") / "results.xlsx")


def table(sheet, head: str) -> list[dict[str, object]]:
    """Return the rows below a line that begins with `head`, down to the first empty one."""
    lines = list(sheet.iter_rows(values_only=True))
    start = next(place for place, line in enumerate(lines) if line[0] == head)
    heads = [cell for cell in lines[start] if cell is not None]
    rows: list[dict[str, object]] = []
    for line in lines[start + 1 :]:
        if line[0] is None:
            break
        rows.append(dict(zip(heads, line, strict=False)))
    return rows


def test_the_peaks_are_those_of_the_json(book, calculation) -> None:
    rows = table(book["Summary"], "Case")
    assert [row["Case"] for row in rows] == ["NCC_0.25", "NCC_0.50", "KNA_0.25", "KNA_0.50"]
    heads = {
        "y_max [mm]": "y_max_mm", "dy_max [mm]": "dy_max_mm", "v_max [mm/s]": "v_max_mm_s", "residual [mm]": "residual_mm",
        "force_max [kN]": "force_max_kN", "temperature_max [degC]": "temperature_max_degC", "friction_min [–]": "friction_min",
        "V_E [mm/s]": "V_E_mm_s", "V_Eh [mm/s]": "V_Eh_mm_s", "pgv [m/s]": "pgv_m_s", "Status": "status", "Record": "record",
    }  # fmt: skip
    for row, summary in zip(rows, calculation.summary, strict=True):
        for head, key in heads.items():
            expected = summary[key]
            # a workbook holds 16 digits
            assert row[head] == (
                expected if isinstance(expected, str) else pytest.approx(expected, rel=1e-14)
            )
    words = [cell for (cell,) in book["Summary"].iter_rows(max_col=1, values_only=True) if cell]
    for one in calculation.results:
        for remark in one.response.remarks:
            assert any(str(word).endswith(remark) for word in words)


def test_predictions_and_codes_are_those_of_the_json_with_their_verdicts(book, calculation) -> None:
    rows = table(book["Predictions and codes"], "Case")
    objects = case_objects([one.case for one in calculation.results], calculation.methods)
    for case, said in zip(("NCC_0.25", "NCC_0.50", "KNA_0.25", "KNA_0.50"), objects, strict=True):
        mine = [row for row in rows if row["Case"] == case]
        assert all(row["Verdict"] for row in mine)
        assert mine[0]["y_max [mm]"] == pytest.approx(said["analysis"]["y_mm"], rel=1e-14)
        predicted = {(row["Method"], row["It knows"]): row for row in mine[1:]}
        assert len(predicted) == len(mine) - 1 == len(said["predictions"]) + len(said["codes"])
        for one in said["predictions"]:
            assert predicted[one["method"], one["basis"]]["dy [mm]"] == pytest.approx(one["dy_mm"], rel=1e-14)
        for one in said["codes"]:
            row = predicted[one["method"], "spectrum"]
            assert row["Verdict"] == one["verdict"]
            assert row["y_max [mm]"] == pytest.approx(one["displacement_mm"], rel=1e-14)
            assert row["F over W [–]"] == pytest.approx(one["base_shear_over_weight"], rel=1e-14)
        conditions = [row for row in table(book["Conditions"], "Case") if row["Case"] == case]
        expected = [(one["method"], c) for one in said["codes"] for c in one["conditions"]]
        assert len(conditions) == len(expected)
        for row, (method, condition) in zip(conditions, expected, strict=True):
            assert (row["Code"], row["Condition"], row["Verdict"]) == (
                method,
                condition["name"],
                condition["verdict"],
            )
            assert (row["Found"], row["Limit"], row["Source"]) == (
                condition["found"],
                condition["limit"],
                condition["source"],
            )
            assert row["Confirmed in the source"] == ("yes" if condition["confirmed"] else "unconfirmed")


def test_the_inputs_say_what_and_from_where(book, calculation) -> None:
    sheet = book["Inputs"]
    cells = {row[0].value: row[1].value for row in sheet.iter_rows(max_col=2)}
    bearing = calculation.scenario.model.bearing
    for part in (bearing, calculation.scenario.model.friction, calculation.scenario.model.heating):
        for parameter, value in part.rows():
            written = parameter.written(value)
            if isinstance(written, list):
                assert [cells[f"{parameter.words} {number}"] for number in (1, 2)] == written
            elif isinstance(written, float):
                assert cells[parameter.words] == written
    assert cells["vertical force"] == pytest.approx(bearing.vertical_force, rel=1e-14)
    assert cells["mu_n"] == calculation.nominal.value
    rows = table(sheet, "Case")
    digests = [row["SHA-256 of time step and acceleration"] for row in rows]
    assert digests == [one.motion.digest for one in calculation.results]
    assert rows[1]["PGV [mm/s]"] == pytest.approx(500.0)
    text = " ".join(
        str(cell) for row in book["Provenance"].iter_rows(values_only=True) for cell in row if cell
    )
    assert f"dcfp {dcfp.version()}" in text
    assert "10.3390/app10155259" in text


def test_each_case_has_its_histories_and_two_charts(book, calculation) -> None:
    for name, one in zip(("NCC_0.25", "NCC_0.50", "KNA_0.25", "KNA_0.50"), calculation.results, strict=True):
        sheet = book[name]
        rows = list(sheet.iter_rows(min_row=4, values_only=True))
        values = np.array(rows, dtype=float)[:, :10]
        assert values.shape[0] == one.response.time.size
        np.testing.assert_allclose(values[:, 3], one.response.displacement, rtol=1e-13)
        np.testing.assert_allclose(values[:, 5], one.response.force / 1e3, rtol=1e-13)
        assert len(sheet._charts) == 2
        assert sheet.freeze_panes == "B4"
        series = sheet._charts[0].series[0]
        assert series.xVal.numRef.f.replace("'", "") == f"{name}!$D$4:$D${len(rows) + 3}"
        assert series.yVal.numRef.f.replace("'", "") == f"{name}!$F$4:$F${len(rows) + 3}"


@pytest.mark.slow
def test_a_long_history_is_thinned_and_says_so(calculation, tmp_path, monkeypatch) -> None:
    monkeypatch.setattr(workbook, "MOST_SAMPLES", 500)
    book = written(calculation, tmp_path / "r.xlsx")
    sheet = book["NCC_0.25"]
    samples = calculation.results[0].response.time.size
    every = -(-samples // 500)
    assert every > 1
    assert sheet.max_row - 3 == -(-samples // every)
    assert f"one sample in {every} of {samples}" in sheet["A2"].value


def test_pages_are_set_up_for_paper(book) -> None:
    for sheet in book:
        assert sheet.page_setup.orientation == "landscape"
        assert sheet.sheet_properties.pageSetUpPr.fitToPage
    assert book["Summary"].print_title_rows is not None
    assert book["Summary"].freeze_panes == "C7"


@pytest.mark.slow
def test_a_name_is_never_a_formula_or_a_link(tmp_path) -> None:
    path = tmp_path / "r.xlsx"
    book = written(calculate(scenario((EVIL, "@cmd [x]:*?/\\'"), title="=1+1&P", pgvs=[250.0])), path)
    cells = [cell for sheet in book for row in sheet.iter_rows() for cell in row if cell.value is not None]
    assert not [cell for cell in cells if cell.data_type == "f"]
    assert not [cell for cell in cells if cell.hyperlink]
    assert any(cell.value == EVIL for cell in cells)
    assert any(cell.value == "=1+1&P" for cell in cells)
    with zipfile.ZipFile(path) as parts:
        sheets = [name for name in parts.namelist() if name.startswith("xl/worksheets/sheet")]
        assert not any(b"<f>" in parts.read(name) for name in sheets)
    assert "&&P" in str(book["Summary"].oddHeader.left.text) or "&P" in str(
        book["Summary"].oddHeader.left.text
    )


@pytest.mark.parametrize(
    ("wanted", "found"),
    [
        (["NCC_0.50", "ncc_0.50"], ["NCC_0.50", "ncc_0.50_2"]),
        (["a" * 40, "a" * 41], ["a" * 31, "a" * 29 + "_2"]),
        (["a[b]:c*d?e/f\\g"], ["a-b-c-d-e-f-g"]),
        (["'quoted'", "", "''"], ["quoted", "case", "case_2"]),
        (["Summary", "history"], ["Summary_2", "history_2"]),
    ],
)
def test_names_of_sheets(wanted: list[str], found: list[str]) -> None:
    assert sheet_names(wanted, ["Summary"]) == found


def test_without_xlsxwriter_there_is_a_way_to_get_it(calculation, tmp_path, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "xlsxwriter", None)
    with pytest.raises(InputError, match=r"pip install 'dcfp\[excel\]'"):
        write_workbook(tmp_path / "r.xlsx", calculation)
    assert list(tmp_path.iterdir()) == []
