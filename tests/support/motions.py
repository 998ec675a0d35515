"""Ground motions that tests make: the near-fault pulse of Mavroeidis and Papageorgiou, and a motion without its instrument's offset."""

import math
from dataclasses import replace

import numpy as np

from dcfp.motion.ground_motion import GroundMotion


def mavroeidis_papageorgiou(
    amplitude: float,
    frequency: float,
    oscillation: float,
    *,
    phase: float = 0.0,
    peak_time: float | None = None,
    duration: float | None = None,
    time_step: float | None = None,
) -> GroundMotion:
    r"""Return the near-fault velocity pulse of Mavroeidis and Papageorgiou (2003), by the exact derivative of its velocity.

    .. math::
        v(t) = \frac{A}{2}\left[1 + \cos\frac{2\pi f_p}{\gamma}(t-t_0)\right]
               \cos\left[2\pi f_p (t-t_0) + \nu\right], \quad |t - t_0| \le \frac{\gamma}{2 f_p}

    Parameters
    ----------
    amplitude
        :math:`A`, the amplitude of the envelope of the velocity [mm/s]; PGV equals it where the phase is 0.
    frequency
        :math:`f_p`, the prevailing frequency [Hz].
    oscillation
        :math:`\gamma`, which sets how many cycles there are [-]; greater than 1.
    phase
        :math:`\nu` [rad]; 0 gives a symmetric and :math:`\pm\pi/2` an antisymmetric velocity.
    peak_time, duration, time_step
        :math:`t_0`, by default the earliest; length, by default to the end of the pulse; and interval, by default a 200th of a period [s].
    """
    half = 0.5 * oscillation / frequency
    centre = half if peak_time is None else peak_time
    length = centre + half if duration is None else duration
    step = 1.0 / frequency / 200 if time_step is None else time_step
    time = np.arange(math.ceil(length / step * (1.0 - 1e-9)) + 1) * step - centre
    slow = 2.0 * math.pi * frequency / oscillation * time
    fast = 2.0 * math.pi * frequency * time + phase
    shape = np.sin(slow) * np.cos(fast) + oscillation * np.sin(fast) * (1.0 + np.cos(slow))
    values = np.where(np.abs(slow) < math.pi, -amplitude * math.pi * frequency / oscillation * shape, 0.0)
    return GroundMotion(values, step, "pulse")


def without_leading_mean(motion: GroundMotion, duration: float) -> GroundMotion:
    """Return a motion without the mean of its first part [s], the noise before the first arrival."""
    points = max(1, round(duration / motion.time_step))
    return replace(motion, acceleration=motion.acceleration - motion.acceleration[:points].mean())
