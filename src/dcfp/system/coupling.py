"""Modes of mass and stiffness matrices without damping, of coordinates that move apart solved apart."""

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray

#: Coupling of two coordinates, over their own mass or stiffness, below which they move apart [-].
_APART = 1e-13


def groups_apart(mass: FloatArray, stiffness: FloatArray) -> list[list[int]]:
    """Return groups of coordinates that are coupled with each other, and not with those of another group."""
    joined = _coupled(mass) | _coupled(stiffness)
    left, groups = set(range(len(mass))), list[list[int]]()
    while left:
        group, edge = set[int](), [min(left)]
        while edge:
            group.update(edge)
            edge = [j for j in np.flatnonzero(joined[edge].any(axis=0)).tolist() if j not in group]
        left -= group
        groups.append(sorted(group))
    return groups


def _coupled(matrix: FloatArray) -> NDArray[np.bool_]:
    own = np.sqrt(np.abs(np.diag(matrix)))
    return np.abs(matrix) > _APART * np.outer(own, own)


def undamped_modes(mass: FloatArray, stiffness: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the squares of the circular frequencies [1/s2], and shapes as columns, of unit modal mass."""
    lower = np.linalg.cholesky(mass)
    half = np.linalg.solve(lower, stiffness)
    squares, vectors = np.linalg.eigh(np.linalg.solve(lower, half.T))
    shapes = np.linalg.solve(lower.T, vectors)
    return np.asarray(squares, dtype=np.float64), np.asarray(shapes, dtype=np.float64)


def modes_apart(mass: FloatArray, stiffness: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return what `undamped_modes` does, lowest first: no shape is of two groups that move apart."""
    squares, shapes = np.empty(len(mass)), np.zeros_like(mass)
    first = 0
    for group in groups_apart(mass, stiffness):
        pick, columns = np.ix_(group, group), slice(first, first + len(group))
        squares[columns], shapes[group, columns] = undamped_modes(mass[pick], stiffness[pick])
        first += len(group)
    order = np.argsort(squares, kind="stable")
    return squares[order], shapes[:, order]
