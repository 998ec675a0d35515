"""What a study can vary: the parameters of the ground motion, of the system and of the procedure."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from typing import TypeAlias

from dcfp.errors import InputError
from dcfp.schema.parameters import Parameter, unknown
from dcfp.schema.units import M_PER_S, M_PER_S2, NONE
from dcfp.system import System, system_parameters
from dcfp.system.system import OF_LAW as OF_LAW

Value: TypeAlias = float | str


class Role(Enum):
    """What a factor is part of."""

    MOTION = "the ground motion"
    MODEL = "the bearing, its friction or its heating"
    PROCEDURE = "the procedure"


@dataclass(frozen=True)
class Factor:
    """Something that a study varies.

    Attributes
    ----------
    name
        As in a study file, and as the coordinate of the results.
    parameter
        Its words, unit and limits.
    role
        What it is part of.
    """

    name: str
    parameter: Parameter
    role: Role

    @property
    def is_number(self) -> bool:
        """Whether its values are numbers."""
        return self.parameter.is_number

    @property
    def limits(self) -> tuple[float, float]:
        """Smallest and largest value that a wrong unit would pass, in the package's unit."""
        return self.parameter.limits


_MOTION = {
    "record": Parameter("ground motion", kind=str),
    "pgv": Parameter("peak ground velocity", M_PER_S, 0.005, 20.0, symbol="PGV"),
    "pga": Parameter("peak ground acceleration", M_PER_S2, 1e-3, 200.0, symbol="PGA"),
    "scale": Parameter("factor on the ground motion", NONE, 1e-3, 1e3),
}
_BEARING = Parameter("bearing file", kind=str)
_PROCEDURE = Parameter("response history analysis, or a method of prediction", kind=str)


def catalogue() -> dict[str, Factor]:
    """Return every factor by its name, in the order in which they are applied: a whole bearing first, then the law, then what changes a law."""
    of_system = {key: one for key, one in system_parameters().items() if one.vary}
    return {
        **{name: Factor(name, one, Role.MOTION) for name, one in _MOTION.items()},
        "bearing": Factor("bearing", _BEARING, Role.MODEL),
        **{name: Factor(name, one, Role.MODEL) for name, one in of_system.items()},
        "procedure": Factor("procedure", _PROCEDURE, Role.PROCEDURE),
    }


def factor(name: str) -> Factor:
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
