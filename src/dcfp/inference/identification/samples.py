"""The parameters that can be fitted; all samples of sliding of several tests, one after another, and the law at them."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.schema.declared import parameters
from dcfp.schema.parameters import Parameter, unknown
from dcfp.system import Heating, System
from dcfp.system.friction import FittedFriction
from dcfp.system.system import OF_LAW

_DECLARED = {**parameters(FittedFriction), **parameters(Heating)}


@dataclass(frozen=True)
class FitParameter(Parameter):
    """A declared constant of the law, or of the plates, that can be fitted.

    Attributes
    ----------
    worth
        Half of the longest 95 % interval at which the data are said to determine it, in its unit; where it `is_scale`, over the estimate.
    is_scale
        Positive by its nature, so that its interval is symmetric in its logarithm.
    """

    worth: float = math.inf
    is_scale: bool = False


def _fitted(name: str, worth: float, *, is_scale: bool = False, **limits: float) -> FitParameter:
    known: dict[str, Any] = vars(_DECLARED[name]) | limits
    return FitParameter(**known, worth=worth, is_scale=is_scale)


#: What can be fitted, by name, in the order in which it is told; of the limits some are closer than those of the law.
PARAMETERS = {
    one.name: one
    for one in (
        _fitted("mu_0", 0.25, is_scale=True, least=1e-4, most=0.99),
        _fitted("pressure_exponent", 0.15),
        _fitted("pressure_floor", 0.5, most=0.999),
        _fitted("speed_drop", 0.25),
        _fitted("speed_rate", 0.5, is_scale=True, least=1e-5),
        _fitted("temperature_rate", 0.007),
        _fitted("conductivity", 0.5, is_scale=True),
    )
}
#: What can only be fixed.
REFERENCES = ("reference_pressure", "reference_temperature", "diffusivity")


def parameter(name: str) -> FitParameter:
    """Return a parameter by its name.

    Raises
    ------
    InputError
        If there is none of that name, or it is one that can only be fixed.
    """
    if name in PARAMETERS:
        return PARAMETERS[name]
    if name == "diffusivity":
        msg = (
            "The diffusivity cannot be fitted: in a half-space only sqrt(diffusivity) / conductivity acts on the temperature of the contact;"
            " fit the conductivity, or fix both."
        )
    elif name in REFERENCES:
        msg = f"The {name} cannot be fitted, it is where mu_0 stands; choose it (fix {name}=VALUE)."
    else:
        msg = f"Identification: {unknown(name, PARAMETERS, 'parameter')}"
    raise InputError(msg)


def unit_of(name: str) -> str:
    """Return the unit of a constant as it is typed; empty for a number."""
    unit = _DECLARED[name].unit
    return unit.name.replace("°", "deg").replace("²", "2") if unit.has_dimension else ""


def value_of(system: System, name: str) -> float:
    """Return a constant of the law or of the plates by its name."""
    return float(getattr(system.friction if hasattr(system.friction, name) else system.heating, name))


def with_values(system: System, values: Mapping[str, float]) -> System:
    """Return a system with some of the constants of its law and of its plates changed.

    Raises
    ------
    InputError
        If there is none of a name, or a value is out of range.
    """
    known = [name if name in REFERENCES else parameter(name).name for name in values]
    of_law = parameters(FittedFriction)
    return system.changed({f"{OF_LAW}{name}" if name in of_law else name: values[name] for name in known})


def in_order(names: Iterable[str]) -> tuple[str, ...]:
    """Return the names of parameters in the order in which they are told, each once."""
    wanted = set(names)
    return tuple(name for name in PARAMETERS if name in wanted)


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


def _blocks(strokes: Sequence[NDArray[np.int64]]) -> NDArray[np.int64]:
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
    system
        What is fixed, and the conductivity and the ambient temperature with which the rises were reckoned.
    """

    def __init__(self, samples: Samples, system: System) -> None:
        self.speed = samples.speed
        self.rise = samples.rise
        self.pressure = np.log(samples.pressure / value_of(system, "reference_pressure"))
        self.start = system.heating.ambient - value_of(system, "reference_temperature")
        self.conductivity = system.heating.conductivity

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
