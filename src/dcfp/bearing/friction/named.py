"""Friction laws by name, for the command line and for bearing files."""

import dataclasses
import difflib
from collections.abc import Mapping
from typing import Any

from dcfp.bearing.friction.constant import ConstantFriction
from dcfp.bearing.friction.constantinou_1990 import Constantinou1990
from dcfp.bearing.friction.kim_constantinou_2023 import (
    KimConstantinou2023Third,
    KimConstantinou2023TwoThirds,
)
from dcfp.bearing.friction.kumar_2015 import Kumar2015
from dcfp.bearing.friction.law import FrictionLaw
from dcfp.bearing.friction.li_2020 import Li2020
from dcfp.errors import InputError

_LAWS: dict[str, type[FrictionLaw]] = {
    law.name: law
    for law in (
        Li2020,
        ConstantFriction,
        Constantinou1990,
        Kumar2015,
        KimConstantinou2023Third,
        KimConstantinou2023TwoThirds,
    )
}


def friction_names() -> tuple[str, ...]:
    """Return the names of the built-in laws."""
    return tuple(_LAWS)


def friction_law(name: str, parameters: Mapping[str, Any] | None = None) -> FrictionLaw:
    """Return a built-in law, with some of its parameters changed.

    Raises
    ------
    InputError
        If there is no law of that name, or it has no such parameter, or a value is out of range.
    """
    key = name.strip().lower()
    if key not in _LAWS:
        near = difflib.get_close_matches(key, _LAWS, n=1)
        hint = f" (did you mean {near[0]!r}?)" if near else ""
        msg = f"There is no friction law {name!r}{hint}; the laws are {', '.join(_LAWS)}."
        raise InputError(msg)
    law = _LAWS[key]
    allowed = [item.name for item in dataclasses.fields(law) if item.init]  # type: ignore[arg-type]
    for given in parameters or {}:
        if given not in allowed:
            msg = f"The friction law {key!r} has no parameter {given!r}; it has {', '.join(allowed)}."
            raise InputError(msg)
    return law(**(parameters or {}))
