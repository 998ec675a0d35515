r"""Relative and absolute input energy, and their maxima: Uang and Bertero (1988), Use of energy as a design criterion in earthquake-resistant design.

The relative energy is the work of :math:`-m a_g` on the relative displacement, the absolute one that of the total inertial force on the ground's displacement:

.. math:: E_r = -\int m\,a_g\,v\,dt, \qquad E_a = \int m\,(a + a_g)\,v_g\,dt = E_r + m\,v_g\,(v_g / 2 + v)

The second definition is found in one program's source; the identity follows from the equation of motion. Their formula for the largest input
energy at a given ductility from the duration of strong motion could not be found. What stands here instead is the largest value of the motion's own spectrum.
"""

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from dcfp.analysis import Response
from dcfp.arrays import FloatArray
from dcfp.methods.fajfar_1989 import MaximumInputEnergy, maximum_input_energy
from dcfp.methods.spectra import EnergySpectrum, input_energy_spectrum
from dcfp.methods.spectra.of_record import DAMPING, PERIODS
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import significant_duration
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import M_PER_S, MM_PER_S, SECOND

UNCONFIRMED = (
    "the formula of Uang and Bertero (1988) for the largest input energy at a ductility, in place of which the largest of the elastic spectrum is taken",
)


@dataclass(frozen=True)
class InputEnergies:
    """Largest input energies at any time, per unit mass.

    Attributes
    ----------
    relative, absolute
        [mm2/s2].
    """

    relative: float
    absolute: float

    @property
    def relative_velocity(self) -> float:
        """V_E = sqrt(2 E / m) of the relative energy [mm/s]."""
        return math.sqrt(2.0 * max(self.relative, 0.0))

    @property
    def absolute_velocity(self) -> float:
        """V_E of the absolute energy [mm/s]."""
        return math.sqrt(2.0 * max(self.absolute, 0.0))


@dataclass(frozen=True)
class MaximumInputEnergies:
    """The largest of an elastic input energy spectrum.

    Attributes
    ----------
    energies
        The largest over the periods, each at its own.
    relative_period, absolute_period
        Periods at which they are reached [s].
    damping
        Ratio of critical damping [-].
    duration
        Significant duration of the motion, from 5 to 95 % of its Arias intensity [s].
    unconfirmed
        What could not be confirmed, and what stands in its place.
    """

    energies: InputEnergies
    relative_period: float
    absolute_period: float
    damping: float
    duration: float
    unconfirmed: tuple[str, ...] = UNCONFIRMED


def elastic_input(motion: GroundMotion, period: float, damping: float = DAMPING) -> InputEnergies:
    """Return the input energies of an elastic oscillator of a period [s] and a damping ratio [-].

    Raises
    ------
    InputError
        If the period or the damping is out of range.
    """
    spectrum = input_energy_spectrum(motion, np.array([period]), damping)
    return InputEnergies(float(spectrum.relative[0]), float(spectrum.absolute[0]))


def sliding_input(response: Response) -> InputEnergies:
    """Return the input energies of the structure on its bearing, from a response history analysis."""
    energy, mass = response.energy, response.bearing.mass
    return InputEnergies(float(energy.input.max()) / mass, float(energy.absolute_input.max()) / mass)


def maximum_input_energies(
    motion: GroundMotion, damping: float = DAMPING, periods: FloatArray = PERIODS
) -> MaximumInputEnergies:
    """Return the largest elastic input energies over periods [s], at a damping ratio [-].

    Raises
    ------
    InputError
        If a period or the damping is out of range.
    """
    spectrum: EnergySpectrum = input_energy_spectrum(motion, periods, damping)
    r, a = int(np.argmax(spectrum.relative)), int(np.argmax(spectrum.absolute))
    return MaximumInputEnergies(
        energies=InputEnergies(float(spectrum.relative[r]), float(spectrum.absolute[a])),
        relative_period=float(spectrum.periods[r]),
        absolute_period=float(spectrum.periods[a]),
        damping=damping,
        duration=significant_duration(motion),
    )


# What is told of the largest input energies of a motion, with the formula of Fajfar et al. (1989) beside them.


class LargestInput(NamedTuple):
    """A ground motion, its largest input energies over the periods, and those of the formula."""

    motion: GroundMotion
    found: MaximumInputEnergies
    formula: MaximumInputEnergy


def largest_input(motion: GroundMotion) -> LargestInput:
    """Return the largest input energies of a motion at the usual damping ratio."""
    return LargestInput(motion, maximum_input_energies(motion), maximum_input_energy(motion))


LARGEST_INPUT = [
    Quantity("record", "name of the ground motion", head="Record", get="motion.name"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, decimals=3, places=12, head="PGV", get="motion.peak_velocity"),
    Quantity("V_E_max_mm_s", "equivalent velocity of the largest relative input energy", MM_PER_S, M_PER_S, 3, head="V_E max", get=lambda one: (2.0 * one.found.energies.relative) ** 0.5),
    Quantity("at_period_s", "period of it", SECOND, decimals=2, head="at T", get="found.relative_period"),
    Quantity("V_E_absolute_max_mm_s", "equivalent velocity of the largest absolute input energy", MM_PER_S, M_PER_S, 3, head="V_E abs. max", get=lambda one: (2.0 * one.found.energies.absolute) ** 0.5),
    Quantity("at_period_absolute_s", "period of it", SECOND, decimals=2, head="at T", get="found.absolute_period"),
    Quantity("significant_duration_s", "time between 5 and 95 % of the Arias intensity", SECOND, decimals=1, head="t_D", get="found.duration"),
    Quantity("V_E_fajfar_1989_unconfirmed_mm_s", "equivalent velocity by Fajfar et al. (1989)", MM_PER_S, M_PER_S, 3, head="Fajfar", get="formula.equivalent_velocity"),
]  # fmt: skip
