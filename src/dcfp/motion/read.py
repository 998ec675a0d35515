"""Read ground motions from a file; the format is found from its content."""

from os import PathLike
from pathlib import Path

from dcfp.motion.formats.component import Component
from dcfp.motion.formats.registry import read_components
from dcfp.motion.formats.selection import select_component
from dcfp.motion.formats.source import read_source, source_of
from dcfp.motion.ground_motion import GroundMotion


def read_motions(
    path: str | PathLike[str], *, units: str | None = None, time_step: float | None = None
) -> list[GroundMotion]:
    """Return every component of a record file, in the order of the file.

    Parameters
    ----------
    path
        The file: PEER AT2, K-NET, KiK-net, JMA CSV, CSMIP V2, COSMOS V1 or V2, ESM, CWB, or plain columns.
    units
        Unit of a plain file: one of mm/s2, cm/s2, gal, m/s2, g. Formats that state their own need none.
    time_step
        Time step of a plain file with one column [s].

    Raises
    ------
    InputError
        If the file cannot be read as a record; the sentence says where it fails and what would be right.
    """
    return [component.motion for component in _components(path, units, time_step)]


def motions_of(
    content: bytes, name: str, *, units: str | None = None, time_step: float | None = None
) -> list[GroundMotion]:
    """Return every component of a record file that is at hand as bytes; nothing is read from a disk.

    Parameters
    ----------
    content
        Of the file.
    name
        Of the file, for the names of the motions and for sentences.
    units, time_step
        As for `read_motions`.

    Raises
    ------
    InputError
        As for `read_motions`.
    """
    source = source_of(content, Path(name))
    return [component.motion for component in read_components(source, units=units, time_step=time_step)]


def read_motion(
    path: str | PathLike[str],
    component: str | None = None,
    *,
    units: str | None = None,
    time_step: float | None = None,
) -> GroundMotion:
    """Return one component of a record file.

    Parameters
    ----------
    path
        The file; see `read_motions`.
    component
        Its name in the file, a channel number or a direction (NS, EW, UD); needed when there are several.
    units
        Unit of a plain file: one of mm/s2, cm/s2, gal, m/s2, g.
    time_step
        Time step of a plain file with one column [s].

    Raises
    ------
    InputError
        If the file cannot be read as a record, or the component is not in it or not given.
    """
    components = _components(path, units, time_step)
    return select_component(components, component, Path(path)).motion


def _components(path: str | PathLike[str], units: str | None, time_step: float | None) -> list[Component]:
    return read_components(read_source(Path(path)), units=units, time_step=time_step)
