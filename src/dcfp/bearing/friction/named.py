"""Friction laws by name, for the command line and for bearing files."""

import dataclasses
import difflib
from collections.abc import Mapping
from typing import Any

from dcfp.bearing.friction.constant import ConstantFriction
from dcfp.bearing.friction.constantinou_1990 import Constantinou1990
from dcfp.bearing.friction.kumar_2015 import Kumar2015
from dcfp.bearing.friction.law import FrictionLaw
from dcfp.bearing.friction.li_2020 import Li2020
from dcfp.errors import InputError

_LAWS: dict[str, tuple[type[FrictionLaw], dict[str, Any]]] = {
    "li2020": (Li2020, {}),
    "constant": (ConstantFriction, {}),
    "constantinou1990": (Constantinou1990, {}),
    "kumar2015": (Kumar2015, {}),
    "kim2023-third": (Kumar2015, {"temperature_law": "one third"}),
    "kim2023-two-thirds": (Kumar2015, {"temperature_law": "two thirds"}),
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
    law, preset = _LAWS[key]
    allowed = [item.name for item in dataclasses.fields(law) if item.init]  # type: ignore[arg-type]
    for given in parameters or {}:
        if given not in allowed:
            msg = f"The friction law {key!r} has no parameter {given!r}; it has {', '.join(allowed)}."
            raise InputError(msg)
    return law(**{**preset, **(parameters or {})})
