"""Optional treatment of a ground motion; nothing is done silently: each step is written into its `treatment`."""

from dataclasses import replace
from importlib import import_module
from typing import Any

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station, joined

#: Largest number of values that resampling makes.
MAXIMUM_POINTS = 50_000_000


def treated(motion: GroundMotion, *, baseline: bool = False, corner: float | None = None) -> GroundMotion:
    """Return a motion without a linear baseline in velocity where `baseline` is wanted, and filtered where a `corner` [Hz] is given.

    Raises
    ------
    InputError
        If the corner cannot be; see `high_pass`.
    """
    if baseline:
        motion = remove_linear_velocity(motion)
    if corner is not None:
        if not baseline:
            # the filter pads with zeros, between which a mean would be two steps
            motion = remove_mean(motion)
        motion = high_pass(motion, corner)
    return motion


def station_treated(station: Station, *, baseline: bool = False, corner: float | None = None) -> Station:
    """Return a station with every component treated as `treated` does, which raises the same errors.

    They are treated as they were before they were brought together, since a mean or a filter is of what was recorded.
    """
    how: dict[str, Any] = {"baseline": baseline, "corner": corner}
    if station.parts:
        return joined([treated(one, **how) for one in station.parts], station.name)
    x, y, *rest = (treated(one, **how) for one in station.components)
    steps = x.treatment[len(station.x.treatment) :]
    return replace(
        station, x=x, y=y, vertical=rest[0] if rest else None, treatment=(*station.treatment, *steps)
    )


def record_treated(
    record: GroundMotion | Station, *, baseline: bool = False, corner: float | None = None
) -> GroundMotion | Station:
    """Return a station or a single component treated as `treated` does, which raises the same errors."""
    if isinstance(record, Station):
        return station_treated(record, baseline=baseline, corner=corner)
    return treated(record, baseline=baseline, corner=corner)


def remove_leading_mean(motion: GroundMotion, duration: float) -> GroundMotion:
    """Subtract the mean of the first part of the acceleration, as for an instrument's offset.

    Parameters
    ----------
    motion
        The ground motion.
    duration
        Length of that part [s]; the noise before the first arrival is meant.

    Raises
    ------
    InputError
        If the motion has no such part.
    """
    if not 0.0 < duration <= motion.duration:
        msg = f"{motion.name}: the mean can be taken of up to {motion.duration:g} s, not of {duration!r} s."
        raise InputError(msg)
    points = max(1, round(duration / motion.time_step))
    values = motion.acceleration - motion.acceleration[:points].mean()
    return _treated(motion, values, f"mean of the first {duration:g} s removed")


def remove_mean(motion: GroundMotion) -> GroundMotion:
    """Subtract the mean of the whole acceleration."""
    values = motion.acceleration - motion.acceleration.mean()
    return _treated(motion, values, "mean removed")


def remove_linear_acceleration(motion: GroundMotion) -> GroundMotion:
    """Subtract the straight line that fits the acceleration best (least squares)."""
    centred = motion.time - motion.time.mean()
    slope = float(centred @ motion.acceleration) / float(centred @ centred)
    line = motion.acceleration.mean() + slope * centred
    return _treated(motion, motion.acceleration - line, "linear baseline in acceleration removed")


def remove_linear_velocity(motion: GroundMotion) -> GroundMotion:
    """Subtract the constant acceleration whose velocity fits the motion's best (least squares).

    The line in velocity goes through the origin, so the motion still starts from rest.
    """
    slope = float(motion.time @ motion.velocity) / float(motion.time @ motion.time)
    return _treated(motion, motion.acceleration - slope, "linear baseline in velocity removed")


def high_pass(
    motion: GroundMotion, corner: float, order: int = 2, *, keep_margins: bool = True
) -> GroundMotion:
    """Filter with a zero-phase Butterworth high-pass, between margins of zeros.

    Parameters
    ----------
    motion
        The ground motion; remove its mean first.
    corner
        Corner frequency [Hz]. The filter runs forward and backward, so the amplitude there is one half.
    order
        Order of the filter in each of the two directions.
    keep_margins
        Whether the margins stay in the motion, which is then longer and begins and ends at rest.

    Raises
    ------
    InputError
        If the corner is not between zero and half the sampling rate, or so low that the margins would be too
        long, or the order is not between 1 and 10.

    Notes
    -----
    The margins last ``1.5 order / corner`` together, as Boore and Bommer (2005) recommend after Converse and
    Brady (1992): an acausal filter needs that time to rise and to decay. Boore (2005) shows that they must
    stay in the motion for its velocity and displacement, and the response to it, to agree with the filter.

    References: Boore, D. M., and Bommer, J. J. (2005), Processing of strong-motion accelerograms: needs,
    options and consequences, Soil Dynamics and Earthquake Engineering 25, 93-115. Boore, D. M. (2005), On
    pads and filters: processing strong-motion data, Bulletin of the Seismological Society of America 95,
    745-750.
    """
    limit = 0.5 / motion.time_step
    if not 0.0 < corner < limit:
        msg = f"{motion.name}: the corner must lie between 0 and {limit:g} Hz, not at {corner!r} Hz."
        raise InputError(msg)
    if order not in range(1, 11):
        msg = f"{motion.name}: the order of the filter must be 1 to 10, not {order!r}."
        raise InputError(msg)
    zeros = 0.75 * order / (corner * motion.time_step)
    if zeros > MAXIMUM_POINTS:
        msg = f"{motion.name}: a corner of {corner!r} Hz is too low for this time step; raise it."
        raise InputError(msg)
    margin = max(1, round(zeros))
    signal: Any = import_module("scipy.signal")  # only here: it takes half a second to import
    sections = signal.butter(order, corner, "highpass", fs=1.0 / motion.time_step, output="sos")
    filtered = signal.sosfiltfilt(sections, np.pad(motion.acceleration, margin), padtype=None)
    step = f"zero-phase Butterworth high-pass {corner:g} Hz, order {order}, forward and backward"
    if not keep_margins:
        return _treated(motion, filtered[margin:-margin], f"{step}, margins cut off")
    before = margin * motion.time_step
    longer = _treated(motion, filtered, f"{step}, margins of {before:g} s kept")
    return replace(longer, origin=motion.origin.later(-before))


def resample(motion: GroundMotion, factor: int) -> GroundMotion:
    """Divide each step into `factor` steps along the same straight line; the motion stays exactly the same.

    Raises
    ------
    InputError
        If the factor is not a positive whole number, or makes too many values.
    """
    largest = MAXIMUM_POINTS // motion.acceleration.size
    if factor not in range(1, largest + 1):
        msg = f"{motion.name}: the factor must be a whole number from 1 to {largest}, not {factor!r}."
        raise InputError(msg)
    old = np.arange(motion.acceleration.size, dtype=np.float64)
    new = np.arange((motion.acceleration.size - 1) * factor + 1, dtype=np.float64) / factor
    values = np.interp(new, old, motion.acceleration)
    treated = _treated(motion, values, f"time step divided by {factor}, linear in between")
    return replace(treated, time_step=motion.time_step / factor)


def _treated(motion: GroundMotion, acceleration: FloatArray, step: str) -> GroundMotion:
    return replace(motion, acceleration=acceleration, treatment=(*motion.treatment, step))
