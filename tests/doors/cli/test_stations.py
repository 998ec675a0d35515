"""Stations at the command line: measures, spectra, and what every command of one direction says of them."""

import csv
import json

import numpy as np
import pytest
import xarray

from dcfp import load_station
from dcfp.methods.spectra import station_spectrum


def plain(folder, *names: str) -> str:
    """Write files of one column, and return them as a station."""
    for seed, name in enumerate(names):
        np.savetxt(folder / name, np.random.default_rng(seed).normal(0.0, 0.1, 200))
    return "+".join(str(folder / name) for name in names)


PLAIN = ("--units", "g", "--time-step", "0.01")


def test_the_measures_of_a_station(run, tmp_path) -> None:
    status, out, err = run("records", "P695-FF-2")
    assert (status, err) == (0, "")
    assert "dir. PGV" in out
    assert "x points to 0 and y to 270 degrees from north" in " ".join(out.split())
    (row,) = json.loads(run("records", "P695-FF-2", "--json").out)
    station = load_station("P695-FF-2")
    assert station is not None
    assert row["pgv_m_s"] == pytest.approx(station.peak_velocity / 1e3)
    assert -90.0 <= row["principal_axis_deg"] <= 90.0
    data = tmp_path / "station.nc"
    assert run("records", "P695-FF-2", "--out", data).status == 0
    with xarray.open_dataset(data) as found:
        np.testing.assert_array_equal(found["ground_velocity_y"], station.y.velocity)
        assert found.attrs["principal_ratio"] == row["principal_ratio"]
    table = tmp_path / "stations.csv"
    assert run("records", "P695-FF-2", "P695-NF-9", "--out", table).status == 0
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert [one["record"] for one in rows] == ["P695-FF-2", "P695-NF-9"]


def test_files_joined_with_what_they_need(run, tmp_path) -> None:
    three = plain(tmp_path, "east.txt", "north.txt", "up.txt")
    (row,) = json.loads(run("records", three, *PLAIN, "--json").out)
    assert row["record"] == "east+north+up"
    assert row["pga_vertical_m_s2"] > 0.0


def test_the_spectra_of_a_station(run) -> None:
    words = ("spectrum", "P695-FF-2", "--pgv", "0.5", "--periods", "0.5", "2", "--damping", "0.1")
    told = json.loads(run(*words, "--json").out)
    station = load_station("P695-FF-2")
    assert station is not None
    found = station_spectrum(station.scaled_to_pgv(500.0), np.array([0.5, 2.0]), 0.1)
    assert [row["S_d_rotd50_mm"] for row in told["spectra"]] == found.rotated(50.0).tolist()
    assert [row["S_d_rotd100_mm"] for row in told["spectra"]] == found.rotated(100.0).tolist()
    assert told["spectra"][0]["pgv_m_s"] == pytest.approx(0.5)
    status, out, err = run(*words)
    assert (status, err) == (0, "")
    assert "RotD100" in out
    assert "Boore 2010" in " ".join(out.split())


@pytest.mark.slow
def test_the_figures(run, tmp_path) -> None:
    for number, words in enumerate(
        (
            ("records", "P695-FF-2", "P695-NF-9"),
            ("spectrum", "P695-FF-2", "--periods", "0.1", "1", "3"),
            ("spectrum", "P695-FF-2", "P695-NF-9", "--periods", "0.1", "1", "3"),
        )
    ):
        figure = tmp_path / f"{number}.png"
        assert run(*words, "--plot", figure).status == 0
        assert figure.read_bytes().startswith(b"\x89PNG")
    status, _, err = run("records", *(f"P695-FF-{one}" for one in range(1, 6)), "--plot", tmp_path / "5.png")
    assert (status, err.count("\n")) == (2, 1)
    assert "at most 3 stations" in err


@pytest.mark.parametrize("command", ["codes", "building"])
def test_what_is_of_one_direction_names_the_components(run, tmp_path, command) -> None:
    pair = plain(tmp_path, "east.txt", "north.txt")
    status, out, err = run(command, pair, *PLAIN)
    assert (status, out, err.count("\n")) == (2, "", 1)
    east, north = pair.split("+")
    assert f"this takes one direction; choose {east} or {north}." in err


@pytest.mark.parametrize("command", ["respond", "predict", "compare", "codes", "building"])
def test_a_vertical_component_must_be_chosen(run, tmp_path, command) -> None:
    up = vertical(tmp_path / "up.AT2")
    status, out, err = run(command, up)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert f"choose it by its name, as in {up}::UP" in err
    for words in ((f"{up}::UP",), (up, "--component", "UP")):
        outcome = run("respond", *words, "--heating", "none")
        assert outcome.status == 0
        assert "the vertical component, taken as horizontal" in " ".join(outcome.out.split())


def vertical(path):
    values = "".join(f"{value:15.7E}\n" for value in 0.1 * np.sin(np.arange(100) * np.pi / 12.5))
    path.write_text(
        "PEER NGA STRONG MOTION DATABASE RECORD\nKobe, 1/16/1995, KJMA, UP\n"
        f"ACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   100, DT=   .0200 SEC\n{values}"
    )
    return path


def test_what_only_tells_takes_a_vertical_component(run, tmp_path) -> None:
    up = vertical(tmp_path / "up.AT2")
    for command in ("records", "spectrum"):
        outcome = run(command, up)
        assert (outcome.status, outcome.err) == (0, "")
        assert "taken as horizontal" not in outcome.out


@pytest.mark.parametrize("command", ["records", "spectrum", "respond"])
def test_stations_and_single_components_together(run, command) -> None:
    status, out, err = run(command, "P695-FF-2", "NCC")
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert "give only stations, or only single components" in err


def test_a_chart_of_stations_says_so(run, tmp_path, monkeypatch) -> None:
    monkeypatch.chdir(tmp_path)
    study = '[factors]\nrecord = ["P695-FF-8", "P695-FF-22"]\npgv = { values = [0.2], unit = "m/s" }\nradius = { values = [3, 4.5], unit = "m" }\nmu = [0.05, 0.1]\nheating = ["none"]\n'
    (tmp_path / "s.toml").write_text(study)
    assert run("study", "s.toml").status == 0
    told = json.loads(run("study", "chart", "s.zarr", "--allow", "200", "--json").out)
    assert sum(one.startswith("The records are stations: displacement") for one in told["remarks"]) == 1
    assert "The records are stations" in run("study", "chart", "s.zarr", "--allow", "200").out


def test_a_component_of_one_file_and_another_file(run, three_components, tmp_path) -> None:
    other = tmp_path / "a+b.AT2"
    other.write_text(
        "PEER NGA STRONG MOTION DATABASE RECORD\nMade, 1/1/2000, Test, 0\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=3, DT= 0.01 SEC,\n 0.0 0.1 0.0\n"
    )
    event = f"{three_components}::NS+{other}"
    status, out, err = run("records", event, "--json")
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert "three NS and a+b are of different earthquakes" in err
