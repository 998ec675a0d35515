"""The energy balance: Li et al. (2020), Eqs (3)-(6)."""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.schema.notebook import fields_card


@dataclass(frozen=True)
class EnergyBalance:
    """Histories of the energies [N mm], shape (n,).

    Attributes
    ----------
    input
        Relative input energy E, Eq. (4): the work of - m a_g on the relative displacement, of a building summed over base and floors.
    absolute_input
        Absolute input energy, the work that the ground does on the structure (Uang and Bertero 1988).
    kinetic
        E_k of the relative velocity, Eq. (5).
    pendulum, spring, storeys
        Parts of the elastic strain energy E_s: in spring (a), in spring (b), and in the storeys of a building.
    hysteretic
        E_h, dissipated by friction.
    damping
        E_xi, taken by the damping of a building.
    """

    input: FloatArray
    absolute_input: FloatArray
    kinetic: FloatArray
    pendulum: FloatArray
    spring: FloatArray
    hysteretic: FloatArray
    storeys: FloatArray | float = 0.0
    damping: FloatArray | float = 0.0

    @property
    def strain(self) -> FloatArray:
        """Elastic strain energy E_s [N mm]."""
        return self.storeys + self.pendulum + self.spring

    @property
    def residual(self) -> FloatArray:
        """E - E_s - E_k - E_xi - E_h, by which Eq. (6) fails to close [N mm]."""
        return self.input - self.strain - self.kinetic - self.damping - self.hysteretic

    @property
    def relative_residual(self) -> float:
        """Largest residual over the largest input energy [-]."""
        largest = float(np.abs(self.input).max())
        return float(np.abs(self.residual).max()) / largest if largest > 0.0 else 0.0

    def _repr_html_(self) -> str:
        return fields_card(self, "Energies over time [N mm]")


def equivalent_velocity(energy: float, mass: float) -> float:
    """Equivalent velocity V_E = sqrt(2 E / m) of an energy [N mm] and a mass [t], in mm/s (Akiyama 1985)."""
    return math.sqrt(max(2.0 * energy / mass, 0.0))
