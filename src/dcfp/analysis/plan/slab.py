"""What a building on its bearings is made of after an analysis: its histories as the kernels leave them, and the motion of the slab."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.plan.model import PlanModel
from dcfp.analysis.plane_response import largest_change
from dcfp.analysis.result import HistoryResult
from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import plan_end as e
from dcfp.kernels import plan_integrate as k
from dcfp.motion.station import Station
from dcfp.system.plan import Plan


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class SlabResponse(HistoryResult):
    """Motion of the slab, and the force of all bearings on it.

    Attributes
    ----------
    plan, motion
        What was shaken by what.
    ground_acceleration
        Shape (n, 2) [mm/s2].
    weight_ratio
        Weight with the vertical acceleration over that at rest, shape (n,).
    overturning_counts
        Whether the loads of the bearings follow the overturning moment.
    """

    plan: Plan
    motion: Station
    ground_acceleration: FloatArray
    weight_ratio: FloatArray
    lines: FloatArray
    modes: NDArray[np.complex128]
    kept: FloatArray
    model: PlanModel
    tallies: FloatArray
    overturning_counts: bool = True

    def of_modes(self, rows: NDArray[np.complex128], modes: NDArray[np.complex128]) -> FloatArray:
        """Return what complex modes, shape (n, modes), sum to by `rows`, shape (rows, modes): the real part, shape (n, rows)."""
        turns = np.flatnonzero(self.model.modes.roots.imag)  # the others have no imaginary part
        # whole arrays: parts of complex ones are multiplied without the library
        real, imaginary = np.ascontiguousarray(modes.real), np.ascontiguousarray(modes.imag[:, turns])
        return real @ rows.real.T - imaginary @ rows.imag[:, turns].T

    @property
    def slab_motion(self) -> FloatArray:
        """Displacement x, y [mm] and rotation [rad] of the slab at the centre of mass, shape (n, 3)."""
        return self.lines[:, :3]

    @property
    def slab_velocity(self) -> FloatArray:
        """Velocity of the slab at the centre of mass [mm/s, mm/s, rad/s], shape (n, 3)."""
        return self.lines[:, 3:6]

    @property
    def displacement(self) -> FloatArray:
        """Distance of the centre of mass from where it was [mm]."""
        return np.hypot(self.slab_motion[:, 0], self.slab_motion[:, 1])

    @property
    def rotation(self) -> FloatArray:
        """Rotation of the slab [rad]."""
        return self.slab_motion[:, 2]

    @property
    def peak_displacement_x(self) -> float:
        """Largest displacement of the centre of mass in direction x at the samples [mm]."""
        return float(np.abs(self.slab_motion[:, 0]).max())

    @property
    def peak_displacement_y(self) -> float:
        """Largest displacement of the centre of mass in direction y at the samples [mm]."""
        return float(np.abs(self.slab_motion[:, 1]).max())

    @cached_property
    def peak_change(self) -> float:
        """Largest change of displacement of the centre of mass between two successive peaks in any direction [mm]."""
        centre, rate = (np.ascontiguousarray(one[:, :2]) for one in (self.slab_motion, self.slab_velocity))
        return largest_change(centre, rate, float(self.time[1]))

    @property
    def peak_velocity(self) -> float:
        """Largest relative velocity of the centre of mass at the samples [mm/s]."""
        return float(np.hypot(*self.slab_velocity[:, :2].T).max())

    @property
    def corner_ratio(self) -> float | None:
        """Largest displacement of a corner over that of the centre of mass [-]."""
        return (
            self.peak_corner_displacement / self.peak_displacement if self.peak_displacement > 0.0 else None
        )

    @property
    def force_ratio(self) -> float:
        """Largest base shear over the weight [-]."""
        return self.peak_base_shear / self.plan.weight

    @property
    def torque(self) -> FloatArray:
        """Torque of the bearings about the centre of mass [N mm]."""
        return self.base_shear[:, 2]

    @property
    def overturning_x(self) -> FloatArray:
        """Moment on the loads of bearings far in x [N mm]."""
        return self.overturning[:, 0]

    @property
    def overturning_y(self) -> FloatArray:
        """Moment on the loads of bearings far in y [N mm]."""
        return self.overturning[:, 1]

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
        return float(self.tallies[e.ROTATION])

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
        return float(self.tallies[e.SHEAR])

    @property
    def overturning(self) -> FloatArray:
        """Moments on the loads of the bearings that press where X and where Y are large [N mm], shape (n, 2)."""
        return self.lines[:, k.LINE_TIPPING : k.LINE_TIPPING + 2]
