"""All samples of sliding of several tests, one after another, and the law at them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray
from dcfp.inference.identification.friction_history import FrictionHistory
from dcfp.inference.identification.parameters import Constants

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
