"""The temperature of the plates over time, as it is kept of an analysis or a test in the plane: at some moments, and at the hottest."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.integration import Keep
from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import plane_integrate as k
from dcfp.kernels.sum_of_exponentials import MODES
from dcfp.schema.quantities import quantity
from dcfp.system import Heating, System
from dcfp.system.fields import PlaneHeat

if TYPE_CHECKING:
    import xarray

#: Most moments at which the plates are kept, besides the hottest and the last, unless it is said after how many samples: each is a picture.
_MOST = 60
#: Dimensions of the temperature of the plates in a data set.
_DIMENSIONS = ("profile_time", "plate", "plate_y", "plate_x")


@dataclass(frozen=True, eq=False)
class Fields:
    """Temperature of the plates [degC], shape (times, plates, y, x), at times [s] and points from the middle of a plate [mm].

    They hold the part of the plates that was ever hot. Number `hottest` of the times is that at which a point is hottest.
    """

    time: FloatArray
    x: FloatArray
    y: FloatArray
    temperature: NDArray[np.float32]
    hottest: int

    def nearest(self, moment: float | None = None) -> int:
        """Return the number of the time that is nearest to a moment [s], by default that of the hottest."""
        return self.hottest if moment is None else int(np.abs(self.time - moment).argmin())

    def variables(self) -> "xarray.Dataset":
        """Return them as variables of a data set, with units."""
        import xarray  # late: it takes long to import

        place = quantity("plate_position").attributes
        coordinates = {
            name: (name, np.array(values), attributes)
            for name, values, attributes in (
                (_DIMENSIONS[0], self.time, quantity("time").attributes),
                (_DIMENSIONS[2], self.y, place),
                (_DIMENSIONS[3], self.x, place),
            )
        }
        values = (_DIMENSIONS, self.temperature, quantity("plate_temperature").attributes)
        return xarray.Dataset({"plate_temperature": values}, coordinates)


def moments_of(keep: Keep, lines: FloatArray, heating: Heating) -> list[int]:
    """Return the samples at which the plates are kept, the hottest among them; none where nothing is to be kept.

    Raises
    ------
    InputError
        If they are asked for at intervals, and the heating model has none.
    """
    last = len(lines) - 1
    if keep.every is None:
        # what follows the sliding is not worth a picture
        last = int(np.flatnonzero(lines[:, k.SLIDES]).max(initial=0))
    every = replace(keep, profiles=min(keep.profiles, _MOST)).interval(last, heating)
    if every is None:
        return []
    return sorted({*range(every, last + 1, every), last, int(lines[:, k.POINT].argmax())})


def fields_at(
    moments: Sequence[int],
    time: FloatArray,
    lines: FloatArray,
    ratios: FloatArray,
    system: System,
    end: PlaneHeat,
    go_on: Callable[[int, int], tuple[PlaneHeat, float]],
) -> Fields:
    """Return the temperature of the plates at some samples of what is gone through again.

    Parameters
    ----------
    moments
        The samples.
    time, lines, ratios
        Times [s], histories, and the vertical force over that at rest, at all samples.
    system
        What is analysed.
    end
        The heat at the end.
    go_on
        Goes on from one sample to another, the first time from the start, and returns the heat there and the time since it was cold [s].
    """
    rows, columns = _hot(end)
    found: list[NDArray[np.float32]] = []
    for before, moment in pairwise((0, *moments)):
        heat, now = go_on(before, moment)
        grid = heat.field
        spans = grid.spans[:, rows] - columns.start
        part = replace(heat, field=grid._replace(points=grid.points[:, rows, columns], spans=spans))
        flux = system.bearing.pressure * float(ratios[moment]) * _rubbing(lines[moment])
        found.append(part.temperatures_of_all(system, now, flux).astype(np.float32))
    temperature = np.stack(found)
    temperature.flags.writeable = False
    across = int(end.field.points.shape[1])
    place = (np.arange(across) - across // 2) * end.field.spacing
    hottest = int(temperature.max(axis=(1, 2, 3)).argmax())
    return Fields(freeze(time[list(moments)]), freeze(place[columns]), freeze(place[rows]), temperature, hottest)  # fmt: skip


def _rubbing(line: FloatArray) -> float:
    """Return mu |v| at a sample [mm/s]; nothing while it sticks."""
    return float(line[k.SLIDES] * line[k.FRICTION] * np.hypot(line[k.VELOCITY_X], line[k.VELOCITY_Y]))


def _hot(heat: PlaneHeat) -> tuple[slice, slice]:
    """Return the rows and columns of the grids beyond which no point has felt anything."""
    points: FloatArray = heat.field.points
    spans = heat.field.spans
    across = np.arange(int(points.shape[2]))
    covered = (across >= spans[..., :1]) & (across < spans[..., 1:])
    hot = (covered | (points[..., :MODES] != 0.0).any(axis=-1)).any(axis=0)
    rows, columns = (np.flatnonzero(hot.any(axis=axis)) for axis in (1, 0))
    return slice(int(rows[0]), int(rows[-1]) + 1), slice(int(columns[0]), int(columns[-1]) + 1)
