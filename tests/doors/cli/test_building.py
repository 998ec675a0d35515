"""``dcfp building`` from end to end."""

import csv
import json
import re

import pytest


def test_building_beside_the_rigid_structure(run):
    (row,) = json.loads(run("building", "NCC", "--pgv", "1.0", "--json").out)
    (rigid,) = json.loads(run("respond", "NCC", "--pgv", "1.0", "--json").out)
    assert row["y_max_rigid_mm"] == pytest.approx(rigid["y_max_mm"])
    # Akiyama (1985): the input energy is nearly the same
    assert row["V_E_mm_s"] == pytest.approx(rigid["V_E_mm_s"], rel=0.1)
    assert len(row["drifts_mm"]) == 5
    assert len(row["floor_accelerations_m_s2"]) == 6
    assert row["energy_residual"] < 1e-9
    assert any("capacity" in remark or "faster" in remark for remark in row["remarks"])
    table = run("building", "NCC", "--pgv", "1.0").out
    assert len(re.findall(r"^ *NCC +1", table, re.MULTILINE)) == 1


def test_a_stiff_building_is_rigid(run):
    (row,) = json.loads(run("building", "LPG", "--pgv", "0.5", "--fixed-base-period", "0.01", "--json").out)
    assert row["y_max_mm"] == pytest.approx(row["y_max_rigid_mm"], rel=2e-3)


def test_undamped_and_as_csv(run, tmp_path):
    table = tmp_path / "table.csv"
    outcome = run(
        "building", "NCC", "--pgv", "0.5", "1.0", "--storeys", "2", "--damping", "0", "--out", table
    )
    assert outcome.status == 0
    rows = list(csv.DictReader(table.read_text().splitlines()))
    assert len(rows) == 2
    words = ("record", "rests", "remarks")
    assert all(float(value) > 0.0 for row in rows for key, value in row.items() if key not in words)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("NCC", "--storeys", "0"), "--storeys"),
        (
            ("NCC", "--storeys", "five"),
            "--storeys: number of storeys must be a whole number from 1 to 60, not 'five'.",
        ),
        (
            ("NCC", "--storeys", "5.5"),
            "--storeys: number of storeys must be a whole number from 1 to 60, not '5.5'.",
        ),
        (("NCC", "--fixed-base-period", "-1"), "--fixed-base-period"),
        (("NCC", "--damping", "2"), "--damping"),
        ((), "RECORD"),
    ],
)
def test_bad_input_is_one_sentence(run, words, told):
    status, out, err = run("building", *words)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert told in err
