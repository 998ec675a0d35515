"""By what two objects are told apart: all that they hold, the same in every process."""

import types
from dataclasses import fields, is_dataclass
from typing import Any, cast

from dcfp.errors import InputError

_PLAIN = (bool, int, str, bytes, type(None))


def identity_of(value: Any) -> Any:
    """Return the content of an object as lists of words and numbers without loss, ready for JSON.

    Raises
    ------
    InputError
        If it holds something that cannot be told apart so, as a law of friction may that a user wrote.
    """
    if isinstance(value, float):
        return value.hex()
    if isinstance(value, _PLAIN):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return [identity_of(one) for one in cast("list[Any]", value)]
    if is_dataclass(value) and not isinstance(value, type):
        parts = {item.name: identity_of(getattr(value, item.name)) for item in fields(value) if item.init}
        return {"kind": type(value).__name__, **parts}
    if isinstance(value, types.ModuleType):
        return ["module", value.__name__]
    function = getattr(value, "py_func", value)
    if isinstance(function, types.FunctionType):
        return _of_function(function)
    if isinstance(value, (types.BuiltinFunctionType, type)) or hasattr(value, "__qualname__"):
        return ["built in", getattr(value, "__module__", ""), getattr(value, "__qualname__", repr(value))]
    if hasattr(value, "ufunc") or type(value).__name__ == "ufunc":
        return ["ufunc", value.__name__]
    msg = (
        f"a law of friction uses {type(value).__name__} {str(value)[:60]!r}, by which its results cannot be told from those of another law;"
        " let it use numbers and functions only, or keep the results in memory."
    )
    raise InputError(msg)


def globals_of(function: types.FunctionType) -> dict[str, Any]:
    """Return what a function and those within it may take from its module."""
    return {
        name: function.__globals__[name]
        for name in _names_in(function.__code__)
        if name in function.__globals__
    }


def _of_function(function: types.FunctionType, above: tuple[types.CodeType, ...] = ()) -> Any:
    """Return what a function does: its code, and the values that it uses from around it."""
    code = function.__code__
    if code in above:
        return "itself"
    closed = [cell.cell_contents for cell in function.__closure__ or ()]
    known = (*above, code)
    return [
        "function",
        _of_code(code),
        [[name, _within(value, known)] for name, value in globals_of(function).items()],
        [_within(value, known) for value in closed],
        [_within(value, known) for value in function.__defaults__ or ()],
    ]


def _within(value: Any, above: tuple[types.CodeType, ...]) -> Any:
    function = getattr(value, "py_func", value)
    return _of_function(function, above) if isinstance(function, types.FunctionType) else identity_of(value)


def _of_code(code: types.CodeType) -> Any:
    constants = [
        _of_code(one) if isinstance(one, types.CodeType) else identity_of(one)
        for one in code.co_consts
        if not isinstance(one, frozenset)
    ]
    return [code.co_code.hex(), list(code.co_names), list(code.co_varnames), constants]


def _names_in(code: types.CodeType) -> list[str]:
    """Return the names that a function and those within it may take from around it."""
    inner = [name for one in code.co_consts if isinstance(one, types.CodeType) for name in _names_in(one)]
    return sorted({*code.co_names, *inner})
