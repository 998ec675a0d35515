"""All checks in their order."""

from collections.abc import Callable

from dcfp.schema.check import Check
from dcfp.verify import (
    analytic,
    building,
    codes,
    convergence,
    explicit,
    half_space,
    laws,
    opensees,
    prediction,
    published,
    rig,
    rig_explicit,
    rig_opensees,
)
from dcfp.verify.check import Task

#: In the order in which they are printed.
GROUPS = (
    published,
    analytic,
    half_space,
    laws,
    convergence,
    explicit,
    prediction,
    codes,
    building,
    rig,
    rig_explicit,
    opensees,
    rig_opensees,
)


def tasks(full: bool = False) -> list[Task]:
    """Return the checks to be made; all of them where `full`."""
    return [task for group in GROUPS for task in group.TASKS if full or not task.long]


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
