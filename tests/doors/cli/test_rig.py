"""``dcfp test`` from end to end."""

import json
import math
import re
from pathlib import Path

import numpy as np
import pytest
import xarray

from dcfp.analysis.rig import read_measurement


@pytest.fixture
def loop(tmp_path: Path) -> Path:
    """A measured test: a sine of 100 mm under 7540 kN with Coulomb friction of 0.05."""
    time = np.arange(0.0, 4.0 * math.pi, 0.02)
    rows = ["# from a machine", "time [s],displacement [mm],force [kN],load [kN]"]
    for t in time:
        force = 7540.0 * (100.0 * math.sin(t) / 9000.0 + 0.05 * math.copysign(1.0, math.cos(t)))
        rows.append(f"{t:.3f},{100.0 * math.sin(t):.4f},{force:.4f},7540")
    path = tmp_path / "loop.csv"
    path.write_text("\n".join(rows))
    return path


def test_the_dependency_test_prints_its_friction_beside_that_of_the_paper(run):
    outcome = run("test", "dependency", "--heating", "precise")
    assert outcome.status == 0
    said = " ".join(outcome.out.split())
    assert "second cycle 0.0390; the tests of Li et al. (2020) gave 0.043, from which it is -9 % away" in said
    assert len(re.findall(r"^T0\d", outcome.out, re.MULTILINE)) == 16


def test_json_has_one_object_for_each_cycle(run):
    outcome = run("test", "asce", "--json")
    rows = json.loads(outcome.out)
    assert len(rows) == 3 + 20 + 7 * 3 + 2 + 20 + 3
    assert rows[0]["test"] == "T01"
    for key in (
        "keff_kN_mm",
        "beta_eff",
        "post_yield_stiffness_kN_mm",
        "strength_kN",
        "energy_kN_m",
        "friction_at_zero",
        "temperature_max_degC",
    ):
        assert isinstance(rows[5][key], float), key
    assert isinstance(rows[0]["remarks"], list)


def test_models_side_by_side(run):
    outcome = run("test", "asce", "--compare", "--tests", "T02", "T06")
    assert outcome.status == 0
    assert [line.split()[:2] for line in outcome.out.splitlines() if line.startswith("T0")] == [
        ["T02", "1"], ["T02", "2"], ["T02", "3"], ["T02", "20"], ["T06", "1"], ["T06", "2"], ["T06", "3"],
    ]  # fmt: skip
    rows = json.loads(run("test", "asce", "--compare", "--tests", "T02", "--json").out)
    assert {row["heating"] for row in rows} == {"precise", "simplified", "none"}


def test_checks_say_what_is_unconfirmed(run):
    outcome = run("test", "asce7-16", "--displacement", "380", "--period", "4.26", "--checks")
    assert "NOT MET" in outcome.out
    assert "unconfirmed" in outcome.out
    assert "lambda_max" in outcome.out
    told = json.loads(run("test", "asce", "--checks", "--json").out)
    assert {factor["name"] for factor in told["factors"]} >= {"friction of the loop", "energy per cycle"}
    assert any(item["confirmed"] for item in told["criteria"])


def test_a_file_of_a_test_can_be_run_again(run, tmp_path):
    first = tmp_path / "first.csv"
    assert run("test", "dependency", "--tests", "T01", "--out", first).status == 0
    measured = read_measurement(first)
    assert measured.load[0] == pytest.approx(60.0 * math.pi * 200.0**2)
    again = json.loads(run("test", first, "--json").out)
    once = json.loads(run("test", "dependency", "--tests", "T01", "--json").out)
    assert [row["energy_kN_m"] for row in again] == pytest.approx(
        [row["energy_kN_m"] for row in once], rel=2e-3
    )


