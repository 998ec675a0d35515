"""The heat in the plates, and a bearing under its load, as the kernels take them; and the temperature along the plates over time."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import heat_state as h
from dcfp.kernels.friction import BearingModel
from dcfp.kernels.motion import SystemConstants
from dcfp.kernels.plate import write_profile
from dcfp.kernels.sum_of_exponentials import HORIZON, MODES, finite_plate_modes, half_space_modes
from dcfp.schema.quantities import quantity
from dcfp.system.bearing import Bearing
from dcfp.system.heating import INSULATED, Heating, PreciseHeating
from dcfp.system.system import System

if TYPE_CHECKING:
    import xarray


#: Displacement for which the line of cells has room at first [mm].
FIRST_REACH = 600.0
#: Horizons for which heat is remembered [-], and the longest horizon [s].
_REMEMBERED, _LONGEST_HORIZON = 3.0, 1200.0


@dataclass(frozen=True)
class PlateHeat:
    """Heat in the plates, which the kernels change in place: arrays of `dcfp.kernels.heat_state`, and the instant weight of the modes [s^1/2]."""

    modes: FloatArray
    workspace: FloatArray
    cells: FloatArray
    instant: float

    @property
    def temperature(self) -> FloatArray:
        """Temperature of the contact on each plate that differs [degC], shape (plates,)."""
        return self.workspace[h.PRESENT : h.PRESENT + self.cells.shape[0]]

    def with_room(self, cells: int) -> "PlateHeat":
        """Return a copy that shares no array with this one, with so many more cells at each end of the plates."""
        workspace = self.workspace.copy()
        for plate in range(self.cells.shape[0]):
            workspace[h.PLATE_ENTRY + plate * h.PLATE_ENTRIES + h.LEFT_CELL] += cells
        blank = np.zeros((self.cells.shape[0], cells, self.cells.shape[2]))
        wider = np.concatenate((blank, self.cells, blank), axis=1)
        return replace(self, modes=self.modes.copy(), workspace=workspace, cells=wider)


def system_constants(system: System) -> SystemConstants:
    """Return the constants of a rigid structure on its bearing per unit mass; two equal plates become one with half the travel."""
    bearing, friction = system.bearing, system.friction
    shares = bearing.shares
    plates = len(set(bearing.radii))
    speeds = shares if friction.speed_is_of_surface else (1.0,) * len(shares)
    return SystemConstants(
        restoring=bearing.restoring_stiffness / bearing.mass,
        elastic=bearing.elastic_stiffness / bearing.mass,
        gravity=bearing.vertical_force / bearing.mass,
        pressure=bearing.pressure,
        yield_per_mu=bearing.vertical_force / bearing.elastic_stiffness,
        plates=plates,
        first_share=shares[0],
        second_share=shares[-1],
        first_speed=speeds[0],
        second_speed=speeds[-1],
    )


def memory_of(duration: float) -> float:
    """Return for how long [s] the modes chosen for a `duration` [s] remember heat within 1 % of a temperature."""
    return _REMEMBERED * horizon_for(duration)


def mean_temperature(bearing: Bearing, temperatures: FloatArray) -> FloatArray:
    """Return the mean of the `temperatures` of each plate that differs [degC], shape (n, plates), by their share of the travel, shape (n,)."""
    return temperatures[:, 0] if temperatures.shape[1] == 1 else temperatures @ np.array(bearing.shares)


def cell_width(system: System) -> float:
    """Width of a cell of the plate [mm]."""
    return 2.0 * system.bearing.contact_half_side / cells_across(system.heating)


def horizon_for(duration: float) -> float:
    """Return the horizon [s] of modes that are to remember heat through a `duration` [s].

    Heat is remembered within 1 % of a temperature for three horizons. The longest, of 20 minutes, leaves the fastest mode quick enough for the tests themselves: within
    0.06 degC; after a day of cooling the plates then are up to 0.8 degC too cold.
    """
    return min(max(HORIZON, duration / _REMEMBERED), _LONGEST_HORIZON)


def cold_plates(system: System, *, reach: float = FIRST_REACH, horizon: float = HORIZON) -> PlateHeat:
    """Return plates at the ambient temperature.

    Parameters
    ----------
    system
        What they belong to.
    reach
        Displacement for which the line of cells of the precise model has room [mm].
    horizon
        Time within which the slowest mode of a half-space hardly decays [s]; see `half_space_modes`.
    """
    heating, plates = system.heating, len(set(system.bearing.radii))
    rates, weights, instant = modes_of(heating, horizon)
    modes = np.zeros((h.MODE_ROWS, MODES))
    modes[h.RATES] = rates
    modes[h.WEIGHTS] = weights * heating.rise_factor
    workspace = cold_workspace(heating.ambient)
    margin = margin_for(system, reach)
    for i in range(plates):
        workspace[h.PLATE_ENTRY + i * h.PLATE_ENTRIES + h.LEFT_CELL] = margin
    return PlateHeat(modes, workspace, no_heat(plates, heating, margin), instant)


def modes_of(heating: Heating, horizon: float = HORIZON) -> tuple[FloatArray, FloatArray, float]:
    """Return rates [1/s], weights [s^-1/2] and the instant weight [s^1/2] of the modes of a plate; `horizon` as for `cold_plates`."""
    if heating.thickness is None:
        return half_space_modes(horizon)
    insulated = heating.back == INSULATED
    return finite_plate_modes(heating.diffusivity, heating.thickness, insulated=insulated)


def cold_workspace(ambient: float) -> FloatArray:
    """Return the workspace of plates at an ambient temperature [degC], without the place of the slider."""
    workspace = np.zeros(h.WORKSPACE_SIZE)
    workspace[h.PRESENT : h.CYCLING_PARAMETER] = ambient
    workspace[h.RATIO : h.PLATE_ENTRY] = 1.0
    workspace[h.STEP_ENTRY :] = math.nan  # no step is prepared
    return workspace


def cells_across(heating: Heating) -> int:
    """Return the number of cells that the length of the contact is divided into."""
    return heating.cells if isinstance(heating, PreciseHeating) else 1


def margin_for(system: System, reach: float = FIRST_REACH) -> int:
    """Return the number of cells on each side of the contact that a displacement of `reach` [mm] needs."""
    if not isinstance(system.heating, PreciseHeating):
        return 0
    return 1 + math.ceil(max(system.bearing.shares) * reach / cell_width(system))


def no_heat(plates: int, heating: Heating, margin: int) -> FloatArray:
    """Return the cells of `plates` cold plates with so many on each side of the contact."""
    return np.zeros((plates, cells_across(heating) + 1 + 2 * margin, MODES + 1))


def heat_of(plates: PlateHeat, system: System) -> h.Heat:
    """Return the kernels' view of the heat in `plates`, which they will change."""
    heating = system.heating
    return h.Heat(
        kind=heating.kind,
        ambient=heating.ambient,
        half_contact=system.bearing.contact_half_side,
        cell=cell_width(system),
        instant=plates.instant * heating.rise_factor,
        modes=plates.modes,
        workspace=plates.workspace,
        cells=plates.cells,
    )


