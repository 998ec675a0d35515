"""`dcfp verify` prints what `dcfp.verification` finds, and fails when a check does."""

import json
from dataclasses import dataclass, replace

import pytest


@dataclass(frozen=True)
class Check:
    group: str = "Kernels"
    name: str = "half-space under a constant flux"
    computed: float | None = 1.0001
    expected: float | None = 1.0
    unit: str = "degC"
    tolerance: str = "0.1 %"
    difference: str = "0.01 %"
    passed: bool | None = True
    note: str = ""
    source: str = "Carslaw and Jaeger (1959)"


GOOD = Check()
BAD = replace(GOOD, name="a wrong one", passed=False, note="look here")
SKIPPED = replace(GOOD, group="OpenSees", name="not installed", computed=None, expected=None, passed=None)


@pytest.fixture
def checks(monkeypatch) -> list[Check]:
    found: list[Check] = [GOOD, SKIPPED]

    def run_checks(full: bool, report) -> list[Check]:
        chosen = [*found, GOOD] if full else found
        for check in chosen:
            report(check)
        return chosen

    monkeypatch.setattr("dcfp.verification.run_checks", run_checks, raising=False)
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
    assert set(rows[0]) == set(Check.__dataclass_fields__)
