"""What is said of a station before it is analysed: the march in the plane, and its two directions by themselves beside it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from dcfp.methods.method import Information
from dcfp.methods.nodes import TOLERANCE, find_nodes
from dcfp.methods.plane_march import NAME, march_in_plane
from dcfp.methods.pulse_march import march_through_pulses
from dcfp.methods.pulses import PREDICTION_QUANTITIES, TOTAL, Prediction
from dcfp.motion.station import Station
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import DEGC, M_PER_S, MM, NONE
from dcfp.system import System

#: The root of the sum of the squares of what the march of each direction by itself says.
DIRECTIONS = "directions, SRSS"
#: What there is not.
NO_INTERVAL = (
    "No interval is given in the plane yet: those of one direction have not been calibrated on analyses of stations."
    " The methods of Li et al. (2020) are of one direction."
)


@dataclass(frozen=True, eq=False)
class PlaneForecast:
    """What is predicted of one station at one PGV: the name of the method, the prediction, and the number of nodes that it knows.

    The highest temperature of the contact [degC] is that of the march in the plane; of the directions by themselves there is none.
    """

    station: Station
    system: System
    method: str
    prediction: Prediction
    nodes: int
    peak_temperature: float | None
    remarks: tuple[str, ...] = ()


def forecast_station(station: Station, system: System, tolerance: float = TOLERANCE) -> list[PlaneForecast]:
    """Return what is predicted of a station: in the plane, and from its directions by themselves, which heat plates of their own.

    Parameters
    ----------
    system
        The bearing with its law and heating model, as for an analysis in the plane.
    tolerance
        See `find_nodes`.
    """
    march = march_in_plane(find_nodes(station, tolerance), system)
    said = march.prediction
    capacity, note = system.bearing.displacement_capacity, system.bearing.capacity_note
    remarks: list[str] = []
    if capacity is not None and said.bound > capacity:
        words = f" ({note})" if note else ""
        remarks.append(
            f"{station.name}: the y_max of {said.bound:.0f} mm by the march goes beyond the capacity of {capacity:.0f} mm{words}."
        )
    if not march.rests:
        remarks.append(f"{station.name}: the march still slides two minutes after the last node.")
    nodes = [find_nodes(one, tolerance) for one in (station.x, station.y)]
    each = [march_through_pulses(one, system).prediction for one in nodes]
    srss = replace(
        said,
        displacement_change=math.hypot(*(one.displacement_change for one in each)),
        displacement=math.hypot(*(one.bound for one in each)),
        total_velocity=math.hypot(*(one.total_velocity or 0.0 for one in each)),
    )
    return [
        PlaneForecast(station, system, NAME, said, march.nodes, march.peak_temperature, tuple(remarks)),
        PlaneForecast(station, system, DIRECTIONS, srss, sum(one.count for one in nodes), None),
    ]


def _said(quantity: Quantity) -> Quantity:
    def get(one: PlaneForecast) -> float | None:
        return quantity.of(one.prediction)

    return replace(quantity, get=get)


#: A line for each station, PGV and method.
COLUMNS = (
    Quantity("record", "name of the station", head="Record", get="station.name"),
    Quantity("pgv_m_s", "peak ground velocity of the resultant in m/s", get=lambda one: round(one.station.peak_velocity / 1e3, 12), printed=False),
    Quantity("PGV", "peak ground velocity of the resultant", M_PER_S, decimals=3, get="station.peak_velocity", stored=False),
    Quantity("method", "method", head="Method", get="method"),
    *(_said(one) for one in PREDICTION_QUANTITIES.values() if one.unit is MM or one is TOTAL),
    Quantity("temperature_max_degC", "highest temperature of the contact", DEGC, decimals=0, head="T", get="peak_temperature"),
    Quantity("nodes", "number of nodes of the ground velocity", NONE, decimals=0, head="Nodes", get="nodes"),
)  # fmt: skip


def station_lines(forecasts: Sequence[PlaneForecast]) -> Table:
    """Return a line for each forecast."""
    return Table(COLUMNS, forecasts)


#: Of a station and a PGV, as the object of one record has it.
_OF_STATION = (
    *COLUMNS[:2],
    Quantity("friction", "friction law", get="system.friction.name"),
    Quantity("heating", "heating model", get="system.heating.name"),
)
#: Of each prediction there.
_OF_PREDICTION = (
    Quantity("method", "method", get="method"),
    Quantity("basis", "what it knows", get=lambda _: Information.BLIND.value),
    *map(_said, PREDICTION_QUANTITIES.values()),
    *COLUMNS[-2:],
)


def station_objects(forecasts: Sequence[PlaneForecast]) -> list[dict[str, Any]]:
    """Return an object for each station and PGV, ready for JSON, with what each method says and what a reader must know; there are no intervals."""
    found: dict[int, dict[str, Any]] = {}
    said = Table(_OF_PREDICTION, forecasts).objects()
    for of, prediction, one in zip(Table(_OF_STATION, forecasts).objects(), said, forecasts, strict=True):
        told = found.setdefault(
            id(one.station), of | {"predictions": [], "interval_from_pgv": None, "remarks": []}
        )
        told["predictions"].append(prediction | {"interval": None})
        told["remarks"] += one.remarks
    for told in found.values():
        told["remarks"].append(NO_INTERVAL)
    return list(found.values())
