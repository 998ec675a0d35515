"""Friction that depends on pressure, velocity and temperature: Kumar, Whittaker and Constantinou (2015)."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.kernels.friction import ExponentialLaw
from dcfp.system.checks import fraction, positive, yes_or_no
from dcfp.system.friction import li_2020
from dcfp.system.friction.law import FrictionLaw, TemperatureLaw

#: Rate of the velocity factor [s/mm]: 100 s/m.
VELOCITY_RATE = 0.1


def pressure_factor(pressure: ArrayLike, reference_pressure: float) -> FloatArray:
    r"""Pressure factor [-] at a pressure [N/mm2].

    .. math:: k_p = 0.7^{0.02 (p - p_0)}
    """
    return np.asarray(np.power(0.7, 0.02 * (np.asarray(pressure, dtype=np.float64) - reference_pressure)))


def velocity_factor(speed: ArrayLike) -> FloatArray:
    r"""Velocity factor [-] at a speed of the slider on a plate [mm/s].

    .. math:: k_v = 1 - 0.5\,e^{-a |v|}, \quad a = 100\ \mathrm{s/m}
    """
    return np.asarray(1.0 - 0.5 * np.exp(-VELOCITY_RATE * np.abs(speed)))


@dataclass(frozen=True)
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

    mu_reference: float = li_2020.MU_0
    reference_pressure: float = 60.0
    pressure_dependent: bool = True
    velocity_dependent: bool = True
    temperature_dependent: bool = True
    temperature_law: ClassVar[TemperatureLaw] = TemperatureLaw(0.789, 0.02, 0.789 * 0.40)
    name: ClassVar[str] = "kumar2015"
    citation: ClassVar[str] = "kumar_2015"
    reference_parameter: ClassVar[str] = "mu_reference"
    speed_is_of_surface: ClassVar[bool] = True

    def __post_init__(self) -> None:
        fraction(self.mu_reference, "reference coefficient of friction")
        positive(self.reference_pressure, "reference pressure", "N/mm2")
        for effect in ("pressure", "velocity", "temperature"):
            yes_or_no(getattr(self, f"{effect}_dependent"), f"{effect}_dependent")

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

    def at_pressure(self, pressure: float) -> ExponentialLaw:
        """Return the constants for the kernels at a pressure [N/mm2]."""
        law = self.temperature_law
        return ExponentialLaw(
            self.mu_reference * float(self.pressure_factor(pressure)),
            0.5 if self.velocity_dependent else 0.0,
            VELOCITY_RATE,
            law.scale if self.temperature_dependent else 0.0,
            law.rate,
            law.floor if self.temperature_dependent else 1.0,
        )
