"""Measures of a ground motion's strength, exact for acceleration that is linear between its values; and what a reader of them must know."""

import math
from typing import Any

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import GRAVITY, M_PER_S, M_PER_S2, MM, NONE, PERCENT, SECOND

#: Velocity at the end, relative to PGV, from which on the baseline is in doubt [-]. In the hundred records of
#: FEMA P-695, all of them corrected, it stays below 0.03.
DRIFT_THRESHOLD = 0.05
#: The same above which the PGV is that of the baseline [-].
_LARGEST_DRIFT = 0.5


def arias_intensity(motion: GroundMotion) -> float:
    r"""Return the Arias intensity [mm/s], :math:`\frac{\pi}{2g}\int a^2\,dt` (Arias 1970)."""
    return math.pi / (2.0 * STANDARD_GRAVITY) * float(_square_steps(motion).sum())


def significant_duration(motion: GroundMotion, start: float = 0.05, end: float = 0.95) -> float:
    """Return the time between two fractions of the Arias intensity [s] (Trifunac and Brady 1975).

    Parameters
    ----------
    motion
        The ground motion.
    start, end
        The fractions [-].

    Raises
    ------
    InputError
        If not ``0 <= start < end <= 1``.
    """
    if not 0.0 <= start < end <= 1.0:
        msg = (
            f"the fractions of the Arias intensity must go up between 0 and 1, not from {start!r} to {end!r}."
        )
        raise InputError(msg)
    steps = _square_steps(motion)
    total = np.concatenate(([0.0], np.cumsum(steps)))
    if total[-1] == 0.0:
        return 0.0
    return _time_at(motion, total, end) - _time_at(motion, total, start)


def cumulative_absolute_velocity(motion: GroundMotion) -> float:
    r"""Return the cumulative absolute velocity [mm/s], :math:`\int |a|\,dt` (EPRI 1988)."""
    first, second = np.abs(motion.acceleration[:-1]), np.abs(motion.acceleration[1:])
    heights = first + second
    # Where the sign changes, two triangles stand in the step instead of one trapezoid.
    changes = motion.acceleration[:-1] * motion.acceleration[1:] < 0.0
    triangles = (first**2 + second**2) / np.where(heights > 0.0, heights, 1.0)
    return 0.5 * motion.time_step * float(np.where(changes, triangles, heights).sum())


def baseline_drift(motion: GroundMotion | Station) -> float:
    """Return the velocity at the end relative to PGV [-]; a corrected record has almost none."""
    if motion.peak_velocity == 0.0:
        return 0.0
    return float(np.linalg.norm(np.atleast_1d(motion.velocity[-1]))) / motion.peak_velocity


def baseline_warning(motion: GroundMotion | Station) -> str | None:
    """Return a sentence when the motion ends with a velocity that suggests an untreated baseline, or None."""
    drift = baseline_drift(motion)
    if drift <= DRIFT_THRESHOLD:
        return None
    return (
        f"{motion.name}: the ground still moves at {100.0 * drift:.0f} % of PGV at the end of the record, "
        "which suggests an untreated baseline; its PGV and displacement are then not those of the ground: "
        "filter it (high_pass) or remove its baseline (baseline)."
    )


def _square_steps(motion: GroundMotion) -> FloatArray:
    """Return the integral of the squared acceleration over each step [mm2/s3]."""
    first, second = motion.acceleration[:-1], motion.acceleration[1:]
    return motion.time_step / 3.0 * (first**2 + first * second + second**2)


def _time_at(motion: GroundMotion, total: FloatArray, fraction: float) -> float:
    """Return when the integral of the squared acceleration first reaches a fraction of its end value [s]."""
    wanted = fraction * float(total[-1])
    step = min(max(int(np.searchsorted(total, wanted)) - 1, 0), total.size - 2)
    first = float(motion.acceleration[step])
    change = float(motion.acceleration[step + 1]) - first
    rest = (wanted - float(total[step])) / motion.time_step
    if abs(change) > 1e-4 * abs(first):
        share = (float(np.cbrt(first**3 + 3.0 * change * rest)) - first) / change
    else:
        share = rest / first**2 if first else 0.0
    return (step + min(max(share, 0.0), 1.0)) * motion.time_step


def refuse_a_drift(motion: GroundMotion | Station) -> None:
    """Refuse a motion whose PGV is that of its baseline.

    Raises
    ------
    InputError
        If it ends at more than half of its PGV.
    """
    drift = baseline_drift(motion)
    if drift > _LARGEST_DRIFT:
        msg = (
            f"{motion.name}: the ground still moves at {100.0 * drift:.0f} % of its PGV at the end, so that its PGV is"
            " that of its baseline; filter the record, for example at 0.05 Hz (high_pass), or remove its baseline (baseline)."
        )
        raise InputError(msg)


def motion_remarks(motion: GroundMotion | Station, *, with_scale: bool = True) -> list[str]:
    """Return what was done to a motion, and whether its baseline is in doubt."""
    steps = [step for step in motion.treatment if with_scale or not step.startswith("scaled by")]
    remarks = [f"{motion.name}: {'; '.join(steps)}."] if steps else []
    warning = baseline_warning(motion)
    return [*remarks, *([warning] if warning else [])]


#: What is told of a ground motion.
MEASURES = [
    Quantity("record", "name of the ground motion", head="Record", get="name"),
    Quantity("event", "earthquake", get="origin.event", printed=False),
    Quantity("station", "station", get="origin.station", printed=False),
    Quantity("component", "component", head="Component", get="origin.component"),
    Quantity("source", "file, or the package and set", get="origin.source", printed=False),
    Quantity("file_format", "format of the file", get="origin.file_format", printed=False),
    Quantity("processing", "what is already in the values", get="origin.processing", printed=False),
    Quantity("citation", "how the data ask to be cited", get="origin.citation", printed=False),
    Quantity("time_step_s", "time step", SECOND, name="time_step", head="dt", get="time_step"),
    Quantity("duration_s", "time from the first to the last value", SECOND, decimals=1, name="duration", head="length", get="duration"),
    Quantity("points", "number of values", NONE, get="acceleration.size", printed=False),
    Quantity("pga_m_s2", "peak ground acceleration", M_PER_S2, GRAVITY, 3, name="pga", head="PGA", get="peak_acceleration"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, decimals=3, name="pgv", head="PGV", get="peak_velocity"),
    Quantity("pgd_mm", "peak ground displacement", MM, decimals=1, name="pgd", head="PGD", get="peak_displacement"),
    Quantity("arias_intensity_m_s", "Arias intensity", M_PER_S, decimals=2, name="arias_intensity", head="Arias", get=arias_intensity),
    Quantity(
        "significant_duration_s", "time between 5 and 95 % of the Arias intensity", SECOND, decimals=1,
        name="significant_duration", head="D5-95", get=significant_duration,
    ),
    Quantity(
        "cumulative_absolute_velocity_m_s", "cumulative absolute velocity", M_PER_S, decimals=2,
        name="cumulative_absolute_velocity", head="CAV", get=cumulative_absolute_velocity,
    ),
    Quantity("baseline_drift", "velocity at the end over the peak ground velocity", NONE, PERCENT, 1, head="drift", get=baseline_drift),
    Quantity("treatment", "what was done to the values", get="treatment", printed=False),
    Quantity("remarks", "what a reader must know", get=motion_remarks, printed=False),
]  # fmt: skip


def measure(motion: GroundMotion) -> dict[str, Any]:
    """Return all measures of a ground motion, and what is known of it, by keys that end with their units."""
    return Table(tuple(MEASURES), [motion]).objects()[0]
