"""What is said of an earthquake before it is analysed: every blind method, with intervals."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from dcfp.errors import InputError
from dcfp.inference.calibration import (
    Intervals,
    intervals_about,
    intervals_from_pgv,
    others_than,
    set_remarks,
)
from dcfp.inference.case import Case
from dcfp.inference.earthquake import is_known
from dcfp.methods import Prediction, Pulses
from dcfp.methods.li_2020 import predict_from_pgv
from dcfp.methods.method import Information, Variant
from dcfp.methods.prediction import Ground, Methods, Predicted, prediction_methods
from dcfp.motion.ground_motion import GroundMotion
from dcfp.system import System


@dataclass(frozen=True, eq=False)
class Forecast:
    """What the methods say of one record at one PGV, or of any earthquake with a PGV.

    Attributes
    ----------
    pgv
        [mm/s].
    predicted
        By method, with what it knows.
    motion
        The record; None where only the PGV is known.
    pulses
        Of the record, as the methods of Li et al. (2020) take them.
    governing
        Number of the pulse that governs by a method, counted from zero in `pulses`; a method without one is not there.
    intervals
        Of every blind method, where they were asked for; under None those from the PGV alone.
    remarks
        Sentences that a reader of the numbers must know.
    """

    pgv: float
    predicted: dict[Variant, Prediction]
    motion: GroundMotion | None = None
    pulses: Pulses | None = None
    governing: dict[Variant, int] = field(default_factory=dict[Variant, int])
    intervals: dict[Variant | None, Intervals] = field(default_factory=dict[Variant | None, Intervals])
    remarks: tuple[str, ...] = ()


#: What is told before an analysis, in this order.
_BEFORE = (Information.PGV, Information.BLIND)


def _said(ground: Ground, methods: Methods) -> dict[Variant, Predicted]:
    """Return what every method says of an earthquake that can be used, those first that need the PGV only."""
    allowed = _BEFORE if ground.motion is not None else (Information.PGV,)
    return {
        Variant(name, information): predicted
        for information in allowed
        for name, method in prediction_methods().items()
        if information in method.knows and (predicted := method.predict(ground, methods)) is not None
    }


def forecast(motion: GroundMotion, methods: Methods, calibration: Sequence[Case] | None = None) -> Forecast:
    """Return what every blind method says of a record.

    Parameters
    ----------
    motion
        The record, at its PGV.
    methods
        The system, and how the methods are set.
    calibration
        Other records at the same PGV, from which the intervals come; those of the same earthquake do not count. None for no intervals.
    """
    ground = Ground.of(motion)
    said = _said(ground, methods)
    predicted = {variant: one.prediction for variant, one in said.items()}
    remarks = [
        *_beyond_capacity(motion.name, predicted, methods.system),
        *(remark for one in said.values() for remark in one.remarks),
        *methods.remarks(motion.peak_velocity),
    ]
    intervals: dict[Variant | None, Intervals] = {}
    if calibration is not None:
        others = others_than(motion, calibration)
        found = _intervals_or_none(others)
        if found is None:
            remarks.append(_without_interval(motion.peak_velocity))
        else:
            intervals = {None: found, **intervals_about(predicted, others)}
            remarks.append(_left_out(motion, len(calibration) - len(others), len(calibration)))
            remarks += set_remarks(motion.peak_velocity, others, methods.system.bearing.displacement_capacity)
    return Forecast(
        pgv=motion.peak_velocity,
        predicted=predicted,
        motion=motion,
        pulses=ground.pulses(methods.threshold),
        governing={
            variant: one.by_pulse.governing
            for variant, one in said.items()
            if one.by_pulse is not None and one.by_pulse.governing is not None
        },
        intervals=intervals,
        remarks=tuple(remarks),
    )


def forecast_from_pgv(pgv: float, methods: Methods, calibration: Sequence[Case] | None = None) -> Forecast:
    """Return what can be said of an earthquake of which only the PGV [mm/s] is known; arguments as for `forecast`.

    Raises
    ------
    InputError
        If no method can be used.
    """
    predicted = {variant: one.prediction for variant, one in _said(Ground(pgv), methods).items()}
    if not predicted:
        predict_from_pgv(pgv, methods.constants)  # its complaint says what is wrong
    remarks = (
        *_beyond_capacity(f"PGV {pgv / 1e3:g} m/s", predicted, methods.system),
        *methods.remarks(pgv),
    )
    if calibration is None:
        return Forecast(pgv, predicted, remarks=remarks)
    found = _intervals_or_none(calibration)
    if found is None:
        return Forecast(pgv, predicted, remarks=(*remarks, _without_interval(pgv)))
    remarks = (*remarks, *set_remarks(pgv, calibration, methods.system.bearing.displacement_capacity))
    return Forecast(pgv, predicted, intervals={None: found}, remarks=remarks)


def _beyond_capacity(name: str, predicted: dict[Variant, Prediction], system: System) -> list[str]:
    """Return a sentence where a method offers a displacement beyond the capacity."""
    bearing = system.bearing
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


def _intervals_or_none(calibration: Sequence[Case]) -> Intervals | None:
    try:
        return intervals_from_pgv(calibration)
    except InputError:
        return None


def _left_out(motion: GroundMotion, left_out: int, number: int) -> str:
    if left_out:
        return f"{motion.name}: {left_out} of the {number} components of the set are left out of its intervals, as of the same earthquake."
    why = (
        "its earthquake is not in the set"
        if is_known(motion)
        else "its source does not say of which earthquake it is"
    )
    return f"{motion.name}: no component of the set is left out of its intervals; {why}."


def _without_interval(pgv: float) -> str:
    return f"At a PGV of {pgv / 1e3:g} m/s too few records move the bearing for an interval."
