"""Finite elements for a plate heated by a moving patch, solved mode by mode.

The plate is a box, so that its matrices are Kronecker products of those of three lines, which scikit-fem
assembles: linear elements along the plate (with lumped mass), quadratic elements, graded, in depth. In the
products of the lines' eigenvectors every unknown fades by itself, and a step under a constant flux is exact,
however long it is.
"""

from dataclasses import dataclass

import numpy as np
import scipy.linalg
import skfem
from numpy.typing import NDArray
from skfem.models.poisson import laplace, mass

Array = NDArray[np.float64]

CONDUCTIVITY = 16.0  # k of the paper [N/(s degC)], 0.016 W/(mm degC)
DIFFUSIVITY = 4.07  # D of the paper [mm2/s]


@dataclass(frozen=True)
class Axis:
    """A line of the box in its own modes.

    Attributes
    ----------
    nodes
        [mm], in increasing order.
    shapes
        Eigenvectors in columns, of unit mass.
    squares
        Eigenvalues [1/mm2]: squares of the wave numbers.
    """

    nodes: Array
    shapes: Array
    squares: Array


def along(nodes: Array, conducts: bool = True) -> Axis:
    """Return a line along the plate, insulated at its ends; without conduction its nodes are strangers."""
    basis = skfem.Basis(skfem.MeshLine(nodes), skfem.ElementLineP1())
    lumped = np.asarray(mass.assemble(basis).sum(axis=1)).ravel()
    if not conducts:
        return Axis(nodes, np.diag(lumped**-0.5), np.zeros(nodes.size))
    squares, shapes = scipy.linalg.eigh(laplace.assemble(basis).toarray(), np.diag(lumped))
    return Axis(nodes, shapes, np.maximum(squares, 0.0))


def across() -> Axis:
    """Return the missing third direction of a planar problem, one millimetre wide."""
    return Axis(np.zeros(1), np.ones((1, 1)), np.zeros(1))


def depth(
    thickness: float,
    first: float = 0.15,
    growth: float = 1.35,
    cold_back: bool = False,
    body: tuple[float, float, float] | None = None,
) -> Axis:
    """Return a line into the plate, finest at the surface (node 0); the back is insulated or kept at ambient.

    With a `body` the plate is a sheet on a body of another steel: thickness of the sheet [mm], and
    conductivity and heat capacity per volume of the body over those of the sheet.
    """
    count = int(np.ceil(np.log1p(thickness / first * (growth - 1.0)) / np.log(growth)))
    lengths = growth ** np.arange(count)
    nodes = np.concatenate(([0.0], np.cumsum(lengths))) * thickness / lengths.sum()
    sheet, conducting, holding = body or (thickness, 1.0, 1.0)
    if body:
        nodes = np.union1d(nodes[np.abs(nodes - sheet) > 0.2 * sheet], [sheet])
    basis = skfem.Basis(skfem.MeshLine(nodes), skfem.ElementLineP2())
    stiffness = skfem.BilinearForm(
        lambda u, v, w: np.where(w.x[0] < sheet, 1.0, conducting) * u.grad[0] * v.grad[0]
    )
    capacity = skfem.BilinearForm(lambda u, v, w: np.where(w.x[0] < sheet, 1.0, holding) * u * v)
    order = np.argsort(basis.doflocs[0])
    order = order[:-1] if cold_back else order
    pick = np.ix_(order, order)
    squares, shapes = scipy.linalg.eigh(
        stiffness.assemble(basis).toarray()[pick], capacity.assemble(basis).toarray()[pick]
    )
    return Axis(basis.doflocs[0][order], shapes, np.maximum(squares, 0.0))


def even(reach: float, spacing: float, end: float | None = None, growth: float = 1.25) -> Array:
    """Return nodes from 0 at equal `spacing` up to `reach` [mm], then growing up to `end`."""
    nodes = list(np.linspace(0.0, reach, int(np.ceil(reach / spacing)) + 1))
    width = nodes[1] * growth
    while end is not None and nodes[-1] + 1.5 * width < end:
        nodes.append(nodes[-1] + width)
        width *= growth
    return np.array(nodes if end is None else [*nodes, end])


