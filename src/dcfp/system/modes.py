"""Modes of a structure on a fixed base, as a frame program prints them, and the stiffness that they are of."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.schema.columns import LENGTHS, TIMES, read_columns
from dcfp.schema.reading import read_bytes
from dcfp.schema.units import NONE

if TYPE_CHECKING:
    from dcfp.system.storeys import Storey

#: Largest cosine between two modes under the masses up to which they are taken for rounded.
LARGEST_COSINE = 0.1
#: Frequency of what the given modes leave out, over the highest given one: it goes with the slab, as good as rigid.
RIGID = 10.0
_NUMBERS = {"": NONE, "-": NONE}
_COLUMNS = {
    "mode": _NUMBERS,
    "period": TIMES,
    "floor": _NUMBERS,
    "ux": LENGTHS,
    "uy": LENGTHS,
    "rz": {"rad": NONE},
}
_EXAMPLE = "mode,period [s],floor,ux [mm],uy [mm],rz [rad]"


@dataclass(frozen=True, eq=False)
class ModeShapes:
    """Modes on a fixed base.

    Parameters
    ----------
    periods
        [s], shape (modes,).
    shapes
        x, y [mm] and rotation [rad] of every floor at its centre of mass, from below, of any size, shape (modes, floors, 3).
    name
        To begin a complaint with.
    """

    periods: FloatArray
    shapes: FloatArray
    name: str = "modes"

    @property
    def floors(self) -> int:
        """Number of floors."""
        return self.shapes.shape[1]

    def turned(self, turn: FloatArray) -> "ModeShapes":
        """Return the modes of a structure that is turned by a matrix, shape (2, 2)."""
        shapes = np.array(self.shapes)
        shapes[..., :2] = shapes[..., :2] @ turn.T
        return ModeShapes(self.periods, freeze(shapes), self.name)

    def stiffness(self, mass: FloatArray, places: Sequence[FloatArray]) -> FloatArray:
        """Return the stiffness matrix [N/mm, N, N mm] of which these are modes with a mass matrix [t, t mm, t mm2].

        Parameters
        ----------
        mass
            Of x, y and rotation of all floors about one vertical axis.
        places
            Centre of mass of each floor from that axis [mm].

        Raises
        ------
        InputError
            If the modes are not orthogonal with these masses.
        """
        shapes = np.array(self.shapes)
        for floor, (x, y) in enumerate(places):
            # from the centre of mass to the axis
            shapes[:, floor, 0] += shapes[:, floor, 2] * y
            shapes[:, floor, 1] -= shapes[:, floor, 2] * x
        lower = np.linalg.cholesky(mass)
        vectors = lower.T @ shapes.reshape(len(shapes), -1).T
        vectors /= np.linalg.norm(vectors, axis=0)
        self._check(vectors)
        # the nearest orthonormal ones: what is printed is rounded
        left, _, right = np.linalg.svd(vectors, full_matrices=True)
        count = len(shapes)
        given, others = left[:, :count] @ right, left[:, count:]
        squares = (2.0 * np.pi / self.periods) ** 2
        half = lower @ given
        beyond = lower @ others
        found = half @ np.diag(squares) @ half.T + RIGID**2 * squares.max() * beyond @ beyond.T
        return np.asarray(0.5 * (found + found.T), dtype=np.float64)

    def _check(self, vectors: FloatArray) -> None:
        cosines = np.abs(np.triu(vectors.T @ vectors, 1))
        first, second = np.unravel_index(int(cosines.argmax()), cosines.shape)
        if cosines[first, second] > LARGEST_COSINE:
            msg = (
                f"{self.name}: modes {first + 1} and {second + 1} are not orthogonal with the masses of the floors (cosine {cosines[first, second]:.2f}, at most {LARGEST_COSINE:g});"
                " look at the masses, the centres, the rotational inertia and the units of ux, uy and rz."
            )
            raise InputError(msg)


def read_modes(path: str | Path, storeys: "Sequence[Storey]") -> ModeShapes:
    """Read modes on a fixed base.

    Parameters
    ----------
    path
        CSV with a line for every mode and floor: ``mode``, ``period [s]``, ``floor`` (1 is the lowest above the slab), ``ux [mm]``, ``uy [mm]`` and ``rz [rad]`` at the centre of mass of the floor.
    storeys
        Of the building, for their number.

    Raises
    ------
    InputError
        If the file cannot be read, a floor of a mode is missing or there twice, or the lines of a mode have different periods.
    """
    where = str(path)
    content = read_bytes(path, f"modes are a CSV file with a head such as {_EXAMPLE}")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        msg = f"{where}: this is not a text file; modes are a CSV file with a head such as {_EXAMPLE}."
        raise InputError(msg) from error
    values, lines = read_columns(text, where, _COLUMNS, tuple(_COLUMNS), 1, "lines of modes", _EXAMPLE)
    numbers = list(dict.fromkeys(values["mode"].tolist()))
    most = 3 * len(storeys)
    if len(numbers) > most:
        msg = f"{where}: there are {len(numbers)} modes, and {len(storeys)} rigid floors have {most}."
        raise InputError(msg)
    shapes, periods = np.full((len(numbers), len(storeys), 3), np.nan), np.zeros(len(numbers))
    for line, mode, period, floor, *shape in zip(
        lines, *(values[name].tolist() for name in _COLUMNS), strict=True
    ):
        row, place = numbers.index(mode), int(floor) - 1
        known = f"{where}, line {line}"
        if place not in range(len(storeys)) or floor != int(floor):
            msg = f"{known}: floor must be a whole number from 1 to {len(storeys)}, not {floor:g}."
            raise InputError(msg)
        if not period > 0.0 or (periods[row] and period != periods[row]):
            msg = f"{known}: the period of mode {mode:g} must be a positive number, the same on all its lines, not {period:g} s."
            raise InputError(msg)
        if not np.isnan(shapes[row, place, 0]):
            msg = f"{known}: floor {floor:g} of mode {mode:g} is there twice."
            raise InputError(msg)
        periods[row], shapes[row, place] = period, shape
    missing = np.argwhere(np.isnan(shapes[..., 0]))
    if len(missing):
        row, place = missing[0]
        msg = f"{where}: floor {place + 1} of mode {numbers[row]:g} is missing."
        raise InputError(msg)
    if not np.abs(shapes).max(axis=(1, 2)).all():
        msg = f"{where}: a mode moves no floor."
        raise InputError(msg)
    return ModeShapes(freeze(periods), freeze(shapes), where)
