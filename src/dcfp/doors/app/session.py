"""What belongs to one visitor: what stands in the fields and the system that it makes, what is chosen, and records that are sent, read from memory, within limits."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cache
from itertools import takewhile
from pathlib import PurePosixPath
from typing import Any

from dcfp.analysis.integration import usual_heating
from dcfp.doors.app.elements import Units
from dcfp.errors import InputError
from dcfp.motion.ground_motion import LONGEST_TAIL, GroundMotion
from dcfp.motion.load import STATION_MARK, motions_of
from dcfp.motion.named import named_motion, named_records, named_station
from dcfp.motion.station import Station, joined
from dcfp.schema.declared import Declared, parameters
from dcfp.schema.parameters import Parameter
from dcfp.system import (
    FRICTION_LAWS,
    HEATINGS,
    LI_2020,
    Bearing,
    FrictionLaw,
    Heating,
    System,
    system_parameters,
)
from dcfp.system.system import OF_LAW

#: Fields of the two plates, whose radii are one parameter of a bearing.
RADII = ("lower_radius", "upper_radius")
#: What the friction of a new page is, and its heat.
_BEGIN = System(LI_2020)
#: Largest file [bytes], most files and most components that one visitor can have.
LARGEST_FILE, MOST_FILES, MOST_COMPONENTS = 20_000_000, 12, 36
#: Most time steps of an analysis with the rest after the record: what a page can be kept waiting for.
MOST_STEPS = 1_000_000
_LONGEST_NAME = 80


@cache
def _named(name: str) -> GroundMotion | Station:
    """Return a record that comes with the package; it stays in memory, for every change of a field analyses it anew."""
    return named_station(name) or named_motion(name)


def capitalised(words: str) -> str:
    """Return words with a capital first letter, and the others as they are."""
    return words[:1].upper() + words[1:]


def read_field(one: Parameter, value: Any) -> Any:
    """Return what stands in a field in the package's unit.

    Raises
    ------
    InputError
        If the field is empty, or its value is not allowed.
    """
    if value is None and not one.optional:
        msg = f"The {one.words}{f' {one.unit.heading}' if one.unit.has_dimension else ''} is missing."
        raise InputError(msg)
    if one.counts and isinstance(value, str):
        value = value.split(",")
    return one.read(value, f"The {one.words}")


def read_fields(fields: Mapping[str, Parameter], values: Mapping[str, Any]) -> dict[str, Any]:
    """Return what stands in some fields by the names of their parameters; raises as `read_field`."""
    return {one.name: read_field(one, values[key]) for key, one in fields.items()}


def bearing_fields() -> dict[str, Parameter]:
    """Return the parameters of a bearing that have a field, with a radius for each plate."""
    known = system_parameters()
    first = takewhile(lambda key: key != "law", known)
    return {key: known[key] for key in first if known[key].is_number and not known[key].counts}


def fields_of(kind: type[Declared], before: str = "") -> dict[str, Parameter]:
    """Return the parameters of a declared class that have a field: all but free words; keys begin with `before`."""
    found = parameters(kind).values()
    return {before + one.key: one for one in found if one.is_number or one.kind is bool or one.choices}


def _written(fields: Mapping[str, Parameter], thing: object) -> dict[str, Any]:
    return {key: one.written(getattr(thing, one.name)) for key, one in fields.items()}


def _values_of(system: System) -> dict[str, Any]:
    law, heating = system.friction, system.heating
    of_bearing = {key: one for key, one in bearing_fields().items() if key not in RADII}
    return {
        **dict(zip(RADII, system.bearing.radii, strict=True)),
        **_written(of_bearing, system.bearing),
        "law": law.name,
        **_written(fields_of(type(law), OF_LAW), law),
        "heating": heating.name,
        **_written(fields_of(type(heating)), heating),
    }


class BearingForm:
    """The fields of a bearing, its friction law and its heating model, by key, in the units beside them; at first the paper's values, None in an empty one."""

    def __init__(self) -> None:
        self.values = _values_of(_BEGIN)

    @property
    def law(self) -> type[FrictionLaw]:
        """The friction law that is chosen."""
        return FRICTION_LAWS.find(self.values["law"])

    @property
    def heating(self) -> type[Heating]:
        """The heating model that is chosen."""
        return HEATINGS.find(self.values["heating"])

    def law_fields(self) -> dict[str, Parameter]:
        """Return the parameters of the chosen law that have a field, its reference coefficient first."""
        fields, first = fields_of(self.law, OF_LAW), self.reference
        return {first: fields.pop(first), **fields} if first else fields

    def heating_fields(self) -> dict[str, Parameter]:
        """Return the parameters of the chosen heating model that have a field."""
        return fields_of(self.heating)

    @property
    def reference(self) -> str:
        """Key of the reference coefficient of the chosen law; empty where it has none."""
        name = self.law.reference_parameter
        return next((key for key, one in fields_of(self.law, OF_LAW).items() if one.name == name), "")

    def put(self, key: str, value: Any) -> None:
        """Put a value into a field; another law or heating model brings its own parameters, and a reference coefficient scales its law."""
        if key == "law":
            law = FRICTION_LAWS.find(value)
            self.values |= _written(fields_of(law, OF_LAW), law())
        elif key == "heating":
            for name, one in fields_of(HEATINGS.find(value)).items():
                self.values.setdefault(name, one.written(one.default))
        elif key == self.reference:
            self._scale(value)
        self.values[key] = value

    def reset(self) -> None:
        """Put the paper's values into every field."""
        self.values = _values_of(_BEGIN)

    def system(self) -> System:
        """Return what the fields hold.

        Raises
        ------
        InputError
            If a field is empty, or its value is not allowed.
        """
        bearing = self._bearing()
        return System(bearing, self._law(), self.heating(**read_fields(self.heating_fields(), self.values)))

    def _bearing(self) -> Bearing:
        fields = bearing_fields()
        found = read_fields(fields, self.values)
        found["radii"] = tuple(read_field(fields[key], self.values[key]) for key in RADII)
        if all(getattr(LI_2020, name) == value for name, value in found.items()):
            return LI_2020
        return Bearing(**found, name="bearing of the page")

    def _law(self) -> FrictionLaw:
        return self.law(**read_fields(self.law_fields(), self.values))

    def _scale(self, reference: Any) -> None:
        """Put in what a reference coefficient makes of the law's other parameters, where it and they are allowed."""
        fields = self.law_fields()
        try:
            law = self._law().with_reference(read_field(fields[self.reference], reference))
        except InputError:
            return
        self.values |= _written(fields, law)