@pytest.mark.slow
def test_measured_loops_stand_beside_the_virtual_ones(run, loop, tmp_path):
    program = tmp_path / "own.toml"
    program.write_text(
        '[[test]]\nname = "A"\namplitude = 100\npeak_velocity = 100\ncycles = 2\nload = 7540\n'
    )
    outcome = run("test", program, "--measured", f"A={loop}", "--plot", tmp_path / "a.png")
    assert outcome.status == 0
    lines = [line for line in outcome.out.splitlines() if "measured" in line]
    assert len(lines) == 2
    energy = 4 * 0.05 * 7540 * 100 / 1e3
    assert float(lines[1].split()[9]) == pytest.approx(energy, rel=0.01)
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert run("test", program, "--compare", "--measured", loop, "--plot", tmp_path / "b.svg").status == 0


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [
        ("dependency",),
        ("dependency", "--compare"),
        ("asce", "--compare", "--tests", "T01", "T02"),
        ("asce", "--tests", "T06", "--heating", "precise"),
        ("asce", "--tests", "T02", "T03", "T04", "T05", "--heating", "none"),
        ("dependency", "--radius", "3000", "2500", "--friction", "kumar2015", "--heating", "precise"),
    ],
)
def test_every_program_has_a_figure(run, tmp_path, words):
    assert run("test", *words, "--plot", tmp_path / "a.png").status == 0
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


@pytest.mark.slow
def test_files_hold_histories_and_measures(run, tmp_path):
    assert (
        run("test", "asce", "--tests", "T06", "--heating", "precise", "--out", tmp_path / "one.nc").status
        == 0
    )
    with xarray.open_dataset(tmp_path / "one.nc", engine="h5netcdf") as data:
        assert data["plate_temperature"].dims == ("profile_time", "plate", "plate_position")
        assert data["force"].attrs["units"] == "N"
    assert run("test", "dependency", "--out", tmp_path / "all.nc").status == 0
    with xarray.open_datatree(tmp_path / "all.nc", engine="h5netcdf") as tree:
        assert tree["keff"].sizes == {"row": 16}
        assert set(tree.children) == {"T01", "T02", "T03", "T04"}
    assert run("test", "dependency", "--out", tmp_path / "all.csv").status == 0
    lines = (tmp_path / "all.csv").read_text().splitlines()
    assert len(lines) == 17
    assert "keff [kN mm-1]" in lines[0]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["dependancy"], "there is no such test program or file; did you mean 'dependency'"),
        ([], "required: PROGRAM"),
        (["dependency", "asce"], "unrecognized|not an option|one PROGRAM"),
        (["dependency", "--tests", "T09"], "has no test 'T09'; it has T01, T02, T03, T04"),
        (["asce7-16"], "needs --displacement and --period"),
        (["asce7-16", "--displacement", "400", "--period", "4.26"], "5 least load: a stroke of 460 mm goes beyond the plate"),
        (["dependency", "--displacement", "400"], "--displacement is for asce7-16 and en15129"),
        (["dependency", "--pressure", "40"], "--pressure has no effect"),
        (["dependency", "--checks"], "belongs to no code"),
        (["dependency", "--measured", "loop.csv"], "say which test it belongs to, such as T01=loop.csv"),
        (["dependency", "--measured", "T09=loop.csv"], "has no test 'T09'"),
        (["dependency", "--measured", "T01=none.csv"], "there is no such file"),
        (["asce", "--checks", "--tests", "T01"], "asks nothing of T01"),
        (["asce", "--checks", "--compare"], "leave out --compare"),
        (["dependency", "--measured", "T01=a.csv", "T01=b.csv"], "no such file|twice"),
        (["x" * 300], "cannot be the name"),
        (["en15129", "--displacement", "380", "--period", "4", "--total-displacement", "300"], "must not be below"),
        (["dependency", "--capacity", "100"], "beyond the plate"),
        (["dependency", "--tolerance", "2"], "above 0 and up to 0.9999"),
        (["dependency", "--thickness", "3"], "from 10 to 200"),
        (["dependency", "--out", "a.txt"], r"\.nc, \.csv"),
        (["dependency", "--slider", "30000"], "slider"),
    ],
)  # fmt: skip
def test_slips_get_one_sentence_and_write_nothing(run, tmp_path, monkeypatch, words, sentence):
    monkeypatch.chdir(tmp_path)
    outcome = run("test", *words, *([] if "--out" in words else ["--out", "result.csv"]))
    assert outcome.status == 2
    assert outcome.out == ""
    assert re.search(sentence, outcome.err), outcome.err
    assert outcome.err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


