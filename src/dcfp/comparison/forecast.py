"""What is said of an earthquake before it is analysed: every blind method, with intervals."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from dcfp.comparison.calibration import Intervals, intervals_about, intervals_from_pgv
from dcfp.comparison.case import Basis, Case, Method, Setting, View, event_of
from dcfp.errors import InputError
from dcfp.prediction import Prediction, PulseMarch, Pulses, find_pulses, march_through_pulses
from dcfp.prediction import li_2020 as paper
from dcfp.record.ground_motion import GroundMotion

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
    march
        The march through the (finer) pulses.
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
    march: PulseMarch | None = None
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
    march = march_through_pulses(
        find_pulses(motion, setting.march_threshold), setting.bearing, setting.friction, setting.heating
    )
    by_pulse = {(Method.PULSE, Basis.BLIND): paper.predict_from_pulses(pulses, setting.constants)}
    predicted: dict[View, Prediction] = {}
    if setting.constants.slides_on_average:
        by_pulse[Method.SIMPLIFIED, Basis.BLIND] = paper.predict_simplified(pulses, setting.constants)
        if motion.peak_velocity > 0.0:
            predicted[Method.DESIGN, Basis.PGV] = paper.predict_from_pgv(
                motion.peak_velocity, setting.constants
            )
    predicted |= {view: found.largest for view, found in by_pulse.items()}
    predicted[Method.MARCH, Basis.BLIND] = march.prediction
    remarks = [*_remarks(motion, pulses, march, setting), *setting_remarks(motion.peak_velocity, setting)]
    intervals: dict[View | None, Intervals] = {}
    if calibration is not None:
        found = _intervals_or_none(calibration)
        if found is None:
            remarks.append(_without_interval(motion.peak_velocity))
        else:
            intervals = {None: found, **intervals_about(predicted, calibration, event_of(motion))}
    return Forecast(
        pgv=motion.peak_velocity,
        predicted=predicted,
        motion=motion,
        pulses=pulses,
        governing={view: found.governing for view, found in by_pulse.items() if found.governing is not None},
        march=march,
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
    remarks = setting_remarks(pgv, setting)
    if calibration is None:
        return Forecast(pgv, predicted, remarks=remarks)
    found = _intervals_or_none(calibration)
    if found is None:
        return Forecast(pgv, predicted, remarks=(*remarks, _without_interval(pgv)))
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
    if setting.friction.caution:
        remarks.append(setting.friction.caution)
    return tuple(remarks)


def _remarks(motion: GroundMotion, pulses: Pulses, march: PulseMarch, setting: Setting) -> list[str]:
    remarks: list[str] = []
    if not pulses.count:
        remarks.append(f"{motion.name}: the ground velocity has no pulse, so nothing is predicted to move.")
    capacity, bound = setting.bearing.displacement_capacity, march.prediction.bound
    if capacity is not None and bound > capacity:
        note = f" ({setting.bearing.capacity_note})" if setting.bearing.capacity_note else ""
        remarks.append(
            f"{motion.name}: the march predicts {bound:.0f} mm, beyond the capacity of {capacity:.0f} mm{note}."
        )
    if not march.rests:
        remarks.append(
            f"{motion.name}: the march still slides two minutes after the last peak; its dy does not count that slide."
        )
    return remarks


def _intervals_or_none(calibration: Sequence[Case]) -> Intervals | None:
    try:
        return intervals_from_pgv(calibration)
    except InputError:
        return None


def _without_interval(pgv: float) -> str:
    return f"At a PGV of {pgv / 1e3:g} m/s too few records move the bearing for an interval."
