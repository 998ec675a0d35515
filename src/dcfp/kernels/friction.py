r"""The coefficient of friction as compiled code sees it.

Every law of the package is a reference value times

.. math:: (1 - a\,e^{-b |v|})\,(A\,e^{-B T} + C)

in which the reference holds the effect of pressure. A user's own law is any compiled function of
pressure, speed and temperature. Which of the two is meant is known from the type of `law`, at compile time.
"""

from collections.abc import Callable
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numba import types
from numba.extending import overload
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.exponential import fading
from dcfp.kernels.motion import Structure


class ExponentialLaw(NamedTuple):
    """Constants of the built-in laws at a given pressure."""

    reference: float
    speed_drop: float
    speed_rate: float
    heat_scale: float
    heat_rate: float
    heat_floor: float


#: The constants of a built-in law, or a compiled function of pressure, speed and temperature.
Law: TypeAlias = ExponentialLaw | Callable[[float, float, float], float]


@kernel
def exponential_coefficient(law: ExponentialLaw, speed: float, temperature: float) -> float:
    """Coefficient of friction [-] of an `ExponentialLaw` at a speed [mm/s] and a temperature [degC]."""
    speed_factor = 1.0 - law.speed_drop * fading(law.speed_rate * speed)
    heat_factor = law.heat_scale * fading(law.heat_rate * temperature) + law.heat_floor
    return law.reference * speed_factor * heat_factor


def coefficient(law: Law, pressure: float, speed: float, temperature: float) -> float:
    """Coefficient of friction [-] at a pressure [N/mm2], a speed [mm/s] and a temperature [degC]."""
    if isinstance(law, ExponentialLaw):
        return exponential_coefficient(law, speed, temperature)
    return law(pressure, speed, temperature)


def _exponential(law: Any, pressure: Any, speed: Any, temperature: Any) -> Any:
    return exponential_coefficient(law, speed, temperature)


def _of_user(law: Any, pressure: Any, speed: Any, temperature: Any) -> Any:
    return law(pressure, speed, temperature)


def _compiled_coefficient(law: Any, pressure: Any, speed: Any, temperature: Any) -> Any:
    return _exponential if isinstance(law, types.BaseNamedTuple) else _of_user


register: Any = overload(coefficient)
register(_compiled_coefficient)


@kernel
def mean_coefficient(
    law: Law, structure: Structure, speed: float, notes: NDArray[np.float64], first: int
) -> float:
    """Coefficient of the whole bearing [-] at a relative speed [mm/s]: the plates' mean by their share of the travel.

    The plates' temperatures [degC] stand in `notes` from entry `first` on.
    """
    one = coefficient(law, structure.pressure, structure.first_speed * speed, notes[first])
    if structure.plates == 1:
        return one
    other = coefficient(law, structure.pressure, structure.second_speed * speed, notes[first + 1])
    return structure.first_share * one + structure.second_share * other


@kernel
def note_ratios(
    law: Law, structure: Structure, speed: float, notes: NDArray[np.float64], first: int, ratio: int
) -> None:
    """Note from entry `ratio` on the coefficient of each plate over that of the bearing, if the plates differ."""
    if structure.plates == 1:
        return
    one = coefficient(law, structure.pressure, structure.first_speed * speed, notes[first])
    other = coefficient(law, structure.pressure, structure.second_speed * speed, notes[first + 1])
    mean = structure.first_share * one + structure.second_share * other
    notes[ratio] = one / mean
    notes[ratio + 1] = other / mean
