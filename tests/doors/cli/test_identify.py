"""`dcfp identify` from end to end."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from dcfp.analysis.rig import Program, RigTest, Sine, VerticalLoad, run_program
from dcfp.system import FittedFriction, read_bearing

TESTS = {"slow": (20.0, 60.0), "middle": (80.0, 60.0), "fast": (300.0, 60.0), "light": (20.0, 35.0)}


@pytest.fixture(scope="module")
def tests(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Measured tests as files: two cycles each, with 1 % of noise on the force."""
    folder = tmp_path_factory.mktemp("measured")
    random = np.random.default_rng(1)
    program = Program(
        "tests",
        tuple(RigTest(name, Sine(200.0, v, 2), VerticalLoad((p,))) for name, (v, p) in TESTS.items()),
    )
    files = {}
    for loops in run_program(program, friction=FittedFriction()):
        noise = 0.01 * np.abs(loops.force).max() * random.standard_normal(loops.time.size)
        columns = (loops.time, loops.displacement, (loops.force + noise) / 1e3, loops.load / 1e3)
        path = folder / f"{loops.test.name}.csv"
        head = "time [s],displacement [mm],force [kN],load [kN]"
        np.savetxt(path, np.column_stack(columns), "%.9g", ",", header=head, comments="")
        files[loops.test.name] = path
    return files


def document(outcome) -> dict:
    assert (outcome.status, outcome.err) == (0, "")
    return json.loads(outcome.out)


@pytest.mark.slow
def test_the_tables_say_what_was_found_and_what_was_not(run, tests) -> None:
    status, out, err = run("identify", *tests.values())
    assert (status, err) == (0, "")
    assert all(
        name in out for name in (*TESTS, "mu_0", "speed_rate", "95 %", "Correlation", "s/mm", "1/degC")
    )
    assert "not asked for" in out
    assert max(len(line) for line in out.splitlines()) <= 100


def test_json_holds_all_of_it(run, tests) -> None:
    found = document(run("identify", *tests.values(), "--json"))
    assert set(found) == {
        "estimates", "held", "confidence", "blocks", "correlation", "residuals", "predictions", "bearing", "friction", "heating", "remarks",
    }  # fmt: skip
    truth = FittedFriction()
    for one in found["estimates"]:
        assert one["lower"] < one["value"] < one["upper"]
        assert abs(one["value"] - getattr(truth, one["name"])) < 4.0 * one["standard_error"]
        assert found["correlation"][one["name"]][one["name"]] == pytest.approx(1.0)
        assert found["friction"][one["name"]] == one["value"]
    assert [row["name"] for row in found["residuals"]] == list(TESTS)


def test_held_out_tests_may_stand_anywhere(run, tests) -> None:
    files = [tests[name] for name in ("slow", "middle", "light")]
    before = document(
        run("identify", "--hold-out", tests["fast"], "--json", *files[:0], "--fit", "mu_0", "--", *files)
    )
    found = document(run("identify", *files, "--hold-out", tests["fast"], "--json"))
    assert [row["test"] for row in found["predictions"]] == ["fast", "fast"]
    assert [row["test"] for row in before["predictions"]] == ["fast", "fast"]
    for row in found["predictions"]:
        assert row["energy_kN_m_ratio"] == pytest.approx(1.0, abs=0.03)
    _, out, _ = run("identify", *files, "--hold-out", tests["fast"])
    assert "Held out" in out
    assert "ratio" in out


def test_the_bearing_file_is_one_for_other_commands(run, tests, tmp_path: Path) -> None:
    file = tmp_path / "found.toml"
    found = document(run("identify", *tests.values(), "--slider", "400", "--out", file, "--json"))
    law = read_bearing(file).friction
    assert isinstance(law, FittedFriction)
    assert law.mu_0 == found["friction"]["mu_0"]
    assert "SHA-256" in file.read_text(encoding="utf-8")
    response = json.loads(run("respond", "NCC", "--pgv", "0.5", "--bearing", file, "--json").out)
    plain = json.loads(run("respond", "NCC", "--pgv", "0.5", "--json").out)
    assert response[0]["friction"] == "fitted"
    assert response[0]["y_max_mm"] == pytest.approx(plain[0]["y_max_mm"], rel=0.03)
    assert run("test", "dependency", "--tests", "T01", "--bearing", file).status == 0
    # and it is where the next identification starts from
    again = document(run("identify", tests["slow"], "--bearing", file, "--fit", "mu_0", "--json"))
    assert again["friction"]["speed_rate"] == law.speed_rate


