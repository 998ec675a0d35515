"""What is said of a station before it is analysed: the march in the plane, and its two directions by themselves beside it."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cache
from typing import Any

import numpy as np

from dcfp.analysis.plane_history import analyse_plane
from dcfp.analysis.plane_response import PlaneResponse
from dcfp.inference.conditional import Experience, of_record
from dcfp.inference.earthquake import earthquake_of, event_of, read_earthquake
from dcfp.inference.statistics import Interval
from dcfp.inference.told import ENDS
from dcfp.methods.directions import predict_in_directions
from dcfp.methods.method import Information
from dcfp.methods.nodes import find_nodes
from dcfp.methods.plane_march import NAME, march_in_plane
from dcfp.methods.prediction import Methods
from dcfp.methods.pulse_march import march_through_pulses
from dcfp.methods.pulses import (
    CHANGE,
    DISPLACEMENT,
    NOTHING,
    PREDICTION_QUANTITIES,
    TOTAL,
    Prediction,
    value_of,
)
from dcfp.motion.named import station_set
from dcfp.motion.station import Station
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import DEGC, DEGREE, M_PER_S, MM, NONE
from dcfp.system import System

#: The root of the sum of the squares of what the march of each direction by itself says.
DIRECTIONS = "directions, SRSS"
#: Words for the stations that intervals come from.
SET = "the 50 stations of FEMA P-695"
#: Under what the intervals stand that know the PGV and the spectrum of the station, and no method.
BY_SPECTRUM = "PGV and spectrum"
#: What has an interval, and is compared.
COMPARED = (CHANGE, DISPLACEMENT, TOTAL)


@dataclass(frozen=True, eq=False)
class PlaneForecast:
    """What is predicted of one station at one PGV: the name of the method, what it knows, and the prediction."""

    station: Station
    system: System
    method: str
    prediction: Prediction
    basis: Information = Information.BLIND
    nodes: int | None = None  #: number of nodes of the ground velocity that it knows, of a march
    peak_temperature: float | None = None  #: of the contact [degC], of the march in the plane
    direction: float | None = (
        None  #: from x towards y, in which it says that [degrees]; None where it is of none
    )
    remarks: tuple[str, ...] = ()
    intervals: Mapping[Quantity, Interval] = field(default_factory=dict[Quantity, Interval])


@dataclass(frozen=True, eq=False)
class StationCase:
    """A station at one PGV, its earthquake, and what the analysis in the plane and the march say."""

    station: Station
    event: str
    analysed: Prediction
    said: Prediction


@cache
def calibration_stations() -> tuple[Station, ...]:
    """Return the stations that intervals come from, as they are."""
    return tuple(station_set("P695-stations") or ())


def peaks_of(response: PlaneResponse) -> Prediction:
    """Return what an analysis in the plane gives of what is predicted."""
    return Prediction(
        response.peak_change, math.nan, math.nan, response.peak_displacement, response.input_velocity
    )


def station_cases(
    pgv: float, methods: Methods, report: Callable[[], None] | None = None
) -> list[StationCase]:
    """Analyse and predict every station of the set at a PGV of the resultant [mm/s]; `report` is called after each."""
    cases: list[StationCase] = []
    for one in calibration_stations():
        station = one.scaled_to_pgv(pgv)
        analysed = peaks_of(analyse_plane(station, methods.system))
        said = march_in_plane(find_nodes(station, methods.march_tolerance), methods.system).prediction
        cases.append(StationCase(station, event_of(station), analysed, said))
        if report is not None:
            report()
    return cases


def _intervals(
    station: Station, said: Prediction, cases: Sequence[StationCase], methods: Methods
) -> tuple[dict[Quantity, Interval], dict[Quantity, Interval], list[str]]:
    """Return where the analysis will lie by the spectrum of the station, the same about the march, and what must be known of them."""
    earthquake = earthquake_of(station)
    others = [case for case in cases if not earthquake.may_be(read_earthquake(case.event))]
    experience = Experience.of(
        [case.station for case in others],
        [case.event for case in others],
        [case.analysed.bound for case in others],
        methods,
    )
    known = of_record(station, experience.periods)
    by_spectrum: dict[Quantity, Interval] = {}
    about: dict[Quantity, Interval] = {}
    beyond: dict[str, None] = {}
    for quantity in COMPARED:
        analysed, predicted = (
            np.array([value_of(one, quantity) for one in ones])
            for ones in ([case.analysed for case in others], [case.said for case in others])
        )
        with np.errstate(divide="ignore", invalid="ignore"):
            errors = np.log(analysed), np.log(analysed / predicted)
        for into, off, value in ((by_spectrum, errors[0], 1.0), (about, errors[1], value_of(said, quantity))):
            if value > 0.0 and (found := experience.interval(off, quantity, known, value)):
                into[quantity], words = found
                beyond |= dict.fromkeys(words)
    left = len(cases) - len(others)
    remarks = (
        [f"{station.name}: {left} of {SET} are left out of its intervals, as of the same earthquake."]
        if left
        else []
    )
    if beyond:
        remarks.append(
            f"{station.name}: it is beyond the stations that its intervals come from, by {' and '.join(beyond)}; the intervals are wider for that, by guess."
        )
    return by_spectrum, about, remarks


def forecast_station(
    station: Station, methods: Methods, calibration: Sequence[StationCase] | None = None
) -> list[PlaneForecast]:
    """Return what is predicted of a station: by the march in the plane, by marches of its directions, which heat plates of their own, and by the methods of one direction.

    Parameters
    ----------
    methods
        The bearing with its law and heating model, as for an analysis in the plane, and how the methods are set.
    calibration
        Other stations at the same PGV, from which the intervals come; those of the same earthquake do not count. None for no intervals.
    """
    system = methods.system
    march = march_in_plane(find_nodes(station, methods.march_tolerance), system)
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
    by_spectrum: dict[Quantity, Interval] = {}
    about: dict[Quantity, Interval] = {}
    if calibration is not None:
        by_spectrum, about, told = _intervals(station, said, calibration, methods)
        remarks += told
    found = [
        PlaneForecast(
            station,
            system,
            NAME,
            said,
            nodes=march.nodes,
            peak_temperature=march.peak_temperature,
            remarks=tuple(remarks),
            intervals=about,
        ),
        _by_directions(station, methods),
    ]
    found += [
        PlaneForecast(station, system, one.method, one.prediction, one.information, direction=one.direction)
        for one in predict_in_directions(station, methods)
    ]
    if by_spectrum:
        found.append(PlaneForecast(station, system, BY_SPECTRUM, NOTHING, intervals=by_spectrum))
    return found


def _by_directions(station: Station, methods: Methods) -> PlaneForecast:
    """Return the root of the sum of the squares of what the march of each direction by itself says."""
    nodes = [find_nodes(one, methods.march_tolerance) for one in (station.x, station.y)]
    each = [march_through_pulses(one, methods.system).prediction for one in nodes]
    srss = Prediction(
        math.hypot(*(one.displacement_change for one in each)),
        math.nan,
        math.nan,
        math.hypot(*(one.bound for one in each)),
        math.hypot(*(one.total_velocity or 0.0 for one in each)),
    )
    return PlaneForecast(station, methods.system, DIRECTIONS, srss, nodes=sum(one.count for one in nodes))


def _said(quantity: Quantity) -> Quantity:
    def get(one: PlaneForecast) -> float | None:
        return quantity.of(one.prediction)

    return replace(quantity, get=get)


#: A line for each station, PGV and method.
_STATION = (
    Quantity("record", "name of the station", head="Record", get="station.name"),
    Quantity(
        "pgv_m_s",
        "peak ground velocity of the resultant in m/s",
        get=lambda one: round(one.station.peak_velocity / 1e3, 12),
        printed=False,
    ),
    Quantity(
        "PGV",
        "peak ground velocity of the resultant",
        M_PER_S,
        decimals=3,
        get="station.peak_velocity",
        stored=False,
    ),
    Quantity("method", "method", head="Method", get="method"),
)
_SAID = (
    *(_said(one) for one in PREDICTION_QUANTITIES.values() if one.unit is MM or one is TOTAL),
    Quantity("temperature_max_degC", "highest temperature of the contact", DEGC, decimals=0, head="T", get="peak_temperature"),
    Quantity("nodes", "number of nodes of the ground velocity", NONE, decimals=0, head="Nodes", get="nodes"),
    Quantity("direction_deg", "direction from x towards y in which the method says that", DEGREE, decimals=0, head="In", get="direction"),
)  # fmt: skip


def _end(quantity: Quantity, end: str, *, printed: bool) -> Quantity:
    def get(one: PlaneForecast) -> float | None:
        found = one.intervals.get(quantity)
        return None if found is None else getattr(found, end)

    head = f"{quantity.head or quantity.title}\n{ENDS[end]}"
    return Quantity(f"{quantity.key}_{end}", f"{end} of {quantity.title}", quantity.unit, decimals=0, head=head, get=get, printed=printed)  # fmt: skip


def station_lines(forecasts: Sequence[PlaneForecast], *, with_intervals: bool = True) -> Table:
    """Return a line for each forecast; the ends of intervals are not printed."""
    ends = tuple(
        _end(quantity, end, printed=False) for quantity in COMPARED for end in ENDS if with_intervals
    )
    return Table(
        (*_STATION, *_SAID, *ends), [one for one in forecasts if one.method != BY_SPECTRUM or one.intervals]
    )


def station_interval_lines(forecasts: Sequence[PlaneForecast]) -> Table:
    """Return a line for each forecast with an interval."""
    ends = tuple(_end(quantity, end, printed=True) for quantity in COMPARED for end in ENDS)
    return Table((*_STATION, *ends), [one for one in forecasts if one.intervals])


#: Of a station and a PGV, as the object of one record has it.
_OF_STATION = (
    *_STATION[:2],
    Quantity("friction", "friction law", get="system.friction.name"),
    Quantity("heating", "heating model", get="system.heating.name"),
)
#: Of each prediction there.
_OF_PREDICTION = (
    Quantity("method", "method", get="method"),
    Quantity("basis", "what it knows", get="basis"),
    *map(_said, PREDICTION_QUANTITIES.values()),
    *_SAID[-3:],
)


def station_objects(forecasts: Sequence[PlaneForecast]) -> list[dict[str, Any]]:
    """Return an object for each station and PGV, ready for JSON, with what each method says and what a reader must know; intervals where they were asked for."""
    found: dict[int, dict[str, Any]] = {}
    said = Table(_OF_PREDICTION, forecasts).objects()
    for of, prediction, one in zip(Table(_OF_STATION, forecasts).objects(), said, forecasts, strict=True):
        told = found.setdefault(
            id(one.station), of | {"predictions": [], "interval_from_spectrum": None, "remarks": []}
        )
        interval = {kind.key: asdict(values) for kind, values in one.intervals.items()} or None
        if one.method == BY_SPECTRUM:
            told["interval_from_spectrum"] = interval
        else:
            told["predictions"].append(prediction | {"interval": interval})
        told["remarks"] += one.remarks
    return list(found.values())
