"""`dcfp records`: the named ones, and what is in a file."""

import json
from pathlib import Path


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
