"""Checks of what a user gives, numbers and names, with the sentence that says what would be right."""

import dataclasses
import difflib
import math
from collections.abc import Mapping
from typing import Any, TypeVar

from dcfp.errors import InputError


def positive(value: float, name: str, unit: str) -> float:
    """Return `value` as a float if it is a positive number; `name` and `unit` are for the sentence."""
    if not _is_number(value) or not (math.isfinite(value) and value > 0.0):
        msg = f"The {name} must be a positive number of {unit}, not {value!r}."
        raise InputError(msg)
    return float(value)


def fraction(value: float, name: str) -> float:
    """Return `value` as a float if it lies above 0 and below 1."""
    if not _is_number(value) or not 0.0 < value < 1.0:
        msg = f"The {name} must lie between 0 and 1, not {value!r}."
        raise InputError(msg)
    return float(value)


def finite(value: float, name: str, unit: str) -> float:
    """Return `value` as a float if it is a finite number."""
    if not _is_number(value) or not math.isfinite(value):
        msg = f"The {name} must be a number of {unit}, not {value!r}."
        raise InputError(msg)
    return float(value)


def yes_or_no(value: object, name: str) -> None:
    """Refuse a `value` that is neither True nor False."""
    if not isinstance(value, bool):
        msg = f"The switch {name} must be true or false, not {value!r}."
        raise InputError(msg)


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


T = TypeVar("T")


def make_named(kind: str, models: Mapping[str, type[T]], name: str, parameters: Mapping[str, Any]) -> T:
    """Return the model of that name with those parameters; `kind` is what to call it in a sentence.

    Raises
    ------
    InputError
        If there is no model of that name, or it has no such parameter, or a value is out of range.
    """
    key = name.strip().lower()
    if key not in models:
        near = difflib.get_close_matches(key, models, n=1)
        hint = f" (did you mean {near[0]!r}?)" if near else ""
        msg = f"There is no {kind} {name!r}{hint}; the choices are {', '.join(models)}."
        raise InputError(msg)
    model: Any = models[key]
    allowed = [item.name for item in dataclasses.fields(model) if item.init]
    for given in parameters:
        if given not in allowed:
            msg = f"The {kind} {key!r} has no parameter {given!r}; it has {', '.join(allowed)}."
            raise InputError(msg)
    return model(**parameters)
