"""Friction that depends on pressure, velocity and temperature: Kumar, Whittaker and Constantinou (2015)."""

import math
from dataclasses import dataclass
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.kernels.law import Law, exponential_law
from dcfp.schema.formulas import Expression
from dcfp.schema.parameters import Parameter, declared
from dcfp.schema.units import FRACTION, N_PER_MM2
from dcfp.system.friction import li_2020
from dcfp.system.friction.law import Factor, FrictionLaw

#: Part of the coefficient that is missing at zero speed [-], and rate of the velocity factor [s/mm]: 100 s/m.
VELOCITY_DROP, VELOCITY_RATE = 0.5, 0.1
#: Base of the factors of pressure and temperature [-], and rate of the former [mm2/N].
BASE, PRESSURE_RATE = 0.7, 0.02


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
        return -self.power * math.log(BASE)

    def factor(self, temperature: ArrayLike) -> FloatArray:
        """Factor k_T [-] at a temperature of the contact [degC]."""
        exponent = self.power * np.asarray(temperature, dtype=np.float64)
        return np.asarray(self.scale * np.power(BASE, exponent) + self.floor)


def pressure_factor(pressure: ArrayLike, reference_pressure: float) -> FloatArray:
    r"""Pressure factor [-] at a pressure [N/mm2].

    .. math:: k_p = 0.7^{0.02 (p - p_0)}
    """
    excess = np.asarray(pressure, dtype=np.float64) - reference_pressure
    return np.asarray(np.power(BASE, PRESSURE_RATE * excess))


def velocity_factor(speed: ArrayLike) -> FloatArray:
    r"""Velocity factor [-] at a speed of the slider on a plate [mm/s].

    .. math:: k_v = 1 - 0.5\,e^{-a |v|}, \quad a = 100\ \mathrm{s/m}
    """
    return np.asarray(1.0 - VELOCITY_DROP * np.exp(-VELOCITY_RATE * np.abs(speed)))


@declared
class Kumar2015(FrictionLaw):
    r"""Law of Kumar et al. (2015), :math:`\mu = \mu_{ref} k_p k_v k_T`.

    Parameters
    ----------
    mu_reference
        Coefficient at the reference pressure, at high speed and 20 degC [-].
    reference_pressure
        p_0 [N/mm2].
    pressure_dependent, velocity_dependent, temperature_dependent
        Whether a factor is used; one that is not is replaced by one.

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
        Parameter(
            "coefficient at the reference pressure, at high speed and 20 degC",
            FRACTION,
            0.0,
            0.9999,
            symbol=r"\mu_{\mathrm{ref}}",
            above=True,
            step=0.005,
        ),
    ] = li_2020.MU_0
    reference_pressure: Annotated[
        float, Parameter("reference pressure", N_PER_MM2, 0.1, 1000.0, symbol="p_0", step=1.0)
    ] = 60.0
    pressure_dependent: Annotated[
        bool, Parameter("whether the coefficient depends on pressure", vary=False)
    ] = True
    velocity_dependent: Annotated[
        bool, Parameter("whether the coefficient depends on velocity", vary=False)
    ] = True
    temperature_dependent: Annotated[
        bool, Parameter("whether the coefficient depends on temperature", vary=False)
    ] = True

    @property
    def reference(self) -> float:
        """Reference coefficient [-]."""
        return self.mu_reference

    def pressure_factor(self, pressure: ArrayLike) -> FloatArray:
        """Factor k_p [-], or one."""
        if self.pressure_dependent:
            return pressure_factor(pressure, self.reference_pressure)
        return np.ones_like(pressure, np.float64)

    def velocity_factor(self, speed: ArrayLike) -> FloatArray:
        """Factor k_v [-], or one."""
        return velocity_factor(speed) if self.velocity_dependent else np.ones_like(speed, np.float64)

    def temperature_factor(self, temperature: ArrayLike) -> FloatArray:
        """Factor k_T [-], or one."""
        if self.temperature_dependent:
            return self.temperature_law.factor(temperature)
        return np.ones_like(temperature, np.float64)

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
        return (
            *((Factor("pressure", "k_p", of_pressure),) if self.pressure_dependent else ()),
            *((Factor("speed", "k_v", of_speed),) if self.velocity_dependent else ()),
            *((Factor("temperature", "k_T", of_temperature),) if self.temperature_dependent else ()),
        )
