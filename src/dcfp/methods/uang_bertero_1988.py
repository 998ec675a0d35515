r"""Relative and absolute input energy, and their maxima: Uang and Bertero (1988), Use of energy as a design criterion in earthquake-resistant design.

The relative energy is the work of :math:`-m a_g` on the relative displacement, the absolute one that of the total inertial force on the ground's displacement:

.. math:: E_r = -\int m\,a_g\,v\,dt, \qquad E_a = \int m\,(a + a_g)\,v_g\,dt = E_r + m\,v_g\,(v_g / 2 + v)

The second definition is found in one program's source; the identity follows from the equation of motion. Their formula for the largest input
energy at a given ductility from the duration of strong motion could not be found. What stands here instead is the largest value of the motion's own spectrum.
"""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.analysis import Response
from dcfp.arrays import FloatArray
from dcfp.methods.spectra import EnergySpectrum, input_energy_spectrum
from dcfp.methods.spectra.of_record import DAMPING, PERIODS
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import significant_duration

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