@pytest.mark.slow
def test_csv_json_and_figure_are_written(run, tests, tmp_path: Path) -> None:
    table, text, figure = (tmp_path / name for name in ("e.csv", "e.json", "e.png"))
    assert run("identify", *tests.values(), "--out", table, "--plot", figure).status == 0
    rows = list(csv.DictReader(table.read_text(encoding="utf-8").splitlines()))
    assert [row["name"] for row in rows][:2] == ["mu_0", "pressure_exponent"]
    assert float(rows[0]["lower"]) < float(rows[0]["value"]) < float(rows[0]["upper"])
    assert rows[-1]["held"] == "not asked for"
    assert figure.read_bytes().startswith(b"\x89PNG")
    shown = run("identify", tests["slow"], tests["fast"], "--out", text, "--json")
    assert json.loads(text.read_text(encoding="utf-8")) == document(shown)


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ((), "name at least one FILE"),
        (("{slow}", "--fit", "pressure_exponent"), "cannot determine pressure_exponent"),
        (("{slow}", "--fit", "mu0"), "did you mean 'mu_0'"),
        (("{slow}", "--fix", "mu_0"), "write NAME=VALUE"),
        (("{slow}", "--fix", "mu_0=x"), "write NAME=VALUE"),
        (("{slow}", "--fix", "mu_0=0.07", "mu_0=0.08"), "mu_0 is given twice"),
        (("{slow}", "--fix", "speed=3"), "no parameter 'speed'"),
        (("{slow}", "--mu", "0.07"), "--fix mu_0=0.07"),
        (("{slow}", "--friction", "kumar2015"), "leave the option out"),
        (("{slow}", "--pressure", "60"), "--pressure 60 has no effect"),
        (("{slow}", "--hold-out", "{slow}"), "Two tests have the name"),
        (("{slow}", "--out", "result.nc"), "can be written as .toml, .json, .csv"),
        (("{slow}", "--out", "{slow}", "--overwrite"), "this file is an input"),
        (("{slow}", "--hold-out", "{fast}", "--out", "{fast}", "--overwrite"), "this file is an input"),
        (("nowhere.csv",), "there is no such file"),
    ],
)  # fmt: skip
def test_bad_input_gets_one_sentence_and_status_2(run, tests, words, sentence) -> None:
    before = {name: path.read_bytes() for name, path in tests.items()}
    status, out, err = run("identify", *(word.format(**tests) for word in words))
    assert (status, out) == (2, "")
    assert sentence in err
    assert len(err.strip().splitlines()) == 1
    assert {name: path.read_bytes() for name, path in tests.items()} == before


def test_a_refusal_leaves_no_files(run, tests, tmp_path: Path) -> None:
    words = ("--fit", "pressure_exponent", "--out", tmp_path / "b.toml", "--plot", tmp_path / "b.png")
    assert run("identify", tests["slow"], *words).status == 2
    assert list(tmp_path.iterdir()) == []


def test_a_file_without_load_is_refused(run, tests, tmp_path: Path) -> None:
    lines = tests["slow"].read_text().splitlines()
    path = tmp_path / "short.csv"
    path.write_text("\n".join(line.rpartition(",")[0] for line in lines))
    status, _, err = run("identify", path)
    assert status == 2
    assert "'load [kN]'" in err


def test_the_conductivity_is_written_where_the_heating_is(run, tests) -> None:
    words = ("--fit", "mu_0", "conductivity", "speed_drop", "speed_rate")
    found = document(run("identify", *tests.values(), *words, "--fix", "temperature_rate=0.007", "--json"))
    one = next(one for one in found["estimates"] if one["name"] == "conductivity")
    assert abs(one["value"] - 16.0) < 4.0 * one["standard_error"]
    assert found["heating"]["conductivity"] == one["value"]


def test_a_file_with_another_law_is_refused(run, tests, tmp_path: Path) -> None:
    path = tmp_path / "other.toml"
    path.write_text('[friction]\nlaw = "kumar2015"\n')
    status, out, err = run("identify", tests["slow"], "--bearing", path)
    assert (status, out) == (2, "")
    assert "and not 'kumar2015'; leave [friction] out" in err


def test_plates_of_finite_thickness_are_no_trouble(run, tests) -> None:
    found = document(run("identify", *tests.values(), "--thickness", "30", "--json"))
    assert found["heating"]["thickness"] == 30.0
