"""A building of which each storey is a spring: masses, stiffnesses and the viscous damping of its modes on a fixed base."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Annotated, TypeAlias

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.schema.declared import Declared, declared
from dcfp.schema.notebook import fields_card
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import FRACTION, N_PER_MM, NONE, SECOND, TONNE

_STOREYS = Parameter("number of storeys", NONE, 1, kind=int)
_PERIOD = Parameter("first period on a fixed base", SECOND, 0.0, above=True)
_MASS_RATIO = Parameter("mass of the base over that of a floor", NONE, 0.0, above=True)
_RATIO = Parameter("damping ratio", FRACTION, 0.0, 0.9999, above=True)
_MASS = Parameter("mass of a floor", TONNE, 0.0, above=True)
_STIFFNESS = Parameter("stiffness of a storey", N_PER_MM, 0.0, above=True)


@declared
class StiffnessProportional(Declared):
    """A damper in each storey, in proportion to its stiffness, C = beta K; the `ratio` is that of the first mode on a fixed base."""

    ratio: Annotated[float, _RATIO]

    def factors(self, frequencies: FloatArray) -> tuple[float, float]:
        """Return alpha [1/s] and beta [s] of C = alpha M + beta K; circular frequencies [1/s] of the modes, lowest first."""
        return 0.0, 2.0 * self.ratio / float(frequencies[0])


@declared
class Rayleigh(Declared):
    """Damping by mass and by stiffness, C = alpha M + beta K, on the motion relative to the base, with the ratios of two modes on a fixed base."""

    ratios: Annotated[tuple[float, float], _RATIO]
    modes: Annotated[tuple[int, int], Parameter("number of a mode", NONE, 1)] = (1, 2)

    def check_relations(self) -> None:
        """Refuse one mode twice."""
        if not self.modes[0] < self.modes[1]:
            msg = f"The modes of Rayleigh damping must be two different numbers, the lower one first, not {self.modes!r}."
            raise InputError(msg)

    def factors(self, frequencies: FloatArray) -> tuple[float, float]:
        """Return alpha [1/s] and beta [s] of C = alpha M + beta K; circular frequencies [1/s] of the modes, lowest first."""
        first, second = self.modes
        if second > frequencies.size:
            msg = f"Rayleigh damping by mode {second} needs a building of at least as many storeys, not {frequencies.size}."
            raise InputError(msg)
        chosen = frequencies[[first - 1, second - 1]]
        alpha, beta = np.linalg.solve(
            np.column_stack((0.5 / chosen, 0.5 * chosen)), np.array(self.ratios, dtype=np.float64)
        )
        if min(alpha * chosen[0], beta * chosen[0] ** 3) < -1e-12 * chosen[0] ** 2:
            msg = f"The damping ratios {self.ratios!r} are too far apart: between or beyond the modes {self.modes!r} the damping would be negative."
            raise InputError(msg)
        return max(float(alpha), 0.0), max(float(beta), 0.0)


Damping: TypeAlias = StiffnessProportional | Rayleigh


#: Damping unless another is chosen: 2 % in the first mode on a fixed base, in proportion to the stiffness.
TWO_PERCENT = StiffnessProportional(0.02)


@dataclass(frozen=True)
class ShearBuilding:
    """A base on the isolation layer, and storeys above it.

    Parameters
    ----------
    masses
        Of the base and of the floors above it, from below [t], one more than there are storeys.
    stiffnesses
        Shear stiffness of each storey, from below [N/mm].
    damping
        Of the superstructure; None for none. The isolation layer has no viscous damping.

    Notes
    -----
    Only ratios matter, for a bearing's vertical force says what it carries: masses and stiffnesses are multiplied by the one factor with
    which the masses add up to that of the bearing (`scaled_to`). This leaves periods and damping ratios as they are, so masses can
    be given as fractions too.
    """

    masses: tuple[float, ...] = field(metadata={"unit": TONNE})
    stiffnesses: tuple[float, ...] = field(metadata={"unit": N_PER_MM})
    damping: Damping | None = TWO_PERCENT

    def __post_init__(self) -> None:
        masses = _checked(self.masses, _MASS)
        stiffnesses = _checked(self.stiffnesses, _STIFFNESS)
        if not stiffnesses:
            msg = (
                "A building needs at least one storey; without any it is the rigid structure of dcfp.respond."
            )
            raise InputError(msg)
        if len(masses) != len(stiffnesses) + 1:
            msg = (
                f"A building of {len(stiffnesses)} storeys needs {len(stiffnesses) + 1} masses, that of the base first,"
                f" not {len(masses)}."
            )
            raise InputError(msg)
        object.__setattr__(self, "masses", masses)
        object.__setattr__(self, "stiffnesses", stiffnesses)
        if self.damping is not None:
            self.damping.factors(self._frequencies)

    @property
    def storeys(self) -> int:
        """Number of storeys above the base."""
        return len(self.stiffnesses)

    @property
    def mass(self) -> float:
        """Sum of all masses [t]."""
        return math.fsum(self.masses)

    @property
    def fixed_base_periods(self) -> FloatArray:
        """Periods of the undamped storeys on a fixed base [s], longest first, shape (storeys,)."""
        return freeze(2.0 * math.pi / self._frequencies)

    @property
    def storey_stiffness(self) -> FloatArray:
        """Stiffness matrix of the storeys [N/mm] for the displacements of base and floors, shape (floors, floors)."""
        return self._of_all(self._fixed_base_stiffness)

    @property
    def damping_matrix(self) -> FloatArray:
        """Damping matrix [N s/mm] for the velocities of base and floors, shape (floors, floors)."""
        if self.damping is None:
            return np.zeros((self.storeys + 1, self.storeys + 1))
        alpha, beta = self.damping.factors(self._frequencies)
        return self._of_all(alpha * np.diag(self.masses[1:]) + beta * self._fixed_base_stiffness)

    def scaled_to(self, mass: float) -> "ShearBuilding":
        """Return the building with this sum of masses [t], and stiffnesses multiplied by the same factor."""
        factor = _MASS.checked(mass, "ShearBuilding: mass") / self.mass
        return replace(
            self,
            masses=tuple(factor * m for m in self.masses),
            stiffnesses=tuple(factor * k for k in self.stiffnesses),
        )

    @property
    def _fixed_base_stiffness(self) -> FloatArray:
        above = np.array([*self.stiffnesses[1:], 0.0])
        between = -above[:-1]
        return np.diag(np.array(self.stiffnesses) + above) + np.diag(between, 1) + np.diag(between, -1)

    @cached_property
    def _frequencies(self) -> FloatArray:
        root = 1.0 / np.sqrt(np.array(self.masses[1:]))
        return freeze(np.sqrt(np.linalg.eigvalsh(self._fixed_base_stiffness * np.outer(root, root))))

    def _of_all(self, of_storeys: FloatArray) -> FloatArray:
        """Return a matrix for the motion relative to the base as one for that of base and floors."""
        relative = np.hstack((-np.ones((self.storeys, 1)), np.eye(self.storeys)))
        return relative.T @ of_storeys @ relative

    def _repr_html_(self) -> str:
        facts = {"fixed_base_periods [s]": tuple(self.fixed_base_periods.tolist())}
        return fields_card(self, f"Shear building of {self.storeys} storeys", facts)


def uniform_building(
    storeys: int,
    period: float,
    *,
    mass_ratio: float = 1.0,
    damping: Damping | None = TWO_PERCENT,
) -> ShearBuilding:
    """Return a building of equal storeys with masses as fractions of their sum.

    Parameters
    ----------
    storeys, damping
        Number of storeys above the base, and damping of the superstructure.
    period
        First on a fixed base [s].
    mass_ratio
        Mass of the base over that of a floor [-].
    """
    storeys = _STOREYS.checked(storeys, "uniform_building: number of storeys")
    frequency = 2.0 * math.pi / _PERIOD.checked(period, "uniform_building: first period on a fixed base")
    floor = 1.0 / (
        storeys + _MASS_RATIO.checked(mass_ratio, "uniform_building: ratio of the base's mass to a floor's")
    )
    # of n equal masses on equal springs: omega_1 = 2 sqrt(k/m) sin(pi / (4 n + 2))
    stiffness = floor * (0.5 * frequency / math.sin(math.pi / (4 * storeys + 2))) ** 2
    return ShearBuilding((mass_ratio * floor, *(floor,) * storeys), (stiffness,) * storeys, damping)


def _checked(values: Sequence[float], one: Parameter) -> tuple[float, ...]:
    return tuple(one.checked(value, f"ShearBuilding: {one.words}") for value in values)
