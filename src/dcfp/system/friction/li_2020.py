"""Friction that depends on pressure, velocity and temperature: Li et al. (2020), section 4.1."""

from itertools import compress
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.kernels.law import Law, exponential_law
from dcfp.schema.declared import declared
from dcfp.schema.formulas import Expression
from dcfp.system.friction.law import (
    Factor,
    FrictionLaw,
    OfPressure,
    OfTemperature,
    OfVelocity,
    Tested,
    coefficient_parameter,
)

#: Coefficient at 60 N/mm2, 400 mm/s and about 20 degC [-], section 4.1.
MU_0 = 0.075
#: Constants of Eqs (7), (8) [s/mm] and (9) [1/degC].
GAMMA_SCALE, GAMMA_POWER, GAMMA_FLOOR = 2.03, -0.19, 0.068
ALPHA_DROP, ALPHA_RATE = 0.55, 0.019
BETA_SCALE, BETA_RATE = 1.13, 0.007


def pressure_factor(pressure: ArrayLike) -> FloatArray:
    r"""Pressure dependency factor [-] at a pressure [N/mm2].

    .. math:: \gamma = 2.03\,\sigma^{-0.19} + 0.068

    Li et al. (2020), Eq. (7).
    """
    power = np.asarray(pressure, dtype=np.float64) ** GAMMA_POWER
    return np.asarray(GAMMA_SCALE * power + GAMMA_FLOOR)


def velocity_factor(speed: ArrayLike) -> FloatArray:
    r"""Velocity dependency factor [-] at a relative speed of the plates [mm/s].

    .. math:: \alpha = 1 - 0.55\,e^{-0.019 |v|}

    Li et al. (2020), Eq. (8).
    """
    return np.asarray(1.0 - ALPHA_DROP * np.exp(-ALPHA_RATE * np.abs(speed)))


def temperature_factor(temperature: ArrayLike) -> FloatArray:
    r"""Temperature dependency factor [-] at a temperature of the contact [degC].

    .. math:: \beta = 1.13\,e^{-0.007 T}

    Li et al. (2020), Eq. (9).
    """
    return np.asarray(BETA_SCALE * np.exp(-BETA_RATE * np.asarray(temperature, dtype=np.float64)))


@declared
class Li2020(FrictionLaw):
    r"""The paper's law, :math:`\mu = \mu_0 \gamma \alpha \beta`: Li et al. (2020), Eq. (10).

    Parameters
    ----------
    mu_0
        Coefficient at 60 N/mm2, 400 mm/s and 17.5 degC [-], where each factor is one within 0.05 %.

    Notes
    -----
    The speed of Eq. (8) is that of the upper plate relative to the lower one, as the paper writes, and was fitted to bearings
    of two equal plates. On a single or two different plates it is still taken as that, not as twice the speed on one plate.
    """

    name: ClassVar[str] = "li2020"
    words: ClassVar[str] = "Li et al. (2020), the paper's"
    citation: ClassVar[str] = "li_2020"
    reference_parameter: ClassVar[str] = "mu_0"
    tested: ClassVar[Tested | None] = Tested(
        (30.0, 90.0), (0.0, 644.0), "Li et al. 2020, Tables 1 and 2", 20.0
    )

    equation_numbers: ClassVar[str] = ", Eqs (7)-(10)"
    product_number: ClassVar[str] = ", Eq. (10)"

    mu_0: Annotated[float, coefficient_parameter("coefficient at 60 N/mm2, 400 mm/s and 17.5 degC")] = MU_0
    pressure_dependent: OfPressure = True
    velocity_dependent: OfVelocity = True
    temperature_dependent: OfTemperature = True

    def at_pressure(self, pressure: float) -> Law:
        """Return the constants for the kernels at a pressure [N/mm2]."""
        return exponential_law(
            self.mu_0 * (float(pressure_factor(pressure)) if self.pressure_dependent else 1.0),
            ALPHA_DROP if self.velocity_dependent else 0.0,
            ALPHA_RATE,
            BETA_SCALE if self.temperature_dependent else 0.0,
            BETA_RATE,
            0.0 if self.temperature_dependent else 1.0,
        )

    def factors(self) -> tuple[Factor, ...]:
        """Return the factors that are used."""
        gamma = Expression(f"{GAMMA_SCALE:g}{{dot}}{{x}}^({GAMMA_POWER:g}) + {GAMMA_FLOOR:g}", "sigma")
        alpha = Expression(f"1 - {ALPHA_DROP:g} exp(-{ALPHA_RATE:g}{{dot}}{{x}})", "v")
        beta = Expression(f"{BETA_SCALE:g} exp(-{BETA_RATE:g}{{dot}}{{x}})", "T")
        factors = (
            Factor("pressure", "gamma", gamma, pressure_factor, ", Eq. (7)"),
            Factor("speed", "alpha", alpha, velocity_factor, ", Eq. (8)"),
            Factor("temperature", "beta", beta, temperature_factor, ", Eq. (9)"),
        )
        used = (self.pressure_dependent, self.velocity_dependent, self.temperature_dependent)
        return tuple(compress(factors, used))