# Records that a visitor sends: read from memory, within limits.


@dataclass(frozen=True, eq=False)
class Upload:
    """One component of a file, its name by which a scenario finds it beside itself, and how a plain file is read."""

    motion: GroundMotion
    file: str
    options: dict[str, str | float]


def read_upload(
    content: bytes, name: str, *, units: str | None = None, time_step: float | None = None
) -> list[Upload]:
    """Return the components of a file that was sent, with the name that its sender gave it; `units` and `time_step` are as for `dcfp.motion.load.read_motions`.

    Raises
    ------
    InputError
        If it is too large, or no record.
    """
    shown = plain_name(name)
    if len(content) > LARGEST_FILE:
        raise InputError(too_large(shown))
    motions = motions_of(content, shown, units=units, time_step=time_step)
    for motion in motions:
        steps = motion.acceleration.size + LONGEST_TAIL / motion.time_step
        if steps > MOST_STEPS:
            msg = (
                f"{shown}: with a time step of {motion.time_step:g} s this record is too long for the page, which takes"
                f" {MOST_STEPS:,} steps; analyse it in Python or on the command line."
            )
            raise InputError(msg)
    given = {"units": units, "time_step": time_step}
    options = {name: value for name, value in given.items() if value is not None}
    if len(motions) == 1:
        return [Upload(motions[0], shown, options)]
    return [Upload(motion, f"{shown}::{motion.origin.component}", options) for motion in motions]


def plain_name(name: str) -> str:
    """Return the last part of a file's name without control characters, shortened; never empty."""
    last = PurePosixPath(name.replace("\\", "/")).name
    clean = "".join(letter for letter in last if letter.isprintable()).strip()
    clean = re.sub(r"\s+", " ", clean).lstrip(".") or "record"
    return clean if len(clean) <= _LONGEST_NAME else f"{clean[: _LONGEST_NAME - 9]}…{clean[-8:]}"


def too_large(name: str) -> str:
    """Return what is said of a file that is too large."""
    return (
        f"{plain_name(name)}: the file is larger than {LARGEST_FILE / 1e6:.0f} MB, so it is not one record."
    )


