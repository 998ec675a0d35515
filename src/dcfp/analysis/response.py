"""The result of a response history analysis: histories, energies, peaks, and how it ended."""

import json
import math
from abc import ABC, abstractmethod
from dataclasses import asdict, dataclass, replace
from enum import Enum
from operator import attrgetter
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from dcfp.analysis.assumptions import OF_RESPONSE
from dcfp.analysis.integration import Integration
from dcfp.analysis.result import MotionResult
from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.kernels._jit import Records, as_bytes
from dcfp.kernels.integrate import INTEGRATION_STATE, Extremes
from dcfp.motion.ground_motion import GroundMotion, provenance
from dcfp.motion.measures import motion_remarks
from dcfp.schema.check import Check
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.units import KN, M_PER_S
from dcfp.system import System
from dcfp.system.plates import PlateHeat, cold_plates

if TYPE_CHECKING:
    from dcfp.analysis.plane_response import PlaneState


@dataclass(frozen=True)
class State:
    """Everything that an integration changes: where it can be taken up again.

    Attributes
    ----------
    integration
        Motion, energies and peaks: one `dcfp.kernels.integrate.IntegrationState`, shape (1,).
    plates
        Heat in the plates.
    ground_velocity
        Of the ground at this moment [mm/s].
    system
        What it is the state of.
    """

    integration: Records
    plates: PlateHeat
    ground_velocity: float
    system: System

    @property
    def extremes(self) -> Extremes:
        """What was added up or compared on the way, per unit mass."""
        return Extremes(*self.integration["extremes"].item())

    def with_room(self, cells: int) -> "State":
        """Return a copy that shares no array with this one, with so many more cells at each end of the plates."""
        states = as_bytes(self.integration).copy().view(INTEGRATION_STATE)
        return replace(self, integration=states, plates=self.plates.with_room(cells))

    def copy(self) -> "State":
        """Return a copy that shares no array with this one."""
        return self.with_room(0)

    def afresh(self) -> "State":
        """Return the same motion and heat with energies and peaks begun anew, for the next earthquake."""
        state = self.copy()
        new = states_at_rest(1, float(self.plates.temperature.max()))
        new["extremes"]["turning"] = state.integration["motion"]["displacement"]
        for name in ("extremes", "steps", "status", "at_rest"):
            state.integration[name] = new[name]
        return state


def states_at_rest(count: int, temperature: float) -> Records:
    """Return states of integrations at rest, with nothing added up yet and that peak temperature [degC]."""
    states = np.zeros(count, INTEGRATION_STATE)
    states["extremes"]["temperature"] = temperature
    states["extremes"]["friction"] = math.inf
    return states


def state_at_rest(system: System) -> State:
    """Return the state at rest and at the ambient temperature."""
    return State(states_at_rest(1, system.heating.ambient), cold_plates(system), 0.0, system)


class Status(Enum):
    """How an analysis ended; the value is what results and tables show."""

    OK = "ok"
    BEYOND_CAPACITY = "beyond capacity"
    STILL_MOVING = "still moving"


#: The same as numbers, for arrays.
NUMBERS = {Status.OK: 1, Status.BEYOND_CAPACITY: 2, Status.STILL_MOVING: 3}
#: Numbers for what has no `Status`: not analysed yet, and an analysis that could not be finished.
NOT_RUN, FAILED = 0, 4


#: What is told of one analysis: what it is of, its peaks and how it ended; by the names of the nomenclature, as JSON, CSV and tables have it.
PEAKS = Quantities("peak of a response")
PEAKS.add("record", Quantity("record", "name of the ground motion", head="Record", get="motion.name"))
PEAKS.tell("peak_ground_velocity", "pgv_m_s", unit=M_PER_S, name="pgv", head="PGV", decimals=3, get="motion.peak_velocity")  # fmt: skip
PEAKS.add("law", Quantity("friction", "friction law", printed=False, get="friction_law.name"))
PEAKS.add("heating", Quantity("heating", "heating model", printed=False, get="heating.name"))
PEAKS.tell("peak_displacement", "y_max_mm", name="y_max", decimals=1)
PEAKS.tell("peak_change", "dy_max_mm", name="dy_max", decimals=1)
PEAKS.tell("peak_velocity", "v_max_mm_s", name="v_max", decimals=3)
PEAKS.tell("residual_displacement", "residual_mm", name="residual", head="resid.", decimals=1)
PEAKS.tell("peak_force", "force_max_kN", unit=KN, name="force_max", head="F_max", decimals=0)
PEAKS.tell("force_ratio", head="F/W", decimals=3, stored=False)
PEAKS.tell("peak_temperature", "temperature_max_degC", name="temperature_max", head="T_max", decimals=0)
PEAKS.tell("least_friction", "friction_min", head="mu_min", decimals=4)
PEAKS.tell("input_velocity", "V_E_mm_s", name="V_E", decimals=3)
PEAKS.tell("hysteretic_velocity", "V_Eh_mm_s", name="V_Eh", decimals=3)
PEAKS.tell("relative_energy_residual", "energy_residual", printed=False, get="energy.relative_residual")
PEAKS.add("status", Quantity("status", "how the analysis ended", head="Status"))
PEAKS.tell("elapsed", "elapsed_s")

