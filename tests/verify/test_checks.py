"""Every check of `dcfp verify` passes, and every kind of check can fail."""

from dataclasses import replace
from functools import cache, partial
from itertools import islice

import pytest

from dcfp.schema.check import Check, Verdict
from dcfp.verify import analytic, check, laws, opensees, rig_explicit, run_checks
from dcfp.verify.check import CannotCheckError, Found, Task, judge

SHORT = check.tasks()
MOTIONS, OPENSEES = "Closed forms of the motion", [task for task in SHORT if task.group == "OpenSees"]
#: What takes seconds at full size: smaller cases of the first three are below, and the others are made for one or two records of four.
DEAR = (
    "100 components",
    "a pause",
    "OpenSees: test machine",
    "constant friction, KNA",
    "constant friction, IVD",
    *(f"response spectrum of {name}" for name in ("KNA", "LPG", "IVD")),
    # in the plane one station at one PGV of what the full run does
    *(f"P695-{name}" for name in ("FF-2 at 1.0", "FF-5", "FF-7", "FF-14", "NF-2")),
)

#: What takes more than a second as it is.
SLOW = (
    "OpenSees: peak displacement, heated",
    "90 % interval",
    "Plain explicit integration: peak temperature",
    "OpenSees: peak temperature",
    "OpenSees: in the plane",
    "OpenSees: building",
    "brute force",
    "Plain explicit integration: peak displacement",
    "Prediction: pulse method",
    "16 analyses, precise",
)


def identifier(task: Task) -> str:
    return f"{task.group}: {task.name}"


def must_pass_and_could_fail(task: Task) -> None:
    try:
        finding = task.measure()
    except CannotCheckError as error:
        pytest.skip(str(error)) if not error.fails else pytest.fail(str(error))
    outcome = judge(task.group, task.name, finding)
    assert outcome.passed, f"{outcome.difference} is more than {outcome.limit}; {outcome.remark}"
    assert judge(task.group, task.name, missed(finding)).passed is False


def missed(finding: Found) -> Found:
    """The finding beside an expected value that is a little too far away."""
    if finding.relative:
        expected = finding.computed * (1.0 + 1.02 * finding.limit + 1e-12) / (1.0 - 1.02 * finding.limit)
    else:
        expected = finding.computed + 1.01 * finding.limit + 1e-12
    return replace(finding, expected=expected, more_is_better=False)


def is_dear(task: Task) -> bool:
    return any(words in identifier(task) for words in DEAR)


def marks_of(task: Task) -> list[pytest.MarkDecorator]:
    if is_dear(task):
        return [pytest.mark.long]
    return [pytest.mark.slow] if any(words in identifier(task) for words in SLOW) else []


@pytest.mark.parametrize(
    "task",
    [pytest.param(task, marks=marks_of(task), id=identifier(task)) for task in check.tasks(full=True)],
)
def test_check(task: Task) -> None:
    must_pass_and_could_fail(task)


# ----- smaller cases of what is dear -----


def named(words: str) -> list[Task]:
    return [task for task in check.tasks(full=True) if words in identifier(task)]


@pytest.mark.parametrize("heating", ["simplified", "precise"])
def test_every_tenth_of_the_components(heating: str, monkeypatch: pytest.MonkeyPatch) -> None:
    hundred = laws.hundred_components
    monkeypatch.setattr(laws, "hundred_components", lambda pgv: islice(hundred(pgv), 4, None, 10))
    monkeypatch.setattr(laws, "converged_and_default", cache(laws.converged_and_default.__wrapped__))
    tasks = named(f"100 components at 0.5 m/s, {heating}")
    assert len(tasks) == 2
    for task in tasks:
        must_pass_and_could_fail(task)
    assert len(laws.converged_and_default("100 components at 0.5 m/s", heating)) == 10


