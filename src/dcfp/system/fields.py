"""The heat in the plates under a disc of contact, as the kernels of the plane take it."""

import math
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray
from dcfp.errors import AnalysisError
from dcfp.kernels import plane_heat as k
from dcfp.kernels.friction import BearingModel
from dcfp.kernels.heat_state import DISC, RATIO
from dcfp.kernels.sum_of_exponentials import HORIZON, MODES
from dcfp.system.heating import PreciseHeating
from dcfp.system.plates import FIRST_REACH, PlateHeat, cold_plates, kernel_model
from dcfp.system.system import System

#: Points of all grids of a bearing that it may have, two gigabytes; of which only those are taken from the memory that the slider comes near.
MOST_POINTS = 16_000_000


@dataclass(frozen=True)
class PlaneHeat:
    """Heat in the plates, which the kernels change in place: that of the points that have felt every flux, and the grids, with the displacement that they have room for [mm]."""

    plates: PlateHeat
    field: k.Field
    reach: float

    def copy(self) -> "PlaneHeat":
        """Return a copy that shares no array with this one."""
        field = self.field
        grid = field._replace(
            points=field.points.copy(), spans=field.spans.copy(), tallies=field.tallies.copy()
        )
        return replace(self, plates=self.plates.with_room(0), field=grid)

    def with_room(self, factor: float, system: System) -> "PlaneHeat":
        """Return a copy that shares no array with this one, with room for a displacement of so many times the one before."""
        wider = cold_heat(system, factor * self.reach).field
        rows = self.field.points.shape[1]
        first = (wider.points.shape[1] - rows) // 2
        inside = slice(first, first + rows)
        wider.points[:, inside, inside] = self.field.points
        wider.spans[:] = 0
        wider.spans[:, inside] = self.field.spans + first
        wider.tallies[:] = self.field.tallies
        never = wider.tallies[:, k.PEAK_ROW] < 0.0
        wider.tallies[:, k.HOT_ROW : k.DISC_Y + 1] += first
        wider.tallies[never, k.PEAK_ROW] = -1.0
        return PlaneHeat(self.plates.with_room(0), wider, factor * self.reach)

    def model(self, system: System) -> BearingModel:
        """Return the kernels' view of a bearing under its own load, with this heat."""
        model = kernel_model(system, self.plates)
        if not isinstance(system.heating, PreciseHeating):
            return model
        return model._replace(heat=model.heat._replace(kind=DISC))

    def begin_peaks(self, system: System, time: float) -> None:
        """Begin the search for the hottest point anew at a time [s] at which nothing slides."""
        field, modes = self.field, self.plates.modes
        if not field.points.size:
            return
        for plate in range(field.points.shape[0]):
            own = self.temperatures(plate, system, time)
            row, column = np.unravel_index(int(own.argmax()), own.shape)
            field.tallies[plate, k.HOTTEST] = own[row, column]
            field.tallies[plate, [k.HOT_ROW, k.PEAK_ROW]] = row
            field.tallies[plate, [k.HOT_COLUMN, k.PEAK_COLUMN]] = column
            # above every difference from the common modes, so that all points are looked at once
            modes[k.PLATE_ROW + plate * k.PLATE_ROWS + k.BOUND] = np.abs(
                field.points[plate, ..., :MODES]
            ).max(axis=(0, 1))

    def temperatures(self, plate: int, system: System, time: float, flux: float = 0.0) -> FloatArray:
        """Return the temperature of every point of a plate [degC] at a time [s], under a `flux` of that plate [N/(mm s)], shape (rows, columns)."""
        field, modes = self.field, self.plates.modes
        rates, common = modes[k.RATES], modes[k.PLATE_ROW + plate * k.PLATE_ROWS + k.COMMON]
        points: FloatArray = field.points[plate]
        own, felt = np.zeros(points.shape[:2]), points[..., 0] != 0.0
        few = points[felt]
        own[felt] = (few[:, :MODES] * np.exp(rates * (few[:, MODES:] - time))).sum(axis=-1)
        columns = np.arange(int(field.points.shape[2]))
        first, beyond = field.spans[plate, :, :1], field.spans[plate, :, 1:]
        covered = (columns >= first) & (columns < beyond)
        at_once = self.plates.instant * system.heating.rise_factor * flux
        return system.heating.ambient + own + covered * (float(common.sum()) + at_once)

    def temperatures_of_all(self, system: System, time: float, flux: float = 0.0) -> FloatArray:
        """Return the temperature of the plates [degC] at a time [s] under a `flux` mu p |v| [N/(mm s)], shape (plates, rows, columns)."""
        workspace, shares = self.plates.workspace, (system.bearing.shares[0], system.bearing.shares[-1])
        each = [
            self.temperatures(plate, system, time, shares[plate] * float(workspace[RATIO + plate]) * flux)
            for plate in range(int(self.field.points.shape[0]))
        ]
        return np.stack(each)


