r"""The coefficient of friction as compiled code sees it.

Every law of the package is a reference value times

.. math:: (1 - a\,e^{-b |v|})\,(A\,e^{-B T} + C)

in which the reference holds the effect of pressure. A user's own law is any compiled function of
pressure, speed and temperature. Which of the two is meant is known from the type of `law`, at compile time.
"""

import math
from typing import NamedTuple

from numba import types
from numba.extending import overload

from dcfp.kernels._jit import kernel


class ExponentialLaw(NamedTuple):
    """Constants of the built-in laws at a given pressure."""

    reference: float
    speed_drop: float
    speed_rate: float
    heat_scale: float
    heat_rate: float
    heat_floor: float


@kernel
def exponential_coefficient(law, speed, temperature):
    """Coefficient of friction [-] of an `ExponentialLaw` at a speed [mm/s] and a temperature [degC]."""
    speed_factor = 1.0 - law.speed_drop * math.exp(-law.speed_rate * speed)
    heat_factor = law.heat_scale * math.exp(-law.heat_rate * temperature) + law.heat_floor
    return law.reference * speed_factor * heat_factor


def coefficient(law, pressure, speed, temperature):
    """Coefficient of friction [-] at a pressure [N/mm2], a speed [mm/s] and a temperature [degC]."""
    if isinstance(law, ExponentialLaw):
        return exponential_coefficient(law, speed, temperature)
    return law(pressure, speed, temperature)


@overload(coefficient)
def _compiled_coefficient(law, pressure, speed, temperature):
    if isinstance(law, types.BaseNamedTuple):
        return lambda law, pressure, speed, temperature: exponential_coefficient(law, speed, temperature)
    return lambda law, pressure, speed, temperature: law(pressure, speed, temperature)


@kernel
def mean_coefficient(law, structure, speed, notes, first):
    """Coefficient of the whole bearing [-] at a relative speed [mm/s]: the plates' mean by their share of the travel.

    The plates' temperatures [degC] stand in `notes` from entry `first` on.
    """
    one = coefficient(law, structure.pressure, structure.first_speed * speed, notes[first])
    if structure.plates == 1:
        return one
    other = coefficient(law, structure.pressure, structure.second_speed * speed, notes[first + 1])
    return structure.first_share * one + structure.second_share * other
