r"""Relative and absolute input energy, and their maxima: Uang and Bertero (1988), Use of energy as a design criterion in earthquake-resistant design.

The relative energy is the work of :math:`-m a_g` on the relative displacement, the absolute one that of the total inertial force on the ground's displacement:

.. math:: E_r = -\int m\,a_g\,v\,dt, \qquad E_a = \int m\,(a + a_g)\,v_g\,dt = E_r + m\,v_g\,(v_g / 2 + v)

The second definition is found in one program's source; the identity follows from the equation of motion. Their formula for the largest input
energy at a given ductility from the duration of strong motion could not be found. What stands here instead is the largest value of the motion's own spectrum.

Beside it stands the formula of Fajfar, Vidic and Fischinger (1989). It is unconfirmed: no source that could be read prints it. Their paper of 1990 measures
damage by v_g t_D^0.25, whose square has the same powers of velocity and duration, which agrees but proves nothing.
"""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.methods.spectra import input_energy_spectrum
from dcfp.methods.spectra.of_record import DAMPING, PERIODS
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import significant_duration
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import M_PER_S, MM_PER_S, SECOND

#: Factor of the formula of Fajfar, Vidic and Fischinger (1989) [s^0.5]; unconfirmed.
FACTOR = 2.2
UNCONFIRMED = (
    "the formula of Uang and Bertero (1988) for the largest input energy at a ductility, in place of which the largest of the elastic spectrum is taken",
    "the formula E / m = 2.2 t_D^0.5 PGA PGV of Fajfar, Vidic and Fischinger (1989)",
)


@dataclass(frozen=True)
class LargestInput:
    """The largest input energies of a ground motion over the periods of its elastic spectra, per unit mass."""

    motion: GroundMotion
    relative: float  #: [mm2/s2]
    absolute: float  #: [mm2/s2]
    relative_period: float  #: at which it is reached [s]
    absolute_period: float  #: at which it is reached [s]
    damping: float  #: ratio of critical damping [-]
    duration: float  #: significant duration t_D of the motion, from 5 to 95 % of its Arias intensity [s]
    unconfirmed: tuple[str, ...] = UNCONFIRMED  #: what could not be confirmed, and what stands in its place

    @property
    def formula(self) -> float:
        r"""Largest input energy of any oscillator after Fajfar et al. (1989) [mm2/s2]: :math:`E_i / m = 2.2\,\sqrt{t_D}\,\mathrm{PGA}\,\mathrm{PGV}`."""
        return FACTOR * math.sqrt(self.duration) * self.motion.peak_acceleration * self.motion.peak_velocity


def largest_input(
    motion: GroundMotion, damping: float = DAMPING, periods: FloatArray = PERIODS
) -> LargestInput:
    """Return the largest elastic input energies over periods [s], at a damping ratio [-].

    Raises
    ------
    InputError
        If a period or the damping is out of range.
    """
    spectrum = input_energy_spectrum(motion, periods, damping)
    r, a = int(np.argmax(spectrum.relative)), int(np.argmax(spectrum.absolute))
    return LargestInput(
        motion=motion,
        relative=float(spectrum.relative[r]),
        absolute=float(spectrum.absolute[a]),
        relative_period=float(spectrum.periods[r]),
        absolute_period=float(spectrum.periods[a]),
        damping=damping,
        duration=significant_duration(motion),
    )


LARGEST_INPUT = [
    Quantity("record", "name of the ground motion", head="Record", get="motion.name"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, decimals=3, places=12, head="PGV", get="motion.peak_velocity"),
    Quantity("V_E_max_mm_s", "equivalent velocity of the largest relative input energy", MM_PER_S, M_PER_S, 3, head="V_E max", get=lambda one: (2.0 * one.relative) ** 0.5),
    Quantity("at_period_s", "period of it", SECOND, decimals=2, head="at T", get="relative_period"),
    Quantity("V_E_absolute_max_mm_s", "equivalent velocity of the largest absolute input energy", MM_PER_S, M_PER_S, 3, head="V_E abs. max", get=lambda one: (2.0 * one.absolute) ** 0.5),
    Quantity("at_period_absolute_s", "period of it", SECOND, decimals=2, head="at T", get="absolute_period"),
    Quantity("significant_duration_s", "time between 5 and 95 % of the Arias intensity", SECOND, decimals=1, head="t_D", get="duration"),
    Quantity("V_E_fajfar_1989_unconfirmed_mm_s", "equivalent velocity by Fajfar et al. (1989)", MM_PER_S, M_PER_S, 3, head="Fajfar", get=lambda one: math.sqrt(2.0 * one.formula)),
]  # fmt: skip
