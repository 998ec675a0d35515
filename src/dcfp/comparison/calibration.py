"""Cases that an interval rests on: the hundred components of FEMA P-695 at the same PGV, under the same bearing."""

from collections.abc import Callable, Sequence
from functools import cache

import numpy as np

from dcfp.comparison.case import VIEWS, Basis, Case, Setting, View, compare
from dcfp.comparison.intervals import Interval, errors, interval
from dcfp.comparison.quantities import QUANTITIES, Quantity
from dcfp.comparison.statistics import value_of
from dcfp.prediction import Prediction
from dcfp.record.ground_motion import GroundMotion
from dcfp.record.named import record_set

#: Words for the set.
SET = "the 100 components of FEMA P-695"

#: What an interval is given for: a blind prediction, or None for the PGV alone.
BLIND_VIEWS: tuple[View, ...] = tuple(view for view in VIEWS if view[1] is Basis.BLIND)

Intervals = dict[Quantity, Interval]


@cache
def calibration_set() -> tuple[GroundMotion, ...]:
    """Return the components, as they are."""
    return tuple(record_set("P695") or ())


def cases_at(pgv: float, setting: Setting, report: Callable[[], None] | None = None) -> list[Case]:
    """Analyse and predict every component at a PGV [mm/s]; `report` is called after each."""
    cases: list[Case] = []
    for motion in calibration_set():
        cases.append(compare(motion.scaled_to_pgv(pgv), setting))
        if report is not None:
            report()
    return cases


def intervals_from_pgv(cases: Sequence[Case]) -> Intervals:
    """Return where the analyses of earthquakes with the PGV of `cases` lie, knowing nothing else.

    Raises
    ------
    InputError
        If nothing moves in most of the cases.
    """
    return {quantity: interval(errors(cases, None, quantity)) for quantity in QUANTITIES}


def intervals_about(
    predicted: dict[View, Prediction], cases: Sequence[Case], event: str
) -> dict[View, Intervals]:
    """Return where the analysis will lie, knowing what each blind method says of the record.

    Parameters
    ----------
    predicted
        What the methods say of the record.
    cases
        Other records at the same PGV.
    event
        The earthquake of the record, of which no case may count; see `event_of`.
    """
    others = [case for case in cases if case.event != event]
    found: dict[View, Intervals] = {}
    for view in BLIND_VIEWS:
        if view in predicted:
            found[view] = _about(predicted[view], view, others)
    return found


def _about(prediction: Prediction, view: View, others: Sequence[Case]) -> Intervals:
    intervals: Intervals = {}
    for quantity in QUANTITIES:
        value = value_of(prediction, quantity)
        known = errors(others, view, quantity)
        # a method that sees nothing move says nothing of how far it will
        if value > 0.0 and np.isfinite(known).any():
            intervals[quantity] = interval(known, value)
    return intervals
