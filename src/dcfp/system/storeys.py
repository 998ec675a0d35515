"""Storeys above an isolated slab: rigid floors with x, y and rotation, their modes on a fixed base, and the damping of these."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Annotated

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import KN_M, KN_PER_MM, METRE, TONNE, TONNE_M2
from dcfp.system.coupling import modes_apart
from dcfp.system.modes import ModeShapes

#: Coupling of translation and rotation, over their own masses or stiffnesses, up to which a storey is centred [-].
_CENTRED = 1e-9
#: Kinds of damping: the same ratio in every mode on a fixed base, or in proportion to the stiffness, with the ratio in the first one.
MODAL, STIFFNESS_PROPORTIONAL = "modal", "stiffness"
DAMPING_KINDS = (STIFFNESS_PROPORTIONAL, MODAL)
#: A place in the plan.
PLACE = Parameter("place in the plan", METRE, -1e4, 1e4, counts=(2,), option=False, vary=False)


def place_parameter(words: str, absent: str) -> Parameter:
    """Return the parameter of a place in the plan, with what it is where it is not given."""
    return Parameter(words, METRE, -1e4, 1e4, option=False, vary=False, absent=absent)


@declared
class Storey(Declared):
    """A storey and the floor on top of it.

    Parameters
    ----------
    stiffness
        In x and in y [N/mm]; one number is that of both.
    """

    noun = "a storey"

    mass: Annotated[float, Parameter("mass of the floor", TONNE, 0.0, above=True)]
    stiffness: Annotated[
        tuple[float, ...] | float | None,
        Parameter(
            "stiffness in x and in y", KN_PER_MM, 0.0, above=True, counts=(1, 2), repeat=2, absent="by the modes of the building",
        ),
    ] = None  # fmt: skip
    height: Annotated[float, Parameter("height from the floor below", METRE, 0.0, 100.0)] = 0.0
    torsional_stiffness: Annotated[
        float | None,
        Parameter(
            "stiffness against rotation about the centre of stiffness", KN_M, 0.0, above=True,
            absent="walls and columns are spread evenly over the sides",
        ),
    ] = None  # fmt: skip
    inertia: Annotated[
        float | None,
        Parameter(
            "rotational inertia about the centre of mass", TONNE_M2, 0.0, above=True,
            absent="the mass is spread evenly over the sides",
        ),
    ] = None  # fmt: skip
    centre: Annotated[
        tuple[float, float] | None, place_parameter("centre of mass", "that of the building")
    ] = None
    stiffness_centre: Annotated[
        tuple[float, float] | None, place_parameter("centre of stiffness", "the centre of the slab")
    ] = None

    @property
    def stiffnesses(self) -> tuple[float, float]:
        """Stiffness in x and y [N/mm]; zero where modes say it."""
        one = 0.0 if self.stiffness is None else self.stiffness
        return (one[0], one[-1]) if isinstance(one, tuple) else (one, one)

    def inertia_over(self, sides: tuple[float, float]) -> float:
        """Return the rotational inertia of the floor about its centre of mass [t mm2], over `sides` [mm] where none is given."""
        spread = self.mass * (sides[0] ** 2 + sides[1] ** 2) / 12.0
        return spread if self.inertia is None else self.inertia

    def twist_over(self, sides: tuple[float, float]) -> float:
        """Return the torsional stiffness about the centre of stiffness [N mm], over `sides` [mm] where none is given."""
        kx, ky = self.stiffnesses
        spread = (ky * sides[0] ** 2 + kx * sides[1] ** 2) / 12.0
        return spread if self.torsional_stiffness is None else self.torsional_stiffness

    def stiffened(self, factor: float) -> "Storey":
        """Return the storey with all stiffnesses times a factor."""
        twist = self.torsional_stiffness
        return replace(
            self,
            stiffness=tuple(factor * one for one in self.stiffnesses),
            torsional_stiffness=None if twist is None else factor * twist,
        )


@dataclass(frozen=True)
class Superstructure:
    """Floors above a slab, of which each has x, y and rotation about the vertical axis through one origin, relative to the slab.

    Attributes
    ----------
    mass, stiffness
        Matrices [t, t mm, t mm2; N/mm, N, N mm], shape (3 floors, 3 floors).
    heights
        Of the floors above the slab [mm].
    ratio, kind
        Damping ratio, and one of `DAMPING_KINDS`.
    """

    mass: FloatArray
    stiffness: FloatArray
    heights: FloatArray
    ratio: float = 0.02
    kind: str = STIFFNESS_PROPORTIONAL
    axis: FloatArray = field(default_factory=lambda: np.eye(3))

    @property
    def floors(self) -> int:
        """Number of floors above the slab."""
        return self.heights.size

    @property
    def rigid(self) -> FloatArray:
        """Motion of the floors with the slab, shape (3 floors, 3)."""
        return np.tile(np.eye(3), (self.floors, 1))

    @cached_property
    def modes(self) -> tuple[FloatArray, FloatArray]:
        """Circular frequencies on a fixed base [1/s], lowest first, and shapes as columns, of unit modal mass."""
        if self.floors == 0:
            return np.empty(0), np.empty((0, 0))
        squares, shapes = modes_apart(self.mass, self.stiffness)
        return freeze(np.sqrt(squares)), freeze(shapes)

    @property
    def twists(self) -> bool:
        """Whether a floor that moves in x or y is turned."""
        turning = np.arange(len(self.mass)) % 3 == 2
        own = [np.sqrt(np.diag(one)) for one in (self.mass, self.stiffness)]
        ratios = [
            np.abs(one) / np.outer(r, r) for one, r in zip((self.mass, self.stiffness), own, strict=True)
        ]
        return any(bool((one[np.ix_(turning, ~turning)] > _CENTRED).any()) for one in ratios)

    @property
    def damping(self) -> FloatArray:
        """Damping 2 z w of the modes on a fixed base [1/s]."""
        frequencies, _ = self.modes
        if self.kind == MODAL or not frequencies.size:
            return 2.0 * self.ratio * frequencies
        return 2.0 * self.ratio * frequencies**2 / frequencies[0]

    @property
    def periods(self) -> FloatArray:
        """Periods on a fixed base [s], longest first."""
        return 2.0 * math.pi / self.modes[0]


def superstructure(
    storeys: tuple[Storey, ...],
    sides: tuple[float, float],
    centre: tuple[float, float],
    middle: tuple[float, float],
    angle: float,
    ratio: float,
    kind: str,
    shapes: ModeShapes | None = None,
    accident: tuple[float, float] = (0.0, 0.0),
) -> Superstructure:
    """Return the superstructure of storeys from below.

    Parameters
    ----------
    storeys
        From below.
    sides
        Of the floors [mm].
    centre, middle
        Origin, which is the centre of mass of floors that have no other, and centre of stiffness of storeys that have no other [mm].
    angle
        From x to the first axis of storeys and sides [rad].
    ratio, kind
        Of the damping.
    shapes, accident
        Modes of which the stiffness is, in place of storeys; and by how much the centres of mass have been moved from where they are in these [mm].
    """
    places = [np.subtract(one.centre or centre, centre) for one in storeys]
    mass = _masses(storeys, sides, places)
    if shapes is not None:
        nominal = [
            np.subtract(one, accident if storey.centre is None else 0.0)
            for one, storey in zip(places, storeys, strict=True)
        ]
        stiffness = shapes.stiffness(_masses(storeys, sides, nominal), nominal)
    else:
        middles = [np.subtract(one.stiffness_centre or middle, centre) for one in storeys]
        stiffness = _stiffnesses(
            [_storey_stiffness(one, sides, away, angle) for one, away in zip(storeys, middles, strict=True)]
        )
    heights = np.cumsum([one.height for one in storeys])
    return Superstructure(mass, stiffness, np.asarray(heights, dtype=np.float64), ratio, kind)


def _masses(
    storeys: tuple[Storey, ...], sides: tuple[float, float], places: Sequence[FloatArray]
) -> FloatArray:
    """Return the mass matrix of floors whose centres of mass lie at `places` from the origin."""
    found = np.zeros((3 * len(storeys), 3 * len(storeys)))
    for j, (one, (x, y)) in enumerate(zip(storeys, places, strict=True)):
        own = slice(3 * j, 3 * j + 3)
        inertia = one.inertia_over(sides)
        m = one.mass
        found[own, own] = [[m, 0.0, -m * y], [0.0, m, m * x], [-m * y, m * x, inertia + m * (x * x + y * y)]]
    return found


def _stiffnesses(blocks: Sequence[FloatArray]) -> FloatArray:
    """Return the stiffness matrix of storeys whose own ones are `blocks`, from below."""
    found = np.zeros((3 * len(blocks), 3 * len(blocks)))
    for j, block in enumerate(blocks):
        own = slice(3 * j, 3 * j + 3)
        found[own, own] += block
        if j > 0:
            below = slice(3 * j - 3, 3 * j)
            found[below, below] += block
            found[own, below] -= block
            found[below, own] -= block
    return found


def _storey_stiffness(
    storey: Storey, sides: tuple[float, float], away: FloatArray, angle: float
) -> FloatArray:
    """Return the stiffness of a storey about the origin, from which its centre of stiffness is `away`."""
    kx, ky = storey.stiffnesses
    cosine, sine = math.cos(angle), math.sin(angle)
    turn = np.array([[cosine, sine], [-sine, cosine]])
    plane = turn.T @ np.diag([kx, ky]) @ turn
    # displacement at the centre of stiffness of x, y and rotation about the origin
    there = np.array([[1.0, 0.0, -away[1]], [0.0, 1.0, away[0]]])
    found = there.T @ plane @ there
    found[2, 2] += storey.twist_over(sides)
    return found
