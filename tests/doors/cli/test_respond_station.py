"""`dcfp respond` of stations, from end to end."""

import json
import math

import openpyxl
import pytest
import xarray

from dcfp import load_station, respond


def test_the_keys_and_all_digits(run) -> None:
    outcome = run("respond", "P695-FF-2", "--pgv", "0.25", "0.5", "--json")
    found = json.loads(outcome.out)
    station = load_station("P695-FF-2")
    assert station is not None
    response = respond(station.scaled_to_pgv(500.0))
    assert found[1]["heating"] == "precise"
    assert found[1]["y_max_mm"] == response.peak_displacement
    for key in ("y1_max_mm", "y2_max_mm", "dy_max_mm", "residual_mm", "temperature_point_max_degC", "load_min_kN", "load_max_kN", "V_E_mm_s"):  # fmt: skip
        assert isinstance(found[1][key], float), key
    assert found[1]["uplift"] is False
    assert found[1]["pgv_m_s"] == pytest.approx(0.5)


def test_a_table_a_figure_and_files(run, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    outcome = run(
        "respond", "P695-FF-2", "--pgv", "0.5", "--heating", "none", "--plot", "one.png", "--out", "one.nc"
    )
    assert (outcome.status, outcome.err) == (0, "")
    assert "T_point" in outcome.out
    data = xarray.open_dataset(tmp_path / "one.nc")
    assert {"displacement_x", "displacement_y", "displacement", "force_x", "temperature"} <= set(data)
    assert data["displacement_x"].attrs["units"] == "mm"
    assert data.attrs["y_max_mm"] == pytest.approx(float(abs(data["displacement"]).max()), rel=1e-3)
    assert (tmp_path / "one.png").stat().st_size > 10_000
    outcome = run("respond", "P695-FF-2", "P695-NF-9", "--pgv", "0.5", "--heating", "none", "--plot", "two.png", "--out", "two.csv")  # fmt: skip
    assert (outcome.status, outcome.err) == (0, "")
    head, *lines = (tmp_path / "two.csv").read_text().splitlines()
    assert "y1_max [mm]" in head
    assert len(lines) == 2


def test_a_script_for_opensees(run, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    outcome = run("respond", "P695-FF-2", "--pgv", "0.5", "--friction", "constant", "--heating", "none", "--out", "model.py")  # fmt: skip
    assert (outcome.status, outcome.err) == (0, "")
    script = (tmp_path / "model.py").read_text()
    compile(script, "model.py", "exec")
    assert "DCFP_PEAK_DISPLACEMENT_Y = " in script


def test_turned_by_an_option(run) -> None:
    words = ("respond", "P695-FF-2", "--pgv", "0.5", "--heating", "none", "--json")
    one, other = (json.loads(run(*words, *more).out)[0] for more in ((), ("--rotate", "90")))
    assert other["y_max_mm"] == pytest.approx(one["y_max_mm"], rel=1e-9)
    assert other["y1_max_mm"] == pytest.approx(one["y2_max_mm"], rel=1e-9)


def test_a_bearing_file_without_a_heating_model_has_that_of_stations(run, tmp_path) -> None:
    (tmp_path / "b.toml").write_text("radius = 3000\n[heating]\nambient = 5\n")
    words = ("respond", "P695-FF-8", "--bearing", str(tmp_path / "b.toml"), "--json")
    (found,) = json.loads(run(*words).out)
    station = load_station("P695-FF-8")
    assert station is not None
    assert found["heating"] == "precise"
    assert found["y_max_mm"] == respond(station, tmp_path / "b.toml").peak_displacement


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("P695-FF-2", "NCC"), "give only stations, or only single components"),
        (("NCC", "--rotate", "30"), "--rotate is for stations"),
        (("NCC", "--vertical"), "--vertical is for stations"),
        (("P695-FF-2", "--vertical"), "the station has no vertical component"),
        (("KNA+NCC",), "are of different earthquakes"),
        (("P695-FF-2", "--pgv", "0.25", "0.5", "--out", "script.py"), "a script is of one record at one PGV"),
        (("P695-FF-2", "--friction", "lomiento2013", "--out", "script.py"), "OpenSees has no element"),
    ],
)
def test_what_does_not_go_together(run, words, sentence: str) -> None:
    outcome = run("respond", *words)
    assert outcome.status == 2
    assert sentence in outcome.err
    assert len(outcome.err.strip().splitlines()) == 1


