"""Viscous damping of a superstructure, from ratios of its modes on a fixed base."""

import math
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError


@dataclass(frozen=True)
class StiffnessProportional:
    """A damper in each storey, in proportion to its stiffness: C = beta K.

    Parameters
    ----------
    ratio
        Damping ratio of the first mode on a fixed base [-]; those of the others are in proportion to their frequencies.
    """

    ratio: float

    def __post_init__(self) -> None:
        _damping_ratio(self.ratio)

    def factors(self, frequencies: FloatArray) -> tuple[float, float]:
        """Return alpha [1/s] and beta [s] of C = alpha M + beta K; circular frequencies [1/s] of the modes, lowest first."""
        return 0.0, 2.0 * self.ratio / float(frequencies[0])


@dataclass(frozen=True)
class Rayleigh:
    """Damping by mass and by stiffness, C = alpha M + beta K, on the motion relative to the base.

    Parameters
    ----------
    ratios
        Damping ratios of two modes on a fixed base [-].
    modes
        Numbers of these modes; 1 is the first.
    """

    ratios: tuple[float, float]
    modes: tuple[int, int] = (1, 2)

    def __post_init__(self) -> None:
        if len(self.ratios) != 2 or len(self.modes) != 2:
            msg = "Rayleigh damping needs the ratios of two modes and the numbers of both."
            raise InputError(msg)
        for ratio in self.ratios:
            _damping_ratio(ratio)
        first, second = self.modes
        if type(first) is not int or type(second) is not int or not 1 <= first < second:
            msg = f"The modes of Rayleigh damping must be two different numbers from 1 on, the lower one first, not {self.modes!r}."
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


def _damping_ratio(ratio: float) -> None:
    if not (math.isfinite(ratio) and 0.0 < ratio < 1.0):
        msg = f"A damping ratio must lie between 0 and 1, not {ratio!r}; without damping it is None."
        raise InputError(msg)
