"""The ground velocity as a line of straight legs: nodes after Douglas and Peucker (1973), moved and fitted by least squares."""

import math
from dataclasses import dataclass, field, replace

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.kernels import plane_nodes as plane
from dcfp.kernels.nodes import (
    BLOCK,
    FIT_SIZE,
    SUMS,
    WAITING_SIZE,
    choose_nodes,
    fit_nodes,
    move_nodes,
    moving,
    peak_of,
    squares_beside,
    write_sums,
)
from dcfp.methods.pulses import scaled_velocities
from dcfp.motion.load import Motion, motion_of
from dcfp.motion.station import Station
from dcfp.schema.notebook import card
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import FRACTION, MM_PER_S, SECOND

#: How far the ground velocity may be from a leg before it is cut, and what is usual; see ``docs/prediction.md`` for the evidence.
LEAVE = Parameter(
    "part of PGV by which the ground velocity may leave a straight leg",
    FRACTION,
    0.0,
    1.0,
    above=True,
)
TOLERANCE = 0.1
#: How often the nodes are moved before their velocities are fitted.
MOVES = 2


@dataclass(frozen=True, eq=False)
class Nodes:
    """Where the legs of a ground velocity meet that is straight in between; of a station in both directions at once."""

    times: FloatArray = field(metadata={"unit": SECOND})  #: [s], shape (n,), increasing
    velocities: FloatArray = field(
        metadata={"unit": MM_PER_S}
    )  #: of the ground there [mm/s], shape (n,) or (n, 2)
    tolerance: float = (
        TOLERANCE  #: part of PGV by which the ground velocity leaves the legs before the fit [-]
    )
    misfit: float = 0.0  #: root mean square of the ground velocity beside the legs, over its own [-]

    def __post_init__(self) -> None:
        times = np.asarray(self.times, dtype=np.float64)
        velocities = np.asarray(self.velocities, dtype=np.float64)
        if times.ndim != 1 or velocities.shape not in (times.shape, (times.size, 2)):
            msg = f"The nodes need as many times as velocities, not {times.size} and {velocities.shape[0]}."
            raise InputError(msg)
        if not (
            np.isfinite(times).all() and np.isfinite(velocities).all() and (times[1:] > times[:-1]).all()
        ):
            msg = "The times of the nodes must be finite and increase, and their velocities be finite."
            raise InputError(msg)
        object.__setattr__(self, "times", freeze(times))
        object.__setattr__(self, "velocities", freeze(velocities))

    @property
    def count(self) -> int:
        """Number of nodes."""
        return self.times.size

    def scaled(self, factor: float) -> "Nodes":
        """Return the nodes of the same motion multiplied by `factor` [-].

        Raises
        ------
        InputError
            If the factor is zero or not a finite number.
        """
        return replace(self, velocities=scaled_velocities(self.velocities, factor, "Nodes"))

    def _repr_html_(self) -> str:
        rows = [
            {"node [s]": time, "velocity [mm/s]": ", ".join(f"{one:.4g}" for one in np.atleast_1d(velocity))}
            for time, velocity in zip(self.times.tolist(), self.velocities, strict=True)
        ]
        return card(f"{self.count} nodes of a ground velocity", {"tolerance": self.tolerance}, rows=rows)


def find_nodes(motion: Motion | Station, tolerance: float = TOLERANCE, *, fitted: bool = True) -> Nodes:
    """Return the nodes of a ground velocity, from where it begins to accelerate to where it ceases.

    They do not depend on where the motion was sampled, nor on its sign, scale or quiet before and after; of a station nor on where x and y point.

    Parameters
    ----------
    motion
        The ground motion, or that of a station; or the name of a record, or a file.
    tolerance
        Part of the PGV, of a station of the resultant [-], above 0 and at most 1.
    fitted
        Whether the legs are moved and fitted to the ground velocity by least squares; else the nodes lie on it.

    Raises
    ------
    InputError
        If the tolerance is out of range.
    """
    tolerance = LEAVE.checked(tolerance, "The tolerance of the legs")
    if isinstance(motion, Station):
        return _of_station(motion, tolerance, fitted)
    motion = motion_of(motion)
    step, velocity = motion.time_step, motion.velocity
    per_sample = motion.acceleration * step
    limit = tolerance * peak_of(per_sample, velocity)
    if limit == 0.0:
        return Nodes(np.empty(0), np.empty(0), tolerance)
    first, last = moving(per_sample)
    bows, waiting, places = _room(velocity.size)
    places = places[: choose_nodes(per_sample, velocity, first, last, limit, bows, waiting, places)]
    velocities, work = np.empty(places.size), np.empty((places.size, FIT_SIZE))
    sums = np.empty((velocity.size - 1, SUMS))
    write_sums(per_sample, velocity, sums)
    for _ in range(MOVES if fitted else 0):
        move_nodes(per_sample, velocity, sums, places, work)
    fit_nodes(per_sample, velocity, sums, places, work, fitted, velocities)
    return Nodes(
        places * step,
        velocities,
        tolerance,
        _misfit(squares_beside(per_sample, velocity, sums, places, velocities)),
    )


def _room(samples: int) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the arrays in which nodes are chosen, the last for their places."""
    most = 2 * samples
    return np.empty((samples - 2) // BLOCK + 1), np.empty((most, WAITING_SIZE)), np.empty(most)


def _of_station(station: Station, tolerance: float, fitted: bool) -> Nodes:
    """Return the nodes of a station."""
    step = station.time_step
    vx, vy = station.x.velocity, station.y.velocity
    ax, ay = station.x.acceleration * step, station.y.acceleration * step
    limit = tolerance * plane.plane_peak_of(ax, ay, vx, vy)
    if limit == 0.0:
        return Nodes(np.empty(0), np.empty((0, 2)), tolerance)
    begin, cease = zip(moving(ax), moving(ay), strict=True)
    bows, waiting, places = _room(vx.size)
    count = plane.choose_plane_nodes(ax, ay, vx, vy, min(begin), max(cease), limit, bows, waiting, places)
    places = places[:count]
    velocities, work = np.empty((2, count)), np.empty((count, plane.MOVE_SIZE))
    sums = np.empty((2, vx.size - 1, SUMS))
    write_sums(ax, vx, sums[0])
    write_sums(ay, vy, sums[1])
    for _ in range(MOVES if fitted else 0):
        plane.move_plane_nodes(ax, ay, vx, vy, sums, places, work)
    squares = np.zeros(2)
    for acceleration, velocity, of, found in (
        (ax, vx, sums[0], velocities[0]),
        (ay, vy, sums[1], velocities[1]),
    ):
        fit_nodes(acceleration, velocity, of, places, work, fitted, found)
        squares += squares_beside(acceleration, velocity, of, places, found)
    return Nodes(places * step, velocities.T, tolerance, _misfit(squares))


def _misfit(squares: tuple[float, float] | FloatArray) -> float:
    beside, own = squares
    return math.sqrt(beside / own) if own > 0.0 else 0.0
