"""A vertical component for stations of the package, which have none."""

from dataclasses import replace

import numpy as np

import dcfp
from dcfp import Station
from dcfp.constants import STANDARD_GRAVITY

#: How much faster than the component of which it is made.
_FASTER = 2.5


def with_vertical(station: Station, peak: float, of: str = "P695-FF-3") -> Station:
    """Return the station with component x of another one, made faster, for its vertical one, with this peak [g]."""
    other = dcfp.load_station(of)
    assert other is not None
    times = np.arange(len(station.acceleration)) * station.time_step
    own_times = np.arange(len(other.x.acceleration)) * other.time_step / _FASTER
    wave = np.interp(times, own_times, other.x.acceleration, right=0.0)
    rising = wave * peak * STANDARD_GRAVITY / np.abs(wave).max()
    return replace(station, vertical=replace(station.x, acceleration=rising))
