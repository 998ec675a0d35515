"""The records of Li et al. (2020), Table 3, that do not come with the package, found among the files of a folder."""

import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from dcfp.errors import InputError
from dcfp.inference.earthquake import earthquake_of, read_earthquake
from dcfp.motion.formats.directions import direction
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import read_motions
from dcfp.motion.named import MISSING, NamedRecord


@dataclass(frozen=True, eq=False)
class FoundRecords:
    """Records of the paper that were found in a folder, by their names, with a sentence on the choice of each, and sentences on the files that cannot be read."""

    motions: dict[str, GroundMotion]
    choices: dict[str, str]
    left_out: tuple[str, ...]


def find_paper_records(
    folder: Path, treat: Callable[[GroundMotion], GroundMotion] = lambda motion: motion
) -> FoundRecords:
    """Return the records of the paper among the files of a folder.

    A horizontal component is of a record if both its earthquake and its station are those of Table 3, or its file is named after the record, as ``JKB.csv``. Table 3 does
    not say which component it is of, so it is the one whose PGV is nearest to the printed one.

    Parameters
    ----------
    folder
        Of the files, in the formats of `dcfp.motion.formats`; what else is in it is left alone.
    treat
        What is done to a motion before its PGV is compared, such as a filter.

    Raises
    ------
    InputError
        If there is no such folder, none of its files is of a record of the paper, or a motion cannot be treated.
    """
    if not folder.is_dir():
        msg = f"{folder}: there is no such folder; give one with records of the paper that do not come with the package ({', '.join(MISSING)})."
        raise InputError(msg)
    components: dict[str, list[tuple[Path, GroundMotion]]] = {name: [] for name in MISSING}
    left_out: list[str] = []
    files = sorted(path for path in folder.iterdir() if path.is_file())
    for file in files:
        try:
            motions = read_motions(file)
        except InputError as error:
            left_out.append(f"left out: {error}")
            continue
        for motion in motions:
            for name, row in MISSING.items():
                if direction(motion.origin.component) != "UD" and _is_of(motion, file, row):
                    components[name].append((file, treat(motion)))
    chosen: dict[str, GroundMotion] = {}
    choices: dict[str, str] = {}
    for name, several in components.items():
        if several:
            file, motion = min(several, key=lambda one: _difference(one[1], MISSING[name]))
            chosen[name] = replace(motion, name=name)
            choices[name] = _choice(name, file, motion, len(several))
    if not chosen:
        sought = ", ".join(f"{name} ({row.station}, {row.event} {row.year})" for name, row in MISSING.items())
        msg = f"{folder}: none of its {len(files)} files is of a record of the paper that does not come with the package: {sought}; name one, as in JKB=FILE."
        raise InputError(msg)
    return FoundRecords(chosen, choices, tuple(left_out))


def _is_of(motion: GroundMotion, file: Path, row: NamedRecord) -> bool:
    if file.stem.upper() == row.name:
        return True
    said = earthquake_of(motion)
    # a foreshock or an aftershock has the same name and year; a day may be local or UTC
    is_another_day = said.day is not None and row.day is not None and abs((said.day - row.day).days) > 1
    return (
        said.is_known
        and not is_another_day
        and said.may_be(read_earthquake(f"{row.event} {row.year}"))
        and _word(motion.origin.station) in {_word(name) for name in row.station_names}
    )


def _word(station: str) -> str:
    """Return the letters and digits of a station's name, without a number before it, as in ``47770KOBE``."""
    return re.sub(r"^\d+|[^A-Z0-9]", "", station.upper())


def _difference(motion: GroundMotion, row: NamedRecord) -> float:
    return abs(motion.peak_velocity - row.peak_velocity)


def _choice(name: str, file: Path, motion: GroundMotion, count: int) -> str:
    component = f", component {motion.origin.component}" if motion.origin.component else ""
    of_several = (
        f", of {count} horizontal components the one whose PGV is nearest to Table 3" if count > 1 else ""
    )
    return f"{name} is {file.name}{component}{of_several}."
