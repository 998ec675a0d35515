"""Where an integration can be taken up again."""

import math
from dataclasses import dataclass, replace

import numpy as np

from dcfp.kernels._jit import Records, as_bytes
from dcfp.kernels.heat_state import Heat
from dcfp.kernels.integrate import INTEGRATION_STATE, Extremes
from dcfp.system import System
from dcfp.system.plates import PlateHeat, cold_plates
from dcfp.system.plates import heat_of as plate_heat_of


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

    def copy(self) -> "State":
        """Return a copy that shares no array with this one."""
        return replace(self, integration=_copied(self.integration), plates=self.plates.copy())

    def afresh(self) -> "State":
        """Return the same motion and heat with energies and peaks begun anew, for the next earthquake."""
        state = self.copy()
        new = states_at_rest(1, float(self.plates.temperature.max()))
        new["extremes"]["turning"] = state.integration["motion"]["displacement"]
        for name in ("extremes", "steps", "status", "at_rest"):
            state.integration[name] = new[name]
        return state

    def with_room(self, cells: int) -> "State":
        """Return a copy with so many more cells at each end of the plates."""
        return replace(self, integration=_copied(self.integration), plates=self.plates.with_room(cells))


def _copied(states: Records) -> Records:
    return as_bytes(states).copy().view(INTEGRATION_STATE)


def states_at_rest(count: int, temperature: float) -> Records:
    """Return states of integrations at rest, with nothing added up yet and that peak temperature [degC]."""
    states = np.zeros(count, INTEGRATION_STATE)
    states["extremes"]["temperature"] = temperature
    states["extremes"]["friction"] = math.inf
    return states


def state_at_rest(system: System) -> State:
    """Return the state at rest and at the ambient temperature."""
    return State(states_at_rest(1, system.heating.ambient), cold_plates(system), 0.0, system)


def heat_of(state: State) -> Heat:
    """Return the kernels' view of the heat in `state`, which they will change."""
    return plate_heat_of(state.plates, state.system)
