"""`dcfp export`, and what `dcfp respond` writes for other programs."""

import ast
import json
from pathlib import Path

import openpyxl
import pytest
import xarray

SCENARIO = """
title = "Tower A"
[factors]
record = {records}
pgv = {{ values = {pgvs}, unit = "m/s" }}
[bearing]
radius = 3000
[bearing.friction]
law = "{law}"
"""


def scenario(
    folder: Path, records: str = '["NCC"]', pgvs: str = "[0.5]", law: str = "kumar2015", more: str = ""
) -> Path:
    path = folder / "scenario.toml"
    path.write_text(SCENARIO.format(records=records, pgvs=pgvs, law=law) + more, encoding="utf-8")
    return path


def summary_of(file: Path) -> dict[str, tuple]:
    """The rows of the summary of a workbook by their names, read without its histories."""
    book = openpyxl.load_workbook(file, read_only=True)
    rows = {row[0]: row for row in book["Summary"].iter_rows(values_only=True) if row and row[0] is not None}
    book.close()
    return rows


def test_a_script(run, tmp_path) -> None:
    file = tmp_path / "model.py"
    status, out, err = run("export", scenario(tmp_path), "--out", file)
    assert (status, out, err) == (0, f"{file}: written.\n", "")
    text = file.read_text(encoding="utf-8")
    ast.parse(text)
    assert "FPBearingPTV" in text
    assert "radius 3000 and 3000 mm" in text


@pytest.mark.slow
def test_a_workbook_has_the_peaks_of_the_json(run, tmp_path) -> None:
    file = tmp_path / "results.xlsx"
    outcome = run("export", scenario(tmp_path, pgvs="[0.25, 0.5]"), "--out", file, "--json")
    document = json.loads(outcome.out)
    assert (outcome.status, document["file"]) == (0, str(file))
    rows = summary_of(file)
    for name, one in zip(("NCC_0.25", "NCC_0.50"), document["analyses"], strict=True):
        assert rows[name][3] == pytest.approx(one["y_max_mm"], rel=1e-14)


@pytest.mark.slow
def test_netcdf_and_csv(run, tmp_path) -> None:
    file = scenario(tmp_path, pgvs="[0.25, 0.5]")
    assert run("export", file, "--out", tmp_path / "r.nc").status == 0
    with xarray.open_dataset(tmp_path / "r.nc", engine="h5netcdf") as data:
        assert data.sizes["analysis"] == 2
    assert run("export", file, "--out", tmp_path / "r.csv").status == 0
    assert (tmp_path / "r.csv").read_text(encoding="utf-8").count("\n") == 3


def test_respond_writes_a_script_of_one_analysis(run, tmp_path) -> None:
    file = tmp_path / "model.py"
    outcome = run(
        "respond", "NCC", "--pgv", "0.5", "--friction", "constant", "--mu", "0.06", "--out", file, "--json"
    )
    (row,) = json.loads(outcome.out)
    text = file.read_text(encoding="utf-8")
    assert "FRICTION = 0.06" in text
    assert f"DCFP_PEAK_DISPLACEMENT = {row['y_max_mm']!r}" in text


@pytest.mark.slow
def test_respond_writes_a_workbook(run, tmp_path) -> None:
    file = tmp_path / "r.xlsx"
    words = (
        "--pgv",
        "0.25",
        "--radius",
        "3000",
        "--step",
        "0.01",
        "--out",
        file,
        "--plot",
        tmp_path / "r.png",
    )
    outcome = run("respond", "NCC", "KNA", *words, "--json")
    assert outcome.status == 0
    assert (tmp_path / "r.png").exists()
    rows = summary_of(file)
    for name, one in zip(("NCC_0.25", "KNA_0.25"), json.loads(outcome.out), strict=True):
        assert rows[name][3] == pytest.approx(one["y_max_mm"], rel=1e-14)


@pytest.mark.parametrize(
    ("change", "out", "words"),
    [
        ({"pgvs": "[0.25, 0.5]"}, "m.py", ("one record at one intensity", "2 analyses", ".xlsx")),
        ({"records": '["NCC", "KNA"]'}, "m.py", ("2 analyses",)),
        ({"law": "lomiento2013"}, "m.py", ("lomiento2013", "kumar2015 or constant")),
        ({}, "m.doc", (".py, .xlsx, .nc, .csv",)),
        ({}, "no/such/m.py", ("folder",)),
        ({"law": "kumar2051"}, "m.py", ("scenario.toml", "kumar2051")),
        ({"more": "[sampling]\ncount = 3\n[sampling.factors]\nmu = [0.04]\n"}, "m.xlsx", ("dcfp study",)),
    ],
)
def test_what_cannot_be_is_told_in_one_line(run, tmp_path, change, out, words) -> None:
    file = scenario(tmp_path, **change)
    status, printed, err = run("export", file, "--out", tmp_path / out)
    assert (status, printed, err.count("\n")) == (2, "", 1), err
    assert err.startswith("dcfp: ")
    for word in words:
        assert word in err
    assert list(tmp_path.iterdir()) == [file]


def test_a_file_that_is_not_there(run, tmp_path) -> None:
    assert "none.toml" in run("export", tmp_path / "none.toml", "--out", tmp_path / "m.py").err
    assert "--out" in run("export", scenario(tmp_path)).err


def test_respond_refuses_a_script_of_several(run, tmp_path) -> None:
    status, out, err = run("respond", "NCC", "--pgv", "0.25", "0.5", "--out", tmp_path / "m.py")
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert "one record at one PGV, not of 2 analyses" in err
    assert list(tmp_path.iterdir()) == []


def test_an_existing_file_is_kept_unless_told(run, tmp_path) -> None:
    file = tmp_path / "m.py"
    file.write_text("precious")
    assert "--overwrite" in run("export", scenario(tmp_path), "--out", file).err
    assert file.read_text() == "precious"
    assert run("export", scenario(tmp_path), "--out", file, "--overwrite").status == 0
    assert file.read_text().startswith("# ")


def test_a_scenario_is_not_written_over(run, tmp_path) -> None:
    file = scenario(tmp_path)
    copy = file.rename(tmp_path / "scenario.py")
    assert "input" in run("export", copy, "--out", copy, "--overwrite").err
    assert copy.read_text().startswith("\ntitle")