def flip(row: str) -> str:
    """Turn the sign of the force of a row."""
    cells = row.split(",")
    return ",".join([*cells[:2], str(-float(cells[2])), cells[3]])


def test_a_spreadsheet_with_semicolons_and_decimal_commas_is_read(run, loop):
    rows = loop.read_text().splitlines()
    plain = run("test", loop, "--json").out
    loop.write_text("\n".join(["sep=;", *(row.replace(",", ";").replace(".", ",") for row in rows[1:])]))
    assert (
        json.loads(run("test", loop, "--json").out)[0]["energy_kN_m"] == json.loads(plain)[0]["energy_kN_m"]
    )


def test_measured_cycles_are_in_the_json(run, loop, tmp_path):
    program = tmp_path / "own.toml"
    program.write_text(
        '[[test]]\nname = "A"\namplitude = 100\npeak_velocity = 100\ncycles = 2\nload = 7540\n'
    )
    rows = json.loads(run("test", program, "--measured", loop, "--json").out)
    assert [row["heating"] for row in rows] == ["simplified"] * 2 + ["measured"] * 2
    assert rows[2]["friction_at_zero"] == pytest.approx(0.05, rel=0.02)


def test_a_caution_stands_beside_the_checks(run, tmp_path):
    words = ["test", "asce", "--tests", "T07", "--friction", "lomiento2013"]
    assert "unconfirmed and its constants" in " ".join(run(*words, "--checks").out.split())
    assert any("unconfirmed" in told for told in json.loads(run(*words, "--checks", "--json").out)["remarks"])
    assert run(*words, "--out", tmp_path / "a.nc").status == 0
    with xarray.open_dataset(tmp_path / "a.nc", engine="h5netcdf") as data:
        assert "unconfirmed" in data.attrs["remarks"]


def test_an_input_is_never_written_over(run, loop):
    before = loop.read_bytes()
    assert run("test", loop, "--out", loop, "--overwrite").status == 2
    assert loop.read_bytes() == before


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (lambda rows: [*rows[:100], *rows[300:]], r"line 101: a gap of"),
        (lambda rows: [*rows[:100], rows[99], *rows[100:]], r"time goes from .* it must increase"),
        (lambda rows: [rows[0], rows[1].replace("[mm]", "[m]"), *rows[2:]], "displacement is 1e\\+05 mm"),
        (
            lambda rows: [rows[0], rows[1].replace("load [kN]", "load [N]"), *rows[2:]],
            "look at the units of both",
        ),
        (
            lambda rows: [rows[0], rows[1].replace("force [kN],load [kN]", "x,load [N]"), *rows[2:]],
            "look at the unit of the load",
        ),
        (lambda rows: [rows[0], rows[1].replace(" [mm]", ""), *rows[2:]], "has no unit"),
        (
            lambda rows: [*rows[:50], rows[50].replace("7540", "-7540"), *rows[51:]],
            "line 51: the load is -7540 kN",
        ),
        (lambda rows: [*rows[:50], rows[50].replace("7540", ""), *rows[51:]], "line 51: the load is missing"),
        (
            lambda rows: [*rows[:50], rows[50].replace("7540", "x"), *rows[51:]],
            "line 51: the load is 'x', not a number",
        ),
        (lambda rows: [*rows[:2], *(flip(row) for row in rows[2:])], "negative work"),
        (lambda rows: [], "empty"),
        (lambda rows: rows[:12], "10 samples"),
    ],
)
def test_bad_measurements_get_one_sentence(run, loop, change, sentence):
    loop.write_text("\n".join(change(loop.read_text().splitlines())))
    outcome = run("test", loop)
    assert outcome.status == 2
    assert re.search(sentence, outcome.err), outcome.err
    assert outcome.err.count("\n") == 1
