"""``dcfp test`` with paths in the plane, from end to end."""

import csv
import json
import math
from pathlib import Path

import numpy as np
import pytest
import xarray


@pytest.fixture
def own(tmp_path: Path) -> Path:
    """A program of a circle and a figure of eight, with a pause."""
    path = tmp_path / "own.toml"
    path.write_text(
        '[[test]]\nname = "A"\nwaveform = "circle"\namplitude = 100\nperiod = 2\ncycles = 2\nload = 7540\n'
        '[[test]]\nname = "B"\nwaveform = "eight"\namplitude = 100\npeak_velocity = 200\ncycles = 1\npause = 60\n'
    )
    return path


def test_the_program_of_the_plane(run) -> None:
    rows = json.loads(run("test", "plane", "--json").out)
    assert [(row["test"], row["lap"]) for row in rows] == [
        (name, lap) for name in ("sine", "circle", "eight", "cloverleaf") for lap in (1, 2, 3)
    ]
    assert {row["heating"] for row in rows} == {"precise"}
    assert max(row["energy_residual"] for row in rows) < 1e-7
    by_name = {(row["test"], row["lap"]): row for row in rows}
    circle, sine = by_name["circle", 3], by_name["sine", 3]
    # two directions heat one spot: less than pi / 2 times the work on pi / 2 times the path, at a hotter point
    assert circle["path_m"] == pytest.approx(math.pi / 2.0 * sine["path_m"], rel=1e-6)
    assert circle["energy_kN_m"] < 0.95 * math.pi / 2.0 * sine["energy_kN_m"]
    assert circle["temperature_point_max_degC"] > sine["temperature_point_max_degC"] + 40.0
    for row in rows:
        assert 1e3 * row["load_kN"] / row["pressure_N_mm2"] == pytest.approx(math.pi * 200.0**2, rel=1e-9)
        assert row["energy_kN_m"] == pytest.approx(
            row["friction_mean"] * row["load_kN"] * row["path_m"], rel=1e-9
        )
        assert (
            row["temperature_end_degC"]
            <= row["temperature_max_degC"]
            <= row["temperature_point_max_degC"] + 1e-9
        )


def test_a_program_of_ones_own_is_printed_with_three_models(run, own) -> None:
    outcome = run("test", own, "--compare", "--tests", "A")
    assert outcome.status == 0
    lines = [line.split() for line in outcome.out.splitlines() if line.startswith("A")]
    assert [line[1:3] for line in lines] == [
        [model, lap] for model in ("precise", "simplified", "none") for lap in ("1", "2")
    ]
    # 2 pi 100 mm 0.043 7540 kN
    assert float(lines[-1][8]) == pytest.approx(2.0 * math.pi * 0.1 * 0.043 * 7540.0, abs=0.06)


@pytest.mark.slow
def test_files_hold_histories_laps_and_the_plates(run, own, tmp_path) -> None:
    data, table, both = tmp_path / "a.nc", tmp_path / "a.csv", tmp_path / "both.csv"
    assert run("test", own, "--tests", "A", "--out", data).status == 0
    with xarray.open_dataset(data) as found:
        assert found["force_x"].attrs["units"] == "N"
        radius = np.hypot(found["displacement_x"], found["displacement_y"])
        assert np.allclose(radius, 100.0)
        assert found["plate_temperature"].dims == ("profile_time", "plate", "plate_y", "plate_x")
        end = found["plate_temperature"].isel(profile_time=0, plate=0)
        assert float(end.max()) > float(found["temperature"][-1]) > 25.0
        assert json.loads(found.attrs["laps_measured"])[1]["lap"] == 2
    assert run("test", own, "--out", both).status == 0
    rows = list(csv.DictReader(both.read_text().splitlines()))
    assert [row["test"] for row in rows] == ["A", "A", "B"]
    # the file of a test is a path that can be gone along again
    assert run("test", own, "--tests", "A", "--out", table).status == 0
    once, again = (json.loads(run("test", what, "--json").out) for what in (own, table))
    assert [row["energy_kN_m"] for row in again] == pytest.approx(
        [row["energy_kN_m"] for row in once[:2]], rel=1e-4
    )
    assert {row["waveform"] for row in again} == {"recorded path"}
    # it is no displacement in one direction, though it has one
    assert "displacement" in table.read_text().splitlines()[0]


@pytest.mark.slow
@pytest.mark.parametrize(
    "words", [(), ("--tests", "eight"), ("--tests", "circle", "--compare"), ("--heating", "simplified")]
)
def test_every_program_has_a_figure(run, tmp_path, words) -> None:
    assert run("test", "plane", *words, "--plot", tmp_path / "a.png").status == 0
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("plane", "--checks"), "--checks is for tests in one direction"),
        (("plane", "--measured", "circle=loop.csv"), "--measured is for tests in one direction"),
        (("plane", "--tests", "spiral"), "no test 'spiral'"),
        (("plane", "--pressure", "40"), "--pressure has no effect"),
        (("plane", "--displacement", "300"), "--displacement is for asce7-16"),
        (("plain",), "did you mean 'plane'"),
        (("far.toml",), "goes beyond the plate, whose capacity is 440 mm"),
        (("one.csv",), "a column 'x' and none 'y [mm]'"),
    ],
)
def test_what_cannot_be_tested_gets_a_sentence(run, tmp_path, monkeypatch, words, said: str) -> None:
    monkeypatch.chdir(tmp_path)
    far = '[[test]]\nwaveform = "circle"\namplitude = 600\npeak_velocity = 100\ncycles = 1\n'
    Path("far.toml").write_text(far)
    Path("one.csv").write_text("time [s],x [mm]\n" + "\n".join(f"{i},{i}" for i in range(30)))
    outcome = run("test", *words, "--out", "a.csv")
    assert outcome.status == 2
    assert said in " ".join(outcome.err.split())
    assert len(outcome.err.strip().splitlines()) <= 4
    assert not Path("a.csv").exists()
