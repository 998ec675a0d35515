"""Ground motions from a name or a file; the format of a file is found from its content."""

from collections.abc import Iterable
from os import PathLike, fspath
from pathlib import Path
from typing import Any, TypeAlias

from dcfp.errors import InputError
from dcfp.motion.formats.registry import read_components, select_component
from dcfp.motion.formats.source import read_source, source_of
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import named_motion, named_station, record_set, station_set
from dcfp.motion.station import Station, joined
from dcfp.schema.parameters import refuse_other

#: Between a file and the component in it, as in ``tokyo.csv::NS``.
COMPONENT_MARK = "::"


def load_motion(
    record: str | PathLike[str],
    component: str | None = None,
    *,
    units: str | None = None,
    time_step: float | None = None,
) -> GroundMotion:
    """Return a ground motion by the name of a record or from a file.

    Parameters
    ----------
    record
        A name (see `named_motion`) or a path. It is a path if it exists, or if it has a folder or a suffix in
        it; ``FILE::COMPONENT`` chooses a component.
    component, units, time_step
        As for `read_motion`.

    Raises
    ------
    InputError
        If there is no such name or file, or the file cannot be read.
    """
    text = fspath(record)
    path, chosen = _split(text)
    if chosen is not None and component is not None and chosen != component:
        msg = f"{text}: the component is given twice, as {chosen!r} and as {component!r}; give it once."
        raise InputError(msg)
    chosen = component if chosen is None else chosen
    is_path = isinstance(record, PathLike) or _exists(path) or "/" in path or "\\" in path
    if is_path or Path(path).suffix:
        return read_motion(path, chosen, units=units, time_step=time_step)
    for given in (chosen, units, time_step):
        if given is not None:
            msg = f"{text}: a named record has its own component, unit and time step; leave out {given!r}."
            raise InputError(msg)
    return named_motion(path)


#: Between the components of a station, as in ``east.AT2+north.AT2``.
STATION_MARK = "+"
#: What ends the names of the files of a station of K-NET and KiK-net (at the surface), in the order x, y, vertical.
_TRIPLES = ((".EW", ".NS", ".UD"), (".EW2", ".NS2", ".UD2"))


def load_station(
    record: str | PathLike[str], *, units: str | None = None, time_step: float | None = None
) -> Station | None:
    """Return the ground motion of a station, or None where `record` is not one.

    Parameters
    ----------
    record
        ``P695-FF-2``; two or three names or files joined by ``+`` in the order x, y, vertical, of which a later one may be the component of the
        same file, as in ``tokyo.csv::NS+::EW+::UD``; or what three files of K-NET or KiK-net have before their endings.
    units, time_step
        As for `read_motion`.

    Raises
    ------
    InputError
        If a component cannot be read, or they do not go together.
    """
    text = fspath(record)
    if _exists(text) and not Path(text).is_dir():
        return None
    parts = text.split(STATION_MARK)
    if len(parts) > 1:
        first, _ = _split(parts[0])
        words = [first + one if one.startswith(COMPONENT_MARK) else one for one in parts]
        if "" in words or len(set(words)) < len(words):
            msg = f"{text}: a station is two or three different components joined by +, such as east.AT2+north.AT2."
            raise InputError(msg)
        # a name has its own unit and time step
        motions = [_component(word, units, time_step) for word in words]
        return joined(motions, STATION_MARK.join(one.name for one in motions))
    for endings in _TRIPLES:
        files = [Path(text + ending) for ending in endings]
        if all(file.is_file() for file in files[:2]):
            return joined([read_motion(file) for file in files if file.is_file()], Path(text).name)
    return named_station(text)


def _component(word: str, units: str | None, time_step: float | None) -> GroundMotion:
    path, _ = _split(word)
    named = not (_exists(path) or "/" in path or "\\" in path or Path(path).suffix)
    return load_motion(word) if named else load_motion(word, units=units, time_step=time_step)


#: What is taken for a ground motion: one, the name of a record, or a file.
Motion: TypeAlias = GroundMotion | str | PathLike[str]


def motion_of(motion: Motion, pgv: float | None = None) -> GroundMotion:
    """Return a ground motion, by the name of a record or from a file unless it is one; scaled to a PGV [mm/s] if one is given.

    Raises
    ------
    InputError
        If it is none of these, or the PGV is out of range.
    """
    if isinstance(motion, (str, PathLike)):
        motion = load_motion(motion)
    refuse_other(motion, GroundMotion, "motion", "a GroundMotion, the name of a record or a file")
    return motion if pgv is None else motion.scaled_to_pgv(pgv)


