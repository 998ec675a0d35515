"""Numbers with units from a study file, in the units of the package."""

from functools import cache
from typing import TYPE_CHECKING, Any

from dcfp.errors import InputError

if TYPE_CHECKING:
    import pint

    from dcfp.study.factors import Factor


@cache
def _registry() -> "pint.UnitRegistry[Any]":
    import pint  # late: it takes a fifth of a second to import

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
    import pint

    registry: Any = _registry()
    try:
        given, own = registry.Unit(unit), registry.Unit("" if factor.unit == "1" else factor.unit)
        if not given.is_compatible_with(own):
            msg = (
                f"factor {factor.name!r} is in {factor.unit if factor.has_dimension else 'no unit'}, with which"
                f" {unit!r} is not compatible."
            )
            raise InputError(msg)
        zero = float(registry.Quantity(0.0, given).to(own).magnitude) if difference else 0.0
        if given == own:
            return values
        found = [float(registry.Quantity(value, given).to(own).magnitude) - zero for value in values]
        # 68 degF are 20 degC, not 20.000000000000057
        return [float(f"{value:.13g}") for value in found]
    except InputError:
        raise
    except (
        pint.errors.PintError,
        ValueError,
        TypeError,
        AttributeError,
        AssertionError,
        SyntaxError,
    ) as error:
        msg = f"factor {factor.name!r}: {unit!r} is not a unit; write for example {factor.unit!r}."
        raise InputError(msg) from error
