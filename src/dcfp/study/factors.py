"""What a study can vary: the parameters of the ground motion, of the system and of the procedure."""

from collections.abc import Mapping
from dataclasses import replace
from typing import TypeAlias

from dcfp.errors import InputError
from dcfp.methods import METHODS
from dcfp.schema.parameters import PGV, Parameter, unknown
from dcfp.schema.units import M_PER_S2, NONE
from dcfp.system import System, system_parameters
from dcfp.system.system import OF_LAW as OF_LAW

Value: TypeAlias = float | str

#: Factors of the ground motion.
OF_MOTION = {
    "record": Parameter("ground motion", key="record", kind=str),
    "pgv": PGV,
    "pga": Parameter("peak ground acceleration", M_PER_S2, 1e-3, 200.0, symbol=r"\mathrm{PGA}", key="pga"),
    "scale": Parameter("factor on the ground motion", NONE, 1e-3, 1e3, key="scale"),
}
_BEARING = Parameter("bearing file", key="bearing", kind=str)
_PROCEDURE = Parameter("response history analysis, or a method of prediction", key="procedure", kind=str)
#: The procedure that is the analysis itself; the others are the methods of prediction.
ANALYSIS = "analysis"


def catalogue() -> dict[str, Parameter]:
    """Return every factor by its name, in the order in which they are applied: a whole bearing first, then the law, then what changes a law."""
    of_system = {
        key: replace(one, counts=(), repeat=1, optional=False)
        for key, one in system_parameters().items()
        if one.vary
    }
    procedure = replace(_PROCEDURE, choices=(ANALYSIS, *METHODS))
    return {**OF_MOTION, "bearing": _BEARING, **of_system, "procedure": procedure}


def factor(name: str) -> Parameter:
    """Return a factor by its name; ``friction.`` and a name is that parameter of the friction law.

    Raises
    ------
    InputError
        If there is none of that name.
    """
    known = catalogue()
    if name not in known:
        msg = unknown(name, known, "factor")
        raise InputError(msg)
    return known[name]


def is_of_system(name: str) -> bool:
    """Whether a factor changes the bearing, its friction or its heating."""
    return name not in OF_MOTION and name != _PROCEDURE.key


def changed(system: System, values: Mapping[str, Value], bearings: Mapping[str, System]) -> System:
    """Return a system with the values of factors put before its own; `bearings` are those that the factor ``bearing`` names.

    Raises
    ------
    InputError
        If there cannot be such a system.
    """
    if "bearing" in values:
        system = bearings[str(values["bearing"])]
    return system.changed({name: value for name, value in values.items() if name != "bearing"})
