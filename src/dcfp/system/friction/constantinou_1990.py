"""Friction that depends on velocity: Constantinou, Mokha and Reinhorn (1990)."""

from dataclasses import replace
from typing import Annotated, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.kernels.law import Law, exponential_law
from dcfp.schema.declared import declared
from dcfp.schema.formulas import Expression, Formula, number
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import S_PER_MM
from dcfp.system.friction import li_2020
from dcfp.system.friction.law import FrictionLaw, coefficient_formula, coefficient_parameter


@declared
class Constantinou1990(FrictionLaw):
    r"""The exponential rise from a slow to a fast coefficient.

    .. math:: \mu = f_{max} - (f_{max} - f_{min})\,e^{-a |v|}

    Parameters
    ----------
    rate
        a [s/mm], for the speed of the slider on a plate.

    Notes
    -----
    The paper measured sheets of Teflon on steel; its coefficients are not those of a bearing of another
    material. The defaults therefore restate mu_0 and Eq. (8) of Li et al. (2020), whose rate
    is for the relative speed of two plates, twice that of the slider on one.
    """

    name: ClassVar[str] = "constantinou1990"
    words: ClassVar[str] = "Constantinou et al. (1990)"
    citation: ClassVar[str] = "constantinou_1990"
    reference_parameter: ClassVar[str] = "fast"
    speed_is_of_surface: ClassVar[bool] = True

    fast: Annotated[float, coefficient_parameter("coefficient of friction at high speed", r"f_{\max}")] = (
        li_2020.MU_0
    )
    slow: Annotated[float, coefficient_parameter("coefficient of friction at zero speed", r"f_{\min}")] = (
        0.45 * li_2020.MU_0
    )
    rate: Annotated[
        float,
        Parameter("rate of the velocity factor", S_PER_MM, 0.0, 10.0, symbol="a", above=True, step=0.005),
    ] = 2.0 * li_2020.ALPHA_RATE

    def check_relations(self) -> None:
        """Refuse a slow coefficient above the fast one."""
        if self.slow > self.fast:
            msg = f"The slow coefficient of friction, {self.slow!r}, must not exceed the fast one, {self.fast!r}."
            raise InputError(msg)

    def with_reference(self, coefficient: float) -> Self:
        """Return the law with another coefficient at high speed [-], and that at zero speed in proportion."""
        return replace(self, fast=coefficient, slow=self.slow / self.fast * coefficient)

    def velocity_factor(self, speed: ArrayLike) -> FloatArray:
        """Rise from f_min / f_max to one [-]."""
        drop = 1.0 - self.slow / self.fast
        return np.asarray(1.0 - drop * np.exp(-self.rate * np.abs(speed)))

    def at_pressure(self, pressure: float) -> Law:
        """Return the constants for the kernels."""
        del pressure
        return exponential_law(self.fast, 1.0 - self.slow / self.fast, self.rate, 0.0, 0.0, 1.0)

    @property
    def _expression(self) -> Expression:
        constants = {
            "fast": ('f_"max"', f"{self.fast:g}"),
            "slow": ('f_"min"', f"{self.slow:g}"),
            "rate": ("a", f"{self.rate:g}"),
        }
        return Expression("{fast} - ({fast} - {slow}) exp(-{rate}{dot}{x})", "v", constants)

    def equations(self) -> tuple[str, ...]:
        """Return the equation in symbols."""
        return (f"mu = {self._expression.symbols}",)

    def formulas(self, pressure: float, speed: float, temperature: float, source: str) -> tuple[Formula, ...]:
        """Return the coefficient at a state, with numbers."""
        coefficient = float(self.coefficient(pressure, speed, temperature))
        expression = self._expression
        numbers = expression.numbers(number(speed, 1))
        return (coefficient_formula(expression.symbols, numbers, coefficient, source),)