def both_ways(nodes: Array) -> Array:
    """Return nodes mirrored to the other side of zero."""
    return np.concatenate((-nodes[:0:-1], nodes))


class Plate:
    """Temperature rises of a plate, at first zero.

    Parameters
    ----------
    x, y, z
        Lines along the sliding, across it and into the plate.
    """

    def __init__(self, x: Axis, y: Axis, z: Axis) -> None:
        self.x, self.y, self.z = x, y, z
        sums = x.squares[:, None, None] + y.squares[None, :, None] + z.squares[None, None, :]
        self.rates = DIFFUSIVITY * sums
        self.amplitudes = np.zeros_like(self.rates)
        self._step = (np.nan, np.zeros(0), np.zeros(0))

    def heat(self, load: Array, step: float) -> None:
        """Advance by `step` [s] under `load` [N mm/s], the power into each node of the surface."""
        if step != self._step[0]:
            fade = np.exp(-self.rates * step)
            with np.errstate(invalid="ignore", divide="ignore"):
                gain = np.where(self.rates * step > 1e-12, -np.expm1(-self.rates * step) / self.rates, step)
            self._step = (step, fade, gain * self.z.shapes[0] * DIFFUSIVITY / CONDUCTIVITY)
        driven = self.x.shapes.T @ load @ self.y.shapes
        self.amplitudes *= self._step[1]
        self.amplitudes += driven[:, :, None] * self._step[2]

    def surface(self, after: float = 0.0) -> Array:
        """Return the temperature rises of the surface's nodes, at once or `after` so long at rest [s]."""
        left = self.amplitudes * np.exp(-self.rates * after) if after else self.amplitudes
        return np.asarray(self.x.shapes @ (left @ self.z.shapes[0]) @ self.y.shapes.T)


class Patch:
    """The contact: which part of each node's share of the surface it covers.

    Parameters
    ----------
    plate
        It slides along its x axis.
    half_lengths
        Half lengths of the chords along x [mm], and the share that each has in each node across, shape
        (chords, nodes).
    """

    def __init__(self, plate: Plate, half_lengths: Array, shares: Array) -> None:
        self._nodes, self._half_lengths, self._shares = plate.x.nodes, half_lengths, shares

    def at(self, position: float) -> Array:
        """Return the area that it covers of each node's share [mm2], with its centre at `position` [mm]."""
        ahead = _integrals(self._nodes, position + self._half_lengths)
        return np.asarray((ahead - _integrals(self._nodes, position - self._half_lengths)) @ self._shares)


def strip(plate: Plate, half_side: float) -> Patch:
    """Return the square contact in a planar problem (a line along the sliding)."""
    return Patch(plate, np.array([half_side]), np.ones((1, 1)))


def disc(plate: Plate, radius: float, points: int = 3) -> Patch:
    """Return one half of a round contact, y > 0."""
    nodes = plate.y.nodes
    roots, weights = np.polynomial.legendre.leggauss(points)
    half = 0.5 * np.diff(nodes)
    where = (nodes[:-1, None] + half[:, None] * (1.0 + roots)).ravel()
    weight = (half[:, None] * weights).ravel()
    inside = where < radius
    where, weight = where[inside], weight[inside]
    hats = np.array([np.interp(where, nodes, unit) for unit in np.eye(nodes.size)]).T
    return Patch(plate, np.sqrt(radius**2 - where**2), weight[:, None] * hats)


def _integrals(nodes: Array, ends: Array) -> Array:
    """Integrals of the hat functions of the nodes up to each of the `ends`, shape (nodes, ends)."""
    lengths = np.diff(nodes)
    part = np.clip((ends[None, :] - nodes[:-1, None]) / lengths[:, None], 0.0, 1.0)
    result = np.zeros((nodes.size, ends.size))
    result[1:] += 0.5 * part**2 * lengths[:, None]
    result[:-1] += (part - 0.5 * part**2) * lengths[:, None]
    return result