@pytest.mark.slow
@pytest.mark.parametrize("task", named("a pause"), ids=identifier)
def test_a_pause_after_one_fast_cycle(task: Task, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(rig_explicit, "_PAUSED", "ASCE T10")
    must_pass_and_could_fail(task)


@pytest.mark.slow
@pytest.mark.parametrize("task", named("OpenSees: test machine"), ids=identifier)
def test_the_test_machine_of_opensees_in_steps_twice_as_long(
    task: Task, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(opensees, "_STEPS_IN_CYCLE", (1000, 2000))
    must_pass_and_could_fail(task)


def test_every_check_has_a_name_of_its_own() -> None:
    names = [identifier(task) for task in check.tasks(full=True)]
    assert len(set(names)) == len(names)


def test_the_full_run_only_adds() -> None:
    assert set(map(identifier, SHORT)) < set(map(identifier, check.tasks(full=True)))


# ----- a check can fail -----


@pytest.mark.parametrize(
    ("finding", "passed"),
    [
        (Found(1.0, 1.0, 0.0, unit="mm"), True),
        (Found(1.1, 1.0, 0.2, unit="mm"), True),
        (Found(1.3, 1.0, 0.2, unit="mm"), False),
        (Found(0.7, 1.0, 0.2, unit="mm"), False),
        (Found(101.0, 100.0, 0.02, unit="mm", relative=True), True),
        (Found(103.0, 100.0, 0.02, unit="mm", relative=True), False),
        (Found(-103.0, -100.0, 0.02, unit="mm", relative=True), False),
        (Found(float("nan"), 1.0, 1e9, unit="mm"), False),
        (Found(float("inf"), 1.0, 1e9, unit="mm", more_is_better=True), False),
        (Found(3.0, 2.0, 0.5, unit="-", more_is_better=True), True),
        (Found(1.0, 2.0, 0.5, unit="-", more_is_better=True), False),
    ],
)
def test_a_finding_is_judged_by_its_limit(finding: Found, passed: bool) -> None:
    assert judge("group", "name", finding).passed is passed


@pytest.mark.parametrize(
    ("finding", "ratio"),
    [
        (Found(1.0, 1.0, 0.0, unit="mm"), 0.0),
        (Found(1.1, 1.0, 0.0, unit="mm"), None),
        (Found(0.7, 1.0, 0.2, unit="mm"), 1.5),
        (Found(-103.0, -100.0, 0.02, unit="mm", relative=True), 1.5),
        (Found(float("nan"), 1.0, 1.0, unit="mm"), None),
        (Found(3.0, 2.0, 0.5, unit="-", more_is_better=True), 0.0),
        (Found(1.0, 2.0, 0.5, unit="-", more_is_better=True), 2.0),
    ],
)
def test_the_ratio_is_the_difference_over_what_is_allowed(finding: Found, ratio: float | None) -> None:
    assert judge("group", "name", finding).ratio == (None if ratio is None else pytest.approx(ratio))


def test_a_wrong_formula_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(analytic, "STANDARD_GRAVITY", 9810.0)
    found = {task.name: task.run().passed for task in SHORT if task.group == MOTIONS}
    assert found["distance of a slide to its stop"] is False
    assert found["velocity when a slide stops"] is False
    assert found["distance of a slide on a flat plate"] is False


# ----- the run -----


def test_each_check_is_reported_as_it_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    def measure(value: float) -> Found:
        return Found(value, 1.0, 0.5, unit="mm", note="a note", source="a source")

    def skipped() -> Found:
        reason = "not here"
        raise CannotCheckError(reason)

    tasks = [
        Task("one", "right", partial(measure, 1.0)),
        Task("one", "wrong", partial(measure, 2.0)),
        Task("two", "skipped", skipped),
    ]
    monkeypatch.setattr(check, "tasks", lambda full: tasks)
    reported: list[Check] = []
    checks = run_checks(report=reported.append)
    assert reported == checks
    assert [outcome.passed for outcome in checks] == [True, False, None]
    assert checks[0] == Check(
        "right",
        Verdict.MET,
        1.0,
        "0.5 mm",
        "a source",
        of="one",
        unit="mm",
        expected=1.0,
        difference="0 mm",
        ratio=0.0,
        remark="a note",
    )
    assert checks[2].remark == "not here"
    assert checks[2].found is None


# ----- OpenSees that is not there -----


@pytest.fixture
def without_opensees(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(opensees, "find_spec", lambda name: None)
    monkeypatch.delenv(opensees.REQUIRED, raising=False)
    opensees.run_job.cache_clear()


@pytest.mark.usefixtures("without_opensees")
@pytest.mark.parametrize("task", OPENSEES, ids=identifier)
def test_without_opensees_its_checks_are_skipped_with_a_way_to_get_it(task: Task) -> None:
    outcome = task.run()
    assert outcome.passed is None
    assert "openseespy" in outcome.remark


@pytest.mark.usefixtures("without_opensees")
def test_without_opensees_its_checks_fail_where_it_is_required(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(opensees.REQUIRED, "1")
    outcome = OPENSEES[0].run()
    assert outcome.passed is False
    assert opensees.REQUIRED in outcome.remark


def test_a_failure_of_the_other_process_is_told(monkeypatch: pytest.MonkeyPatch, tmp_path) -> None:
    program = tmp_path / "program.py"
    program.write_text("raise RuntimeError('libblas.so.3 is missing')")
    monkeypatch.setattr(opensees, "find_spec", lambda name: object())
    monkeypatch.setattr(opensees, "_PROGRAM", program)
    monkeypatch.delenv(opensees.REQUIRED, raising=False)
    opensees.run_job.cache_clear()
    outcome = OPENSEES[0].run()
    opensees.run_job.cache_clear()
    assert outcome.passed is None
    assert "libblas" in outcome.remark


def test_values_with_both_errors_are_extrapolated_exactly() -> None:
    values = [100.0 - 3.0 * step**0.5 + 7.0 * step for step in (0.004, 0.002, 0.001)]
    assert opensees.extrapolated((values[0], values[1], values[2])) == pytest.approx(100.0, rel=1e-12)
