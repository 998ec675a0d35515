"""Friction that depends on pressure, velocity and temperature, with constants from tests of a bearing."""

import math
from dataclasses import dataclass
from typing import ClassVar, cast

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.kernels.friction import ExponentialLaw
from dcfp.system.checks import finite, fraction, positive
from dcfp.system.friction import li_2020
from dcfp.system.friction.law import FrictionLaw, Tested

#: Temperature at which Eq. (9) of Li et al. (2020), 1.13 exp(-0.007 T), is one [degC].
REFERENCE_TEMPERATURE = math.log(1.13) / 0.007

#: Largest values that a wrong unit would pass.
_LARGEST_EXPONENT, _LARGEST_SPEED_RATE, _LARGEST_TEMPERATURE_RATE = 5.0, 10.0, 0.2


@dataclass(frozen=True)
class FittedFriction(FrictionLaw):
    r"""The form of the law of Li et al. (2020) with free constants, :math:`\mu = \mu_0 \gamma \alpha \beta`.

    .. math:: \gamma = (1 - c)\,(p / p_{ref})^{-n} + c, \quad
              \alpha = 1 - a\,e^{-b |v|}, \quad
              \beta = e^{-r\,(T - T_{ref})}

    Parameters
    ----------
    mu_0
        Coefficient at the reference pressure and temperature and at high speed [-].
    pressure_exponent
        n [-].
    pressure_floor
        c, the part of the coefficient that no pressure takes away [-].
    reference_pressure
        p_ref [N/mm2].
    speed_drop
        a, the part of the coefficient that is missing at zero speed [-].
    speed_rate
        b [s/mm], for the relative speed of the plates.
    temperature_rate
        r [1/degC].
    reference_temperature
        T_ref [degC].
    tested_pressure, tested_speed
        Smallest and largest pressure [N/mm2] and relative speed [mm/s] of the tests that the constants rest on; None where they are not known.
    tested_ambient
        Temperature of the bearing before these tests [degC].

    Notes
    -----
    The defaults restate Eqs (7)-(10) of Li et al. (2020), whose factor of pressure is 1.0005 at 60 N/mm2, within 0.06 % from 20 to 120 N/mm2.
    `dcfp identify` writes a bearing file with the constants of a bearing that was tested.
    """

    mu_0: float = li_2020.MU_0
    pressure_exponent: float = 0.19
    pressure_floor: float = 0.068
    reference_pressure: float = 60.0
    speed_drop: float = 0.55
    speed_rate: float = 0.019
    temperature_rate: float = 0.007
    reference_temperature: float = REFERENCE_TEMPERATURE
    tested_pressure: tuple[float, float] | None = None
    tested_speed: tuple[float, float] | None = None
    tested_ambient: float | None = None
    name: ClassVar[str] = "fitted"
    citation: ClassVar[str] = "li_2020"
    reference_parameter: ClassVar[str] = "mu_0"

    def __post_init__(self) -> None:
        fraction(self.mu_0, "coefficient of friction mu_0")
        _between(self.pressure_exponent, "pressure exponent", 0.0, _LARGEST_EXPONENT)
        _between(self.pressure_floor, "pressure floor", 0.0, 1.0)
        positive(self.reference_pressure, "reference pressure", "N/mm2")
        _between(self.speed_drop, "speed drop", 0.0, 0.999)
        positive(self.speed_rate, "speed rate", "s/mm")
        _between(self.speed_rate, "speed rate [s/mm]", 0.0, _LARGEST_SPEED_RATE)
        _between(self.temperature_rate, "temperature rate [1/degC]", 0.0, _LARGEST_TEMPERATURE_RATE)
        finite(self.reference_temperature, "reference temperature", "degC")
        for name in ("tested_pressure", "tested_speed"):
            object.__setattr__(self, name, _range(getattr(self, name), name))
        if self.tested_ambient is not None:
            finite(self.tested_ambient, "temperature before the tests", "degC")

    def tests(self) -> Tested | None:
        """Return the tests that the constants rest on, if the law says which."""
        if self.tested_pressure is None or self.tested_speed is None:
            return None
        return Tested(
            self.tested_pressure, self.tested_speed, "the tests it was fitted to", self.tested_ambient
        )

    @property
    def reference(self) -> float:
        """Coefficient mu_0 [-]."""
        return self.mu_0

    def pressure_factor(self, pressure: ArrayLike) -> FloatArray:
        """Factor gamma [-]."""
        ratio = np.asarray(pressure, dtype=np.float64) / self.reference_pressure
        return np.asarray((1.0 - self.pressure_floor) * ratio**-self.pressure_exponent + self.pressure_floor)

    def velocity_factor(self, speed: ArrayLike) -> FloatArray:
        """Factor alpha [-]."""
        return np.asarray(1.0 - self.speed_drop * np.exp(-self.speed_rate * np.abs(speed)))

    def temperature_factor(self, temperature: ArrayLike) -> FloatArray:
        """Factor beta [-]."""
        rise = np.asarray(temperature, dtype=np.float64) - self.reference_temperature
        return np.asarray(np.exp(-self.temperature_rate * rise))

    def at_pressure(self, pressure: float) -> ExponentialLaw:
        """Return the constants for the kernels at a pressure [N/mm2]."""
        return ExponentialLaw(
            self.mu_0 * float(self.pressure_factor(pressure)),
            self.speed_drop,
            self.speed_rate,
            math.exp(self.temperature_rate * self.reference_temperature),
            self.temperature_rate,
            0.0,
        )


def _range(values: object, name: str) -> tuple[float, float] | None:
    """Return a smallest and a largest value; a list of a file becomes a tuple."""
    if values is None:
        return None
    if not isinstance(values, (list, tuple)) or len(cast("list[float]", values)) != 2:
        msg = f"{name} must be a pair of numbers, the smallest and the largest, not {values!r}."
        raise InputError(msg)
    least, most = cast("list[float]", values)
    if not finite(least, name, "the tests") <= finite(most, name, "the tests"):
        msg = f"{name} must be the smallest and the largest value in this order, not {values!r}."
        raise InputError(msg)
    return float(least), float(most)


def _between(value: float, name: str, least: float, most: float) -> None:
    finite(value, name, "numbers")
    if not least <= value <= most:
        msg = f"The {name} must lie between {least:g} and {most:g}, not {value!r}."
        raise InputError(msg)
