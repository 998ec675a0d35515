"""Values and distributions of a factor as a study file writes them; numbers with units in the units of the package."""

import math
import re
from collections.abc import Mapping
from functools import cache
from importlib import import_module
from typing import Any, TypeGuard, cast

import numpy as np

from dcfp.errors import InputError
from dcfp.study.factors import Factor, Value
from dcfp.study.sampling import Choice, Distribution, Normal, Uniform

_GRID_KEYS = ("values", "from", "to", "count", "spacing", "unit")
#: Keys of each distribution besides its unit; the first two are what it needs.
_DISTRIBUTIONS = {
    "uniform": ("from", "to"),
    "log-uniform": ("from", "to"),
    "normal": ("mean", "standard_deviation"),
    "lognormal": ("median", "dispersion"),
}
_MOST_VALUES = 1_000_000
_LARGEST_WHOLE = 10**15


def values_from(one: Factor, given: Any) -> list[Value]:
    """Return the values of a factor in its unit: from a value, a list, or a table with ``values`` or ``from``, ``to`` and ``count``.

    Raises
    ------
    InputError
        If there is none, or it is not a number where it should be, or in the wrong unit.
    """
    if not isinstance(given, dict):
        return _converted(one, _listed(given), None)
    table = cast("dict[str, Any]", given)
    _refuse_unknown(one, table, _GRID_KEYS)
    unit = _unit(one, table)
    if "values" in table:
        if len(table) > (2 if "unit" in table else 1):
            msg = f"factor {one.name!r} has values, so that it takes nothing else but a unit."
            raise InputError(msg)
        return _converted(one, _listed(table["values"]), unit)
    return _range(one, table, unit)


def _listed(given: Any) -> list[Any]:
    return cast("list[Any]", given) if isinstance(given, list) else [given]


def distribution_from(one: Factor, given: Any) -> Distribution:
    """Return the distribution of a sampled factor in its unit: a list or ``values`` are a choice, ``from`` and ``to`` a range.

    Raises
    ------
    InputError
        As for `values_from`, and if the distribution is not known.
    """
    if not isinstance(given, dict) or "values" in given:
        return Choice(tuple(values_from(one, given)))
    table = cast("dict[str, Any]", given)
    name = table.get("distribution", "uniform")
    if not isinstance(name, str) or name not in _DISTRIBUTIONS:
        msg = (
            f"factor {one.name!r}: the distribution must be one of {', '.join(_DISTRIBUTIONS)}, not {name!r}."
        )
        raise InputError(msg)
    needed = _DISTRIBUTIONS[name]
    _refuse_unknown(one, table, (*needed, "distribution", "unit"))
    first, second = (_number(one, table, key) for key in needed)
    unit = _unit(one, table)
    try:
        if name in ("uniform", "log-uniform"):
            least, most = convert([first, second], unit, one)
            return Uniform(least, most, name == "log-uniform")
        (centre,) = convert([first], unit, one)
        if name == "lognormal":
            return Normal(centre, second, logarithmic=True)
        (spread,) = convert([second], unit, one, difference=True)
        return Normal(centre, spread)
    except InputError as error:
        text = str(error)
        msg = text if text.startswith("factor") else f"factor {one.name!r}: {text}"
        raise InputError(msg) from error


def _range(one: Factor, table: Mapping[str, Any], unit: str | None) -> list[Value]:
    first, last = (_number(one, table, key) for key in ("from", "to"))
    count = table.get("count")
    if type(count) is not int or not 1 <= count <= _MOST_VALUES:
        msg = f"factor {one.name!r} needs a count from 1 to {_MOST_VALUES}, not {count!r}."
        raise InputError(msg)
    spacing = table.get("spacing", "linear")
    if spacing not in ("linear", "log"):
        msg = f"factor {one.name!r}: the spacing is linear or log, not {spacing!r}."
        raise InputError(msg)
    if spacing == "log" and not (first > 0.0 and last > 0.0):
        msg = f"factor {one.name!r}: a logarithmic range must be of positive numbers."
        raise InputError(msg)
    places = np.linspace(first, last, count) if spacing == "linear" else np.geomspace(first, last, count)
    # 0.1 to 2.0 in 20 steps means 0.3, not 0.30000000000000004
    return _converted(one, [float(f"{place:.12g}") for place in places.tolist()], unit)


