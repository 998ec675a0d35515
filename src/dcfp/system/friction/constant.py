"""A constant coefficient of friction (Coulomb)."""

from typing import Annotated, ClassVar

from dcfp.kernels.law import Law, exponential_law
from dcfp.schema.declared import declared
from dcfp.schema.formulas import Formula
from dcfp.system.friction.law import FrictionLaw, coefficient_formula, coefficient_parameter

#: Nominal coefficient mu_n [-], Li et al. (2020), section 4.4: mean of the tests at zero displacement
#: in the second cycle of dependency test T01.
NOMINAL_COEFFICIENT = 0.043


@declared
class ConstantFriction(FrictionLaw):
    """The same coefficient at every pressure, speed and temperature.

    Parameters
    ----------
    mu
        Coefficient of friction [-]; by default the nominal one of Li et al. (2020), section 4.4.
    """

    name: ClassVar[str] = "constant"
    words: ClassVar[str] = "constant"
    citation: ClassVar[str] = "li_2020"
    reference_parameter: ClassVar[str] = "mu"

    mu: Annotated[float, coefficient_parameter("coefficient of friction", r"\mu")] = NOMINAL_COEFFICIENT

    def at_pressure(self, pressure: float) -> Law:
        """Return the constants for the kernels."""
        del pressure
        return exponential_law(self.mu, 0.0, 0.0, 1.0, 0.0, 0.0)

    def equations(self) -> tuple[str, ...]:
        """Return the equation."""
        return ('mu = "constant"',)

    def formulas(self, pressure: float, speed: float, temperature: float, source: str) -> tuple[Formula, ...]:
        """Return the coefficient, whatever the state."""
        del pressure, speed, temperature
        return (coefficient_formula("", "", self.mu, source),)