def kernel_model(system: System, plates: PlateHeat) -> BearingModel:
    """Return the kernels' view of a bearing under its own load, with the heat in its `plates`, which they will change."""
    law = system.friction.at_pressure(system.bearing.pressure)
    return BearingModel(law, system_constants(system), heat_of(plates, system))


@dataclass(frozen=True)
class Profiles:
    """Temperature along the plates [degC], shape (times, plates, cells), at times [s] and middles of cells, from the centre of the plate [mm]."""

    time: FloatArray
    position: FloatArray
    temperature: FloatArray

    @classmethod
    def of(cls, kept: Sequence[tuple[float, FloatArray]], system: System) -> "Profiles":
        """Return the profiles that an integration kept: for each time [s] what `profile_now` gave."""
        temperature = np.stack([profile for _, profile in kept])
        cells = int(temperature.shape[-1])
        # the last cell is there only for the right edge to enter: the line is centred without it
        position = cell_width(system) * (np.arange(cells, dtype=np.float64) - 0.5 * (cells - 2))
        return cls(freeze(np.array([t for t, _ in kept])), freeze(position), freeze(temperature))


def profile_now(heat: h.Heat, constants: SystemConstants, time: float, flux: float) -> FloatArray:
    """Return the temperature along the plates [degC] at a time [s] under a `flux` mu p |v| [N/(mm s)], shape (plates, cells)."""
    rises = np.zeros((constants.plates, heat.cells.shape[1]))
    shares = (constants.first_share, constants.second_share)
    for i in range(constants.plates):
        write_profile(heat, i, time, shares[i] * float(heat.workspace[h.RATIO + i]) * flux, rises[i])
    return rises + heat.ambient


def profile_variables(profiles: Profiles) -> "xarray.Dataset":
    """Return the profiles as variables of a data set, with units."""
    import xarray

    dimensions = ("profile_time", "plate", "plate_position")
    time, position, temperature = (
        (axes, np.array(values), quantity(name).attributes)
        for name, axes, values in (
            ("time", dimensions[0], profiles.time),
            ("plate_position", dimensions[2], profiles.position),
            ("plate_temperature", dimensions, profiles.temperature),
        )
    )
    return xarray.Dataset(
        {"plate_temperature": temperature}, {"profile_time": time, "plate_position": position}
    )
