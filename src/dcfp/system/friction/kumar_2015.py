"""Friction that depends on pressure, velocity and temperature: Kumar, Whittaker and Constantinou (2015).

With two more falls with temperature: Kim and Constantinou (2023).
"""

import math
from itertools import compress
from typing import Annotated, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.kernels.law import Law, exponential_law
from dcfp.schema.declared import declared
from dcfp.schema.formulas import Expression
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import N_PER_MM2
from dcfp.system.friction import li_2020
from dcfp.system.friction.law import (
    Factor,
    FrictionLaw,
    OfPressure,
    OfTemperature,
    OfVelocity,
    coefficient_parameter,
)

#: Part of the coefficient that is missing at zero speed [-], and rate of the velocity factor [s/mm]: 100 s/m.
VELOCITY_DROP, VELOCITY_RATE = 0.5, 0.1
#: Base of the factors of pressure and temperature [-], and rate of the former [mm2/N].
BASE, PRESSURE_RATE = 0.7, 0.02


class TemperatureLaw(NamedTuple):
    r"""A fall with temperature that levels off, :math:`k_T = A\,0.7^{n T} + C`: scale A [-], power n [1/degC] and floor C [-]."""

    scale: float
    power: float
    floor: float

    @property
    def rate(self) -> float:
        """Rate of the same law written with an exponential [1/degC]."""
        return -self.power * math.log(BASE)

    def factor(self, temperature: ArrayLike) -> FloatArray:
        """Factor k_T [-] at a temperature of the contact [degC]."""
        exponent = self.power * np.asarray(temperature, dtype=np.float64)
        return np.asarray(self.scale * np.power(BASE, exponent) + self.floor)


@declared
class Kumar2015(FrictionLaw):
    r"""Law of Kumar et al. (2015), :math:`\mu = \mu_{ref} k_p k_v k_T`.

    .. math:: k_p = 0.7^{0.02 (p - p_0)}, \quad
              k_v = 1 - 0.5\,e^{-a |v|} \ \text{with}\ a = 100\ \mathrm{s/m}

    Notes
    -----
    The reference coefficient is a property of the bearing and not of the law; the default is that of
    the bearing of Li et al. (2020) at its pressure of 60 N/mm2. The paper's steel has a conductivity of 18 N/(s degC) and
    a diffusivity of 4.44 mm2/s; the heating models know that of Li et al. unless it is given to them.
    """

    temperature_law: ClassVar[TemperatureLaw] = TemperatureLaw(0.789, 0.02, 0.789 * 0.40)
    name: ClassVar[str] = "kumar2015"
    words: ClassVar[str] = "Kumar et al. (2015)"
    citation: ClassVar[str] = "kumar_2015"
    reference_parameter: ClassVar[str] = "mu_reference"
    speed_is_of_surface: ClassVar[bool] = True
    reference_symbol: ClassVar[str] = 'mu_"ref"'

    mu_reference: Annotated[
        float,
        coefficient_parameter(
            "coefficient at the reference pressure, at high speed and 20 degC", r"\mu_{\mathrm{ref}}"
        ),
    ] = li_2020.MU_0
    reference_pressure: Annotated[
        float, Parameter("reference pressure", N_PER_MM2, 0.1, 1000.0, symbol="p_0", step=1.0)
    ] = 60.0
    pressure_dependent: OfPressure = True
    velocity_dependent: OfVelocity = True
    temperature_dependent: OfTemperature = True

    def at_pressure(self, pressure: float) -> Law:
        """Return the constants for the kernels at a pressure [N/mm2]."""
        law = self.temperature_law
        return exponential_law(
            self.mu_reference * float(self.pressure_factor(pressure)),
            VELOCITY_DROP if self.velocity_dependent else 0.0,
            VELOCITY_RATE,
            law.scale if self.temperature_dependent else 0.0,
            law.rate,
            law.floor if self.temperature_dependent else 1.0,
        )

    def factors(self) -> tuple[Factor, ...]:
        """Return the factors that are used."""
        heat, ref = self.temperature_law, {"ref": ("p_0", f"{self.reference_pressure:g}")}
        of_pressure = Expression(f"{BASE:g}^({PRESSURE_RATE:g} ({{x}} - {{ref}}))", "p", ref)
        of_speed = Expression(f"1 - {VELOCITY_DROP:g} exp(-{VELOCITY_RATE:g}{{dot}}{{x}})", "v")
        power = f"{BASE:g}^({heat.power:g}{{dot}}{{x}})"
        of_temperature = Expression(f"{heat.scale:g} times {power} + {heat.floor:g}", "T")
        factors = (
            Factor("pressure", "k_p", of_pressure, self._of_pressure),
            Factor("speed", "k_v", of_speed, _of_speed),
            Factor("temperature", "k_T", of_temperature, heat.factor),
        )
        used = (self.pressure_dependent, self.velocity_dependent, self.temperature_dependent)
        return tuple(compress(factors, used))

    def _of_pressure(self, pressure: FloatArray) -> FloatArray:
        return np.power(BASE, PRESSURE_RATE * (pressure - self.reference_pressure))


def _of_speed(speed: FloatArray) -> FloatArray:
    return 1.0 - VELOCITY_DROP * np.exp(-VELOCITY_RATE * np.abs(speed))


@declared
class KimConstantinou2023Third(Kumar2015):
    """The law of Kumar et al. (2015) with a temperature factor that leaves one third at 200 degC."""

    temperature_law: ClassVar[TemperatureLaw] = TemperatureLaw(0.9696, 0.0289, 0.2099)
    name: ClassVar[str] = "kim2023-third"
    words: ClassVar[str] = "Kim and Constantinou (2023), a third at 200 °C"
    citation: ClassVar[str] = "kim_constantinou_2022"


@declared
class KimConstantinou2023TwoThirds(Kumar2015):
    """The law of Kumar et al. (2015) with a temperature factor that leaves two thirds at 200 degC."""

    temperature_law: ClassVar[TemperatureLaw] = TemperatureLaw(0.8383, 0.00851, 0.2099)
    name: ClassVar[str] = "kim2023-two-thirds"
    words: ClassVar[str] = "Kim and Constantinou (2023), two thirds at 200 °C"
    citation: ClassVar[str] = "kim_constantinou_2022"
