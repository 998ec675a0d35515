"""Cases that an interval rests on: the hundred components of FEMA P-695 at the same PGV, under the same bearing."""

from collections.abc import Callable, Sequence
from functools import cache

import numpy as np

from dcfp.inference.case import Case, compare
from dcfp.inference.earthquake import event_of, is_same_record, same_earthquake
from dcfp.inference.intervals import Interval, errors, fewest, interval
from dcfp.methods import Prediction
from dcfp.methods.method import Information, Variant, variants
from dcfp.methods.prediction import Methods
from dcfp.methods.pulses import PREDICTION_QUANTITIES, value_of
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import all_keys, read_stored
from dcfp.schema.quantities import Quantity

#: Words for the set.
SET = "the 100 components of FEMA P-695"

#: Scale of a record, up or down, from which on it is said [-].
_LARGEST_SCALE = 4.0

Intervals = dict[Quantity, Interval]


def blind_variants() -> tuple[Variant, ...]:
    """Return what an interval is given for, besides the PGV alone."""
    return tuple(variant for variant in variants() if variant.information is Information.BLIND)


@cache
def calibration_set() -> tuple[GroundMotion, ...]:
    """Return the components, as they are."""
    return tuple(stored.motion for stored in read_stored(all_keys()))


def cases_at(pgv: float, methods: Methods, report: Callable[[], None] | None = None) -> list[Case]:
    """Analyse and predict every component at a PGV [mm/s]; `report` is called after each."""
    cases: list[Case] = []
    for motion in calibration_set():
        cases.append(compare(motion.scaled_to_pgv(pgv), methods))
        if report is not None:
            report()
    return cases


def others_than(motion: GroundMotion, cases: Sequence[Case]) -> list[Case]:
    """Return the cases of other earthquakes than that of a motion, as far as its source tells."""
    event = event_of(motion)
    same = {one.name for one in calibration_set() if is_same_record(motion, one)}
    return [case for case in cases if case.record not in same and not same_earthquake(event, case.event)]


def intervals_from_pgv(cases: Sequence[Case]) -> Intervals:
    """Return where the analyses of earthquakes with the PGV of `cases` lie, knowing nothing else.

    Raises
    ------
    InputError
        If nothing moves in most of the cases.
    """
    return {quantity: interval(errors(cases, None, quantity)) for quantity in PREDICTION_QUANTITIES.values()}


def intervals_about(predicted: dict[Variant, Prediction], cases: Sequence[Case]) -> dict[Variant, Intervals]:
    """Return where the analysis will lie, knowing what each blind method says of the record.

    Parameters
    ----------
    predicted
        What the methods say of the record.
    cases
        Records of other earthquakes at the same PGV.
    """
    return {one: _about(predicted[one], one, cases) for one in blind_variants() if one in predicted}


def _about(prediction: Prediction, variant: Variant, cases: Sequence[Case]) -> Intervals:
    intervals: Intervals = {}
    for quantity in PREDICTION_QUANTITIES.values():
        value = value_of(prediction, quantity)
        known = errors(cases, variant, quantity)
        # a method that sees nothing move says nothing of how far it will
        if value > 0.0 and np.isfinite(known).sum() >= fewest():
            intervals[quantity] = interval(known, value)
    return intervals


def set_remarks(pgv: float, cases: Sequence[Case], capacity: float | None) -> list[str]:
    """Return what must be known of the set at a PGV [mm/s]: how far its records are scaled, and how many go beyond a capacity [mm]."""
    remarks: list[str] = []
    factors = [pgv / motion.peak_velocity for motion in calibration_set()]
    if max(factors) > _LARGEST_SCALE or min(factors) < 1.0 / _LARGEST_SCALE:
        remarks.append(
            f"For a PGV of {pgv / 1e3:g} m/s the records of the set are scaled by {min(factors):.2g} to {max(factors):.2g}, which changes their"
            " strength but not their duration and periods: the intervals are as good as that is."
        )
    beyond = [case.analysed.whole.bound > capacity for case in cases] if capacity is not None else []
    if any(beyond):
        remarks.append(
            f"At {pgv / 1e3:g} m/s {100.0 * sum(beyond) / len(beyond):.0f} % of the analyses of the set go beyond the capacity of"
            f" {capacity:g} mm."
        )
    return remarks
