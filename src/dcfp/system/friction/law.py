"""What a friction law is; a constant coefficient (Coulomb), a law that a user writes, and the fall with temperature that several laws share."""

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.kernels.friction import ExponentialLaw, Law
from dcfp.schema.notebook import fields_card
from dcfp.system.checks import fraction


@dataclass(frozen=True)
class Tested:
    """The tests that a law rests on.

    Attributes
    ----------
    pressure
        Smallest and largest on the slider's area [N/mm2].
    speed
        Smallest and largest relative speed of the plates [mm/s].
    source
        Where they are described.
    ambient
        Temperature of the bearing before the tests [degC]; None where it is not known.
    """

    pressure: tuple[float, float]
    speed: tuple[float, float]
    source: str
    ambient: float | None = None


class FrictionLaw(ABC):
    """The coefficient of friction as a function of pressure, speed and temperature.

    Attributes
    ----------
    name
        Name on the command line and in results.
    citation
        Key of the source in the bibliography; empty for a law that needs none.
    speed_is_of_surface
        True where the law means the speed of the slider on one plate, False where it means the
        relative speed of the two plates.
    reference_parameter
        Name of the parameter that scales the whole law; empty for a law that has none.
    tested
        The tests that it rests on, where they are known.
    caution
        A sentence that must stand beside every result; empty for a law that needs none.
    """

    name: ClassVar[str]
    citation: ClassVar[str] = ""
    speed_is_of_surface: ClassVar[bool] = False
    reference_parameter: ClassVar[str] = ""
    tested: ClassVar[Tested | None] = None
    caution: ClassVar[str] = ""

    def tests(self) -> Tested | None:
        """Return the tests that the law rests on, where they are known."""
        return self.tested

    @property
    def reference(self) -> float:
        """Coefficient [-] where every factor is one."""
        return 1.0

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
        """Effect of the pressure [N/mm2] on the coefficient [-]; one unless a law says otherwise."""
        return np.ones_like(pressure, dtype=np.float64)

    def velocity_factor(self, speed: ArrayLike) -> FloatArray:
        """Effect of the speed [mm/s] on the coefficient [-]; one unless a law says otherwise."""
        return np.ones_like(speed, dtype=np.float64)

    def temperature_factor(self, temperature: ArrayLike) -> FloatArray:
        """Effect of the temperature of the contact [degC] on the coefficient [-]; one unless a law says otherwise."""
        return np.ones_like(temperature, dtype=np.float64)

    def dose_factor(self, dose: ArrayLike) -> FloatArray:
        """Effect of the dose of rubbing, the integral of p v2 over time [N/s], on the coefficient [-]; one unless a law says otherwise."""
        return np.ones_like(dose, dtype=np.float64)

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

    def _repr_html_(self) -> str:
        return fields_card(self, f"Friction law {self.name}", remarks=(self.caution,) if self.caution else ())


#: Nominal coefficient mu_n [-], Li et al. (2020), section 4.4: mean of the tests at zero displacement
#: in the second cycle of dependency test T01.
NOMINAL_COEFFICIENT = 0.043


@dataclass(frozen=True)
class ConstantFriction(FrictionLaw):
    """The same coefficient at every pressure, speed and temperature.

    Parameters
    ----------
    mu
        Coefficient of friction [-]; by default the nominal one of Li et al. (2020), section 4.4.
    """

    mu: float = NOMINAL_COEFFICIENT
    name: ClassVar[str] = "constant"
    citation: ClassVar[str] = "li_2020"
    reference_parameter: ClassVar[str] = "mu"

    def __post_init__(self) -> None:
        fraction(self.mu, "coefficient of friction")

    @property
    def reference(self) -> float:
        """Coefficient of friction [-]."""
        return self.mu

    def at_pressure(self, pressure: float) -> ExponentialLaw:
        """Return the constants for the kernels."""
        del pressure
        return ExponentialLaw(self.mu, 0.0, 0.0, 1.0, 0.0, 0.0)


@dataclass(frozen=True)
class UserFriction(FrictionLaw):
    """Any function mu(pressure, speed, temperature) of three floats that numba can compile.

    Parameters
    ----------
    function
        Of pressure [N/mm2], relative speed of the plates, zero or more [mm/s], and temperature of the
        contact [degC]; returns the coefficient of friction [-]. Either a plain function or one that
        is already under ``numba.njit``. It should be continuous: where it jumps, the yield force jumps under spring (b), and the
        hysteretic energy can fall there. The kernels are compiled once more for it (several seconds, once per process).
    label
        What to call it in results.
    """

    function: Callable[[float, float, float], float]
    label: str = "user"
    _compiled: Any = field(init=False, repr=False, compare=False)
    name: ClassVar[str] = "user"

    def __post_init__(self) -> None:
        import numba
        from numba.core.errors import NumbaError
        from numba.extending import is_jitted

        if not callable(self.function):
            msg = "A user's friction law must be a function of pressure, speed and temperature."
            raise InputError(msg)
        compiled = self.function
        if not is_jitted(compiled):
            compiled = numba.njit(compiled)
        try:
            values = [float(compiled(60.0, speed, 20.0)) for speed in (0.0, 100.0)]
        except (NumbaError, TypeError, ValueError, ZeroDivisionError) as error:
            msg = (
                "The user's friction law cannot be compiled as a function of three floats: "
                + str(error).strip().splitlines()[0]
            )
            raise InputError(msg) from error
        if not all(np.isfinite(values)) or min(values) <= 0.0:
            msg = f"The user's friction law must return positive numbers; at 60 N/mm2 and 20 degC it gives {values}."
            raise InputError(msg)
        object.__setattr__(self, "_compiled", compiled)

    def coefficient(
        self, pressure: ArrayLike, speed: ArrayLike, temperature: ArrayLike, dose: ArrayLike = 0.0
    ) -> FloatArray:
        """Coefficient of friction [-], whatever the dose; the arguments are broadcast together."""
        del dose
        return np.asarray(
            np.vectorize(self._compiled, otypes=[np.float64])(pressure, np.abs(speed), temperature)
        )

    def at_pressure(self, pressure: float) -> Callable[[float, float, float], float]:
        """Return the compiled function."""
        del pressure
        return self._compiled


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
        return -self.power * math.log(0.7)

    def factor(self, temperature: ArrayLike) -> FloatArray:
        """Factor k_T [-] at a temperature of the contact [degC]."""
        exponent = self.power * np.asarray(temperature, dtype=np.float64)
        return np.asarray(self.scale * np.power(0.7, exponent) + self.floor)