#: What is taken for a ground motion or a station: one, the name of a record, or a file.
Record: TypeAlias = GroundMotion | Station | str | PathLike[str]


def record_of(record: Record, pgv: float | None = None) -> GroundMotion | Station:
    """Return a ground motion or a station as `motion_of` returns a motion, with its errors."""
    if isinstance(record, (str, PathLike)):
        record = load_record(record)
    if isinstance(record, Station):
        return record if pgv is None else record.scaled_to_pgv(pgv)
    return motion_of(record, pgv)


def load_record(
    record: str | PathLike[str],
    component: str | None = None,
    *,
    units: str | None = None,
    time_step: float | None = None,
) -> GroundMotion | Station:
    """Return a station (see `load_station`) or else a single ground motion (see `load_motion`, whose arguments and errors it has)."""
    station = load_station(record, units=units, time_step=time_step) if component is None else None
    return station or load_motion(record, component, units=units, time_step=time_step)


def load_records(
    names: Iterable[str], component: str | None = None, **reading: Any
) -> list[GroundMotion | Station]:
    """Return the stations and ground motions of several names or files; the name of a set stands for all components or stations in it."""
    found: list[GroundMotion | Station] = []
    for name in names:
        found += record_set(name) or station_set(name) or [load_record(name, component, **reading)]
    return found


def seen_from(folder: Path, record: str) -> str:
    """Return the name of a record; where it names files that are there, as they are seen from a folder."""
    beside = str(folder / record)
    if _is_file(beside) or any(_is_file(beside + endings[0]) for endings in _TRIPLES):
        return beside
    if STATION_MARK in record:
        return STATION_MARK.join(seen_from(folder, one) for one in record.split(STATION_MARK))
    file, mark, component = record.partition(COMPONENT_MARK)
    return f"{folder / file}{mark}{component}" if file and _is_file(str(folder / file)) else record


def load_motions(names: Iterable[str], component: str | None = None, **reading: Any) -> list[GroundMotion]:
    """Return the ground motions of several names or files; the name of a set stands for all records in it.

    Arguments and errors are those of `load_motion`.
    """
    sets = [record_set(name) or [load_motion(name, component, **reading)] for name in names]
    return [motion for one in sets for motion in one]


def _split(text: str) -> tuple[str, str | None]:
    if COMPONENT_MARK not in text or _exists(text):
        return text, None
    path, _, component = text.rpartition(COMPONENT_MARK)
    return path, component or None


def _exists(text: str) -> bool:
    try:
        return Path(text).exists()
    except (OSError, ValueError):
        return False


def _is_file(text: str) -> bool:
    return _exists(text) and Path(text).is_file()


def read_motions(
    path: str | PathLike[str], *, units: str | None = None, time_step: float | None = None
) -> list[GroundMotion]:
    """Return every component of a record file, in the order of the file.

    Parameters
    ----------
    path
        The file, in one of the formats of `dcfp.motion.formats`.
    units
        Unit of a plain file: one of mm/s2, cm/s2, gal, m/s2, g. Formats that state their own need none.
    time_step
        Time step of a plain file with one column [s].

    Raises
    ------
    InputError
        If the file cannot be read as a record; the sentence says where it fails and what would be right.
    """
    source = read_source(Path(path), units=units, time_step=time_step)
    return [component.motion for component in read_components(source)]


def motions_of(
    content: bytes, name: str, *, units: str | None = None, time_step: float | None = None
) -> list[GroundMotion]:
    """Return every component of a record file whose content is at hand as bytes.

    Parameters
    ----------
    content
        Of the file.
    name
        Of the file, for the names of the motions and for sentences.
    units, time_step
        As for `read_motions`, whose errors it has too.
    """
    source = source_of(content, Path(name), units=units, time_step=time_step)
    return [component.motion for component in read_components(source)]


def read_motion(
    path: str | PathLike[str],
    component: str | None = None,
    *,
    units: str | None = None,
    time_step: float | None = None,
) -> GroundMotion:
    """Return one component of a record file; all else as for `read_motions`.

    Parameters
    ----------
    component
        Its name in the file, a channel number or a direction (NS, EW, UD); needed when there are several.

    Raises
    ------
    InputError
        If the file cannot be read as a record, or the component is not in it or not given.
    """
    source = read_source(Path(path), units=units, time_step=time_step)
    return select_component(read_components(source), component, source.path).motion
