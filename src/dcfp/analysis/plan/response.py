"""The result of an analysis of an isolated building: histories of slab, bearings and floors, peaks and energies."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.plan.model import PlanModel
from dcfp.analysis.result import EnergyBalance
from dcfp.arrays import FloatArray, freeze, integral
from dcfp.kernels import plan_bearing as b
from dcfp.kernels import plan_integrate as k
from dcfp.motion.station import Station
from dcfp.system.plan import Plan

#: Parts of a sample interval at whose ends peaks of the floors are looked for.
_PARTS = 8


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class PlanResponse:
    """Histories, peaks and energies of a building on many bearings.

    Attributes
    ----------
    plan, motion
        What was shaken by what.
    time
        Of the histories [s], shape (n,).
    ground_acceleration
        Shape (n, 2) [mm/s2].
    weight_ratio
        Weight with the vertical acceleration over that at rest, shape (n,).
    elapsed
        Computing time with set-up [s].
    """

    plan: Plan
    motion: Station
    time: FloatArray
    ground_acceleration: FloatArray
    weight_ratio: FloatArray
    lines: FloatArray
    modes: NDArray[np.complex128]
    kept: FloatArray
    model: PlanModel
    tallies: FloatArray
    elapsed: float

    # ----- the slab -----

    @property
    def slab_motion(self) -> FloatArray:
        """Displacement x, y [mm] and rotation [rad] of the slab at the centre of mass, shape (n, 3)."""
        return self.lines[:, :3]

    @property
    def slab_velocity(self) -> FloatArray:
        """Velocity of the slab at the centre of mass [mm/s, mm/s, rad/s], shape (n, 3)."""
        return self.lines[:, 3:6]

    @property
    def peak_displacement(self) -> float:
        """Largest displacement of the centre of mass [mm]."""
        return float(self.model.kernel.watched[0, 2])

    @property
    def corner_displacements(self) -> FloatArray:
        """Largest displacement of each corner of the slab [mm], shape (4,)."""
        return freeze(self.model.kernel.watched[1:, 2])

    @property
    def peak_corner_displacement(self) -> float:
        """Largest displacement of any corner [mm]."""
        return float(self.corner_displacements.max())

    @property
    def peak_rotation(self) -> float:
        """Largest rotation of the slab [rad]."""
        return float(np.abs(self.slab_motion[:, 2]).max())

    def displacement_at(self, place: tuple[float, float]) -> FloatArray:
        """Return the displacement of a point of the slab [mm], shape (n, 2); `place` in the plan [mm]."""
        x, y = np.subtract(place, self.plan.mass_centre)
        turn = self.slab_motion[:, 2]
        return np.column_stack((self.slab_motion[:, 0] - turn * y, self.slab_motion[:, 1] + turn * x))

    @cached_property
    def base_shear(self) -> FloatArray:
        """Force of all bearings on the slab against its displacement, x, y [N] and torque about the centre of mass [N mm], shape (n, 3)."""
        of_friction = self.lines[:, k.LINE_FRICTION : k.LINE_FRICTION + 3]
        of_loads = self.lines[:, k.LINE_LIFTING : k.LINE_LIFTING + 3]
        return freeze(self.slab_motion @ self.model.kernel.stiffness.T + of_friction + of_loads)

    @property
    def peak_base_shear(self) -> float:
        """Largest resultant of the base shear [N]."""
        return float(np.hypot(*self.base_shear[:, :2].T).max())

    @property
    def overturning(self) -> FloatArray:
        """Moments on the loads of the bearings that press where X and where Y are large [N mm], shape (n, 2)."""
        return self.lines[:, k.LINE_TIPPING : k.LINE_TIPPING + 2]

    # ----- the bearings -----

    @cached_property
    def bearing_displacement(self) -> FloatArray:
        """Displacement of each bearing [mm], shape (n, bearings, 2)."""
        turn, arms = self.slab_motion[:, 2:3], self.plan.arms
        x = self.slab_motion[:, 0:1] - turn * arms[:, 1]
        y = self.slab_motion[:, 1:2] + turn * arms[:, 0]
        return freeze(np.stack((x, y), axis=-1))

    @property
    def bearing_load(self) -> FloatArray:
        """Vertical force on each bearing [N], shape (n, bearings)."""
        return self.kept[:, :, b.N]

    @property
    def bearing_friction(self) -> FloatArray:
        """Coefficient of friction of each bearing [-], shape (n, bearings)."""
        return self.kept[:, :, b.MU]

    @property
    def bearing_temperature(self) -> FloatArray:
        """Temperature of the contact of each bearing [degC], the mean of its plates by their share of the travel, shape (n, bearings)."""
        table, constants = self.model.kernel.bearings.kinds, self.model.kernel.bearings.constants
        kinds = table[constants[:, b.KIND].astype(int)]
        second = np.where(kinds[:, b.PLATES] == 2.0, kinds[:, b.SHARE + 1], 0.0)
        first = 1.0 - second
        return first * self.kept[:, :, b.TEMPERATURE] + second * self.kept[:, :, b.TEMPERATURE + 1]

    @cached_property
    def bearing_force(self) -> FloatArray:
        """Horizontal force of each bearing against its displacement [N], shape (n, bearings, 2)."""
        spring = self.plan.elastic_stiffnesses[:, np.newaxis] * self.kept[:, :, [b.E_X, b.E_Y]]
        pendulum = (self.bearing_load / self.plan.radii)[:, :, np.newaxis] * self.bearing_displacement
        return freeze(spring + pendulum)

    def _bearing_peak(self, column: int) -> FloatArray:
        return freeze(self.model.kernel.bearings.state[:, column])

    @property
    def peak_bearing_displacement(self) -> FloatArray:
        """Largest displacement of each bearing [mm], shape (bearings,)."""
        return self._bearing_peak(b.FURTHEST)

    @property
    def least_load(self) -> FloatArray:
        """Smallest load of each bearing [N], shape (bearings,)."""
        return self._bearing_peak(b.LEAST)

    @property
    def largest_load(self) -> FloatArray:
        """Largest load of each bearing [N], shape (bearings,)."""
        return self._bearing_peak(b.LARGEST)

    @property
    def peak_temperature(self) -> FloatArray:
        """Highest temperature of any plate of each bearing [degC], shape (bearings,)."""
        return self._bearing_peak(b.HOTTEST)

    @property
    def travel(self) -> FloatArray:
        """Length of the path over which each bearing has slid [mm], shape (bearings,)."""
        return self._bearing_peak(b.TRAVEL)

    @property
    def uplift_time(self) -> FloatArray:
        """Time for which each bearing has carried nothing [s], shape (bearings,)."""
        return self._bearing_peak(b.LIFTED)

    # ----- the floors -----

    @cached_property
    def floor_displacement(self) -> FloatArray:
        """Displacement of slab and floors on the vertical axis through the centre of mass relative to the ground, x, y [mm] and rotation, shape (n, floors + 1, 3)."""
        return self._of_levels(self.model.modes.displacement)

    @cached_property
    def floor_velocity(self) -> FloatArray:
        """The same for velocities."""
        return self._of_levels(self.model.modes.velocity)

    def _of_levels(self, rows: NDArray[np.complex128]) -> FloatArray:
        found = (self.modes @ rows.T).real
        slab = found[:, np.newaxis, :3]
        shapes = self.plan.structure.modes[1]
        floors = (found[:, 3:] @ shapes.T).reshape(len(found), -1, 3)
        return freeze(np.concatenate((slab, slab + floors), axis=1))

    @cached_property
    def floor_force(self) -> FloatArray:
        """Force of the storeys on each floor above the slab, against its displacement, x, y [N] and torque [N mm], shape (n, floors, 3)."""
        return freeze(self._of_floors(self.modes))

    def _of_floors(self, modes: NDArray[np.complex128]) -> FloatArray:
        """Return the forces of the storeys for complex modes, or how they change for the modes' derivatives, shape (n, floors, 3)."""
        structure, building, own = self.plan.structure, self.model.building, self.model.modes
        square, damping = np.diag(building.stiffness)[3:], np.diag(building.damping)[3:]
        rows = square[:, np.newaxis] * own.displacement[3:] + damping[:, np.newaxis] * own.velocity[3:]
        weighted = structure.mass @ structure.modes[1]
        return ((modes @ rows.T).real @ weighted.T).reshape(len(modes), -1, 3)

    def _accelerated(self, forces: FloatArray) -> FloatArray:
        """Return the absolute accelerations of the floors under forces of the storeys, shape (n, floors, 3)."""
        by_floor = np.linalg.solve(self.plan.structure.mass, -forces.reshape(len(forces), -1).T)
        return np.asarray(by_floor.T, dtype=np.float64).reshape(forces.shape)

    @cached_property
    def floor_acceleration(self) -> FloatArray:
        """Absolute acceleration of slab and floors on the axis through the centre of mass, x, y [mm/s2] and rotation [rad/s2], shape (n, floors + 1, 3)."""
        plan, forces = self.plan, self.floor_force
        slab = -(self.base_shear - forces.sum(axis=1)) / np.array(
            [plan.slab_mass, plan.slab_mass, plan.slab_inertia]
        )
        floors = self._accelerated(forces) if plan.storeys else forces
        return freeze(np.concatenate((slab[:, np.newaxis], floors), axis=1))

    @property
    def peak_floor_acceleration(self) -> FloatArray:
        """Largest absolute acceleration of slab and floors on the axis through the centre of mass [mm/s2], shape (floors + 1,): of floors also between the samples."""
        slab = np.hypot(*self.floor_acceleration[:, 0, :2].T).max(keepdims=True)
        if not self.plan.storeys:
            return freeze(slab)
        slopes = self._accelerated(
            self._of_floors(self.modes * self.model.kernel.linear.roots + self._pushes)
        )
        return freeze(
            np.concatenate((slab, _largest(self.floor_acceleration[:, 1:], slopes, float(self.time[1]))))
        )

    @property
    def _pushes(self) -> NDArray[np.complex128]:
        """What drives each complex mode at the samples, shape (n, modes)."""
        forces = (
            self.lines[:, k.LINE_FRICTION : k.LINE_FRICTION + 3]
            + self.lines[:, k.LINE_LIFTING : k.LINE_LIFTING + 3]
        )
        return np.column_stack((-forces, self.ground_acceleration)) @ self.model.kernel.linear.gains

    @cached_property
    def drift(self) -> FloatArray:
        """Drift of each storey on the axis through the centre of mass, x, y [mm] and rotation, from below, shape (n, storeys, 3)."""
        return freeze(np.diff(self.floor_displacement, axis=1))

    @property
    def peak_drift(self) -> FloatArray:
        """Largest drift of each storey on the axis through the centre of mass [mm], from below, shape (storeys,), also between the samples."""
        return freeze(_largest(self.drift, np.diff(self.floor_velocity, axis=1), float(self.time[1])))

    # ----- energies -----

    @cached_property
    def energy(self) -> EnergyBalance:
        """Energies [N mm]."""
        put_in, hysteretic, lifting, damped, _, stored = self.lines[
            :, k.LINE_ENERGIES : k.LINE_ENERGIES + 6
        ].T
        building, modes = self.model.building, self.model.modes
        coordinates, rates = (self.modes @ modes.displacement.T).real, (self.modes @ modes.velocity.T).real
        slab, above = coordinates[:, :3], coordinates[:, 3:]
        ground = integral(self.ground_acceleration, float(self.time[1]))
        momentum = rates @ building.mass[:, :2]
        of_ground = (ground * (0.5 * self.plan.total_mass * ground + momentum)).sum(axis=1)
        return EnergyBalance(
            input=put_in,
            absolute_input=put_in + of_ground,
            kinetic=0.5 * ((rates @ building.mass) * rates).sum(axis=1),
            pendulum=0.5 * ((slab @ self.model.kernel.stiffness) * slab).sum(axis=1),
            spring=stored,
            hysteretic=hysteretic,
            storeys=0.5 * above**2 @ np.diag(building.stiffness)[3:],
            damping=damped,
            lifting=lifting,
        )

    @property
    def slip_work(self) -> float:
        """Sum of mu N times the slip of all bearings [N mm], which the hysteretic energy of the balance equals but for the error of the steps."""
        return float(self.tallies[k.RUBBED])

    @property
    def steps(self) -> int:
        """Number of steps."""
        return int(self.tallies[k.STEPS])


def _largest(values: FloatArray, slopes: FloatArray, interval: float) -> FloatArray:
    """Return the largest resultant of x and y over time, also between samples, by cubics through values and slopes; of arrays (n, m, 3), shape (m,)."""
    v, d = values[..., :2], interval * slopes[..., :2]
    found = np.hypot(v[..., 0], v[..., 1]).max(axis=0)
    for part in np.arange(1, _PARTS) / _PARTS:
        rest = 1.0 - part
        there = (
            (1.0 + 2.0 * part) * rest**2 * v[:-1] + part**2 * (3.0 - 2.0 * part) * v[1:]
            + part * rest**2 * d[:-1] - part**2 * rest * d[1:]
        )  # fmt: skip
        found = np.maximum(found, np.hypot(there[..., 0], there[..., 1]).max(axis=0))
    return found
