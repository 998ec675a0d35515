"""A friction law that a user writes."""

import hashlib
import json
import math
import types
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, ClassVar, cast

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.kernels.law import Law, law_by_address
from dcfp.schema.identity import globals_of, identity_of
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
        hysteretic energy can fall there. It is compiled (half a second, and as long for its pressure) and kept on the disk where all that it uses can be told: numbers,
        functions of its own module, `math` and `numpy`.
    label
        What to call it in results.
    """

    function: Callable[[float, float, float], float]
    label: str = "user"
    _compiled: Any = field(init=False, repr=False, compare=False)
    _at_first_pressure: list[Any] = field(default_factory=list[Any], init=False, repr=False, compare=False)
    name: ClassVar[str] = "user"

    def __post_init__(self) -> None:
        from numba.core.errors import NumbaError

        from dcfp.kernels.user_law import compile_law

        if not callable(self.function):
            msg = "A user's friction law must be a function of pressure, speed and temperature."
            raise InputError(msg)
        try:
            compiled = compile_law(self.function, _digest(self.function))
        except (NumbaError, TypeError, ValueError) as error:
            msg = (
                "The user's friction law cannot be compiled as a function of three floats: "
                + str(error).strip().splitlines()[0]
            )
            raise InputError(msg) from error
        values = [compiled(60.0, speed, 20.0) for speed in (0.0, 100.0)]
        if not all(np.isfinite(values)) or min(values) <= 0.0:
            msg = f"The user's friction law must return positive numbers; at 60 N/mm2 and 20 degC it gives {values}."
            raise InputError(msg)
        object.__setattr__(self, "_compiled", compiled)

    def __reduce__(self) -> tuple[type["UserFriction"], tuple[Any, str]]:
        """Travel as a function: an address means nothing in another process."""
        return UserFriction, (self.function, self.label)

    @property
    def title(self) -> str:
        """Label of the law, or else the name of its function."""
        return repr(getattr(self.function, "__name__", self.label) if self.label == self.name else self.label)

    def coefficient(
        self, pressure: ArrayLike, speed: ArrayLike, temperature: ArrayLike, dose: ArrayLike = 0.0
    ) -> FloatArray:
        """Coefficient of friction [-], whatever the dose; the arguments are broadcast together."""
        del dose
        return np.asarray(
            np.vectorize(self._compiled, otypes=[np.float64])(pressure, np.abs(speed), temperature)
        )

    def at_pressure(self, pressure: float) -> Law:
        """Return the address of the function, compiled once more for the pressure [N/mm2] that is asked for first; it holds at any."""
        from dcfp.kernels.user_law import compile_law

        # under fast mathematics the numbers would depend on which pressure that is, in their last digit
        if getattr(self.function, "targetoptions", {}).get("fastmath"):
            return law_by_address(self._compiled.address)
        if not self._at_first_pressure:
            self._at_first_pressure.append(compile_law(self.function, _digest(self.function), pressure))
        return law_by_address(self._at_first_pressure[0].address)


def _digest(function: Any) -> str | None:
    """Return a digest of all that a function does, or None where it uses something whose content cannot be told."""
    plain = getattr(function, "py_func", function)
    if not isinstance(plain, types.FunctionType) or not _is_told(plain, plain.__module__, ()):
        return None
    options = {name: repr(value) for name, value in getattr(function, "targetoptions", {}).items()}
    whole = json.dumps([plain.__module__, plain.__qualname__, options, identity_of(plain)])
    return hashlib.sha256(whole.encode()).hexdigest()[:16]


def _is_told(value: Any, module: str, above: tuple[types.CodeType, ...]) -> bool:
    """Return whether a law's identity says all of what a value is: not so if it has code of another module in it."""
    if isinstance(value, (bool, int, float, str, type(None))) or value is math or value is np:
        return True
    if isinstance(value, (list, tuple)):
        return all(_is_told(one, module, above) for one in cast("list[Any]", value))
    if isinstance(value, (types.BuiltinFunctionType, np.ufunc, type)):
        return getattr(value, "__module__", "numpy") in ("math", "numpy", "builtins")
    plain = getattr(value, "py_func", value)
    if not isinstance(plain, types.FunctionType) or plain.__module__ != module:
        return False
    if plain.__code__ in above:
        return True
    # a helper made within another function may share its name with one that does something else
    if above and plain.__closure__:
        return False
    known = (*above, plain.__code__)
    used = [*globals_of(plain).values(), *(cell.cell_contents for cell in plain.__closure__ or ())]
    return all(_is_told(one, module, known) for one in (*used, *(plain.__defaults__ or ())))
