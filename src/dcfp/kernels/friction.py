r"""The coefficient of friction as compiled code sees it.

Every law of the package is a reference value times

.. math:: (1 - a\,e^{-b |v|})\,(A\,e^{-B T} + C)

in which the reference holds the effect of pressure; but for one, which wears off with the dose of rubbing instead of the
temperature. A user's own law is any compiled function of
pressure, speed and temperature. Which of these is meant is known from the type of `law`, at compile time.
"""

from collections.abc import Callable
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numba.extending import overload
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.exponential import fading
from dcfp.kernels.heat_state import DOSE
from dcfp.kernels.motion import Structure


class ExponentialLaw(NamedTuple):
    """Constants of the built-in laws at a given pressure."""

    reference: float
    speed_drop: float
    speed_rate: float
    heat_scale: float
    heat_rate: float
    heat_floor: float


class CyclingLaw(NamedTuple):
    """Constants of a law that wears off with the dose of rubbing, at a given pressure."""

    reference: float
    speed_drop: float
    speed_rate: float
    dose_rate: float
    dose_power: float


#: Most constants that a built-in law has.
CONSTANTS = 6
#: The constants of a built-in law, or a compiled function of pressure, speed and temperature.
Law: TypeAlias = ExponentialLaw | CyclingLaw | Callable[[float, float, float], float]


@kernel
def exponential_coefficient(law: ExponentialLaw, speed: float, temperature: float) -> float:
    """Coefficient of friction [-] of an `ExponentialLaw` at a speed [mm/s] and a temperature [degC]."""
    speed_factor = 1.0 - law.speed_drop * fading(law.speed_rate * speed)
    heat_factor = law.heat_scale * fading(law.heat_rate * temperature) + law.heat_floor
    return law.reference * speed_factor * heat_factor


@kernel
def cycling_coefficient(law: CyclingLaw, speed: float, dose: float) -> float:
    """Coefficient of friction [-] of a `CyclingLaw` at a speed [mm/s] and after a dose of rubbing [N/s]."""
    speed_factor = 1.0 - law.speed_drop * fading(law.speed_rate * speed)
    return law.reference * speed_factor * fading((law.dose_rate * dose) ** law.dose_power)


def coefficient(law: Law, pressure: float, speed: float, temperature: float, dose: float) -> float:
    """Coefficient of friction [-] at a pressure [N/mm2], a speed [mm/s], a temperature [degC] and a dose [N/s]."""
    if isinstance(law, ExponentialLaw):
        return exponential_coefficient(law, speed, temperature)
    if isinstance(law, CyclingLaw):
        return cycling_coefficient(law, speed, dose)
    return law(pressure, speed, temperature)


def _exponential(law: Any, pressure: Any, speed: Any, temperature: Any, dose: Any) -> Any:
    return exponential_coefficient(law, speed, temperature)


def _cycling(law: Any, pressure: Any, speed: Any, temperature: Any, dose: Any) -> Any:
    return cycling_coefficient(law, speed, dose)


def _of_user(law: Any, pressure: Any, speed: Any, temperature: Any, dose: Any) -> Any:
    return law(pressure, speed, temperature)


def _compiled_coefficient(law: Any, pressure: Any, speed: Any, temperature: Any, dose: Any) -> Any:
    kind: Any = getattr(law, "instance_class", None)
    return {ExponentialLaw: _exponential, CyclingLaw: _cycling}.get(kind, _of_user)


register_coefficient: Any = overload(coefficient)
register_coefficient(_compiled_coefficient)


def with_reference(law: Law, reference: float) -> Law:
    """Return a built-in law at another pressure, at which its reference is this one [-]; a user's law as it is."""
    if isinstance(law, (ExponentialLaw, CyclingLaw)):
        return law._replace(reference=reference)
    return law


def _exponential_with(law: Any, reference: Any) -> Any:
    return ExponentialLaw(
        reference, law.speed_drop, law.speed_rate, law.heat_scale, law.heat_rate, law.heat_floor
    )


def _cycling_with(law: Any, reference: Any) -> Any:
    return CyclingLaw(reference, law.speed_drop, law.speed_rate, law.dose_rate, law.dose_power)


def _unchanged(law: Any, reference: Any) -> Any:
    return law


def _compiled_with_reference(law: Any, reference: Any) -> Any:
    kind: Any = getattr(law, "instance_class", None)
    return {ExponentialLaw: _exponential_with, CyclingLaw: _cycling_with}.get(kind, _unchanged)


register_reference: Any = overload(with_reference)
register_reference(_compiled_with_reference)


def law_from(law: Law, constants: NDArray[np.float64]) -> Law:
    """Return a built-in law of the same kind with these constants, in their order; a user's law as it is."""
    if isinstance(law, ExponentialLaw):
        return ExponentialLaw(*constants[:6].tolist())
    if isinstance(law, CyclingLaw):
        return CyclingLaw(*constants[:5].tolist())
    return law


def _exponential_from(law: Any, constants: Any) -> Any:
    return ExponentialLaw(constants[0], constants[1], constants[2], constants[3], constants[4], constants[5])


def _cycling_from(law: Any, constants: Any) -> Any:
    return CyclingLaw(constants[0], constants[1], constants[2], constants[3], constants[4])


def _unchanged_from(law: Any, constants: Any) -> Any:
    return law


def _compiled_law_from(law: Any, constants: Any) -> Any:
    kind: Any = getattr(law, "instance_class", None)
    return {ExponentialLaw: _exponential_from, CyclingLaw: _cycling_from}.get(kind, _unchanged_from)


register_law_from: Any = overload(law_from)
register_law_from(_compiled_law_from)


@kernel
def mean_coefficient(
    law: Law, structure: Structure, speed: float, notes: NDArray[np.float64], first: int
) -> float:
    """Coefficient of the whole bearing [-] at a relative speed [mm/s]: the plates' mean by their share of the travel.

    The plates' temperatures [degC] stand in `notes` from entry `first` on, their doses so many entries later.
    """
    one = coefficient(
        law, structure.pressure, structure.first_speed * speed, notes[first], notes[first + DOSE]
    )
    if structure.plates == 1:
        return one
    other = coefficient(
        law, structure.pressure, structure.second_speed * speed, notes[first + 1], notes[first + DOSE + 1]
    )
    return structure.first_share * one + structure.second_share * other


@kernel
def note_ratios(
    law: Law, structure: Structure, speed: float, notes: NDArray[np.float64], first: int, ratio: int
) -> None:
    """Note from entry `ratio` on the coefficient of each plate over that of the bearing, if the plates differ."""
    if structure.plates == 1:
        return
    one = coefficient(
        law, structure.pressure, structure.first_speed * speed, notes[first], notes[first + DOSE]
    )
    other = coefficient(
        law, structure.pressure, structure.second_speed * speed, notes[first + 1], notes[first + DOSE + 1]
    )
    mean = structure.first_share * one + structure.second_share * other
    notes[ratio] = one / mean
    notes[ratio + 1] = other / mean
