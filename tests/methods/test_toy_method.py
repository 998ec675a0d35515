"""A code and a method of prediction, each in one module outside of the package, are found at every door, and nothing else has to be said anywhere."""

import csv
import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from html import unescape
from importlib import import_module
from pathlib import Path

import pytest
from matplotlib.colors import to_hex

import dcfp
from dcfp.doors.cli.main import main
from dcfp.inference import Methods, compare
from dcfp.methods import METHODS
from dcfp.methods.method import variants
from dcfp.motion import named_motion
from dcfp.present.figures.predictions import plot_comparison, plot_forecasts

TOYS = Path(__file__).parent / "toys"
MODULES = ("toy_code", "toy_prediction")
CODE, PREDICTION = "Toy code 2030", "toy prediction"
COLOURS = {CODE: "#117733", PREDICTION: "#882255"}
RECORD = ("NCC", "--pgv", "0.5")


@pytest.fixture(autouse=True)
def toys(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Add them for a test."""
    monkeypatch.syspath_prepend(TOYS)
    for name in MODULES:
        import_module(name)
    yield
    for name in MODULES:
        METHODS.remove(name.replace("_", "-"))
        del sys.modules[name]


def answer(capsys: pytest.CaptureFixture[str], *words: str | Path) -> str:
    assert main([str(word) for word in words]) == 0
    return capsys.readouterr().out


def objects(capsys: pytest.CaptureFixture[str], *words: str | Path) -> list[dict]:
    return json.loads(answer(capsys, *words, "--json"))


def lines(path: Path) -> list[dict[str, str]]:
    with path.open() as rows:
        return list(csv.DictReader(rows))


def marks(figure) -> dict[str, set[str]]:
    """Return the markers of every colour in a figure."""
    found: dict[str, set[str]] = {}
    for axes in figure.axes:
        for line in axes.lines:
            found.setdefault(to_hex(line.get_color()), set()).add(line.get_marker())
    return found


@pytest.mark.slow
def test_an_installed_package_adds_by_its_entry_points(tmp_path: Path) -> None:
    about = tmp_path / "toys-1.0.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: toys\nVersion: 1.0\n")
    (about / "entry_points.txt").write_text("[dcfp.plugins]\ncode = toy_code\nprediction = toy_prediction\n")
    source = str(Path(dcfp.__file__).parents[1])
    environment = os.environ | {"PYTHONPATH": os.pathsep.join((str(tmp_path), str(TOYS), source))}
    command = [sys.executable, "-m", "dcfp.doors.cli.main", "codes", "--asce", "1.5", "0.6", "--json"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    (comparison,) = json.loads(done.stdout)
    assert CODE in [one["method"] for one in comparison["answers"]]


@pytest.mark.slow
def test_codes(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    said = " ".join(answer(capsys, "codes", *RECORD, "--details").split())
    assert CODE in said
    assert "period of the toy" in said
    assert f"{CODE}: The toy code was asked at mu 0.043." in said
    (comparison,) = objects(capsys, "codes", *RECORD)
    (toy,) = [one for one in comparison["answers"] if one["method"] == CODE]
    assert toy["verdict"] == "within its limits"
    assert toy["conditions"][0]["found"] == "6.02 s"
    # between bounds, with the larger force of both, as every code
    (bounded,) = objects(capsys, "codes", *RECORD, "--bounds", "0.5", "2")
    (other,) = [one for one in bounded["answers"] if one["method"] == CODE]
    assert other["displacement_mm"] == toy["displacement_mm"]
    assert other["base_shear_over_weight"] > toy["base_shear_over_weight"]
    answer(capsys, "codes", *RECORD, "--out", tmp_path / "codes.csv")
    assert CODE in [row["method"] for row in lines(tmp_path / "codes.csv")]
    answer(capsys, "codes", *RECORD, "--plot", tmp_path / "codes.svg")
    assert CODE in (tmp_path / "codes.svg").read_text()


def test_predict(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    said = answer(capsys, "predict", *RECORD)
    assert PREDICTION in said
    assert "The toy was asked." in said
    (forecast,) = objects(capsys, "predict", *RECORD)
    (toy,) = [one for one in forecast["predictions"] if one["method"] == PREDICTION]
    assert toy["y_mm"] == pytest.approx(100.0)
    assert toy["basis"] == "blind"
    answer(capsys, "predict", *RECORD, "--out", tmp_path / "predicted.csv")
    (row,) = [row for row in lines(tmp_path / "predicted.csv") if row["method"] == PREDICTION]
    assert float(row["y [mm]"]) == pytest.approx(100.0)
    answer(capsys, "predict", "NCC", "KNA", "--pgv", "0.5", "--plot", tmp_path / "predicted.svg")
    assert PREDICTION in (tmp_path / "predicted.svg").read_text()


def test_compare(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    said = answer(capsys, "compare", *RECORD)
    assert CODE in said
    assert "toy" in said.replace(CODE, "")
    (case,) = objects(capsys, "compare", *RECORD)["cases"]
    assert PREDICTION in [one["method"] for one in case["predictions"]]
    assert CODE in [one["method"] for one in case["codes"]]
    answer(capsys, "compare", *RECORD, "--out", tmp_path / "compared.csv")
    assert {CODE, PREDICTION} <= {row["method"] for row in lines(tmp_path / "compared.csv")}


def test_figures() -> None:
    motion = named_motion("NCC").scaled_to_pgv(500.0)
    methods = Methods()
    case = compare(motion, methods, codes=True)
    found = marks(plot_comparison([case]))
    assert found[COLOURS[CODE]] == {"8"}
    assert "d" in found[COLOURS[PREDICTION]]
    from dcfp.inference.forecast import forecast

    assert found[COLOURS[PREDICTION]] <= marks(plot_forecasts([forecast(motion, methods)]))[COLOURS[PREDICTION]]  # fmt: skip


@pytest.mark.slow
def test_report_and_workbook(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    from openpyxl import load_workbook

    file = tmp_path / "toy.toml"
    file.write_text('title = "Toy"\n[factors]\nrecord = ["NCC"]\npgv = { values = [0.5], unit = "m/s" }\n')
    # the page: a PDF says the same, and takes three times as long to make and to read
    answer(capsys, "report", file, "--out", tmp_path / "toy.html")
    printed = re.sub(r"<[^>]*>", " ", (tmp_path / "toy.html").read_text(encoding="utf-8"))
    printed = " ".join(unescape(printed).split())
    assert CODE in printed
    assert PREDICTION in printed
    assert "Toy displacement of the code" in printed
    assert "Toy displacement of the prediction" in printed
    answer(capsys, "export", file, "--out", tmp_path / "toy.xlsx")
    cells = {
        str(cell.value)
        for sheet in load_workbook(tmp_path / "toy.xlsx").worksheets
        for row in sheet.iter_rows()
        for cell in row
    }
    assert {CODE, PREDICTION} <= cells
    assert "period of the toy" in cells


def test_studies(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    file = tmp_path / "study.toml"
    file.write_text(
        'title = "Toy"\n[factors]\nrecord = ["NCC"]\npgv = { values = [0.5], unit = "m/s" }\nprocedure = ["toy-code", "toy-prediction"]\n'
    )
    answer(capsys, "study", "run", file, "--out", tmp_path / "toy.zarr")
    answer(capsys, "study", "export", tmp_path / "toy.zarr", "--out", tmp_path / "toy.csv")
    rows = {row["procedure"]: float(row["peak_displacement [mm]"]) for row in lines(tmp_path / "toy.csv")}
    assert rows["toy-prediction"] == pytest.approx(100.0)
    assert rows["toy-code"] > 0.0


def test_python_and_notebook() -> None:
    case = compare(named_motion("NCC").scaled_to_pgv(500.0), codes=True)
    toys = {variant for variant in variants() if variant.method in COLOURS}
    assert toys <= case.predicted.keys()
    assert CODE in case.codes[CODE]._repr_html_()
    assert "period of the toy" in case.codes[CODE]._repr_html_()


def test_the_page() -> None:
    pytest.importorskip("nicegui", reason="the web page needs nicegui")
    from dcfp.doors.app.elements import Units
    from dcfp.doors.app.response_tab import bars, predictions_of

    case = compare(named_motion("NCC").scaled_to_pgv(500.0), codes=True)
    rows = {row[0]: row for row in predictions_of(case).cells()}
    assert rows[CODE][-1] == "within its limits"
    assert rows[PREDICTION][4] == "100.0"
    assert {CODE, f"{PREDICTION}, blind"} <= set(bars(case, Units())["yAxis"]["data"])


def test_the_documentation(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("sphinx", reason="the documentation needs Sphinx")
    monkeypatch.syspath_prepend(TOYS.parents[2] / "docs" / "_extensions")
    table = import_module("declared").method_table()
    assert f"| {CODE} | `toy-code` | spectrum | Li" in table
    assert f"| {PREDICTION} | `toy-prediction` | record | Li" in table