def cold_heat(
    system: System, reach: float = FIRST_REACH, *, horizon: float = HORIZON, points: int | None = None
) -> PlaneHeat:
    """Return plates at the ambient temperature with room for a displacement of `reach` [mm]; other heating models than the precise one have no grid.

    The `horizon` [s] is as for `cold_plates`; `points` across the slider are those of the heating model unless they are fewer.

    Raises
    ------
    AnalysisError
        If the grids would be too large.
    """
    plates = cold_plates(system, reach=0.0, horizon=horizon)
    bearing, heating = system.bearing, system.heating
    radius, count = 0.5 * bearing.slider_diameter, len(set(bearing.radii))
    if not isinstance(heating, PreciseHeating):
        empty = k.Field(
            1.0, radius, np.zeros((count, 0, 0, MODES + 1)), np.zeros((count, 0, 2), np.int64), np.zeros((count, k.TALLIES))
        )  # fmt: skip
        return PlaneHeat(plates, empty, math.inf)
    points = heating.points if points is None else min(points, heating.points)
    spacing = bearing.slider_diameter / points
    middle = math.ceil((radius + max(bearing.shares) * reach) / spacing) + 3
    rows = 2 * middle + 1
    if count * rows**2 > MOST_POINTS:
        msg = (
            f"the slider of {bearing.slider_diameter:g} mm goes further than {0.5 * reach:.0f} mm, too far for the field of heat on {points} points"
            " across it; take fewer points, or the simplified heating model."
        )
        raise AnalysisError(msg)
    spans, tallies = _disc(middle, spacing, radius, heating.ambient)
    field = k.Field(
        spacing, radius, np.zeros((count, rows, rows, MODES + 1)), spans.repeat(count, axis=0), tallies.repeat(count, axis=0)
    )  # fmt: skip
    return PlaneHeat(plates, field, reach)


@lru_cache(maxsize=16)
def _disc(middle: int, spacing: float, radius: float, ambient: float) -> tuple[NDArray[np.int64], FloatArray]:
    """Return for a disc in the middle of a cold plate the first covered column of each row, and the first beyond, shape (1, rows, 2), and what is counted."""
    away = (np.arange(2 * middle + 1) - middle) * spacing
    inside = np.abs(away) <= radius
    half = np.floor(np.sqrt(np.maximum(radius**2 - away**2, 0.0)) / spacing).astype(np.int64)
    spans = np.where(inside[:, np.newaxis], np.column_stack((middle - half, middle + half + 1)), 0)
    tallies = np.zeros(k.TALLIES)
    tallies[[k.COVERED_POINTS, k.ALWAYS]] = float((spans[:, 1] - spans[:, 0]).sum())
    tallies[k.HOTTEST], tallies[k.PEAK_ROW] = ambient, -1.0
    tallies[[k.DISC_X, k.DISC_Y]] = middle
    spans.flags.writeable = tallies.flags.writeable = False
    return spans[np.newaxis], tallies[np.newaxis]