@cache
def named_choices() -> dict[str, str]:
    """Return the named records that come with the package, in words: the paper's first."""
    rows = [row for row in named_records() if row.motion is not None]
    rows.sort(key=lambda row: not row.alias)
    told = [(row.alias or row.name, f"{row.event} {row.year}, {row.station}") for row in rows]
    # both components of a record of FEMA P-695 are a station
    told += [
        (row.name.rpartition("-")[0], f"{row.event} {row.year}, {row.station}, two directions")
        for row in rows
        if row.name.startswith("P695-") and row.name.endswith("-a")
    ]
    return {name: f"{name} · {words}" for name, words in told}


@dataclass
class Session:
    """The state of one page: the fields, the units of results, records that were sent by key and the number of their files, stations that were joined, and what is chosen.

    The PGV is in m/s, the corner of a high-pass filter in Hz, and the angle by which a station is turned in degrees; the `usual` heating model is that of the kind of the records.
    """

    bearing: BearingForm = field(default_factory=BearingForm)
    units: Units = field(default_factory=Units)
    sent: dict[str, Upload] = field(default_factory=dict[str, Upload])
    files: int = 0
    stations: dict[str, tuple[str, ...]] = field(default_factory=dict[str, tuple[str, ...]])
    chosen: list[str] = field(default_factory=lambda: ["NCC"])
    pgv: float = 0.5
    as_recorded: bool = False
    baseline: bool = False
    corner: float | None = None
    rotate: float | None = None
    vertical: bool = False
    usual: str = _BEGIN.heating.name

    @property
    def in_plane(self) -> bool:
        """Whether what is chosen are stations."""
        return any(isinstance(self.motion(key), Station) for key in self.chosen)

    def choose(self, keys: list[str]) -> None:
        """Choose records; where no heating model was chosen, it is the usual one of their kind."""
        self.chosen = keys
        if not keys:
            return
        usual = usual_heating([self.motion(keys[0])])
        if self.bearing.values["heating"] == self.usual:
            self.bearing.put("heating", usual)
        self.usual = usual

    def join(self) -> str:
        """Make a station of the components that are chosen, in their order, and return its key.

        Raises
        ------
        InputError
            If they are not two or three components that go together.
        """
        keys = tuple(self.chosen)
        if len(keys) not in (2, 3) or self.in_plane:
            msg = "Choose the two or three components of a station, the vertical one last, and nothing else; then join them."
            raise InputError(msg)
        name = STATION_MARK.join(self.file_of(key) for key in keys)
        self._joined(keys, name)
        self.stations[name] = keys
        return name

    def _joined(self, keys: tuple[str, ...], name: str) -> Station:
        motions = [one for key in keys if isinstance(one := self.motion(key), GroundMotion)]
        return joined(motions, name)

    def take(self, uploads: list[Upload]) -> list[str]:
        """Keep the records of one more file, and return their keys.

        Raises
        ------
        InputError
            If there are too many.
        """
        self.refuse_more_files()
        if len(self.sent) + len(uploads) > MOST_COMPONENTS:
            msg = (
                f"The page keeps at most {MOST_COMPONENTS} components of your files; reload it to begin anew."
            )
            raise InputError(msg)
        self.files += 1
        keys = [f"sent-{number}" for number in range(len(self.sent), len(self.sent) + len(uploads))]
        self.sent |= zip(keys, uploads, strict=True)
        return keys

    def refuse_more_files(self) -> None:
        """Raise an InputError where there are too many files for another one.

        Raises
        ------
        InputError
            If so.
        """
        if self.files >= MOST_FILES:
            msg = f"The page keeps at most {MOST_FILES} of your files; reload it to begin anew."
            raise InputError(msg)

    def choices(self) -> dict[str, str]:
        """Return every record that can be chosen, in words: those that were sent first."""
        own = {key: f"{one.motion.name} · your file" for key, one in self.sent.items()}
        own |= {key: f"{key} · joined" for key in self.stations}
        return own | named_choices()

    def motion(self, key: str) -> GroundMotion | Station:
        """Return a record or a station as it is."""
        if key in self.stations:
            return self._joined(self.stations[key], key)
        return self.sent[key].motion if key in self.sent else _named(key)

    def file_of(self, key: str) -> str:
        """Return how a scenario names a record."""
        return self.sent[key].file if key in self.sent else key
