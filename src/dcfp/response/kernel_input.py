"""Translates a bearing and its heating model into what the kernels take."""

import math
from dataclasses import dataclass

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
    STEP_NOTE,
    WEIGHTS,
    Heat,
)
from dcfp.kernels.march import LEAST_FRICTION, PEAK_TEMPERATURE, STATE_SIZE
from dcfp.kernels.memory import MODES, fading_modes
from dcfp.kernels.motion import Structure

#: Displacement for which the line of cells has room at first [mm].
FIRST_REACH = 600.0


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
    """

    march: FloatArray
    bank: FloatArray
    notes: FloatArray
    cells: FloatArray
    ground_velocity: float = 0.0

    def copy(self, ground_velocity: float | None = None) -> "State":
        """Return a copy that shares nothing with this one."""
        velocity = self.ground_velocity if ground_velocity is None else ground_velocity
        return State(self.march.copy(), self.bank.copy(), self.notes.copy(), self.cells.copy(), velocity)


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


def state_at_rest(structure: Structure, bearing: Bearing, heating: Heating, reach: float) -> State:
    """Return the state at rest and at the ambient temperature, with cells for displacements up to `reach` [mm]."""
    rates, weights, _ = fading_modes()
    bank = np.zeros((BANK_ROWS, MODES))
    bank[RATES] = rates
    bank[WEIGHTS] = weights * heating.rise_factor
    notes = np.zeros(NOTES)
    notes[PRESENT:PLATE_NOTE] = heating.ambient
    notes[STEP_NOTE:] = math.nan  # no step is prepared
    margin = 0
    across = 1
    if isinstance(heating, PreciseHeating):
        across = heating.cells
        margin = 1 + math.ceil(max(bearing.shares) * reach / cell_width(bearing, heating))
    for i in range(structure.plates):
        notes[PLATE_NOTE + i * PLATE_NOTES + LEFT_CELL] = margin
    march = np.zeros(STATE_SIZE)
    march[PEAK_TEMPERATURE] = heating.ambient
    march[LEAST_FRICTION] = math.inf
    cells = np.zeros((structure.plates, across + 1 + 2 * margin, MODES + 1))
    return State(march, bank, notes, cells)


def heat_of(state: State, bearing: Bearing, heating: Heating) -> Heat:
    """Return the kernels' view of the heat in `state`, which they will change."""
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
