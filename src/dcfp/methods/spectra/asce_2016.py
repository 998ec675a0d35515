"""The spectrum of the risk-targeted maximum considered earthquake: ASCE/SEI 7-16, sections 11.4.6 and 11.4.7."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.constants import STANDARD_GRAVITY
from dcfp.schema.checks import positive

#: Part of T_S at which the plateau begins, and of it the value at period zero [-].
_START, _AT_ZERO = 0.2, 0.4


@dataclass(frozen=True)
class Asce2016Spectrum:
    """Four branches: rising, constant acceleration, constant velocity, constant displacement.

    Parameters
    ----------
    short
        S_MS, acceleration at short periods, in units of gravity [-].
    one_second
        S_M1, acceleration at 1 s, in units of gravity [-].
    long_period
        T_L, from which on the displacement is constant [s].
    """

    short: float
    one_second: float
    long_period: float = 8.0
    unconfirmed: tuple[str, ...] = ("the branches below T_S and beyond T_L of the spectrum",)

    def __post_init__(self) -> None:
        positive(self.short, "S_MS", "g")
        positive(self.one_second, "S_M1", "g")
        positive(self.long_period, "long-period transition T_L", "s")

    @property
    def name(self) -> str:
        """What to call it."""
        return f"ASCE 7-16, S_MS {self.short:g} g, S_M1 {self.one_second:g} g"

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration [mm/s2] at a period [s]."""
        T = np.asarray(period, dtype=np.float64)
        T_S = self.one_second / self.short
        T_0 = _START * T_S
        T_L = self.long_period
        rising = self.short * (_AT_ZERO + (1.0 - _AT_ZERO) * T / T_0)
        velocity = self.one_second / np.maximum(T, 1e-9)
        S_a = np.where(
            T < T_0,
            rising,
            np.where(
                T <= T_S, self.short, np.where(T <= T_L, velocity, velocity * T_L / np.maximum(T, 1e-9))
            ),
        )
        return np.asarray(S_a * STANDARD_GRAVITY)
