"""A friction law that a user writes."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.system.friction.law import FrictionLaw


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
