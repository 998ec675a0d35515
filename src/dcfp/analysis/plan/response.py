"""The result of an analysis of an isolated building: slab, bearings, floors and energies."""

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from dcfp.analysis.plan import quantities as told
from dcfp.analysis.plan.bearings import BearingsResponse
from dcfp.analysis.plan.floors import FloorsResponse
from dcfp.analysis.plan.remarks import remarks_of
from dcfp.analysis.plane_result import add_directions
from dcfp.analysis.response import Status
from dcfp.analysis.result import EnergyBalance, equivalent_velocity
from dcfp.arrays import integral
from dcfp.kernels import plan_end as e
from dcfp.kernels import plan_integrate as k
from dcfp.schema.quantities import Quantities
from dcfp.system.plan import Plan

if TYPE_CHECKING:
    import xarray

#: Shortest time without any slip after which a building is at rest [s], and how many times the longest period on a fixed base it is at least.
_LEAST_REST, _PERIODS = 1.0, 2.0


def time_to_rest(plan: Plan) -> float:
    """Return the time without any slip after which a building is at rest [s]."""
    longest = float(plan.structure.periods[0]) if plan.storeys else 0.0
    return max(_LEAST_REST, _PERIODS * longest)


class PlanResponse(BearingsResponse, FloorsResponse):
    """Histories, peaks and energies of a building on many bearings."""

    quantities: ClassVar[Quantities] = told.PLAN_PEAKS
    histories: ClassVar[Quantities] = told.PLAN_HISTORIES
    dimensions: ClassVar[Mapping[str, str]] = told.DIMENSIONS

    @property
    def name(self) -> str:
        """Name of the ground motion."""
        return self.motion.name

    @property
    def title(self) -> str:
        """What it is, in words."""
        return f"{self.plan.name} under {self.motion.name}"

    @property
    def laws(self) -> str:
        """Names of the friction laws."""
        return ", ".join(dict.fromkeys(one.friction.name for one in self.plan.systems))

    @property
    def heatings(self) -> str:
        """Names of the heating models."""
        return ", ".join(dict.fromkeys(one.heating.name for one in self.plan.systems))

    @property
    def damping_words(self) -> str:
        """Damping of the storeys, without which no result of a floor is to be told."""
        plan = self.plan
        if not plan.storeys:
            return "none: rigid"
        kinds = {"modal": "in every mode on a fixed base", "stiffness": "in the first mode on a fixed base, proportional to the stiffness"}  # fmt: skip
        return f"{100.0 * plan.damping:g} % {kinds[plan.damping_kind]}"

    @property
    def remarks(self) -> tuple[str, ...]:
        """Sentences that a reader must know."""
        return remarks_of(self)

    @property
    def attributes(self) -> dict[str, Any]:
        """What a data set says of it."""
        return {one.key: one.datum(self) for one in self.quantities.values() if one.stored and one.flat}

    def to_dataset(self) -> "xarray.Dataset":
        """Return histories over ``time``, ``bearing``, ``level`` and ``storey`` with their units, the peaks of bearings and levels, and what is told of it as attributes."""
        bearings, levels = (
            replace(one, columns=one.columns[1:])
            for one in (told.bearing_table(self), told.level_table(self))
        )
        storeys = len(self.plan.storeys)
        of_bearings = bearings.dataset("bearing").rename(
            {one.title: f"bearing_{one.title}" for one in bearings.flat}
        )
        of_levels = levels.dataset("level").rename({one.title: f"level_{one.title}" for one in levels.flat})
        whole = super().to_dataset().merge(of_bearings).merge(of_levels)
        return whole.assign_coords(
            bearing=range(1, self.plan.count + 1), level=range(storeys + 1), storey=range(1, storeys + 1)
        )

    @property
    def rests(self) -> bool:
        """Whether it has come to rest."""
        return float(self.time[-1] - self.tallies[e.LAST_SLIP]) > time_to_rest(self.plan)

    @property
    def status(self) -> Status:
        """How the analysis ended; the capacity is that of every bearing."""
        beyond = any(
            one.bearing.displacement_capacity is not None and furthest > one.bearing.displacement_capacity
            for one, furthest in zip(self.plan.systems, self.peak_bearing_displacement, strict=True)
        )
        return Status.BEYOND_CAPACITY if beyond else Status.OK if self.rests else Status.STILL_MOVING

    @property
    def residual_displacement(self) -> float:
        """Displacement of the centre of mass when the last elastic oscillation has died away [mm]."""
        return float(np.hypot(*told.residual_displacement(self)))

    @cached_property
    def energy(self) -> EnergyBalance:
        """Energies [N mm]."""
        put_in, hysteretic, lifting, damped, _, stored = self.lines[
            :, k.LINE_ENERGIES : k.LINE_ENERGIES + 6
        ].T
        building, modes = self.model.building, self.model.modes
        of_slab, participation = building.mass[:3, :3], building.mass[3:, :3]
        above, speeds = (self.of_modes(one[3:], self.modes) for one in (modes.displacement, modes.velocity))
        slab, rates = self.slab_motion, self.slab_velocity
        of_floors = speeds @ participation
        ground = integral(self.ground_acceleration, float(self.time[1]))
        momentum = (rates @ of_slab + of_floors)[:, :2]
        of_ground = (ground * (0.5 * self.plan.total_mass * ground + momentum)).sum(axis=1)
        return EnergyBalance(
            input=put_in,
            absolute_input=put_in + of_ground,
            kinetic=0.5 * ((rates @ of_slab + 2.0 * of_floors) * rates).sum(axis=1)
            + 0.5 * (speeds**2).sum(axis=1),
            pendulum=0.5 * ((slab @ self.model.kernel.stiffness) * slab).sum(axis=1),
            spring=stored,
            hysteretic=hysteretic,
            storeys=0.5 * above**2 @ np.diag(building.stiffness)[3:],
            damping=damped,
            lifting=lifting,
        )

    @property
    def input_velocity(self) -> float:
        """Equivalent velocity V_E of the input energy at the end, with the mass of the building [mm/s]."""
        return equivalent_velocity(float(self.energy.input[-1]), self.plan.total_mass)

    @property
    def hysteretic_velocity(self) -> float:
        """Equivalent velocity V_Eh of the hysteretic energy at the end [mm/s]."""
        return equivalent_velocity(float(self.energy.hysteretic[-1]), self.plan.total_mass)

    @property
    def slip_work(self) -> float:
        """Sum of mu N times the slip of all bearings [N mm], which the hysteretic energy of the balance equals but for the error of the steps."""
        return float(self.tallies[e.RUBBED])

    @property
    def steps(self) -> int:
        """Number of steps."""
        return int(self.tallies[e.STEPS])


add_directions(
    PlanResponse,
    ground_acceleration="ground_acceleration",
    displacement="slab_motion",
    velocity="slab_velocity",
    force="base_shear",
)
