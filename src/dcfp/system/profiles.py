"""Temperature along the plates over time."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.kernels.heat_state import RATIO, Heat
from dcfp.kernels.motion import Structure
from dcfp.kernels.plate import write_profile
from dcfp.schema.nomenclature import quantity
from dcfp.system.bearing import Bearing
from dcfp.system.heating import Heating
from dcfp.system.plates import cell_width

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Profiles:
    """Temperature along the plates.

    Attributes
    ----------
    time
        [s], shape (times,).
    position
        Of the middle of each cell, from the centre of the plate [mm], shape (cells,).
    temperature
        [degC], shape (times, plates, cells).
    """

    time: FloatArray
    position: FloatArray
    temperature: FloatArray

    @classmethod
    def of(cls, kept: Sequence[tuple[float, FloatArray]], bearing: Bearing, heating: Heating) -> "Profiles":
        """Return the profiles that a march kept: for each time [s] what `profile_now` gave."""
        temperature = np.stack([profile for _, profile in kept])
        cells = int(temperature.shape[-1])
        # the last cell is there only for the right edge to enter: the line is centred without it
        position = cell_width(bearing, heating) * (np.arange(cells, dtype=np.float64) - 0.5 * (cells - 2))
        return cls(freeze(np.array([t for t, _ in kept])), freeze(position), freeze(temperature))


def profile_now(heat: Heat, structure: Structure, time: float, flux: float) -> FloatArray:
    """Return the temperature along the plates [degC] at a time [s], shape (plates, cells).

    `flux` is mu p |v| [N/(mm s)], zero while sticking.
    """
    rises = np.zeros((structure.plates, heat.cells.shape[1]))
    shares = (structure.first_share, structure.second_share)
    for i in range(structure.plates):
        write_profile(heat, i, time, shares[i] * float(heat.notes[RATIO + i]) * flux, rises[i])
    return rises + heat.ambient


def profile_variables(profiles: Profiles) -> "xarray.Dataset":
    """Return the profiles as variables of a data set, with units."""
    import xarray

    return xarray.Dataset(
        {
            "plate_temperature": (
                ("profile_time", "plate", "plate_position"),
                np.array(profiles.temperature),
                quantity("plate_temperature").attributes,
            )
        },
        coords={
            "profile_time": ("profile_time", np.array(profiles.time), quantity("time").attributes),
            "plate_position": (
                "plate_position",
                np.array(profiles.position),
                quantity("plate_position").attributes,
            ),
        },
    )
