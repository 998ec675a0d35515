"""The parameters that can be fitted, with their words, units and limits; all samples of sliding of several tests, one after another, and the law at them."""

import difflib
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.identification.friction_history import FrictionHistory
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
        msg = f"The {name} cannot be fitted, it is where mu_0 stands; choose it (fix {name}=VALUE)."
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


#: Blocks that the samples are cut into, at least; a stroke is one where there are enough of them.
_FEWEST_BLOCKS = 30


@dataclass(frozen=True, eq=False)
class Samples:
    """Samples of sliding; every array has the shape (n,).

    Attributes
    ----------
    coefficient
        Measured [-].
    pressure, speed
        [N/mm2, mm/s].
    rise
        Of the temperature above that at the start, with the conductivity that it was reckoned with [degC].
    test, block
        Number of the test, and of the block of samples within which errors may depend on each other.
    """

    coefficient: FloatArray
    pressure: FloatArray
    speed: FloatArray
    rise: FloatArray
    test: NDArray[np.int64]
    block: NDArray[np.int64]

    @classmethod
    def of(cls, histories: Sequence[FrictionHistory], ambient: float) -> "Samples":
        """Put the histories together, whose plates started at a temperature [degC]."""
        tests = np.concatenate([np.full(np.count_nonzero(h.used), i) for i, h in enumerate(histories)])
        return cls(
            coefficient=np.concatenate([h.coefficient[h.used] for h in histories]),
            pressure=np.concatenate([h.pressure[h.used] for h in histories]),
            speed=np.concatenate([h.speed[h.used] for h in histories]),
            rise=np.concatenate([h.temperature[h.used] - ambient for h in histories]),
            test=tests,
            block=_blocks([h.stroke[h.used] for h in histories]),
        )


def _blocks(
    strokes: Sequence[NDArray[np.int64]],
) -> NDArray[np.int64]:
    """Return the number of the stroke of each sample of all tests; where strokes are few, each is cut in equal parts."""
    found = sum(np.unique(own).size for own in strokes)
    parts = -(-_FEWEST_BLOCKS // found)
    numbers: list[NDArray[np.int64]] = []
    count = 0
    for own in strokes:
        number = np.empty(own.size, dtype=np.int64)
        for stroke in np.unique(own):
            place = np.flatnonzero(own == stroke)
            number[place] = count + np.arange(place.size) * parts // place.size
            count += parts
        numbers.append(number)
    return np.unique(np.concatenate(numbers), return_inverse=True)[1]


class LawAtSamples:
    """The fitted law at the samples, and its derivatives by the parameters.

    Parameters
    ----------
    samples
        Where.
    constants
        What is fixed, and the conductivity and the ambient temperature with which the rises were reckoned.
    """

    def __init__(self, samples: Samples, constants: Constants) -> None:
        self.speed = samples.speed
        self.rise = samples.rise
        self.pressure = np.log(samples.pressure / constants.law.reference_pressure)
        self.start = constants.heating.ambient - constants.law.reference_temperature
        self.conductivity = constants.heating.conductivity

    def __call__(self, values: Mapping[str, float]) -> FloatArray:
        """Return the coefficient [-]."""
        return self.derivatives(values, ())[0]

    def derivatives(self, values: Mapping[str, float], names: Sequence[str]) -> tuple[FloatArray, FloatArray]:
        """Return the coefficient [-], and its derivatives by the parameters, shape (n, parameters)."""
        floor, rate = values["pressure_floor"], values["temperature_rate"]
        power = np.exp(-values["pressure_exponent"] * self.pressure)
        gamma = (1.0 - floor) * power + floor
        faded = np.exp(-values["speed_rate"] * self.speed)
        alpha = 1.0 - values["speed_drop"] * faded
        rise = self.rise * (self.conductivity / values["conductivity"])
        beta = np.exp(-rate * (self.start + rise))
        scaled = values["mu_0"] * beta
        coefficient = scaled * gamma * alpha
        columns: dict[str, Callable[[], FloatArray]] = {
            "mu_0": lambda: beta * gamma * alpha,
            "pressure_exponent": lambda: scaled * alpha * ((floor - 1.0) * power * self.pressure),
            "pressure_floor": lambda: scaled * alpha * (1.0 - power),
            "speed_drop": lambda: -scaled * gamma * faded,
            "speed_rate": lambda: scaled * gamma * (values["speed_drop"] * self.speed * faded),
            "temperature_rate": lambda: -coefficient * (self.start + rise),
            "conductivity": lambda: coefficient * rise * (rate / values["conductivity"]),
        }
        slopes = [columns[name]() for name in names]
        return coefficient, np.stack(slopes, axis=1) if slopes else np.empty((coefficient.size, 0))
