"""What is said of an earthquake before it is analysed: every blind method, with intervals."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from dcfp.analysis.assumptions import LARGEST_YIELD_RADIUS
from dcfp.errors import InputError
from dcfp.inference.calibration import (
    Intervals,
    intervals_about,
    intervals_from_pgv,
    others_than,
    set_remarks,
)
from dcfp.inference.case import (
    Basis,
    Case,
    Method,
    Setting,
    View,
    design_prediction,
    march,
    pulse_predictions,
)
from dcfp.inference.earthquake import is_known
from dcfp.methods import Prediction, PulseMarch, Pulses, find_pulses
from dcfp.methods import li_2020 as paper
from dcfp.motion.ground_motion import GroundMotion

#: Part by which a PGV that was scaled to may be off [-].
_ROUNDING = 1e-6


@dataclass(frozen=True, eq=False)
class Forecast:
    """What the methods say of one record at one PGV, or of any earthquake with a PGV.

    Attributes
    ----------
    pgv
        [mm/s].
    predicted
        By method and basis.
    motion
        The record; None where only the PGV is known.
    pulses
        Of the record, as the methods of Li et al. (2020) take them.
    governing
        Number of the pulse that governs by a method, counted from zero in `pulses`; a method without one is not there.
    intervals
        Of every view, where they were asked for; under None those from the PGV alone.
    remarks
        Sentences that a reader of the numbers must know.
    """

    pgv: float
    predicted: dict[View, Prediction]
    motion: GroundMotion | None = None
    pulses: Pulses | None = None
    governing: dict[View, int] = field(default_factory=dict[View, int])
    intervals: dict[View | None, Intervals] = field(default_factory=dict[View | None, Intervals])
    remarks: tuple[str, ...] = ()


def forecast(motion: GroundMotion, setting: Setting, calibration: Sequence[Case] | None = None) -> Forecast:
    """Return what every blind method says of a record.

    Parameters
    ----------
    motion
        The record, at its PGV.
    setting
        The bearing, and how the methods are set.
    calibration
        Other records at the same PGV, from which the intervals come; those of the same earthquake do not count. None for no intervals.
    """
    pulses = find_pulses(motion, setting.threshold)
    of_pulses = {(method, Basis.BLIND): said for method, said in pulse_predictions(pulses, setting).items()}
    marched = march(motion, setting)
    predicted: dict[View, Prediction] = {
        **design_prediction(motion, setting),
        **{view: said.largest for view, said in of_pulses.items()},
        (Method.MARCH, Basis.BLIND): marched.prediction,
    }
    remarks = [
        *_beyond_capacity(motion.name, predicted, setting),
        *_remarks(motion, pulses, predicted[Method.PULSE, Basis.BLIND], marched, setting),
        *setting_remarks(motion.peak_velocity, setting),
    ]
    intervals: dict[View | None, Intervals] = {}
    if calibration is not None:
        others = others_than(motion, calibration)
        found = _intervals_or_none(others)
        if found is None:
            remarks.append(_without_interval(motion.peak_velocity))
        else:
            intervals = {None: found, **intervals_about(predicted, others)}
            remarks.append(_left_out(motion, len(calibration) - len(others), len(calibration)))
            remarks += set_remarks(motion.peak_velocity, others, setting.bearing.displacement_capacity)
    return Forecast(
        pgv=motion.peak_velocity,
        predicted=predicted,
        motion=motion,
        pulses=pulses,
        governing={view: said.governing for view, said in of_pulses.items() if said.governing is not None},
        intervals=intervals,
        remarks=tuple(remarks),
    )


def forecast_from_pgv(pgv: float, setting: Setting, calibration: Sequence[Case] | None = None) -> Forecast:
    """Return what can be said of an earthquake of which only the PGV [mm/s] is known; arguments as for `forecast`.

    Raises
    ------
    InputError
        If the design method cannot be used.
    """
    predicted: dict[View, Prediction] = {
        (Method.DESIGN, Basis.PGV): paper.predict_from_pgv(pgv, setting.constants)
    }
    remarks = (
        *_beyond_capacity(f"PGV {pgv / 1e3:g} m/s", predicted, setting),
        *setting_remarks(pgv, setting),
    )
    if calibration is None:
        return Forecast(pgv, predicted, remarks=remarks)
    found = _intervals_or_none(calibration)
    if found is None:
        return Forecast(pgv, predicted, remarks=(*remarks, _without_interval(pgv)))
    remarks = (*remarks, *set_remarks(pgv, calibration, setting.bearing.displacement_capacity))
    return Forecast(pgv, predicted, intervals={None: found}, remarks=remarks)


def setting_remarks(pgv: float, setting: Setting) -> tuple[str, ...]:
    """Return what must be known of the methods at a PGV [mm/s], whatever the record."""
    constants = setting.constants
    remarks: list[str] = []
    if not constants.slides_on_average:
        remarks.append(
            f"The simplified and the design method are left out: mu_n g, {constants.friction_deceleration:.0f} mm/s2, is not below"
            f" their average slope of {constants.average_slope:.0f} mm/s2."
        )
    elif 0.0 < pgv < constants.reference_pgv * (1.0 - _ROUNDING):
        remarks.append(
            "Li et al. (2020), section 6.2.2, give the average slope of the simplified and the design method for PGVs from"
            f" {constants.reference_pgv / 1e3:g} m/s on."
        )
    law, bearing = setting.friction, setting.bearing
    if law.caution:
        remarks.append(f"Friction law {law.name}: {law.caution}")
    stretch = constants.nominal_friction * bearing.vertical_force / bearing.elastic_stiffness
    if stretch > LARGEST_YIELD_RADIUS:
        remarks.append(
            f"Spring (b) stretches {stretch:.1f} mm before the bearing slides; the predictions take it as rigid."
        )
    return tuple(remarks)


def _beyond_capacity(name: str, predicted: dict[View, Prediction], setting: Setting) -> list[str]:
    """Return a sentence where a method offers a displacement beyond the capacity."""
    capacity = setting.bearing.displacement_capacity
    beyond = {
        view[0].value: said.bound
        for view, said in predicted.items()
        if capacity is not None and said.bound > capacity
    }
    if not beyond:
        return []
    note = f" ({setting.bearing.capacity_note})" if setting.bearing.capacity_note else ""
    offered = ", ".join(f"{method} {bound:.0f} mm" for method, bound in beyond.items())
    return [
        f"{name}: what is offered for y_max goes beyond the capacity of {capacity:.0f} mm{note}: {offered}."
    ]


def _remarks(
    motion: GroundMotion, pulses: Pulses, said: Prediction, marched: PulseMarch, setting: Setting
) -> list[str]:
    remarks: list[str] = []
    if not pulses.count:
        remarks.append(f"{motion.name}: the ground velocity has no pulse, so nothing is predicted to move.")
    elif said.displacement_change == 0.0:
        remarks.append(
            f"{motion.name}: by the pulse method nothing moves, since every pulse has a ku/kg above 1; its straight lines leave out that the"
            " ground accelerates more in the middle of a pulse."
        )
    if not marched.rests:
        remarks.append(
            f"{motion.name}: the march still slides two minutes after the last peak; its dy does not count that slide."
        )
    return remarks


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
