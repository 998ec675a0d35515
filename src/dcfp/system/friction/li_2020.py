"""Friction that depends on pressure, velocity and temperature: Li et al. (2020), section 4.1."""

from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.kernels.law import Law, exponential_law
from dcfp.schema.formulas import Expression
from dcfp.schema.parameters import Parameter, declared
from dcfp.schema.units import FRACTION
from dcfp.system.friction.law import Factor, FrictionLaw, Tested

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
    pressure_dependent, velocity_dependent, temperature_dependent
        Whether a factor is used; one that is not is replaced by one.

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

    mu_0: Annotated[
        float,
        Parameter(
            "coefficient at 60 N/mm2, 400 mm/s and 17.5 degC",
            FRACTION,
            0.0,
            0.9999,
            symbol=r"\mu_0",
            above=True,
            step=0.005,
        ),
    ] = MU_0
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
        """Coefficient mu_0 [-]."""
        return self.mu_0

    def pressure_factor(self, pressure: ArrayLike) -> FloatArray:
        """Factor gamma [-], Eq. (7), or one."""
        return pressure_factor(pressure) if self.pressure_dependent else np.ones_like(pressure, np.float64)

    def velocity_factor(self, speed: ArrayLike) -> FloatArray:
        """Factor alpha [-], Eq. (8), or one."""
        return velocity_factor(speed) if self.velocity_dependent else np.ones_like(speed, np.float64)

    def temperature_factor(self, temperature: ArrayLike) -> FloatArray:
        """Factor beta [-], Eq. (9), or one."""
        if self.temperature_dependent:
            return temperature_factor(temperature)
        return np.ones_like(temperature, np.float64)

    def at_pressure(self, pressure: float) -> Law:
        """Return the constants for the kernels at a pressure [N/mm2]."""
        return exponential_law(
            self.mu_0 * float(self.pressure_factor(pressure)),
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
        return (
            *((Factor("pressure", "gamma", gamma, ", Eq. (7)"),) if self.pressure_dependent else ()),
            *((Factor("speed", "alpha", alpha, ", Eq. (8)"),) if self.velocity_dependent else ()),
            *((Factor("temperature", "beta", beta, ", Eq. (9)"),) if self.temperature_dependent else ()),
        )
