"""A measured path: histories of x and y from a CSV file whose head names each column and its unit."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from dcfp.analysis.rig.measurement import (
    FORCES,
    check_motion,
    check_no_tension,
    read_histories,
    read_text,
)
from dcfp.analysis.rig.plane_path import ComplexArray
from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.columns import LENGTHS, TIMES, Columns, names_of

#: What a column may be called: by hand, and in a file that `dcfp test --out` wrote.
_NAMES = (("x", "y"), ("displacement_x", "displacement_y"))


@dataclass(frozen=True, eq=False)
class MeasuredPath:
    """A path that was measured: times from zero [s], positions x + i y [mm], and the vertical force [N] or None where the file has none."""

    name: str
    time: FloatArray
    position: ComplexArray
    optional_load: FloatArray | None


def is_path(path: str | Path) -> bool:
    """Return whether a CSV file is of a path: whether its head names x or y, and no displacement alone."""
    names = names_of(read_text(path)[1])
    return bool(names & set(_NAMES[1])) or (bool(names & set(_NAMES[0])) and "displacement" not in names)


def read_path(path: str | Path) -> MeasuredPath:
    """Read a measured path.

    Parameters
    ----------
    path
        CSV as `dcfp.analysis.rig.read_measurement` takes it, with ``time [s]``, ``x [mm]`` and ``y [mm]``, and where it was measured ``load [kN]``; ``displacement_x [mm]`` and
        ``displacement_y [mm]`` are as good.

    Raises
    ------
    InputError
        If the file cannot be read, a column, a number or a unit is missing, time does not increase or has a gap, the load turns into tension, or a quantity is so large or small
        that its unit must be wrong.
    """
    where, (_, text) = str(path), read_text(path)
    names = names_of(text)
    directions = next((pair for pair in _NAMES if names & set(pair)), _NAMES[0])
    for one, other in (directions, directions[::-1]):
        if one not in names and other in names:
            msg = f"{where}: the first line names a column '{other}' and none '{one} [mm]'; a path in the plane needs both."
            raise InputError(msg)
    columns: Columns = {"time": TIMES, **dict.fromkeys(directions, LENGTHS), "load": FORCES}
    known, lines = read_histories(text, where, columns, ("time", *directions))
    position: ComplexArray = np.asarray(known[directions[0]] + 1j * known[directions[1]])
    check_motion(known["time"], position, lines, where)
    check_no_tension(known.get("load"), lines, where)
    return MeasuredPath(Path(path).stem, known["time"], position, known.get("load"))
