"""Measures of the ground motion of a station, in the plane of its horizontal components."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

from dcfp.arrays import FloatArray
from dcfp.motion.measures import MEASURES, arias_intensity, motion_remarks
from dcfp.motion.station import Station
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import DEGREE, GRAVITY, M_PER_S, M_PER_S2, NONE


class PrincipalAxes(NamedTuple):
    """The directions in which the two components of the acceleration are not correlated."""

    angle: float  #: of the stronger one, from x towards y [degrees], from -90 to 90
    ratio: float  #: of the root mean squares of the weaker to the stronger acceleration [-]


def principal_axes(station: Station) -> PrincipalAxes:
    """Return the horizontal principal axes of a station, of the whole record.

    Notes
    -----
    Penzien, J., and Watabe, M. (1975), Characteristics of 3-dimensional earthquake ground motions, Earthquake Engineering and Structural
    Dynamics 3, 365-373, doi:10.1002/eqe.4290030407: the axes of the matrix of the integrals of products of the accelerations over time, which
    are exact here for acceleration that is linear between samples.
    """
    x, y = station.acceleration.T
    xx, yy, xy = _product(x, x), _product(y, y), _product(x, y)
    middle, reach = 0.5 * (xx + yy), math.hypot(0.5 * (xx - yy), xy)
    angle = 0.5 * math.degrees(math.atan2(2.0 * xy, xx - yy))
    return PrincipalAxes(angle, math.sqrt(max(middle - reach, 0.0) / (middle + reach)) if middle else 0.0)


def _product(first: FloatArray, second: FloatArray) -> float:
    """Return the integral of a product over time, for a time step of one and both linear between samples."""
    ends = 2.0 * float(first[:-1] @ second[:-1] + first[1:] @ second[1:])
    return (ends + float(first[:-1] @ second[1:] + first[1:] @ second[:-1])) / 6.0


def direction_of_pgv(station: Station) -> float:
    """Return where the ground moves when its resultant velocity is largest, from x towards y, as a line [degrees], from -90 to 90."""
    velocity = station.velocity
    x, y = velocity[(velocity**2).sum(axis=1).argmax()]
    angle = math.degrees(math.atan2(y, x))
    return angle - 180.0 if angle > 90.0 else angle + 180.0 if angle <= -90.0 else angle


def station_remarks(station: Station) -> list[str]:
    """Return where its components point, and what `motion_remarks` tells of it."""
    told = [f"{station.name}: {station.orientation}."] if station.orientation else []
    return [*told, *motion_remarks(station)]


def _arias(station: Station) -> float:
    return arias_intensity(station.x) + arias_intensity(station.y)


def _azimuth(place: int) -> Callable[[Station], float | None]:
    return lambda station: None if station.azimuths is None else station.azimuths[place]


#: Those of one direction that are told of a station in the same way.
_SHARED = {
    one.key: one
    for one in MEASURES
    if one.key not in ("significant_duration_s", "cumulative_absolute_velocity_m_s")
}
_CHANGED = {
    "record": replace(_SHARED["record"], words="name of the station"),
    "component": replace(_SHARED["component"], words="components x, y and vertical", printed=False),
    "points": replace(_SHARED["points"], get="x.acceleration.size"),
    "pga_m_s2": replace(_SHARED["pga_m_s2"], words="peak ground acceleration of the resultant"),
    "pgv_m_s": replace(_SHARED["pgv_m_s"], words="peak ground velocity of the resultant"),
    "pgd_mm": replace(_SHARED["pgd_mm"], words="peak ground displacement of the resultant"),
    "arias_intensity_m_s": replace(
        _SHARED["arias_intensity_m_s"],
        words="sum of the Arias intensities of x and y",
        get=_arias,
    ),
    "remarks": replace(_SHARED["remarks"], get=station_remarks),
}
_OWN = [
    Quantity("pgv_x_m_s", "peak ground velocity of x", M_PER_S, decimals=3, name="pgv_x", head="PGV x", get="x.peak_velocity"),
    Quantity("pgv_y_m_s", "peak ground velocity of y", M_PER_S, decimals=3, name="pgv_y", head="PGV y", get="y.peak_velocity"),
    Quantity("pga_vertical_m_s2", "peak vertical ground acceleration", M_PER_S2, GRAVITY, 3, name="pga_vertical", head="PGA up",
             get=lambda one: None if one.vertical is None else one.vertical.peak_acceleration),
    Quantity("direction_pgv_deg", "direction of the peak ground velocity, from x towards y", DEGREE, decimals=0, name="direction_pgv", head="dir. PGV", get=direction_of_pgv),
    Quantity("principal_axis_deg", "direction of the stronger principal axis of the acceleration, from x towards y", DEGREE, decimals=0, name="principal_axis", head="axis",
             get=lambda one: principal_axes(one).angle),
    Quantity("principal_ratio", "weaker over stronger principal acceleration, root mean squares", NONE, decimals=2, head="ratio", get=lambda one: principal_axes(one).ratio),
    Quantity("azimuth_x_deg", "where x points, clockwise from north", DEGREE, name="azimuth_x", get=_azimuth(0), printed=False),
    Quantity("azimuth_y_deg", "where y points, clockwise from north", DEGREE, name="azimuth_y", get=_azimuth(1), printed=False),
]  # fmt: skip
_LAST = ("baseline_drift", "treatment", "remarks")

#: What is told of a station.
STATION_MEASURES = [
    *(_CHANGED.get(key, one) for key, one in _SHARED.items() if key not in _LAST),
    *_OWN,
    *(_CHANGED.get(key, _SHARED[key]) for key in _LAST),
]