@pytest.mark.parametrize("command", ["building"])
def test_what_is_of_one_direction_says_so(run, command: str) -> None:
    outcome = run(command, "P695-FF-2")
    assert outcome.status == 2
    assert "this takes one direction; choose P695-FF-2-a or P695-FF-2-b" in outcome.err


def test_a_workbook_of_both_directions(run, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    words = ("respond", "P695-FF-2", "--pgv", "0.25", "--heating", "none", "--out", "pair.xlsx", "--json")
    outcome = run(*words)
    (told,) = json.loads(outcome.out)
    book = openpyxl.load_workbook(tmp_path / "pair.xlsx")
    assert book.sheetnames == ["Summary", "Inputs", "Checks", "P695-FF-2_0.25", "Provenance"]
    rows = [[cell for cell in row if cell is not None] for row in book["Summary"].iter_rows(values_only=True)]
    head = next(place for place, row in enumerate(rows) if row[:1] == ["Case"])
    summary = dict(zip(rows[head], rows[head + 1], strict=True))
    for key, name in (("y_max_mm", "y_max [mm]"), ("y1_max_mm", "y1_max [mm]"), ("load_min_kN", "load_min [kN]")):  # fmt: skip
        assert summary[name] == pytest.approx(told[key], rel=1e-14)
    assert any(row and str(row[0]).startswith("Predictions and the methods of codes") for row in rows)
    sheet = book["P695-FF-2_0.25"]
    lines = list(sheet.iter_rows(min_row=3, values_only=True))
    values = dict(zip(lines[0], zip(*lines[1:], strict=True), strict=True))
    x, y, resultant = (values[f"displacement of the isolation layer{one} [mm]"] for one in (" in direction x", " in direction y", ", resultant"))  # fmt: skip
    assert [math.hypot(*one) for one in zip(x, y, strict=True)] == pytest.approx(resultant)
    assert max(map(abs, x)) == pytest.approx(told["y1_max_mm"], rel=1e-3)
    assert len(sheet._charts) == 4
    path = sheet._charts[0]
    assert path.x_axis.scaling.max == path.y_axis.scaling.max >= told["y_max_mm"]


def test_one_that_fails_takes_no_other_with_it(run, tmp_path, monkeypatch) -> None:
    monkeypatch.setattr("dcfp.system.fields.MOST_POINTS", 120_000)
    words = (
        "respond",
        "P695-FF-8",
        "P695-FF-22",
        "--pgv",
        "0.1",
        "6",
        "--out",
        tmp_path / "peaks.csv",
        "--json",
    )
    status, out, err = run(*words)
    assert status == 1
    first, second = err.splitlines()
    assert first.startswith("dcfp: P695-FF-8, PGV 6 m/s: the slider of 400 mm goes further than")
    assert second.startswith("dcfp: P695-FF-22, PGV 6 m/s: ")
    alone = json.loads(run("respond", "P695-FF-8", "--pgv", "0.1", "--json").out)
    found = json.loads(out)
    assert [(one["record"], one["pgv_m_s"]) for one in found] == [
        ("P695-FF-8", pytest.approx(0.1)),
        ("P695-FF-22", pytest.approx(0.1)),
    ]
    assert found[0]["y_max_mm"] == alone[0]["y_max_mm"]
    _, *lines = (tmp_path / "peaks.csv").read_text().splitlines()
    assert len(lines) == 2
    # what is left of several is a table as well
    assert run("respond", "P695-FF-8", "--pgv", "0.1", "6", "--out", tmp_path / "left.csv").status == 1
    head, *lines = (tmp_path / "left.csv").read_text().splitlines()
    assert "y1_max [mm]" in head
    assert len(lines) == 1
