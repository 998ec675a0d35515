"""The parameters that can be fitted: their words, units and limits."""

import difflib
import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from dcfp.errors import InputError
from dcfp.system import Heating
from dcfp.system.friction import FittedFriction


@dataclass(frozen=True)
class Parameter:
    """A constant of the law, or of the heat.

    Attributes
    ----------
    name
        On the command line, and in `FittedFriction` or the heating model.
    symbol
        In mathematics.
    unit
        Empty for a number.
    words
        What it is.
    least, most
        Limits of the fit.
    worth
        Half of the longest 95 % interval at which the data are said to determine it, in its unit; where it `is_scale`, over the estimate.
    is_scale
        Positive by its nature, so that its interval is symmetric in its logarithm.
    """

    name: str
    symbol: str
    unit: str
    words: str
    least: float
    most: float
    worth: float
    is_scale: bool = False

    @property
    def label(self) -> str:
        """Name with the unit."""
        return f"{self.name} [{self.unit or '-'}]"


PARAMETERS = (
    Parameter("mu_0", r"\mu_0", "", "coefficient at the reference pressure and temperature and at high speed", 1e-4, 0.99, 0.25, True),
    Parameter("pressure_exponent", "n", "", "exponent of the pressure", 0.0, 5.0, 0.15),
    Parameter("pressure_floor", "c", "", "part of the coefficient that no pressure takes away", 0.0, 0.999, 0.5),
    Parameter("speed_drop", "a", "", "part of the coefficient that is missing at zero speed", 0.0, 0.999, 0.25),
    Parameter("speed_rate", "b", "s/mm", "rate at which the coefficient rises with speed", 1e-5, 10.0, 0.5, True),
    Parameter("temperature_rate", "r", "1/degC", "rate at which the coefficient falls with temperature", 0.0, 0.2, 0.007),
    Parameter("conductivity", "k", "N/(s degC)", "thermal conductivity of the plates", 0.1, 1e4, 0.5, True),
)  # fmt: skip

#: What can only be fixed.
REFERENCES = ("reference_pressure", "reference_temperature", "diffusivity")


def parameter(name: str) -> Parameter:
    """Return a parameter by its name.

    Raises
    ------
    InputError
        If there is none of that name, or it is one that can only be fixed.
    """
    for one in PARAMETERS:
        if one.name == name:
            return one
    if name == "diffusivity":
        msg = (
            "The diffusivity cannot be fitted: in a half-space only sqrt(diffusivity) / conductivity acts on the temperature of the contact;"
            " fit the conductivity, or fix both."
        )
        raise InputError(msg)
    if name in REFERENCES:
        msg = f"The {name} cannot be fitted, it is where mu_0 stands; choose it with --fix {name}=VALUE."
        raise InputError(msg)
    names = [one.name for one in PARAMETERS]
    near = difflib.get_close_matches(name, names, n=1)
    hint = f" (did you mean {near[0]!r}?)" if near else ""
    msg = f"There is no parameter {name!r}{hint}; the choices are {', '.join(names)}."
    raise InputError(msg)


@dataclass(frozen=True)
class Constants:
    """A law and a heating model, whose constants are starting values, fixed or fitted."""

    law: FittedFriction
    heating: Heating

    def value(self, name: str) -> float:
        """Return a constant by its name."""
        return float(getattr(self.heating if name in ("conductivity", "diffusivity") else self.law, name))

    def changed(self, values: Mapping[str, float]) -> "Constants":
        """Return the constants with some of them changed.

        Raises
        ------
        InputError
            If there is none of a name, or a value is out of range.
        """
        law, heating = self.law, self.heating
        for name, value in values.items():
            if name not in REFERENCES:
                one = parameter(name)
                if not (math.isfinite(value) and one.least <= value <= one.most):
                    msg = f"The {name} must lie between {one.least:g} and {one.most:g}{f' {one.unit}' if one.unit else ''}, not {value!r}."
                    raise InputError(msg)
            if name in ("conductivity", "diffusivity"):
                heating = replace(heating, **{name: value})
            else:
                law = replace(law, **{name: value})
        return Constants(law, heating)


def in_order(names: Iterable[str]) -> tuple[str, ...]:
    """Return the names of parameters in the order in which they are told, each once."""
    wanted = set(names)
    return tuple(one.name for one in PARAMETERS if one.name in wanted)
