"""The form that three laws of friction and temperature share."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray


@dataclass(frozen=True)
class TemperatureLaw:
    r"""A fall with temperature that levels off.

    .. math:: k_T = A\,0.7^{n T} + C

    Parameters
    ----------
    scale
        A [-].
    power
        n [1/degC].
    floor
        C [-].
    """

    scale: float
    power: float
    floor: float

    @property
    def rate(self) -> float:
        """Rate of the same law written with an exponential [1/degC]."""
        return -self.power * math.log(0.7)

    def factor(self, temperature: ArrayLike) -> FloatArray:
        """Factor k_T [-] at a temperature of the contact [degC]."""
        exponent = self.power * np.asarray(temperature, dtype=np.float64)
        return np.asarray(self.scale * np.power(0.7, exponent) + self.floor)
