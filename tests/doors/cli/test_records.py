"""`dcfp records`: the named ones, and what is in a file."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
import xarray

from dcfp import load_motion


def test_the_paper_s_records_come_first(run) -> None:
    status, out, err = run("records")
    assert (status, err) == (0, "")
    lines = out.splitlines()
    assert [line.split()[0] for line in lines[2:10]] == [
        "KNA",
        "NCC",
        "LPG",
        "IVD",
        "JKB",
        "TC1",
        "TSD",
        "TIM",
    ]
    assert max(len(line) for line in lines) <= 100
    assert "P695-NF-28-b" in out
    assert "supply" in out


def test_every_named_record_is_there_once(run) -> None:
    rows = json.loads(run("records", "--json").out)
    assert len([row for row in rows if row["available"]]) == 100
    assert len({row["name"] for row in rows}) == len(rows)


def test_one_record_with_its_measures(run) -> None:
    row = json.loads(run("records", "NCC", "--json").out)[0]
    assert row["record"] == "NCC"
    assert 0.44 < row["pgv_m_s"] < 0.46
    assert "filtered" in row["processing"]
    _, out, _ = run("records", "NCC")
    assert "Northridge" in out
    assert "In the data" in out


def test_a_file_with_a_drift_is_warned_of(run, drifting: Path) -> None:
    status, out, _ = run("records", drifting, "--units", "m/s2")
    assert status == 0
    assert "untreated baseline" in " ".join(out.split())
    row = json.loads(run("records", drifting, "--units", "m/s2", "--json").out)[0]
    assert row["baseline_drift"] > 0.5


def test_the_drift_is_taken_out_where_that_is_wanted(run, drifting: Path) -> None:
    words = ("records", drifting, "--units", "m/s2")
    assert "filter it (--high-pass) or remove its baseline (--baseline)" in " ".join(run(*words).out.split())
    for option in (("--baseline",), ("--high-pass", "0.1")):
        (row,) = json.loads(run(*words, *option, "--json").out)
        assert row["baseline_drift"] < 0.25
        assert "removed" in row["remarks"][0]


def test_the_sets_of_stations_are_told(run) -> None:
    for words in ((), ("P695-NF",)):
        out = " ".join(run("records", *words).out.split())
        assert "P695-FF-1 to P695-FF-22 and P695-NF-1 to P695-NF-28" in out
        assert "P695-stations, P695-FF-stations, P695-NF-stations" in out


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("P695-FF-99", "those of P695-FF have the numbers 1 to 22."),
        ("P695-NF-29-a", "those of P695-NF have the numbers 1 to 28."),
        ("P695-FF-2-c", "the components of this station are P695-FF-2-a and P695-FF-2-b."),
        ("P695-FF-station", "did you mean P695-FF-stations"),
        ("FF-2", "did you mean P695-FF-2 or"),
    ],
)
def test_what_is_meant_by_a_name_that_is_none(run, name: str, sentence: str) -> None:
    status, out, err = run("records", name)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert f"'{name}'" in err
    assert sentence in err


def test_every_component_of_a_file_or_one(run, three_components: Path) -> None:
    rows = json.loads(run("records", three_components, "--json").out)
    assert [row["component"] for row in rows] == ["NS", "EW", "UD"]
    one = json.loads(run("records", three_components, "--component", "EW", "--json").out)
    assert one == rows[1:2]
    assert json.loads(run("records", f"{three_components}::EW", "--json").out) == one
    _, out, _ = run("records", three_components)
    assert "offset not removed" in out


def test_nothing_of_that_name(run) -> None:
    status, out, err = run("records", "NCX")
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert "NCC" in err


def test_the_list_as_a_table(run, tmp_path: Path) -> None:
    out = tmp_path / "list.csv"
    assert run("records", "--out", out).status == 0
    rows = list(csv.DictReader(out.read_text().splitlines()))
    assert rows[0]["alias"] == "KNA"
    assert sum(row["available"] == "true" for row in rows) == 100


def test_one_record_as_histories(run, tmp_path: Path) -> None:
    table, data = tmp_path / "r.csv", tmp_path / "r.nc"
    assert [run("records", "NCC", "--out", out).status for out in (table, data)] == [0, 0]
    motion = load_motion("NCC")
    head = table.read_text().splitlines()[0]
    assert head.endswith("ground_velocity [mm s-1],ground_displacement [mm]")
    values = np.loadtxt(table, delimiter=",", skiprows=1)
    np.testing.assert_allclose(values[:, 3], motion.displacement, rtol=1e-8)
    with xarray.open_dataset(data) as found:
        assert found.ground_acceleration.attrs["units"] == "mm s-2"
        assert found.attrs["record_sha256"] == motion.digest
        np.testing.assert_array_equal(found.ground_velocity, motion.velocity)


@pytest.mark.slow
def test_several_records_as_measures_and_groups(run, three_components: Path, tmp_path: Path) -> None:
    table, data, plot = (tmp_path / f"r.{kind}" for kind in ("csv", "nc", "png"))
    assert run("records", three_components, "NCC", "--out", table, "--plot", plot).status == 0
    assert run("records", three_components, "NCC", "--out", data).status == 0
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert [row["component"] for row in rows][:3] == ["NS", "EW", "UD"]
    with xarray.open_datatree(data) as tree:
        assert len(tree.children) == 4
        assert tree.pgv.attrs["units"] == "m s-1"
    assert plot.stat().st_size > 5000


@pytest.mark.parametrize(
    "words",
    [
        ("--plot", "a.png"),
        ("--out", "a.nc"),
        ("--high-pass", "0.05"),
        ("NCC", "--out", "a.txt"),
        ("NCC", "--plot", "a.gif"),
        ("NCC", "--out", "there.csv"),
        ("NCC", "--plot", "no/a.png"),
    ],
)
def test_what_cannot_be_written_is_refused(run, monkeypatch, tmp_path: Path, words: tuple[str, ...]) -> None:
    monkeypatch.chdir(tmp_path)
    Path("there.csv").write_text("mine")
    status, out, err = run("records", *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert [path.name for path in tmp_path.iterdir()] == ["there.csv"]
    assert Path("there.csv").read_text() == "mine"
