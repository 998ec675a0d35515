"""Where a march can be taken up again."""

import math
from dataclasses import dataclass, replace

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.kernels.heat_state import Heat
from dcfp.kernels.march import (
    FIRST_TALLY,
    LEAST_FRICTION,
    PEAK_TEMPERATURE,
    STATE_DISPLACEMENT,
    STATE_SIZE,
    STATE_TURNING,
)
from dcfp.system import System
from dcfp.system.plates import PlateHeat, cold_plates
from dcfp.system.plates import heat_of as plate_heat_of


@dataclass(frozen=True)
class State:
    """Everything that a march changes: where it can be taken up again.

    Attributes
    ----------
    march
        Motion, energies and peaks.
    plates
        Heat in the plates.
    ground_velocity
        Of the ground at this moment [mm/s].
    system
        What it is the state of.
    """

    march: FloatArray
    plates: PlateHeat
    ground_velocity: float
    system: System

    def copy(self) -> "State":
        """Return a copy that shares no array with this one."""
        return replace(self, march=self.march.copy(), plates=self.plates.copy())

    def afresh(self) -> "State":
        """Return the same motion and heat with energies and peaks begun anew, for the next earthquake."""
        state = self.copy()
        march = state.march
        motion = march[:FIRST_TALLY].copy()
        march[:] = tallies_at(float(self.plates.temperature.max()))
        march[:FIRST_TALLY] = motion
        march[STATE_TURNING] = march[STATE_DISPLACEMENT]
        return state

    def with_room(self, cells: int) -> "State":
        """Return a copy with so many more cells at each end of the plates."""
        return replace(self, march=self.march.copy(), plates=self.plates.with_room(cells))


def tallies_at(temperature: float) -> FloatArray:
    """Return the march's state at rest, with nothing added up yet and that peak temperature [degC]."""
    march = np.zeros(STATE_SIZE)
    march[PEAK_TEMPERATURE] = temperature
    march[LEAST_FRICTION] = math.inf
    return march


def state_at_rest(system: System) -> State:
    """Return the state at rest and at the ambient temperature."""
    return State(tallies_at(system.heating.ambient), cold_plates(system), 0.0, system)


def heat_of(state: State) -> Heat:
    """Return the kernels' view of the heat in `state`, which they will change."""
    return plate_heat_of(state.plates, state.system)
