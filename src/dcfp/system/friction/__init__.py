"""Friction laws, one module for each paper; by name for the command line and for bearing files."""

from collections.abc import Mapping
from typing import Any

from dcfp.system.checks import make_named
from dcfp.system.friction.constantinou_1990 import Constantinou1990 as Constantinou1990
from dcfp.system.friction.fitted import FittedFriction as FittedFriction
from dcfp.system.friction.kim_constantinou_2023 import KimConstantinou2023Third as KimConstantinou2023Third
from dcfp.system.friction.kim_constantinou_2023 import (
    KimConstantinou2023TwoThirds as KimConstantinou2023TwoThirds,
)
from dcfp.system.friction.kumar_2015 import Kumar2015 as Kumar2015
from dcfp.system.friction.law import ConstantFriction as ConstantFriction
from dcfp.system.friction.law import FrictionLaw as FrictionLaw
from dcfp.system.friction.law import UserFriction as UserFriction
from dcfp.system.friction.li_2020 import Li2020 as Li2020
from dcfp.system.friction.lomiento_2013 import Lomiento2013 as Lomiento2013

_LAWS: dict[str, type[FrictionLaw]] = {
    law.name: law
    for law in (
        Li2020,
        ConstantFriction,
        Constantinou1990,
        Kumar2015,
        KimConstantinou2023Third,
        KimConstantinou2023TwoThirds,
        Lomiento2013,
        FittedFriction,
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
    return make_named("friction law", _LAWS, name, parameters or {})
