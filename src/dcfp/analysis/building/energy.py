"""The energy balance of a building: Li et al. (2020), Eqs (3)-(6), summed over base and floors."""

from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.schema.notebook import fields_card


@dataclass(frozen=True)
class BuildingEnergy:
    """Histories of the energies [N mm], shape (n,).

    Attributes
    ----------
    input
        Relative input energy E, the work of - m_i a_g on the relative displacements.
    kinetic
        E_k of the relative velocities.
    storeys, pendulum, spring
        Parts of the elastic strain energy E_s: in the storeys, in spring (a) and in spring (b).
    damping
        E_xi, taken by the superstructure's damping.
    hysteretic
        E_h, dissipated by friction.
    """

    input: FloatArray
    kinetic: FloatArray
    storeys: FloatArray
    pendulum: FloatArray
    spring: FloatArray
    damping: FloatArray
    hysteretic: FloatArray

    @property
    def strain(self) -> FloatArray:
        """Elastic strain energy E_s [N mm]."""
        return self.storeys + self.pendulum + self.spring

    @property
    def residual(self) -> FloatArray:
        """E - E_s - E_k - E_xi - E_h, by which the balance fails to close [N mm]."""
        return self.input - self.strain - self.kinetic - self.damping - self.hysteretic

    @property
    def relative_residual(self) -> float:
        """Largest residual over the largest input energy [-]."""
        largest = float(np.abs(self.input).max())
        return float(np.abs(self.residual).max()) / largest if largest > 0.0 else 0.0

    def _repr_html_(self) -> str:
        return fields_card(self, "Energies over time [N mm]")
