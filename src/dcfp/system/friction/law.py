"""What a friction law is."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Annotated, Any, ClassVar, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.errors import AnalysisError, InputError
from dcfp.kernels.law import Law
from dcfp.schema.declared import Declared
from dcfp.schema.formulas import Expression, Formula, number
from dcfp.schema.parameters import Parameter
from dcfp.schema.registry import Registry
from dcfp.schema.units import FRACTION


@dataclass(frozen=True)
class Tested:
    """The tests that a law rests on.

    Attributes
    ----------
    pressure, speed
        Smallest and largest pressure on the slider [N/mm2] and relative speed of the plates [mm/s].
    source
        Where they are described.
    ambient
        Temperature of the bearing before the tests [degC]; None where it is not known.
    """

    pressure: tuple[float, float]
    speed: tuple[float, float]
    source: str
    ambient: float | None = None


@dataclass(frozen=True)
class Factor:
    """A factor of a law, as it is calculated and as a report works it out.

    Attributes
    ----------
    of
        What it depends on: pressure, speed, temperature, or dose.
    symbol, expression, equation
        In the mathematics of `dcfp.schema.formulas`, with its number in the source as it stands behind that.
    function
        The same as a function of an array [N/mm2, mm/s, degC or N/s].
    """

    of: str
    symbol: str
    expression: Expression
    function: Callable[[FloatArray], FloatArray]
    equation: str = ""


def coefficient_parameter(words: str, symbol: str = r"\mu_0") -> Parameter:
    """Declare a coefficient of friction."""
    return Parameter(words, FRACTION, 0.0, 0.9999, symbol=symbol, above=True, step=0.005)


#: Switches of laws whose factors can be left out.
OfPressure: TypeAlias = Annotated[bool, Parameter("whether the coefficient depends on pressure", vary=False)]
OfVelocity: TypeAlias = Annotated[bool, Parameter("whether the coefficient depends on velocity", vary=False)]
OfTemperature: TypeAlias = Annotated[
    bool, Parameter("whether the coefficient depends on temperature", vary=False)
]

#: Decimals of a factor or coefficient that is worked out.
DECIMALS = 4


#: Friction laws by name.
FRICTION_LAWS: "Registry[type[FrictionLaw]]" = Registry("friction law")


class FrictionLaw(Declared, ABC):
    """The coefficient of friction as a function of pressure, speed and temperature; a law with a ``name`` and ``words`` of its own registers itself.

    Attributes
    ----------
    name, words
        At every door and in results, and where there is room; no words for a law that cannot be asked for by its name.
    citation, equation_numbers, product_number
        Key of the source in the bibliography, and numbers in it of all equations and of the one with the factors, as they stand behind it.
    speed_is_of_surface
        Whether the law means the speed of the slider on one plate, and not the relative speed of the two plates.
    reference_parameter, reference_symbol
        Name of the parameter that scales the whole law, if there is one, and its symbol in the mathematics of `dcfp.schema.formulas`.
    tested, caution
        The tests that it rests on, where they are known, and a sentence that must stand beside every result.
    """

    noun = "the friction law"
    name: ClassVar[str]
    words: ClassVar[str] = ""
    citation: ClassVar[str] = ""
    speed_is_of_surface: ClassVar[bool] = False
    reference_parameter: ClassVar[str] = ""
    tested: ClassVar[Tested | None] = None
    caution: ClassVar[str] = ""
    reference_symbol: ClassVar[str] = "mu_0"
    equation_numbers: ClassVar[str] = ""
    product_number: ClassVar[str] = ""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        if cls.__dict__.get("words"):
            FRICTION_LAWS.add(cls.name, cls)

    @property
    def title(self) -> str:
        """By what a sentence calls the law."""
        return self.name

    def no_number(self, what: str, time: float | None = None) -> AnalysisError:
        """Return the error of an analysis that has met no number, perhaps at a `time` [s], as where a law raises or returns nan."""
        where = what if time is None else f"{what} at {time:.4g} s"
        msg = f"{where}: no finite number; look at the friction law {self.title}, which may raise there or return nan or infinity."
        return AnalysisError(msg)

    def no_progress(self, what: str, time: float) -> AnalysisError:
        """Return the error of an analysis whose steps have become too short at a `time` [s]."""
        msg = f"{what}: the analysis makes no progress at {time:.4g} s; look at the friction law {self.title}, or try a shorter step."
        return AnalysisError(msg)

    def tests(self) -> Tested | None:
        """Return the tests that the law rests on, where they are known."""
        return self.tested

    @property
    def reference(self) -> float:
        """Coefficient [-] where every factor is one."""
        return getattr(self, self.reference_parameter) if self.reference_parameter else 1.0

    def with_reference(self, coefficient: float) -> Self:
        """Return the same law with another reference coefficient [-].

        Raises
        ------
        InputError
            If the law has none, or it is out of range.
        """
        if not self.reference_parameter:
            msg = f"The friction law {self.name} has no reference coefficient that could be changed."
            raise InputError(msg)
        law: Any = self
        return replace(law, **{self.reference_parameter: coefficient})

    def pressure_factor(self, pressure: ArrayLike) -> FloatArray:
        """Effect of the pressure [N/mm2] on the coefficient [-]; one where there is none."""
        return self._factor("pressure", pressure)

    def velocity_factor(self, speed: ArrayLike) -> FloatArray:
        """Effect of the speed [mm/s] on the coefficient [-]; one where there is none."""
        return self._factor("speed", speed)

    def temperature_factor(self, temperature: ArrayLike) -> FloatArray:
        """Effect of the temperature of the contact [degC] on the coefficient [-]; one where there is none."""
        return self._factor("temperature", temperature)

    def dose_factor(self, dose: ArrayLike) -> FloatArray:
        """Effect of the dose of rubbing, the integral of p v2 over time [N/s], on the coefficient [-]; one where there is none."""
        return self._factor("dose", dose)

    def _factor(self, of: str, values: ArrayLike) -> FloatArray:
        functions = {one.of: one.function for one in self.factors()}
        return np.asarray(functions.get(of, np.ones_like)(np.asarray(values, dtype=np.float64)))

    @abstractmethod
    def at_pressure(self, pressure: float) -> Law:
        """Return the law at a constant pressure [N/mm2] in the form that the kernels take."""

    def coefficient(
        self, pressure: ArrayLike, speed: ArrayLike, temperature: ArrayLike, dose: ArrayLike = 0.0
    ) -> FloatArray:
        """Coefficient of friction [-].

        Parameters
        ----------
        pressure
            On the slider's area [N/mm2].
        speed
            Of the upper plate relative to the lower one, or of the slider on a plate
            where ``speed_is_of_surface`` [mm/s].
        temperature
            Of the contact [degC].
        dose
            Of rubbing so far [N/s], for laws that wear off. The arguments are broadcast together.
        """
        return np.asarray(
            self.reference
            * self.pressure_factor(pressure)
            * self.velocity_factor(np.abs(speed))
            * self.temperature_factor(temperature)
            * self.dose_factor(dose)
        )

    def factors(self) -> tuple[Factor, ...]:
        """Return the factors that are used; none for a law that is no product of factors."""
        return ()

    def equations(self) -> tuple[str, ...]:
        """Return the equations in symbols."""
        factors = self.factors()
        product = " ".join((self.reference_symbol, *(one.symbol for one in factors)))
        each = (f"{one.symbol} = {one.expression.symbols}" for one in factors)
        return (f"mu = {product}", *each) if factors else ()

    def formulas(self, pressure: float, speed: float, temperature: float, source: str) -> tuple[Formula, ...]:
        """Return the factors and the coefficient at a state, with numbers; none for a law that wears off or says no equations.

        Parameters
        ----------
        pressure, speed, temperature
            As for `coefficient` [N/mm2, mm/s, degC].
        source
            Of the law, as it stands beside a formula.
        """
        factors, state = self.factors(), {"pressure": pressure, "speed": speed, "temperature": temperature}
        if not factors or any(one.of not in state for one in factors):
            return ()
        values = [float(self._factor(one.of, state[one.of])) for one in factors]
        found: list[Formula] = []
        for one, value in zip(factors, values, strict=True):
            symbols, numbers = one.expression.symbols, one.expression.numbers(number(state[one.of], 1))
            words, where = f"Factor of {one.of}", source + one.equation
            found.append(Formula(words, f"{one.symbol} = {symbols}", numbers, value, DECIMALS, "", where))
        symbols = " ".join((self.reference_symbol, *(one.symbol for one in factors)))
        numbers = " times ".join((f"{self.reference:g}", *(number(value, DECIMALS) for value in values)))
        coefficient = float(self.coefficient(pressure, speed, temperature))
        return (*found, coefficient_formula(symbols, numbers, coefficient, source + self.product_number))

    def card_facts(self) -> dict[str, Any]:
        """Return the caution that must stand beside every result."""
        return {"caution": self.caution} if self.caution else {}


def coefficient_formula(symbols: str, numbers: str, coefficient: float, source: str) -> Formula:
    """Return the formula of a coefficient of friction [-]; `symbols` is its right side, empty where there is none."""
    left = f"mu = {symbols}" if symbols else "mu"
    return Formula("Coefficient of friction", left, numbers, coefficient, DECIMALS, "", source)
