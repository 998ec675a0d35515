"""The result of an analysis of an isolated building: slab, bearings, floors and energies."""

from functools import cached_property

import numpy as np

from dcfp.analysis.plan.bearings import BearingsResponse
from dcfp.analysis.plan.floors import FloorsResponse
from dcfp.analysis.result import EnergyBalance
from dcfp.arrays import integral
from dcfp.kernels import plan_integrate as k


class PlanResponse(BearingsResponse, FloorsResponse):
    """Histories, peaks and energies of a building on many bearings."""

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
