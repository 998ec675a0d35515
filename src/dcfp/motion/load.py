"""Ground motions from a name or a file; the format of a file is found from its content."""

from collections.abc import Iterable
from os import PathLike, fspath
from pathlib import Path
from typing import Any, TypeAlias

from dcfp.errors import InputError
from dcfp.motion.formats.directions import direction
from dcfp.motion.formats.registry import read_components, select_component
from dcfp.motion.formats.source import read_source, source_of
from dcfp.motion.ground_motion import TAKEN_AS_HORIZONTAL, GroundMotion
from dcfp.motion.kyoshin_files import station_files
from dcfp.motion.named import is_of_stations, is_set, named_motion, named_station, record_set, station_set
from dcfp.motion.station import Station, joined, one_direction
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
    _refuse_station(text, path)
    is_path = isinstance(record, PathLike) or _exists(path) or "/" in path or "\\" in path
    if is_path or Path(path).suffix:
        return read_motion(path, chosen, units=units, time_step=time_step)
    for given in (chosen, units, time_step):
        if given is not None:
            msg = f"{text}: a named record has its own component, unit and time step; leave out {given!r}."
            raise InputError(msg)
    return named_motion(path)


def _refuse_station(text: str, path: str) -> None:
    """Refuse what stands for the two or three components of a station."""
    if words := _components(text):
        raise one_direction(text, words[:2])
    if files := _files(path):
        raise one_direction(path, [str(file) for file in files[:2]])


#: Between the components of a station, as in ``east.AT2+north.AT2``.
STATION_MARK = "+"


def load_station(
    record: str | PathLike[str],
    *,
    units: str | None = None,
    time_step: float | None = None,
) -> Station | None:
    """Return the ground motion of a station, or None where `record` is not one.

    Parameters
    ----------
    record
        ``P695-FF-2``; two or three names or files joined by ``+`` in the order x, y, vertical, of which a later one may be the component of the
        same file, as in ``tokyo.csv::NS+::EW+::UD``; or what three files of K-NET or KiK-net have before their endings, or a folder that holds three such files.
    units, time_step
        As for `read_motion`.

    Raises
    ------
    InputError
        If a component cannot be read, or they do not go together.
    """
    text = fspath(record)
    if words := _components(text):
        motions = [_component(word, units, time_step) for word in words]
        if len({one.digest for one in motions}) < len(motions):
            raise _no_station(text)
        # of channels of one file the name of the file stands once
        files = [_split(word)[0] for word in words]
        names = [
            one.origin.component if file == files[0] else one.name
            for file, one in zip(files, motions, strict=True)
        ]
        name = STATION_MARK.join([motions[0].name, *names[1:]])
    elif files := _files(text):
        motions, name = [read_motion(file) for file in files], files[0].stem
    else:
        return named_station(text)
    return joined(motions, name)


def _components(text: str) -> list[str]:
    """Return the words between the marks of a station, none where it has no mark; a mark in the name of a file that exists is not one."""
    parts = [] if _exists(text) else text.split(STATION_MARK)
    words: list[str] = []
    while parts:
        sizes = range(len(parts), 0, -1)
        size = next((n for n in sizes if _is_of_a_file(STATION_MARK.join(parts[:n]))), 1)
        words.append(STATION_MARK.join(parts[:size]))
        parts = parts[size:]
    if len(words) < 2:
        return []
    first, _ = _split(words[0])
    words = [first + one if one.startswith(COMPONENT_MARK) else one for one in words]
    if "" in words or len(set(words)) < len(words) or len(words) > 3:
        raise _no_station(text)
    for one in words:
        if is_of_stations(one) or _files(one):
            msg = f"{text}: {one} has both components already, and + joins single ones; between stations stand blanks."
            raise InputError(msg)
        if is_set(one):
            msg = f"{text}: {one} is a set of records, and + joins the components of one station, as in P695-FF-2-a+P695-FF-2-b."
            raise InputError(msg)
    return words


def _is_of_a_file(word: str) -> bool:
    """Whether a word is a file that exists, or a component of one."""
    path, component = _split(word)
    return _exists(path) and STATION_MARK not in (component or "")


def _no_station(text: str) -> InputError:
    return InputError(
        f"{text}: a station is two or three different components joined by +, such as east.AT2+north.AT2, the vertical one last."
    )


def _files(text: str) -> list[Path]:
    """Return the files of K-NET or KiK-net that a stem or a folder stands for."""
    return [] if Path(text).is_file() else station_files(text)


