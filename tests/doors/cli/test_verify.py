"""`dcfp verify` prints what `dcfp.verify` finds, and fails when a check does."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import pytest

from dcfp.schema.check import Check, Verdict

GOOD = Check(
    "half-space under a constant flux", Verdict.MET, 1.0001, "0.1 %", "Carslaw and Jaeger (1959)",
    of="Kernels", unit="degC", expected=1.0, difference="0.01 %", ratio=0.1,
)  # fmt: skip
BAD = replace(GOOD, name="a wrong one", verdict=Verdict.NOT_MET, remark="look here")
SKIPPED = replace(
    GOOD, of="OpenSees", name="not installed", found=None, expected=None, verdict=Verdict.NOT_KNOWN
)


@pytest.fixture
def checks(monkeypatch) -> list[Check]:
    found: list[Check] = [GOOD, SKIPPED]

    def run_checks(full: bool, report) -> list[Check]:
        chosen = [*found, GOOD] if full else found
        for check in chosen:
            report(check)
        return chosen

    monkeypatch.setattr("dcfp.doors.cli.verify.run_checks", run_checks)
    return found


def test_all_good(run, checks) -> None:
    status, out, err = run("verify")
    assert (status, err) == (0, "")
    assert "1 passed, 0 failed, 1 skipped" in out
    assert "Carslaw" in out


def test_one_failure_makes_the_status_one(run, checks) -> None:
    checks.append(BAD)
    status, out, _ = run("verify")
    assert status == 1
    assert "FAILED" in out
    assert "look here" in out


def test_full_and_json(run, checks) -> None:
    status, out, err = run("verify", "--full", "--json")
    assert (status, err) == (0, "")
    rows = json.loads(out)
    assert len(rows) == 3
    assert set(rows[0]) == {
        "group", "name", "computed", "expected", "unit", "tolerance", "difference", "passed", "note", "source", "ratio",
    }  # fmt: skip


def test_a_table_and_a_figure(run, checks, tmp_path: Path) -> None:
    checks.append(replace(BAD, ratio=None))
    out, plot = tmp_path / "v.csv", tmp_path / "v.svg"
    assert run("verify", "--out", out, "--plot", plot).status == 1
    rows = list(csv.DictReader(out.read_text().splitlines()))
    assert [row["passed"] for row in rows] == ["true", "", "false"]
    assert rows[0]["ratio [-]"] == "0.1"
    assert plot.stat().st_size > 5000


@pytest.mark.parametrize(
    ("option", "name"),
    [("--out", "v.nc"), ("--plot", "v.txt"), ("--out", "there.csv"), ("--out", "no/v.csv")],
)
def test_a_file_that_cannot_be_written_is_refused_before_the_work(
    run, monkeypatch, tmp_path: Path, option: str, name: str
) -> None:
    monkeypatch.setattr("dcfp.doors.cli.verify.run_checks", None)
    (tmp_path / "there.csv").write_text("mine")
    status, out, err = run("verify", option, tmp_path / name)
    assert (status, out, err.count("\n")) == (2, "", 1)
    assert [path.name for path in tmp_path.iterdir()] == ["there.csv"]
