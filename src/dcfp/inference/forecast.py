"""What is said of an earthquake before it is analysed: every blind method, with intervals from the hundred components of FEMA P-695."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import cache
from typing import TypeAlias

import numpy as np

from dcfp.inference.case import Case, compare
from dcfp.inference.conditional import Experience, of_record, of_spectrum
from dcfp.inference.earthquake import earthquake_of, is_known, is_same_record, read_earthquake
from dcfp.inference.statistics import Interval, errors, fewest, interval
from dcfp.methods import Prediction, Pulses
from dcfp.methods.li_2020 import predict_from_pgv
from dcfp.methods.method import Information, Variant, variants
from dcfp.methods.prediction import Ground, Methods, prediction_methods
from dcfp.methods.pulses import PREDICTION_QUANTITIES, value_of
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import all_keys, read_stored
from dcfp.schema.quantities import Quantity
from dcfp.system import Bearing

#: Words for the set that intervals come from.
SET = "the 100 components of FEMA P-695"
#: What is to be known of intervals from the PGV alone.
_UNKNOWN = (
    "The intervals know the PGV alone: of 75 components of other sets one in seven lay outside in y_max at 0.75 m/s, one in six at 1.0 m/s, and one in four in V_E, where one in ten is meant;"
    " a record or a spectrum tells how much of the PGV is at long periods."
)
#: Scale of a record of it, up or down, from which on it is said [-].
_LARGEST_SCALE = 4.0
#: Under what the intervals stand that know the PGV and the spectrum, and no method.
BY_SPECTRUM = Variant("PGV and spectrum", Information.SPECTRUM)
#: What is told before an analysis, in this order.
_BEFORE = (Information.PGV, Information.BLIND)

Intervals: TypeAlias = dict[Quantity, Interval]


@dataclass(frozen=True, eq=False)
class Forecast:
    """What the methods say of one record at one PGV [mm/s], or of any earthquake with a PGV.

    Attributes
    ----------
    motion, pulses
        The record, and its pulses as the methods of Li et al. (2020) take them; None where only the PGV is
        known.
    governing
        Place in `pulses` of the one that governs by a method, from zero; a method without one is not there.
    nodes
        Number of nodes of the ground velocity that a method knows, where it takes it as straight legs.
    intervals
        Of every blind method, where they were asked for; under None those from the PGV alone, and under `BY_SPECTRUM` those that know the spectrum of
        the record besides.
    """

    pgv: float
    predicted: dict[Variant, Prediction]
    motion: GroundMotion | None = None
    pulses: Pulses | None = None
    governing: dict[Variant, int] = field(default_factory=dict[Variant, int])
    nodes: dict[Variant, int] = field(default_factory=dict[Variant, int])
    intervals: dict[Variant | None, Intervals] = field(default_factory=dict[Variant | None, Intervals])
    remarks: tuple[str, ...] = ()


def forecast(
    ground: Ground | GroundMotion, methods: Methods, calibration: Sequence[Case] | None = None
) -> Forecast:
    """Return what every blind method says of a record, or of any earthquake with a PGV.

    Parameters
    ----------
    ground
        The record at its PGV; or an earthquake of which only the PGV is known.
    methods
        The system, and how the methods are set.
    calibration
        Other records at the same PGV, from which the intervals come; those of the same earthquake do not
        count. None for no intervals.

    Raises
    ------
    InputError
        If only the PGV is known, and no method can be used.
    """
    ground = Ground.of(ground) if isinstance(ground, GroundMotion) else ground
    motion, pgv, bearing = ground.motion, ground.pgv, methods.system.bearing
    name = f"PGV {pgv / 1e3:g} m/s" if motion is None else motion.name
    allowed = [one for one in _BEFORE if motion is not None or one is Information.PGV]
    if ground.spectrum is not None:
        allowed.append(Information.SPECTRUM)
    said = {
        Variant(method.name, information): predicted
        for information in allowed
        for method in prediction_methods().values()
        if information in method.knows and (predicted := method.predict(ground, methods)) is not None
    }
    if motion is None and not said:
        predict_from_pgv(pgv, methods.constants)  # its complaint says what is wrong
    predicted = {variant: one.prediction for variant, one in said.items()}
    remarks = [
        *_beyond_capacity(name, predicted, bearing),
        *(remark for one in said.values() for remark in one.remarks),
        *methods.remarks(pgv),
    ]
    intervals: dict[Variant | None, Intervals] = {}
    if calibration is not None:
        others = calibration if motion is None else _others_than(motion, calibration)
        alone = _alone(others)
        if len(alone) < len(PREDICTION_QUANTITIES):
            remarks.append(f"At a PGV of {pgv / 1e3:g} m/s too few records move the bearing for an interval.")
        else:
            intervals = {None: alone}
            if motion is None and ground.spectrum is None:
                remarks.append(_UNKNOWN)
            else:
                told, beyond = _knowing_spectrum(name, ground, others, predicted, methods)
                intervals |= told
                remarks += beyond
            if motion is not None:
                remarks.append(_left_out(motion, len(calibration) - len(others), len(calibration)))
            remarks += _set_remarks(pgv, others, bearing.displacement_capacity)
    return Forecast(
        pgv=pgv,
        predicted=predicted,
        motion=motion,
        pulses=None if motion is None else ground.pulses(methods.threshold),
        governing={
            variant: one.by_pulse.governing
            for variant, one in said.items()
            if one.by_pulse is not None and one.by_pulse.governing is not None
        },
        nodes={variant: one.nodes for variant, one in said.items() if one.nodes is not None},
        intervals=intervals,
        remarks=tuple(remarks),
    )


def _beyond_capacity(name: str, predicted: dict[Variant, Prediction], bearing: Bearing) -> list[str]:
    """Return a sentence where a method offers a displacement beyond the capacity."""
    capacity = bearing.displacement_capacity
    beyond = {
        variant.method: said.bound
        for variant, said in predicted.items()
        if capacity is not None and said.bound > capacity
    }
    if not beyond:
        return []
    note = f" ({bearing.capacity_note})" if bearing.capacity_note else ""
    offered = ", ".join(f"{method} {bound:.0f} mm" for method, bound in beyond.items())
    return [
        f"{name}: what is offered for y_max goes beyond the capacity of {capacity:.0f} mm{note}: {offered}."
    ]


def _left_out(motion: GroundMotion, left_out: int, number: int) -> str:
    if left_out:
        return f"{motion.name}: {left_out} of the {number} components of the set are left out of its intervals, as of the same earthquake."
    why = (
        "its earthquake is not in the set"
        if is_known(motion)
        else "its source does not say of which earthquake it is"
    )
    return f"{motion.name}: no component of the set is left out of its intervals; {why}."


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


def _others_than(motion: GroundMotion, cases: Sequence[Case]) -> list[Case]:
    """Return the cases of other earthquakes than that of a motion, as far as its source tells."""
    earthquake = earthquake_of(motion)
    same = {one.name for one in calibration_set() if is_same_record(motion, one)}
    return [
        case
        for case in cases
        if case.record not in same and not earthquake.may_be(read_earthquake(case.event))
    ]


def _alone(cases: Sequence[Case]) -> Intervals:
    """Return where the analysis will lie, from cases at the same PGV, knowing nothing else."""
    known = {quantity: errors(cases, None, quantity) for quantity in PREDICTION_QUANTITIES.values()}
    return {
        quantity: interval(found) for quantity, found in known.items() if np.isfinite(found).sum() >= fewest()
    }


def _knowing_spectrum(
    name: str, ground: Ground, cases: Sequence[Case], predicted: dict[Variant, Prediction], methods: Methods
) -> tuple[dict[Variant | None, Intervals], list[str]]:
    """Return where the analysis will lie by the spectrum, and by it and each blind prediction; and what of the earthquake is beyond the cases, in a sentence."""
    experience = Experience.of_cases(cases, methods)
    if ground.motion is not None:
        known = of_record(ground.motion, experience.periods)
    elif ground.spectrum is not None:
        known = of_spectrum(ground.spectrum, ground.pgv, experience.periods)
    else:
        return {}, []
    about = {one: predicted[one] for one in blind_variants() if one in predicted}
    intervals: dict[Variant | None, Intervals] = {}
    beyond: dict[str, None] = {}
    for variant, prediction in (BY_SPECTRUM, None), *about.items():
        intervals[variant] = {}
        for quantity in PREDICTION_QUANTITIES.values():
            value = 1.0 if prediction is None else value_of(prediction, quantity)
            # a method that sees nothing move says nothing of how far it will
            if value > 0.0 and (
                found := experience.interval(
                    errors(cases, None if prediction is None else variant, quantity), quantity, known, value
                )
            ):
                intervals[variant][quantity], words = found
                beyond |= dict.fromkeys(words)
    if not beyond:
        return intervals, []
    return intervals, [
        f"{name}: it is beyond the records that its intervals come from, by {' and '.join(beyond)}; the intervals are wider for that, by guess."
    ]


def _set_remarks(pgv: float, cases: Sequence[Case], capacity: float | None) -> list[str]:
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
