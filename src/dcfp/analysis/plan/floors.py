"""Histories and peaks of the floors above a slab on bearings."""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.plan.slab import SlabResponse
from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import plan_integrate as k

#: Parts of a sample interval at whose ends peaks of the floors are looked for.
_PARTS = 8


class FloorsResponse(SlabResponse):
    """Histories and peaks of slab and floors."""

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

    @cached_property
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

    @cached_property
    def peak_drift(self) -> FloatArray:
        """Largest drift of each storey on the axis through the centre of mass [mm], from below, shape (storeys,), also between the samples."""
        return freeze(_largest(self.drift, np.diff(self.floor_velocity, axis=1), float(self.time[1])))

    @property
    def drift_ratios(self) -> list[float | None]:
        """Largest drift of each storey over its height, from below [-]; None where that is not given."""
        heights = [one.height for one in self.plan.storeys]
        drifts = self.peak_drift.tolist()
        return [drift / h if h > 0.0 else None for drift, h in zip(drifts, heights, strict=True)]


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
