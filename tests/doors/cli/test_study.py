"""`dcfp study` from end to end: a file, a plan, a store, what is in it, and out of it."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest
import xarray

import dcfp
from dcfp.study.results import open_store

TEXT = """
title = "A few"
[factors]
record = ["NCC", "KNA"]
pgv = { values = [0.25, 0.5, 1.0], unit = "m/s" }
mu = [0.05, 0.075]
"""


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "few.toml").write_text(TEXT, encoding="utf-8")
    return tmp_path


@pytest.mark.slow
def test_a_study_file_alone_runs_it_into_a_store_beside(run, here: Path) -> None:
    outcome = run("study", "few.toml")
    assert (outcome.status, outcome.err) == (0, "")
    assert "12 = 2 record × 3 pgv × 2 mu" in outcome.out
    dataset = open_store(here / "few.zarr")
    alone = dcfp.respond(dcfp.load_motion("NCC").scaled_to_pgv(500.0))
    found = dataset.sel(record="NCC", pgv=500.0, mu=0.075)
    assert found["peak_displacement"].item() == alone.peak_displacement


@pytest.mark.slow
def test_json_says_what_the_store_holds(run, here: Path) -> None:
    document = json.loads(run("study", "run", "few.toml", "--out", "s.zarr", "--threads", "1", "--json").out)
    assert document["dimensions"] == {"record": 2, "pgv": 3, "mu": 2}
    assert document["analyses"] == {
        "not_run": 0,
        "ok": 12,
        "beyond_capacity": 0,
        "still_moving": 0,
        "failed": 0,
    }
    shown = json.loads(run("study", "show", "s.zarr", "--json").out)
    assert shown == {name: value for name, value in document.items() if name not in ("store", "elapsed_s")}
    values = open_store(here / "s.zarr")["peak_displacement"].sel(pgv=500.0).values
    assert shown["by_intensity"][1]["peak_displacement"]["median"] == pytest.approx(np.median(values))


def test_resume_and_overwrite(run, here: Path) -> None:
    assert run("study", "few.toml").status == 0
    outcome = run("study", "few.toml")
    assert outcome.status == 2
    assert "the store exists, 100 % of it done; go on with it (--resume)" in outcome.err
    assert run("study", "few.toml", "--resume").status == 0
    assert run("study", "few.toml", "--overwrite").status == 0


def test_a_new_file_is_a_study(run, here: Path) -> None:
    assert run("study", "new", "mine.toml").status == 0
    document = json.loads(run("study", "plan", "mine.toml", "--json").out)
    assert document["analyses"] == 4 * 15 * 2 * 3
    assert run("study", "new", "mine.toml").status == 2
    table = run("study", "plan", "mine.toml", "--threads", "1").out
    assert "360 = 4 record × 15 pgv × 2 radius × 3 mu" in table


@pytest.mark.slow
def test_histories_of_one_case_are_those_of_the_analysis(run, here: Path) -> None:
    outcome = run("study", "histories", "few.toml", "--at", "record=NCC", "pgv=0.5", "mu=0.075", "--json")
    (row,) = json.loads(outcome.out)
    (alone,) = json.loads(run("respond", "NCC", "--pgv", "0.5", "--json").out)
    assert {**row, "elapsed_s": 0} == {**alone, "elapsed_s": 0}
    assert (
        run(
            "study",
            "histories",
            "few.toml",
            "--at",
            "record=NCC",
            "pgv=0.5",
            "mu=0.05",
            "--out",
            "h.nc",
            "--plot",
            "h.png",
        ).status
        == 0
    )
    assert xarray.open_dataset(here / "h.nc")["displacement"].size > 1000


def test_histories_need_one_case(run, here: Path) -> None:
    outcome = run("study", "histories", "few.toml", "--at", "record=NCC")
    assert outcome.status == 2
    assert "--at pgv=... mu=..." in outcome.err


@pytest.mark.slow
def test_export_holds_every_analysis(run, here: Path) -> None:
    run("study", "few.toml")
    assert run("study", "export", "few.zarr", "--out", "few.nc").status == 0
    assert run("study", "export", "few.zarr", "--out", "few.csv").status == 0
    with xarray.open_dataset(here / "few.nc") as whole:
        store = open_store(here / "few.zarr")
        for name in store.data_vars:
            assert np.array_equal(whole[name].values, store[name].values)
        assert whole.attrs == store.attrs
        assert whole["record"].values.tolist() == ["NCC", "KNA"]
    rows = list(csv.DictReader((here / "few.csv").read_text(encoding="utf-8").splitlines()))
    assert len(rows) == 12
    assert rows[3]["record"] == "NCC"
    assert float(rows[3]["pgv [mm s-1]"]) == 500.0
    assert float(rows[3]["mu [-]"]) == 0.075
    alone = dcfp.respond(dcfp.load_motion("NCC").scaled_to_pgv(500.0))
    assert float(rows[3]["peak_displacement [mm]"]) == pytest.approx(alone.peak_displacement, rel=1e-8)
    assert rows[3]["status"] == "ok"
    shown, exported = (run("study", "show", name, "--json").out for name in ("few.zarr", "few.nc"))
    assert shown == exported


def test_what_gives_no_result_is_an_exit_status_of_one(run, here: Path, zeros: Path) -> None:
    """A spectrum of nothing says nothing."""
    text = (
        f'[motion]\nunits = "m/s2"\n[factors]\nrecord = ["{zeros.name}"]\nprocedure = ["analysis", "asce7"]\n'
    )
    (here / "fails.toml").write_text(text, encoding="utf-8")
    outcome = run("study", "fails.toml")
    assert "1 gave no result, and stand as not a number." in outcome.out
    assert outcome.status == 1


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("study none.toml", "none.toml: there is no such file; a study is a TOML file"),
        ("study run", "the following arguments are required: STUDY.toml"),
        ("study ruun few.toml", "there is no command 'ruun'; did you mean 'run'?"),
        ("study few.toml --resume --overwrite", "--resume goes on with a store and --overwrite replaces it"),
        ("study few.toml --threads 2 --processes 2", "--threads and --processes say where the analyses run in two ways"),
        ("study few.toml --threads none", "--threads: analyses at the same time must be a whole number from 1 to 1024, not 'none'"),
        ("study few.toml --out nowhere/s.zarr", "nowhere/s.zarr: the store cannot be written"),
        ("study few.toml --out few.toml", "few.toml: this is not the store of a study"),
        ("study show none.zarr", "none.zarr: there is no such store; dcfp study run STUDY.toml writes one"),
        ("study show few.toml", "few.toml: this is not the store of a study"),
        ("study export few.toml --out x.nc", "few.toml: this is not the store of a study"),
        ("study export few.toml --out x.doc", "x.doc: data can be written as .nc, .csv"),
        ("study new few.toml", "few.toml: the file exists"),
        ("study new few.txt", "few.txt: a study can be written as .toml"),
        ("study histories few.toml --at NCC", "--at: write FACTOR=VALUE"),
        ("study histories few.toml --at record=XYZ", "There is no record of XYZ in this study; there is NCC, KNA"),
        ("study histories few.toml --at radius=3", "'radius' is no factor of this study"),
    ],
)  # fmt: skip
def test_what_is_wrong_gets_one_sentence(run, here: Path, words: str, sentence: str) -> None:
    before = {path.name for path in here.iterdir()}
    outcome = run(*words.split())
    assert outcome.status == 2
    assert outcome.out == ""
    assert sentence in outcome.err
    assert outcome.err.count("\n") == 1
    assert {path.name for path in here.iterdir()} == before


def test_help(run) -> None:
    outcome = run("study")
    assert outcome.status == 0
    for command in (
        "new",
        "plan",
        "run",
        "show",
        "export",
        "ida",
        "fragility",
        "bounds",
        "sensitivity",
        "chart",
    ):
        assert command in outcome.out
        assert run("study", command, "--help").status == 0
