"""Checks of numbers that a user gives, with the sentence that says what would be right."""

import math

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


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)
