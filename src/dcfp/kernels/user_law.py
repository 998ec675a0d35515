"""A friction law written in Python, compiled to a C function that the kernels call by its address.

A law must answer with a number: one that raises, or returns nan or infinity, answers nan, on which every kernel stops.
"""

import ctypes
import inspect
import math
import struct
import types
from collections.abc import Callable
from typing import Any

import numba as _numba
from numba.core.ccallback import CFunc
from numba.extending import is_jitted

from dcfp.kernels._jit import LawCache, cache_folder, caching_in, numba_config
from dcfp.kernels.law import LAW_ARGUMENTS

# numba makes much of itself at run time, out of sight of a type checker
numba: Any = _numba
_float = numba.float64
_ARGUMENTS = (numba.types.CPointer(_float), _float, _float, _float, _float)
#: Compiled laws by what identifies them. They stay: whoever holds an address must not have to hold the code too.
_compiled: dict[str, "CompiledLaw"] = {}


class CompiledLaw:
    """A law at an address, of a function with the `LAW_ARGUMENTS`."""

    def __init__(self, callback: Any, address: int) -> None:
        self._callback = callback
        self.address = address
        self._function = ctypes.CFUNCTYPE(ctypes.c_double, *LAW_ARGUMENTS)(address)

    def __call__(self, pressure: float, speed: float, temperature: float, cycling: float = 0.0) -> float:
        """Coefficient of friction [-] of a law without constants; nan where the function gives no number."""
        return self._function((ctypes.c_double * 6)(), pressure, speed, temperature, cycling)


def compile_law(
    function: Callable[..., float], identity: str | None, pressure: float = math.nan
) -> CompiledLaw:
    """Compile a law, or take it from the disk.

    Parameters
    ----------
    function
        Of pressure, speed and temperature, or of the array of the six constants, pressure, speed, temperature and cycling parameter; a
        plain function or one under ``numba.njit``.
    identity
        A digest of all that the function does; None where it cannot be told, so that the code must not be kept on the disk.
    pressure
        At which the code is quickest [N/mm2], for what depends on the pressure alone is a number in it; it holds at any other too. Of several that
        are asked for in a process the first counts.

    Raises
    ------
    numba.core.errors.NumbaError
        If it cannot be compiled.
    """
    key = identity and f"{identity}{'' if math.isnan(pressure) else ' at a pressure'}"
    law = _compiled.get(key or "")
    if law is None:
        name = identity and f"{identity}{struct.pack('>d', pressure).hex()}"
        law = _made(function, name, pressure)
        _compiled[key or f"{id(law)}"] = law
    return law


def _made(function: Callable[..., float], identity: str | None, pressure: float) -> CompiledLaw:
    has_constants = _arguments(function) == len(_ARGUMENTS)
    wrapper = _wrapper(_own_copy(function, identity), pressure, has_constants=has_constants)
    if numba_config.DISABLE_JIT:
        callback: Any = ctypes.CFUNCTYPE(ctypes.c_double, *LAW_ARGUMENTS)(wrapper)
        return CompiledLaw(callback, ctypes.cast(callback, ctypes.c_void_p).value or 0)
    callback = CFunc(wrapper, (_ARGUMENTS, _float), {}, {})
    if identity is not None:
        # symbols of code from the disk must not be taken for those of another law
        wrapper.__name__ = wrapper.__qualname__ = f"law_{identity}"
        if folder := cache_folder():
            with caching_in(f"{folder}/{identity}"):
                callback._cache = LawCache(wrapper)
    callback.compile()
    return CompiledLaw(callback, callback.address)


def _arguments(function: Callable[..., float]) -> int:
    return len(inspect.signature(getattr(function, "py_func", function)).parameters)


def _own_copy(function: Any, identity: str | None) -> Any:
    """Return the function under numba, as the user put it there or plainly; under a name of its own where it is to be kept."""
    if numba_config.DISABLE_JIT:
        return function
    options: dict[str, Any] = function.targetoptions if is_jitted(function) else {"nopython": True}
    plain = getattr(function, "py_func", function)
    if identity is None or not isinstance(plain, types.FunctionType):
        return function if is_jitted(function) else numba.njit(function)
    copy = types.FunctionType(
        plain.__code__, plain.__globals__, plain.__name__, plain.__defaults__, plain.__closure__
    )
    copy.__qualname__ = f"{plain.__qualname__}_{identity}"
    return numba.jit(**options)(copy)


def _wrapper(law: Any, usual: float, *, has_constants: bool) -> Any:
    """Return the function with a C signature that answers nan instead of an exception or an infinity."""

    def answer(constants: Any, pressure: float, speed: float, temperature: float, cycling: float) -> float:
        value = math.nan
        try:
            # the same call twice: in the first the compiler knows the pressure, and calculates what follows from it
            if pressure == usual:
                value = float(law(usual, speed, temperature))
            else:
                value = float(law(pressure, speed, temperature))
        except Exception:
            value = math.nan
        return value if math.isfinite(value) else math.nan

    def answer_with(
        constants: Any, pressure: float, speed: float, temperature: float, cycling: float
    ) -> float:
        value = math.nan
        try:
            value = float(law(numba.carray(constants, 6), pressure, speed, temperature, cycling))
        except Exception:
            value = math.nan
        return value if math.isfinite(value) else math.nan

    return answer_with if has_constants else answer