#: Its histories.
HISTORIES = Quantities("history of a response")
for _name in (
    "ground_acceleration", "ground_velocity", "displacement", "velocity", "structure_velocity", "structure_acceleration",
    "force", "friction", "temperature", "sliding",
):  # fmt: skip
    HISTORIES.tell(_name)
for _name in ("input", "absolute_input", "kinetic", "strain", "hysteretic"):
    HISTORIES.tell(f"{_name}_energy", get=attrgetter(f"energy.{_name}"))
HISTORIES.tell("energy_residual", get=attrgetter("energy.residual"))


def check_start(name: str, start: "State | PlaneState | None", system: System) -> None:
    """Refuse a state to begin from that is of another system."""
    if start is not None and start.system != system:
        msg = f"{name}: the starting state is that of another bearing, friction law or heating model."
        raise InputError(msg)


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class RigidResponse(MotionResult, ABC):
    """What responses of a rigid structure on a bearing have in common, in one direction and in the plane, where the magnitude is meant."""

    integration: Integration
    final_state: "State | PlaneState"

    @property
    def peak_displacement(self) -> float:
        """Largest displacement y_max, to either side or from the middle [mm]."""
        return self.final_state.extremes.displacement

    @property
    def peak_velocity(self) -> float:
        """Largest relative velocity at the ends of steps [mm/s]."""
        return self.final_state.extremes.velocity

    @property
    def peak_force(self) -> float:
        """Largest horizontal force at the ends of steps [N]."""
        return self.final_state.extremes.force * self.bearing.mass

    @property
    def force_ratio(self) -> float:
        """Largest horizontal force over the weight [-]."""
        return self.peak_force / self.bearing.vertical_force

    @property
    def peak_temperature(self) -> float:
        """Highest temperature of the contact of any plate [degC]."""
        return self.final_state.extremes.temperature

    @property
    def least_friction(self) -> float:
        """Smallest coefficient of friction while sliding [-]; where it never slides, the one at rest at the start."""
        least = self.final_state.extremes.friction
        return least if math.isfinite(least) else float(self.friction[0])

    @property
    @abstractmethod
    def _anchor(self) -> float:
        """Where the other end of spring (b) is at the end [mm]."""

    @property
    def residual_displacement(self) -> float:
        """Displacement at which it stays when the last elastic oscillation has died away [mm]."""
        elastic = self.bearing.elastic_stiffness
        return self._anchor * elastic / (elastic + self.bearing.restoring_stiffness)

    @property
    def steps(self) -> int:
        """Number of steps that the integration took."""
        return int(self.final_state.integration["steps"][0])

    @property
    def status(self) -> Status:
        """How the analysis ended."""
        capacity = self.bearing.displacement_capacity
        if capacity is not None and self.peak_displacement > capacity:
            return Status.BEYOND_CAPACITY
        return Status.OK if self.rests else Status.STILL_MOVING

    @property
    def checks(self) -> tuple[Check, ...]:
        """What it ought to keep to, and every assumption, with whether it was kept to."""
        return (*(one for check in OF_RESPONSE.values() for one in check(self)), *super().checks)

    @property
    def all_remarks(self) -> list[str]:
        """Sentences that a reader must know, those on the motion first."""
        return [*motion_remarks(self.motion), *self.remarks]

    @property
    def attributes(self) -> dict[str, Any]:
        """What a data set says of it besides its system."""
        motion = self.motion
        return {
            **self.summary(),
            **provenance(motion.digest, motion.origin, motion.treatment),
            "settings": json.dumps(asdict(self.integration)),
        }


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Response(RigidResponse):
    """Histories, peaks and energies of a rigid structure on a bearing; its ``final_state`` is where it can be gone on with."""

    quantities: ClassVar[Quantities] = PEAKS
    histories: ClassVar[Quantities] = HISTORIES
    columns: ClassVar[tuple[str, ...]] = (
        "displacement", "velocity", "elongation", "friction", "sliding", "input", "hysteretic",
    )  # fmt: skip

    motion: GroundMotion
    final_state: State

    @property
    def title(self) -> str:
        """What it is, in words."""
        return f"Response to {self.motion.name}"

    @property
    def structure_velocity(self) -> FloatArray:
        """Absolute velocity of the structure v_u = v + v_g [mm/s]: Li et al. (2020), Eq. (13)."""
        return self.velocity + self.ground_velocity

    @property
    def structure_acceleration(self) -> FloatArray:
        """Absolute acceleration of the structure [mm/s2]."""
        return -self.force / self.bearing.mass

    def _energies(self) -> tuple[FloatArray, FloatArray, dict[str, FloatArray]]:
        mass, velocity, ground = self.bearing.mass, self.velocity, self.ground_velocity
        return mass * ground * (0.5 * ground + velocity), 0.5 * mass * velocity**2, {}

    @property
    def peak_change(self) -> float:
        """Largest change of displacement between two successive peaks, dy_max [mm]; Li et al. (2020), section 6.1."""
        return self.final_state.extremes.change

    @property
    def _anchor(self) -> float:
        return float(self.displacement[-1] - self.elongation[-1])