def _component(word: str, units: str | None, time_step: float | None) -> GroundMotion:
    path, _ = _split(word)
    named = not (_exists(path) or "/" in path or "\\" in path or Path(path).suffix)
    # a name has its own unit and time step
    return load_motion(word) if named else load_motion(word, units=units, time_step=time_step)


#: What is taken for a ground motion: one, the name of a record, or a file.
Motion: TypeAlias = GroundMotion | str | PathLike[str]


def motion_of(motion: Motion | Station, pgv: float | None = None, *, vertical: bool = False) -> GroundMotion:
    """Return a ground motion, by the name of a record or from a file unless it is one; scaled to a PGV [mm/s] if one is given.

    A `vertical` one is taken only where that is meant.

    Raises
    ------
    InputError
        If it is none of these, or a station, or vertical without being asked for, or the PGV is out of range.
    """
    if isinstance(motion, Station):
        raise one_direction(motion.name, ("its x", "its y"))
    if isinstance(motion, (str, PathLike)):
        motion = (load_motion if vertical else load_horizontal)(motion)
    refuse_other(motion, GroundMotion, "motion", "a GroundMotion, the name of a record or a file")
    if not vertical:
        motion = _horizontal(motion)
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


def load_horizontal(
    record: str | PathLike[str], component: str | None = None, **reading: Any
) -> GroundMotion:
    """Return a ground motion for an analysis in one direction, as `load_motion` does; a vertical one only where it is chosen by its name.

    Raises
    ------
    InputError
        As of `load_motion`; or if the only component is vertical and was not chosen by its name.
    """
    motion = load_motion(record, component, **reading)
    chosen = component is not None or _split(fspath(record))[1] is not None
    return motion.as_horizontal() if chosen and _is_vertical(motion) else _horizontal(motion, fspath(record))


def _is_vertical(motion: GroundMotion) -> bool:
    return direction(motion.origin.component) == "UD" and TAKEN_AS_HORIZONTAL not in motion.treatment


def _horizontal(motion: GroundMotion, record: str | None = None) -> GroundMotion:
    """Return a motion that is not vertical, or was asked for."""
    if not _is_vertical(motion):
        return motion
    label = motion.origin.component
    how = (
        "give its as_horizontal()"
        if record is None
        else f"choose it by its name, as in {record}{COMPONENT_MARK}{label}"
    )
    msg = f"{record or motion.name}: this is a vertical component ({label}), and an analysis in one direction takes it as horizontal; if that is meant, {how}."
    raise InputError(msg)


def load_record(
    record: str | PathLike[str],
    component: str | None = None,
    *,
    vertical: bool = False,
    **reading: Any,
) -> GroundMotion | Station:
    """Return a station (see `load_station`) or else a single ground motion (see `load_horizontal`, or `load_motion` where it may be vertical), whose arguments and errors it has."""
    station = load_station(record, **reading) if component is None else None
    load = load_motion if vertical else load_horizontal
    return station or load(record, component, **reading)


def load_records(
    names: Iterable[str], component: str | None = None, *, vertical: bool = False, **reading: Any
) -> list[GroundMotion | Station]:
    """Return the stations and ground motions of several names or files; the name of a set stands for all components or stations in it."""
    found: list[GroundMotion | Station] = []
    for name in names:
        found += (
            record_set(name)
            or station_set(name)
            or [load_record(name, component, vertical=vertical, **reading)]
        )
    return found


def seen_from(folder: Path, record: str) -> str:
    """Return the name of a record; where it names files that are there, as they are seen from a folder."""
    beside = str(folder / record)
    if record and (_exists(beside) or _files(beside)):
        return beside
    if STATION_MARK in record:
        return STATION_MARK.join(seen_from(folder, one) for one in record.split(STATION_MARK))
    file, mark, component = record.partition(COMPONENT_MARK)
    return f"{folder / file}{mark}{component}" if file and _exists(str(folder / file)) else record


def load_motions(names: Iterable[str], component: str | None = None, **reading: Any) -> list[GroundMotion]:
    """Return the ground motions of several names or files; the name of a set stands for all records in it.

    Arguments and errors are those of `load_horizontal`.
    """
    sets = [record_set(name) or [load_horizontal(name, component, **reading)] for name in names]
    return [motion for one in sets for motion in one]


def _split(text: str) -> tuple[str, str | None]:
    if COMPONENT_MARK not in text or _exists(text):
        return text, None
    path, _, component = text.rpartition(COMPONENT_MARK)
    return path, component or None


def _exists(text: str) -> bool:
    try:
        return bool(text.strip()) and Path(text).exists()  # no name is not this folder
    except (OSError, ValueError):
        return False


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
