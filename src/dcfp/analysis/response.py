"""The result of a response history analysis."""

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

from dcfp.analysis.energy import EnergyBalance, equivalent_velocity
from dcfp.analysis.kernel_input import State
from dcfp.analysis.status import Status
from dcfp.analysis.validity import validity_remarks
from dcfp.arrays import FloatArray
from dcfp.kernels import march as m
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.notebook import card, with_units
from dcfp.system import Bearing, FrictionLaw, Heating
from dcfp.system.plates import mean_temperature
from dcfp.system.profiles import Profiles
from dcfp.system.validity import LARGEST_ANGLE

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Settings:
    """How finely and how far the analysis went; see `dcfp.respond`."""

    tail: float | None
    tolerance: float
    step: float | None
    profile_every: int | None


@dataclass(frozen=True)
class Histories:
    """Histories at equal steps; ``lines`` is what the kernels wrote, a row for each time."""

    time: FloatArray
    ground_acceleration: FloatArray
    ground_velocity: FloatArray
    lines: FloatArray


@dataclass(frozen=True, eq=False)
class Response:
    """Histories, peaks and energies of a rigid structure on a bearing, and what they came from."""

    motion: GroundMotion
    bearing: Bearing
    friction_law: FrictionLaw
    heating: Heating
    settings: Settings
    histories: Histories
    final_state: State
    rests: bool
    profiles: Profiles | None
    elapsed: float

    # ----- histories, shape (n,) -----

    @property
    def time(self) -> FloatArray:
        """Time [s]."""
        return self.histories.time

    @property
    def ground_acceleration(self) -> FloatArray:
        """Ground acceleration a_g [mm/s2]."""
        return self.histories.ground_acceleration

    @property
    def ground_velocity(self) -> FloatArray:
        """Absolute velocity of the ground v_g [mm/s]."""
        return self.histories.ground_velocity

    @property
    def displacement(self) -> FloatArray:
        """Relative displacement y [mm]."""
        return self._line(m.DISPLACEMENT)

    @property
    def velocity(self) -> FloatArray:
        """Relative velocity v [mm/s]."""
        return self._line(m.VELOCITY)

    @property
    def structure_velocity(self) -> FloatArray:
        """Absolute velocity of the structure v_u = v + v_g [mm/s]: Li et al. (2020), Eq. (13)."""
        return self.velocity + self.ground_velocity

    @property
    def elongation(self) -> FloatArray:
        """Elongation of spring (b), y - O_Y [mm]."""
        return self._line(m.ELONGATION)

    @property
    def friction(self) -> FloatArray:
        """Coefficient of friction [-]: the one at work while sliding, the one to overcome while sticking."""
        return self._line(m.FRICTION)

    @property
    def sliding(self) -> FloatArray:
        """Side on which it slides: 1, -1, or 0 while sticking."""
        return self._line(m.SIDE)

    @property
    def temperature(self) -> FloatArray:
        """Temperature of the contact [degC]; of two different plates the mean by their share of the travel."""
        return mean_temperature(self.bearing, self.histories.lines[:, m.TEMPERATURE :])

    @property
    def force(self) -> FloatArray:
        """Horizontal force of the bearing [N]."""
        pendulum = self.bearing.restoring_stiffness * self.displacement
        return pendulum + self.bearing.elastic_stiffness * self.elongation

    @property
    def structure_acceleration(self) -> FloatArray:
        """Absolute acceleration of the structure [mm/s2]."""
        return -self.force / self.bearing.mass

    @cached_property
    def energy(self) -> EnergyBalance:
        """Energies [N mm]."""
        return EnergyBalance.of(
            self.bearing,
            self.displacement,
            self.velocity,
            self.elongation,
            self.ground_velocity,
            self._line(m.INPUT) * self.bearing.mass,
            self._line(m.HYSTERETIC) * self.bearing.mass,
        )

    def _line(self, column: int) -> FloatArray:
        return self.histories.lines[:, column]

    # ----- peaks -----

    @property
    def peak_displacement(self) -> float:
        """Largest displacement y_max, to either side [mm]."""
        return float(self.final_state.march[m.PEAK_DISPLACEMENT])

    @property
    def peak_change(self) -> float:
        """Largest change of displacement between two successive peaks, dy_max [mm]; Li et al. (2020), section 6.1."""
        return float(self.final_state.march[m.PEAK_CHANGE])

    @property
    def peak_velocity(self) -> float:
        """Largest relative velocity at the ends of steps [mm/s]."""
        return float(self.final_state.march[m.PEAK_VELOCITY])

    @property
    def peak_force(self) -> float:
        """Largest horizontal force at the ends of steps [N]."""
        return float(self.final_state.march[m.PEAK_FORCE]) * self.bearing.mass

    @property
    def peak_temperature(self) -> float:
        """Highest temperature of the contact of any plate [degC]."""
        return float(self.final_state.march[m.PEAK_TEMPERATURE])

    @property
    def least_friction(self) -> float:
        """Smallest coefficient of friction while sliding [-]; where it never slides, the one at rest at the start."""
        least = float(self.final_state.march[m.LEAST_FRICTION])
        return least if math.isfinite(least) else float(self.friction[0])

    @property
    def residual_displacement(self) -> float:
        """Displacement at which it stays when the last elastic oscillation has died away [mm]."""
        stuck = float(self.displacement[-1] - self.elongation[-1])
        elastic = self.bearing.elastic_stiffness
        return stuck * elastic / (elastic + self.bearing.restoring_stiffness)

    @property
    def input_velocity(self) -> float:
        """Equivalent velocity V_E of the input energy up to the end [mm/s]; an analysis that was taken up again counts on."""
        return equivalent_velocity(float(self.energy.input[-1]), self.bearing.mass)

    @property
    def hysteretic_velocity(self) -> float:
        """Equivalent velocity V_Eh of the hysteretic energy up to the end [mm/s], counted as `input_velocity`."""
        return equivalent_velocity(float(self.energy.hysteretic[-1]), self.bearing.mass)

    @property
    def steps(self) -> int:
        """Number of steps that the integration took."""
        return int(self.final_state.march[m.STEPS])

    @property
    def status(self) -> Status:
        """How the analysis ended."""
        capacity = self.bearing.displacement_capacity
        if capacity is not None and self.peak_displacement > capacity:
            return Status.BEYOND_CAPACITY
        return Status.OK if self.rests else Status.STILL_MOVING

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences that a reader of the peaks must know."""
        remarks: list[str] = []
        capacity = self.bearing.displacement_capacity
        if capacity is not None and self.peak_displacement > capacity:
            note = f" ({self.bearing.capacity_note})" if self.bearing.capacity_note else ""
            remarks.append(
                f"{self.motion.name}: the displacement of {self.peak_displacement:.0f} mm exceeds"
                f" the capacity of {capacity:.0f} mm{note}."
            )
        far = LARGEST_ANGLE * self.bearing.effective_radius
        if self.peak_displacement > far:
            remarks.append(
                f"{self.motion.name}: the displacement of {self.peak_displacement:.0f} mm exceeds {far:.0f} mm, half of the effective radius,"
                " where the pendulum's force is no longer linear and a plate is hardly as large."
            )
        if not self.rests:
            remarks.append(
                f"{self.motion.name}: it still moves at the end, so the residual displacement is not final."
            )
        remarks.extend(validity_remarks(self))
        return tuple(remarks)

    # ----- forms -----

    def to_dataset(self) -> "xarray.Dataset":
        """Return histories, peaks and provenance as a data set with units."""
        from dcfp.analysis.dataset import dataset

        return dataset(self)

    def summary(self) -> dict[str, float | str]:
        """Return the peaks with their units in their names, ready for JSON."""
        from dcfp.analysis.summary import summary

        return summary(self)

    def __str__(self) -> str:
        return (
            f"{self.motion.name}: y_max {self.peak_displacement:.1f} mm, F_max {self.peak_force / 1e3:.0f} kN,"
            f" T_max {self.peak_temperature:.0f} degC, V_E {self.input_velocity:.0f} mm/s ({self.status.value})"
        )

    def _repr_html_(self) -> str:
        return card(f"Response to {self.motion.name}", with_units(self.summary()), remarks=self.remarks)
