"""Values and distributions of a factor as a study file writes them; numbers with units in the units of the package."""

import math
from collections.abc import Mapping
from typing import Any, TypeGuard, cast

import numpy as np

from dcfp.errors import InputError
from dcfp.schema.units import convert
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
            least, most = (_inner(one, value, unit) for value in (first, second))
            return Uniform(least, most, name == "log-uniform")
        centre = _inner(one, first, unit)
        if name == "lognormal":
            return Normal(centre, second, logarithmic=True)
        return Normal(centre, _inner(one, second, unit, difference=True))
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
    return [_inner(one, float(value), unit) for value in values]


def _inner(one: Factor, value: float, unit: str | None, *, difference: bool = False) -> float:
    """Return a number of a factor in the package's unit; without a unit it is in the declared one."""
    wanted = one.parameter.unit
    if unit is not None:
        value = convert(value, unit, wanted, f"factor {one.name!r}", difference=difference)
    # 0.07 m/s are 70 mm/s, not 70.00000000000001
    return float(f"{wanted.inner(value):.13g}")


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
