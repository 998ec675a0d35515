"""The result of a response history analysis of a building, and its energy balance: Li et al. (2020), Eqs (3)-(6), summed over base and floors."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from dcfp.analysis.building.shear_building import ShearBuilding
from dcfp.analysis.response import Response
from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import building as k
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.notebook import card, fields_card
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import DEGC, M_PER_S, M_PER_S2, MM, MM_PER_S, NONE
from dcfp.system import Bearing, FrictionLaw, Heating
from dcfp.system.plates import mean_temperature

# The energy balance of a building: Li et al. (2020), Eqs (3)-(6), summed over base and floors.


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


@dataclass(frozen=True, eq=False)
class BuildingResponse:
    """Histories, peaks and energies of a building on a bearing, and what they came from.

    Attributes
    ----------
    motion, bearing, friction_law, heating
        What was analysed.
    building
        With the masses that the bearing carries, `ShearBuilding.scaled_to`.
    step
        Fine step of the integration [s]; peaks are looked for at its ends, and where the base turns.
    time
        Of the histories, at the record's samples [s], shape (n,).
    ground_acceleration
        [mm/s2], shape (n,).
    rests
        Whether no more sliding can come.
    elapsed
        Computing time of the march [s].
    """

    motion: GroundMotion
    bearing: Bearing
    friction_law: FrictionLaw
    heating: Heating
    building: ShearBuilding
    step: float
    time: FloatArray
    ground_acceleration: FloatArray
    rests: bool
    elapsed: float
    _lines: FloatArray
    _peaks: FloatArray
    _state: FloatArray
    _resistance: FloatArray

    # ----- histories -----

    @property
    def floor_displacement(self) -> FloatArray:
        """Displacement of base and floors relative to the ground [mm], shape (n, storeys + 1)."""
        return self._lines[:, : self._floors]

    @property
    def floor_velocity(self) -> FloatArray:
        """Velocity of base and floors relative to the ground [mm/s], shape (n, storeys + 1)."""
        return self._lines[:, self._floors : 2 * self._floors]

    @property
    def displacement(self) -> FloatArray:
        """Displacement y of the isolation layer, which is that of the base [mm], shape (n,)."""
        return self.floor_displacement[:, 0]

    @property
    def drift(self) -> FloatArray:
        """Drift of each storey, from below [mm], shape (n, storeys)."""
        return np.diff(self.floor_displacement, axis=1)

    @property
    def elongation(self) -> FloatArray:
        """Elongation of spring (b) [mm], shape (n,)."""
        return self._line(k.LINE_ELONGATION)

    @property
    def friction(self) -> FloatArray:
        """Coefficient of friction [-]: the one at work while sliding, the one to overcome while sticking; shape (n,)."""
        return self._line(k.LINE_FRICTION)

    @property
    def sliding(self) -> FloatArray:
        """Side on which it slides: 1, -1, or 0 while sticking; shape (n,)."""
        return self._line(k.LINE_SIDE)

    @property
    def temperature(self) -> FloatArray:
        """Temperature of the contact [degC]; of two different plates the mean by their share of the travel; shape (n,)."""
        return mean_temperature(self.bearing, self._lines[:, 2 * self._floors + k.LINE_SIZE :])

    @property
    def force(self) -> FloatArray:
        """Horizontal force of the bearing [N], shape (n,)."""
        return (
            self.bearing.restoring_stiffness * self.displacement
            + self.bearing.elastic_stiffness * self.elongation
        )

    @cached_property
    def floor_acceleration(self) -> FloatArray:
        """Absolute acceleration of base and floors [mm/s2], shape (n, storeys + 1)."""
        accelerations = self._lines[:, : 2 * self._floors] @ self._resistance.T
        accelerations[:, 0] -= self.bearing.elastic_stiffness * self.elongation / self.building.masses[0]
        return freeze(accelerations)

    @cached_property
    def energy(self) -> BuildingEnergy:
        """Energies [N mm]."""
        masses, stiffnesses = np.array(self.building.masses), np.array(self.building.stiffnesses)
        total = self.bearing.mass
        return BuildingEnergy(
            input=self._line(k.LINE_INPUT) * total,
            kinetic=0.5 * self.floor_velocity**2 @ masses,
            storeys=0.5 * self.drift**2 @ stiffnesses,
            pendulum=0.5 * self.bearing.restoring_stiffness * self.displacement**2,
            spring=0.5 * self.bearing.elastic_stiffness * self.elongation**2,
            damping=self._line(k.LINE_DAMPED) * total,
            hysteretic=self._line(k.LINE_HYSTERETIC) * total,
        )

    # ----- peaks -----

    @property
    def peak_displacement(self) -> float:
        """Largest displacement y_max of the isolation layer, to either side [mm]."""
        return float(self._peaks[k.PEAK_DRIFT, 0])

    @property
    def peak_drift(self) -> FloatArray:
        """Largest drift of each storey, to either side [mm], shape (storeys,)."""
        return self._peaks[k.PEAK_DRIFT, 1:]

    @property
    def peak_acceleration(self) -> FloatArray:
        """Largest absolute acceleration of base and floors [mm/s2], shape (storeys + 1,)."""
        return self._peaks[k.PEAK_ACCELERATION]

    @property
    def peak_temperature(self) -> float:
        """Highest temperature of the contact of any plate [degC]."""
        return float(self._state[k.PEAK_TEMPERATURE])

    @property
    def input_velocity(self) -> float:
        """Equivalent velocity V_E of the input energy up to the end, sqrt(2 E / m) with the total mass [mm/s]; Akiyama (1985)."""
        return math.sqrt(2.0 * max(float(self._line(k.LINE_INPUT)[-1]), 0.0))

    @property
    def hysteretic_velocity(self) -> float:
        """Equivalent velocity V_Eh of the hysteretic energy up to the end [mm/s]."""
        return math.sqrt(2.0 * max(float(self._line(k.LINE_HYSTERETIC)[-1]), 0.0))

    def __str__(self) -> str:
        return (
            f"{self.motion.name}, {self.building.storeys} storeys: y_max {self.peak_displacement:.1f} mm,"
            f" drift {self.peak_drift.max():.1f} mm, T_max {self.peak_temperature:.0f} degC,"
            f" V_E {self.input_velocity:.0f} mm/s ({'at rest' if self.rests else 'still moving'})"
        )

    @property
    def _floors(self) -> int:
        return self.building.storeys + 1

    def _line(self, column: int) -> FloatArray:
        return self._lines[:, 2 * self._floors + column]

    def _repr_html_(self) -> str:
        facts = {
            "y_max [mm]": self.peak_displacement,
            "largest drift [mm]": float(self.peak_drift.max()),
            "largest acceleration [mm/s2]": float(self.peak_acceleration.max()),
            "T_max [degC]": self.peak_temperature,
            "V_E [mm/s]": self.input_velocity,
            "V_Eh [mm/s]": self.hysteretic_velocity,
            "comes to rest": self.rests,
        }
        return card(f"{self.building.storeys} storeys under {self.motion.name}", facts)


# What is told of a building, beside the rigid structure of the same mass.


class BesideRigid(NamedTuple):
    """A building and the rigid structure on the same bearing under the same ground motion."""

    building: BuildingResponse
    rigid: Response

    @property
    def velocity_ratio(self) -> float | None:
        """V_E of the building over that of the rigid structure [-]."""
        rigid = self.rigid.input_velocity
        return self.building.input_velocity / rigid if rigid > 0.0 else None

    @property
    def remarks(self) -> list[str]:
        """Sentences that a reader must know; of the capacity those of the building."""
        one, capacity = self.building, self.building.bearing.displacement_capacity
        name = one.motion.name
        remarks: list[str] = []
        if capacity is not None and one.peak_displacement > capacity:
            remarks.append(
                f"{name}: the displacement of {one.peak_displacement:.0f} mm exceeds the capacity of {capacity:.0f} mm."
            )
        if not one.rests:
            remarks.append(f"{name}: the building still oscillates at the end of the analysis.")
        return [*remarks, *(remark for remark in self.rigid.remarks if "capacity" not in remark)]


#: What is told of it.
BESIDE_RIGID = [
    Quantity("record", "name of the ground motion", head="Record", get="building.motion.name"),
    Quantity("pgv_m_s", "peak ground velocity", M_PER_S, decimals=3, places=12, head="PGV", get="building.motion.peak_velocity"),
    Quantity("y_max_mm", "largest displacement of the isolation layer", MM, decimals=1, head="y_max", get="building.peak_displacement"),
    Quantity("y_max_rigid_mm", "the same of the rigid structure", MM, decimals=1, head="rigid", get="rigid.peak_displacement"),
    Quantity("V_E_mm_s", "equivalent velocity of the input energy", MM_PER_S, M_PER_S, 3, head="V_E", get="building.input_velocity"),
    Quantity("V_E_rigid_mm_s", "the same of the rigid structure", MM_PER_S, M_PER_S, 3, head="rigid", get="rigid.input_velocity"),
    Quantity("V_E_ratio", "V_E over that of the rigid structure", NONE, decimals=3, head="V_E over\nrigid", get="velocity_ratio", stored=False),
    Quantity("drift_max_mm", "largest drift of a storey", MM, decimals=1, head="drift", get=lambda one: float(one.building.peak_drift.max())),
    Quantity("drifts_mm", "largest drift of each storey", MM, get="building.peak_drift", flat=False, printed=False),
    Quantity("floor_acceleration_max_m_s2", "largest acceleration of a floor", M_PER_S2, decimals=2, head="floor acc.", get=lambda one: float(one.building.peak_acceleration.max())),
    Quantity("floor_accelerations_m_s2", "largest acceleration of each floor", M_PER_S2, get="building.peak_acceleration", flat=False, printed=False),
    Quantity("temperature_max_degC", "highest temperature of the contact", DEGC, get="building.peak_temperature", printed=False),
    Quantity("energy_residual", "residual of the energy balance over the largest input energy", NONE, get="building.energy.relative_residual", printed=False),
    Quantity("rests", "whether it has come to rest", get="building.rests", printed=False),
    Quantity("remarks", "what a reader must know", get="remarks", printed=False),
]  # fmt: skip
