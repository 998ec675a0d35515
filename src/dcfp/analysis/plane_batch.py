"""Many response history analyses of stations in the plane, without their histories."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from dcfp.analysis.integration import DEFAULT, Integration
from dcfp.analysis.lanes import Lanes
from dcfp.analysis.plane_history import analyse_plane
from dcfp.analysis.response import FAILED, NUMBERS
from dcfp.errors import AnalysisError
from dcfp.motion.station import Station

#: What is told of each lane, by the names of a `PlaneResponse`.
PEAKS = (
    "peak_displacement", "peak_displacement_x", "peak_displacement_y", "peak_change", "peak_velocity", "peak_force", "force_ratio",
    "peak_temperature", "peak_point_temperature", "least_friction", "residual_displacement", "least_load", "largest_load", "uplift",
    "input_velocity", "hysteretic_velocity",
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class StationSet:
    """Stations, unscaled, how finely and far each is stepped through, and whether the vertical force follows their vertical components."""

    stations: Sequence[Station]
    integration: Integration = DEFAULT
    vertical: bool = False

    def __post_init__(self) -> None:
        """Refuse a station that lacks the vertical component where it is needed."""
        for one in self.stations if self.vertical else ():
            one.require_vertical()

    @cached_property
    def steps(self) -> "np.ndarray[tuple[int], np.dtype[np.int64]]":
        """Samples of each station, a measure of what an analysis under it costs."""
        return np.array([one.x.acceleration.size for one in self.stations])


def respond_to_stations(
    grounds: StationSet, lanes: Lanes
) -> dict[str, NDArray[np.float64] | NDArray[np.uint8]]:
    """Analyse every lane as `dcfp.analysis.batch.respond_in_batch`, in the plane."""
    peaks = {name: np.full(len(lanes), np.nan) for name in PEAKS}
    status = np.full(len(lanes), FAILED, dtype=np.uint8)
    scaled, of = None, (-1, np.nan)
    for i in range(len(lanes)):
        record, scale = int(lanes.record[i]), float(lanes.scale[i])
        if scaled is None or of != (record, scale):
            scaled, of = grounds.stations[record].scaled(scale), (record, scale)
        model = lanes.models[int(lanes.model[i])]
        try:
            response = analyse_plane(scaled, model, grounds.integration, vertical=grounds.vertical)
        except AnalysisError:
            continue
        status[i] = NUMBERS[response.status]
        for name in PEAKS:
            peaks[name][i] = getattr(response, name)
    return {**peaks, "status": status}
