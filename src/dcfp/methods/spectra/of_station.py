"""Elastic response spectra of a station, in any direction and over all of them: Boore (2010)."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.kernels import all_directions as k
from dcfp.methods.spectra.of_record import (
    DAMPING,
    PERIODS,
    ResponseSpectrum,
    checked,
    coefficients,
    pieces,
)
from dcfp.motion.ground_motion import refined
from dcfp.motion.station import Station
from dcfp.schema.notebook import fields_card
from dcfp.schema.parameters import refuse_other
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import DEGREE, M_PER_S, M_PER_S2, MM, MM_PER_S2, SECOND

#: Directions of half a turn, from x towards y [degrees]; in the other half are the same displacements.
ANGLES = freeze(np.arange(180.0))
#: Samples in a period that are looked at first, to find what most of the others cannot exceed.
_IN_PERIOD = 10
_DIRECTIONS = freeze(np.column_stack((np.sin(np.radians(90.0 - ANGLES)), np.sin(np.radians(ANGLES)))))


@dataclass(frozen=True, eq=False)
class StationSpectrum:
    """The largest response of elastic oscillators to a station, in every direction."""

    periods: FloatArray = field(metadata={"unit": SECOND})  #: [s], shape (n,)
    damping: float  #: ratio of critical damping [-]
    directions: FloatArray = field(
        repr=False
    )  #: spectral displacement by direction of `ANGLES` [mm], shape (n, 180)
    name: str = "station"

    def rotated(self, percent: float) -> FloatArray:
        """RotDnn: what so many percent of the directions stay below, period by period [mm], shape (n,); Boore (2010).

        Raises
        ------
        InputError
            If it is not between 0 and 100 percent.
        """
        if not 0.0 <= percent <= 100.0:
            msg = f"{self.name}: RotDnn is of 0 to 100 percent of the directions, not {percent!r}."
            raise InputError(msg)
        return np.percentile(self.directions, percent, axis=1)

    @property
    def x(self) -> FloatArray:
        """Spectral displacement of the first component [mm], shape (n,)."""
        return self.directions[:, 0]

    @property
    def y(self) -> FloatArray:
        """Spectral displacement of the second component [mm], shape (n,)."""
        return self.directions[:, len(ANGLES) // 2]

    @property
    def largest_direction(self) -> FloatArray:
        """Direction of the largest displacement, from x towards y [degrees], shape (n,)."""
        return ANGLES[np.argmax(self.directions, axis=1)]

    def measured(self, measure: str) -> ResponseSpectrum:
        """Return the response spectrum by a measure of `PAIR_MEASURES`.

        Raises
        ------
        InputError
            If there is none of that name.
        """
        if measure not in PAIR_MEASURES:
            msg = f"the measure of a pair is one of {', '.join(PAIR_MEASURES)}, not {measure!r}."
            raise InputError(msg)
        said = PAIR_MEASURES[measure]
        return ResponseSpectrum(
            self.periods, self.damping, freeze(said.get(self)), f"{said.title} of {self.name}"
        )

    def _repr_html_(self) -> str:
        return fields_card(self, f"Response spectra of {self.name}")


class PairMeasure(NamedTuple):
    """How the spectra of all directions become one."""

    title: str
    words: str
    get: Callable[[StationSpectrum], FloatArray]  #: returns the spectral displacement [mm], shape (n,)


def _median(one: StationSpectrum) -> FloatArray:
    return one.rotated(50.0)


def _largest(one: StationSpectrum) -> FloatArray:
    return one.rotated(100.0)


def _hypotenuse(one: StationSpectrum) -> FloatArray:
    return np.hypot(one.x, one.y)


def _mean(one: StationSpectrum) -> FloatArray:
    return np.sqrt(one.x * one.y)


#: The measures of a pair by their names.
PAIR_MEASURES = {
    "rotd50": PairMeasure("RotD50", "median of all directions", _median),
    "rotd100": PairMeasure("RotD100", "largest of all directions", _largest),
    "srss": PairMeasure("SRSS", "square root of the sum of the squares of x and y", _hypotenuse),
    "geomean": PairMeasure("geometric mean", "geometric mean of x and y", _mean),
}


def station_spectrum(
    station: Station, periods: FloatArray = PERIODS, damping: float = DAMPING
) -> StationSpectrum:
    """Return the response spectra of the horizontal motion of a station in 180 directions, each as exact as `response_spectrum` is of one.

    Parameters
    ----------
    station
        The ground motion; what oscillates on after its end does not count.
    periods
        [s], increasing.
    damping
        Ratio of critical damping [-].

    Raises
    ------
    InputError
        If a period or the damping is out of range, or it is no station.

    Notes
    -----
    Boore, D. M. (2010), Orientation-independent, nongeometric-mean measures of seismic intensity from two horizontal components of motion,
    Bulletin of the Seismological Society of America 100, 1830-1835, doi:10.1785/0120090400: for each period by itself the largest
    displacement in each direction, and of these RotDnn.
    """
    refuse_other(station, Station, "station", "a Station, as of load_station")
    periods = checked(periods, damping)
    peaks = np.zeros((periods.size, ANGLES.size))
    work = np.empty((k.WORKED, k.SECTORS))
    for part, parts in pieces(station.time_step, periods):
        step = station.time_step / max(parts, 1)
        acceleration = np.column_stack([refined(one, parts) for one in station.acceleration.T])
        own = periods[part]
        turn = 2.0 * np.pi * step / own
        # while it turns, an oscillator accelerates by no more than its spring and the ground do
        slack = np.array(
            [turn**2 / 8.0, np.full(own.size, step**2 / 8.0 * station.peak_acceleration)]
        ) * bool(parts)
        rows = coefficients(own.tobytes(), damping, step)
        every = np.maximum(1, own / step / _IN_PERIOD).astype(np.int64)
        k.respond_in_all_directions(rows, step if parts else None, acceleration, _DIRECTIONS, slack, every, work, peaks[part])  # fmt: skip
    return StationSpectrum(freeze(periods), damping, freeze(peaks), station.name)


class StationOrdinates(NamedTuple):
    """The spectra of a station at one period [s, mm, degrees]."""

    motion: Station
    period: float
    displacements: dict[str, float]  #: by measure
    x: float
    y: float
    direction: float


def station_ordinates(station: Station, spectrum: StationSpectrum) -> list[StationOrdinates]:
    """Return the spectra of a station at every period."""
    measures = {name: one.get(spectrum).tolist() for name, one in PAIR_MEASURES.items()}
    columns = (spectrum.periods, spectrum.x, spectrum.y, spectrum.largest_direction)
    return [
        StationOrdinates(
            station, period, {name: values[place] for name, values in measures.items()}, x, y, direction
        )
        for place, (period, x, y, direction) in enumerate(np.column_stack(columns).tolist())
    ]


def _displacement(name: str) -> Callable[[StationOrdinates], float]:
    return lambda one: one.displacements[name]


def _acceleration(displacement: Callable[[StationOrdinates], float]) -> Callable[[StationOrdinates], float]:
    return lambda one: displacement(one) * (2.0 * np.pi / one.period) ** 2


def _component(name: str) -> Callable[[StationOrdinates], float]:
    return lambda one: getattr(one, name)


STATION_ORDINATES = [
    Quantity("record", "name of the station", head="Record", get="motion.name"),
    Quantity("pgv_m_s", "peak ground velocity of the resultant", M_PER_S, decimals=3, places=12, name="pgv", head="PGV", get="motion.peak_velocity"),
    Quantity("period_s", "period", SECOND, digits=3, name="period", head="T", get="period"),
    *(
        Quantity(f"S_a_{name}_mm_s2", f"pseudo-acceleration, {one.words}", MM_PER_S2, M_PER_S2, 3, name=f"S_a_{name}", head=one.title.replace("geometric", "geom."), get=_acceleration(_displacement(name)))
        for name, one in PAIR_MEASURES.items()
    ),
    *(
        Quantity(f"S_d_{name}_mm", f"spectral displacement, {one.words}", MM, decimals=1, name=f"S_d_{name}", head=one.title, get=_displacement(name), printed=name == "rotd100")
        for name, one in PAIR_MEASURES.items()
    ),
    *(
        Quantity(f"S_d_{name}_mm", f"spectral displacement of component {name}", MM, decimals=1, name=f"S_d_{name}", get=_component(name), printed=False)
        for name in ("x", "y")
    ),
    Quantity("direction_deg", "direction of the largest displacement, from x towards y", DEGREE, decimals=0, name="direction", head="direction", get="direction"),
]  # fmt: skip
