r"""Three laws of how friction falls with temperature: Kim and Constantinou (2023).

Each is :math:`k_T = A\,0.7^{n T} + C` with T in degC, near one at 20 degC, and named after what is left of it at
200 degC. The one that leaves half is that of Kumar, Whittaker and Constantinou (2015).
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray


@dataclass(frozen=True)
class TemperatureLaw:
    """Constants of one law; see `temperature_factor`."""

    scale: float  # A [-]
    power: float  # n [1/degC]
    floor: float  # C [-]

    @property
    def rate(self) -> float:
        """Rate of the same law written with an exponential [1/degC]."""
        return -self.power * math.log(0.7)


TEMPERATURE_LAWS = {
    "half": TemperatureLaw(0.789, 0.02, 0.789 * 0.40),
    "one third": TemperatureLaw(0.9696, 0.0289, 0.2099),
    "two thirds": TemperatureLaw(0.8383, 0.00851, 0.2099),
}


def temperature_factor(temperature: ArrayLike, law: TemperatureLaw) -> FloatArray:
    r"""Temperature factor [-] at a temperature of the contact [degC].

    .. math:: k_T = A\,0.7^{n T} + C
    """
    return np.asarray(law.scale * np.power(0.7, law.power * np.asarray(temperature, float)) + law.floor)
