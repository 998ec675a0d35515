"""Translates a bearing and its heating model into what the kernels take."""

import math
from dataclasses import dataclass, replace

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.bearing import Bearing, FrictionLaw, Heating, PreciseHeating
from dcfp.kernels.heat_state import (
    BANK_ROWS,
    LEFT_CELL,
    NOTES,
    PLATE_NOTE,
    PLATE_NOTES,
    PRESENT,
    RATES,
    RATIO,
    STEP_NOTE,
    WEIGHTS,
    Heat,
)
from dcfp.kernels.march import (
    FIRST_TALLY,
    LEAST_FRICTION,
    PEAK_TEMPERATURE,
    STATE_DISPLACEMENT,
    STATE_SIZE,
    STATE_TURNING,
)
from dcfp.kernels.memory import MODES, fading_modes
from dcfp.kernels.motion import Structure

#: Displacement for which the line of cells has room at first [mm].
_FIRST_REACH = 600.0


@dataclass(frozen=True)
class State:
    """Everything that a march changes: where it can be taken up again.

    Attributes
    ----------
    march
        Motion, energies and peaks.
    bank, notes, cells
        Heat in the plates.
    ground_velocity
        Of the ground at this moment [mm/s].
    model
        The bearing, friction law and heating model that it belongs to.
    """

    march: FloatArray
    bank: FloatArray
    notes: FloatArray
    cells: FloatArray
    ground_velocity: float
    model: tuple[Bearing, FrictionLaw, Heating]

    def copy(self) -> "State":
        """Return a copy that shares no array with this one."""
        return replace(
            self,
            march=self.march.copy(),
            bank=self.bank.copy(),
            notes=self.notes.copy(),
            cells=self.cells.copy(),
        )

    def afresh(self) -> "State":
        """Return the same motion and heat with energies and peaks begun anew, for the next earthquake."""
        state = self.copy()
        march = state.march
        motion = march[:FIRST_TALLY].copy()
        march[:] = tallies_at(float(self.notes[PRESENT : PRESENT + self.cells.shape[0]].max()))
        march[:FIRST_TALLY] = motion
        march[STATE_TURNING] = march[STATE_DISPLACEMENT]
        return state

    def with_room(self, cells: int) -> "State":
        """Return a copy with so many more cells at each end of the plates."""
        state = self.copy()
        blank = np.zeros((self.cells.shape[0], cells, self.cells.shape[2]))
        for plate in range(self.cells.shape[0]):
            state.notes[PLATE_NOTE + plate * PLATE_NOTES + LEFT_CELL] += cells
        return replace(state, cells=np.concatenate((blank, state.cells, blank), axis=1))


def tallies_at(temperature: float) -> FloatArray:
    """Return the march's state at rest, with nothing added up yet and that peak temperature [degC]."""
    march = np.zeros(STATE_SIZE)
    march[PEAK_TEMPERATURE] = temperature
    march[LEAST_FRICTION] = math.inf
    return march


def structure_of(bearing: Bearing, friction: FrictionLaw) -> Structure:
    """Return the structure on `bearing` per unit mass; two equal plates become one with half the travel."""
    shares = bearing.shares
    plates = len(set(bearing.radii))
    speeds = shares if friction.speed_is_of_surface else (1.0,) * len(shares)
    return Structure(
        restoring=bearing.restoring_stiffness / bearing.mass,
        elastic=bearing.elastic_stiffness / bearing.mass,
        gravity=bearing.vertical_force / bearing.mass,
        pressure=bearing.pressure,
        reach=bearing.vertical_force / bearing.elastic_stiffness,
        plates=plates,
        first_share=shares[0],
        second_share=shares[-1],
        first_speed=speeds[0],
        second_speed=speeds[-1],
    )


def cell_width(bearing: Bearing, heating: Heating) -> float:
    """Width of a cell of the plate [mm]."""
    across = heating.cells if isinstance(heating, PreciseHeating) else 1
    return 2.0 * bearing.contact_half_side / across


def state_at_rest(bearing: Bearing, friction: FrictionLaw, heating: Heating) -> State:
    """Return the state at rest and at the ambient temperature."""
    plates = len(set(bearing.radii))
    rates, weights, _ = fading_modes()
    bank = np.zeros((BANK_ROWS, MODES))
    bank[RATES] = rates
    bank[WEIGHTS] = weights * heating.rise_factor
    notes = np.zeros(NOTES)
    notes[PRESENT:RATIO] = heating.ambient
    notes[RATIO:PLATE_NOTE] = 1.0
    notes[STEP_NOTE:] = math.nan  # no step is prepared
    margin = 0
    across = 1
    if isinstance(heating, PreciseHeating):
        across = heating.cells
        margin = 1 + math.ceil(max(bearing.shares) * _FIRST_REACH / cell_width(bearing, heating))
    for i in range(plates):
        notes[PLATE_NOTE + i * PLATE_NOTES + LEFT_CELL] = margin
    cells = np.zeros((plates, across + 1 + 2 * margin, MODES + 1))
    return State(tallies_at(heating.ambient), bank, notes, cells, 0.0, (bearing, friction, heating))


def heat_of(state: State) -> Heat:
    """Return the kernels' view of the heat in `state`, which they will change."""
    bearing, _, heating = state.model
    instant = fading_modes()[2]
    return Heat(
        kind=heating.kind,
        ambient=heating.ambient,
        half_contact=bearing.contact_half_side,
        cell=cell_width(bearing, heating),
        instant=instant * heating.rise_factor,
        bank=state.bank,
        notes=state.notes,
        cells=state.cells,
    )
