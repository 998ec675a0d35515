"""Numbers with units from a study file, in the units of the package."""

import re
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any

from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.study.factors import Factor

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
    zero = _converted(0.0, given, own) if difference else 0.0
    # 68 degF are 20 degC, not 20.000000000000057
    return [float(f"{_converted(value, given, own) - zero:.13g}") for value in values]


def _parsed(unit: str) -> Any:
    if not _UNIT.fullmatch(unit) or unit.count("**") + unit.count("^") > _MOST_POWERS or "**" in unit[:1]:
        raise ValueError(unit)
    if re.search(r"\*\*\s*[0-9.]+\s*\*\*", unit):  # a tower of powers takes for ever
        raise ValueError(unit)
    # N/mm2 is how tables write N/mm**2
    return _registry().Unit(re.sub(r"(?<=[A-Za-z])(?=[2-4]\b)", "**", unit))


def _converted(value: float, given: Any, own: Any) -> float:
    return float(_registry().Quantity(value, given).to(own).magnitude)
