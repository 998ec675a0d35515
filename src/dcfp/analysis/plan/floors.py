"""Histories and peaks of the floors above a slab on bearings."""

from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.plan.slab import SlabResponse
from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import plan_end as e
from dcfp.kernels import plan_integrate as k

#: Parts of a sample interval at whose ends peaks of the floors are looked for.
_PARTS = 8
#: Largest value of s (1 - s)^2, by which a slope moves a cubic.
_BULGE = 4.0 / 27.0


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
        above = self.plan.structure
        floors = above.modes[1] @ rows[3:] + above.rigid @ rows[:3]
        return self._told(np.concatenate((rows[:3], floors)), self.modes)

    def _told(self, rows: NDArray[np.complex128], modes: NDArray[np.complex128]) -> FloatArray:
        """Return rows of complex modes times these, in x, y and rotation, shape (n, rows / 3, 3)."""
        return freeze(self.of_modes(rows, modes).reshape(len(modes), -1, 3))

    @cached_property
    def _of_floors(self) -> NDArray[np.complex128]:
        """Absolute accelerations of the floors above the slab by the complex modes, shape (3 floors, modes)."""
        building, own = self.model.building, self.model.modes
        square, damping = np.diag(building.stiffness)[3:], np.diag(building.damping)[3:]
        pushes = square[:, np.newaxis] * own.displacement[3:] + damping[:, np.newaxis] * own.velocity[3:]
        return -self.plan.structure.modes[1] @ pushes

    @cached_property
    def floor_force(self) -> FloatArray:
        """Force of the storeys on each floor above the slab, against its displacement, x, y [N] and torque [N mm], shape (n, floors, 3)."""
        return self._told(-self.plan.structure.mass @ self._of_floors, self.modes)

    @cached_property
    def floor_acceleration(self) -> FloatArray:
        """Absolute acceleration of slab and floors on the axis through the centre of mass, x, y [mm/s2] and rotation [rad/s2], shape (n, floors + 1, 3)."""
        plan, above = self.plan, self.plan.structure
        masses = np.array([plan.slab_mass, plan.slab_mass, plan.slab_inertia])
        floors = self._told(self._of_floors, self.modes)
        of_floors = floors.reshape(len(floors), -1) @ (above.mass @ above.rigid)
        slab = -(self.base_shear + of_floors) / masses
        return freeze(np.concatenate((slab[:, np.newaxis], floors), axis=1))

    @cached_property
    def peak_floor_acceleration(self) -> FloatArray:
        """Largest absolute acceleration of slab and floors on the axis through the centre of mass, also between the samples [mm/s2], shape (floors + 1,)."""
        slab = np.array([self.tallies[e.ACCELERATION]])
        changes = self._told(self._of_floors, self.modes * self.model.kernel.linear.roots + self._pushes)
        floors = _largest(self.floor_acceleration[:, 1:], changes, float(self.time[1]))
        return freeze(np.concatenate((slab, floors)))

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
    v, d = (np.ascontiguousarray(np.moveaxis(one[..., :2], 0, 1)) for one in (values, interval * slopes))
    far, fast = np.hypot(v[..., 0], v[..., 1]), np.hypot(d[..., 0], d[..., 1])
    found = far.max(axis=1)
    # beyond the larger end a cubic goes no further than this
    reach = np.maximum(far[:, :-1], far[:, 1:]) + _BULGE * (fast[:, :-1] + fast[:, 1:])
    where, cell = np.nonzero(reach > found[:, np.newaxis])
    before, after, leaving, arriving = v[where, cell], v[where, cell + 1], d[where, cell], d[where, cell + 1]
    for part in np.arange(1, _PARTS) / _PARTS:
        rest = 1.0 - part
        there = (
            (1.0 + 2.0 * part) * rest**2 * before + part**2 * (3.0 - 2.0 * part) * after
            + part * rest**2 * leaving - part**2 * rest * arriving
        )  # fmt: skip
        np.maximum.at(found, where, np.hypot(there[:, 0], there[:, 1]))
    return found