def _converted(one: Factor, values: list[Any], unit: str | None) -> list[Value]:
    if not values:
        msg = f"factor {one.name!r} has no value; give it at least one."
        raise InputError(msg)
    if not one.is_number:
        if unit is not None:
            msg = f"factor {one.name!r} takes words, which have no unit."
            raise InputError(msg)
        return values
    for value in values:
        if not _is_number(value):
            msg = f"factor {one.name!r} takes numbers, not {repr(value)[:60]}."
            raise InputError(msg)
    return [*convert([float(value) for value in values], unit, one)]


def _number(one: Factor, table: Mapping[str, Any], key: str) -> float:
    value = table.get(key)
    if not _is_number(value):
        what = (
            f"needs a number for {key!r}"
            if value is None
            else f"needs a number for {key!r}, not {str(value)[:60]!r}"
        )
        msg = f"factor {one.name!r} {what}."
        raise InputError(msg)
    if not one.is_number:
        msg = f"factor {one.name!r} takes words; give it a list of them."
        raise InputError(msg)
    return float(value)


def _is_number(value: Any) -> TypeGuard[float]:
    """Whether a value is a number that can be reckoned with: TOML has whole numbers of any length."""
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return False
    return math.isfinite(value) if isinstance(value, float) else abs(value) < _LARGEST_WHOLE


def _unit(one: Factor, table: Mapping[str, Any]) -> str | None:
    unit = table.get("unit")
    if unit is not None and not isinstance(unit, str):
        msg = f"factor {one.name!r}: the unit must be words in quotes, not {unit!r}."
        raise InputError(msg)
    return unit


def _refuse_unknown(one: Factor, table: Mapping[str, Any], known: tuple[str, ...]) -> None:
    for key in table:
        if key not in known:
            msg = f"factor {one.name!r} has no {key!r}; it has {', '.join(known)}."
            raise InputError(msg)


# Numbers with units from a study file, in the units of the package.


#: What a unit is written with, and how many powers it may have.
_UNIT = re.compile(r"[A-Za-z0-9_*/^. ()°µ²³%-]{0,60}")
_MOST_POWERS = 4


@cache
def _registry() -> Any:
    pint: Any = import_module("pint")  # late: it takes a fifth of a second to import
    return pint.UnitRegistry(autoconvert_offset_to_baseunit=True)


def convert(
    values: list[float], unit: str | None, factor: "Factor", *, difference: bool = False
) -> list[float]:
    """Return numbers in the unit of a factor.

    Parameters
    ----------
    values
        The numbers.
    unit
        Their unit; None where none was given.
    factor
        What they are of.
    difference
        Whether they are differences, such as a standard deviation: 5 degC then are 5 K.

    Raises
    ------
    InputError
        If the unit is missing, not known, or of something else.
    """
    if unit is None:
        if factor.has_dimension:
            msg = f"factor {factor.name!r} needs a unit, for example unit = {factor.unit!r}."
            raise InputError(msg)
        return values
    try:
        given, own = _parsed(unit), _parsed("" if factor.unit == "1" else factor.unit)
        same_kind = given.is_compatible_with(own) and "bel" not in str(given)
    except Exception as error:  # pint lets through whatever the parser below it raises
        msg = f"factor {factor.name!r}: {unit!r} is not a unit; write for example {factor.unit!r}."
        raise InputError(msg) from error
    if not same_kind:
        hint = "; the acceleration of gravity is 'g_0', and 'g' the gram" if unit == "g" else ""
        msg = (
            f"factor {factor.name!r} is in {factor.unit if factor.has_dimension else 'no unit'}, with which"
            f" {unit!r} is not compatible{hint}."
        )
        raise InputError(msg)
    if given == own:
        return values
    zero = _in_own_unit(0.0, given, own) if difference else 0.0
    # 68 degF are 20 degC, not 20.000000000000057
    return [float(f"{_in_own_unit(value, given, own) - zero:.13g}") for value in values]


def _parsed(unit: str) -> Any:
    if not _UNIT.fullmatch(unit) or unit.count("**") + unit.count("^") > _MOST_POWERS or "**" in unit[:1]:
        raise ValueError(unit)
    if re.search(r"\*\*\s*[0-9.]+\s*\*\*", unit):  # a tower of powers takes for ever
        raise ValueError(unit)
    # N/mm2 is how tables write N/mm**2
    return _registry().Unit(re.sub(r"(?<=[A-Za-z])(?=[2-4]\b)", "**", unit))


def _in_own_unit(value: float, given: Any, own: Any) -> float:
    return float(_registry().Quantity(value, given).to(own).magnitude)
