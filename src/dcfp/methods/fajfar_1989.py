"""The largest input energy from duration and peaks of the ground motion: Fajfar, Vidic and Fischinger (1989).

The formula is unconfirmed: no source that could be read prints it. Their paper of 1990 measures damage by v_g t_D^0.25, whose square has the same powers of
velocity and duration, which agrees but proves nothing.
"""

import math
from dataclasses import dataclass

from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import significant_duration

#: Factor of the formula [s^0.5]; unconfirmed.
FACTOR = 2.2
UNCONFIRMED = ("the formula E / m = 2.2 t_D^0.5 PGA PGV of Fajfar, Vidic and Fischinger (1989)",)


@dataclass(frozen=True)
class MaximumInputEnergy:
    """The largest input energy over all periods, per unit mass.

    Attributes
    ----------
    energy
        E / m [mm2/s2].
    duration
        Significant duration t_D, from 5 to 95 % of the Arias intensity [s].
    unconfirmed
        What in it could not be confirmed.
    """

    energy: float
    duration: float
    unconfirmed: tuple[str, ...] = UNCONFIRMED

    @property
    def equivalent_velocity(self) -> float:
        """V_E = sqrt(2 E / m) [mm/s]."""
        return math.sqrt(2.0 * self.energy)


def maximum_input_energy(motion: GroundMotion) -> MaximumInputEnergy:
    r"""Return the largest input energy that a ground motion puts into an oscillator of any period.

    .. math:: E_i / m = 2.2\,\sqrt{t_D}\,\mathrm{PGA}\,\mathrm{PGV}

    with the significant duration t_D (Trifunac and Brady 1975) [s], PGA [mm/s2] and PGV [mm/s].
    """
    t_D = significant_duration(motion)
    return MaximumInputEnergy(FACTOR * math.sqrt(t_D) * motion.peak_acceleration * motion.peak_velocity, t_D)
