"""Which bearing element of OpenSees stands for a model, with which constants, and what is different.

The factors of velocity and temperature of the heated element are written into its source. Free are the coefficient, the rate of the velocity
factor, and the conductivity of the plates, which multiplies the rise of the temperature: a law that falls faster than the element's is met by a contact that is
hotter than it would be. The three are fitted to the coefficient of the law along an analysis, each sample weighted with the energy
that friction dissipates there.
"""

import math
from dataclasses import dataclass, replace
from enum import Enum
from typing import Any, ClassVar, TypeAlias, cast

import numpy as np
from scipy import optimize

from dcfp.analysis import PlaneResponse, Response, respond
from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.kernels.law import EXPONENTIAL, Law, exponential_law
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station
from dcfp.schema.declared import declared
from dcfp.system import FrictionLaw, Kumar2015, SimplifiedHeating, System

#: What a script repeats: an analysis in one direction or in the plane.
Analysis: TypeAlias = Response | PlaneResponse

#: What is written into FPBearingPTV: the temperature at the start [degC], and the part of the coefficient that is missing at zero speed [-].
ELEMENT_AMBIENT = 20.0
ELEMENT_SPEED_DROP = 0.5
_ELEMENT_HEAT_FACTOR = (
    Kumar2015.temperature_law.scale,
    Kumar2015.temperature_law.rate,
    Kumar2015.temperature_law.floor,
)
#: Fewest samples of sliding for a fit; below, the law's own constants are taken.
_FEWEST_SAMPLES = 10
#: Within which the constants are looked for: coefficient over that of the law [-], rate over that of the law [-], factor of the rise [-].
_LOWEST, _HIGHEST = (0.2, 0.05, 0.05), (5.0, 20.0, 20.0)
#: Why an element is not a model.
UNEQUAL = "it has one sliding surface, so that two different plates become two equal ones"
OF_LOAD = "its friction does not change with the pressure, which the vertical motion changes"


class Kind(Enum):
    """Elements and friction models of OpenSees."""

    COULOMB = "singleFPBearing with the friction model Coulomb"
    VELOCITY = "singleFPBearing with the friction model VelDependent"
    HEATED = "FPBearingPTV"


@dataclass(frozen=True)
class Element:
    """An element with its constants.

    Attributes
    ----------
    friction, slow
        Coefficients at high speed, and where it heats at about 20 degC; at zero speed [-].
    rate
        Of the velocity factor, for the relative speed of the plates [s/mm]; zero for none.
    rise_factor
        By which the rise of the temperature is multiplied to come nearest to another law [-].
    stand_in, reasons
        The model of this package that the element is, None where that is the model itself; in words, why it is not.
    """

    kind: Kind
    friction: float
    slow: float = 0.0
    rate: float = 0.0
    rise_factor: float = 1.0
    stand_in: System | None = None
    reasons: tuple[str, ...] = ()


def element_for(motion: GroundMotion | Station, model: System, *, vertical: bool = False) -> Element:
    """Return the element that is a model, or comes nearest to it under a ground motion; `vertical` as for `dcfp.respond`.

    Raises
    ------
    InputError
        If OpenSees has nothing like the friction law, or its element heats and the vertical force changes.
    """
    law = exported_law(model, model.bearing.pressure)
    heats = is_heated(model, law)
    if heats and vertical:
        msg = (
            f"{motion.name}: the element of OpenSees that heats is exported under a constant vertical force;"
            " leave the vertical motion out, or the heating (none)."
        )
        raise InputError(msg)
    return _heated(motion, model, law) if heats else _cold(model, law, vertical)


def _cold(model: System, law: Law, vertical: bool) -> Element:
    """Return an element whose friction knows no temperature but that at the start."""
    element = at_temperature(law, model, model.heating.ambient)
    differs = {
        UNEQUAL: is_unequal(model, element),
        OF_LOAD: vertical and knows_pressure(model),
    }
    reasons = tuple(words for words, found in differs.items() if found)
    if not reasons:
        return element
    return replace(element, stand_in=replace(model, friction=friction_of(element)), reasons=reasons)


def at_temperature(law: Law, model: System, temperature: float) -> Element:
    """Return the element with the friction of an exponential law at a temperature [degC]."""
    fast = law.reference * (law.heat_scale * math.exp(-law.heat_rate * temperature) + law.heat_floor)
    slow = fast * (1.0 - law.speed_drop)
    kind, rate = (Kind.VELOCITY, law.speed_rate * _share(model)) if law.speed_drop else (Kind.COULOMB, 0.0)
    return Element(kind, fast, slow, rate)


def friction_of(element: Element) -> "ElementFriction":
    """Return the friction of an element that does not heat up as a law."""
    return ElementFriction(
        element.friction, 1.0 - element.slow / element.friction, element.rate, heated=False
    )


def is_unequal(model: System, element: Element) -> bool:
    """Whether two plates that differ are not one with the sum of their radii, for each has a speed of its own."""
    return element.rate > 0.0 and model.friction.speed_is_of_surface and _unequal(model)


def exported_law(model: System, pressure: float) -> Law:
    """Return the constants of a law at a pressure [N/mm2].

    Raises
    ------
    InputError
        If OpenSees has nothing like it.
    """
    law = model.friction.at_pressure(pressure)
    if law.form != EXPONENTIAL:
        msg = (
            f"OpenSees has no element that comes near the friction law {model.friction.name};"
            " choose another, for example kumar2015 or constant."
        )
        raise InputError(msg)
    return law


def is_heated(model: System, law: Law) -> bool:
    """Whether the coefficient of friction falls as the bearing heats up."""
    return law.heat_scale * law.heat_rate != 0.0 and model.heating.name != "none"


def knows_pressure(model: System) -> bool:
    """Whether the coefficient at twice the pressure is another."""
    pressure = model.bearing.pressure
    once, twice = (model.friction.at_pressure(times * pressure).reference for times in (1.0, 2.0))
    return once != twice


def _heated(motion: GroundMotion | Station, model: System, law: Law) -> Element:
    reasons = _differences(model, law)
    if not reasons:
        rate = law.speed_rate * _share(model) if law.speed_drop else 0.0
        return Element(Kind.HEATED, law.reference, rate=rate)
    return _fitted(motion, model, law, reasons)


def _differences(model: System, law: Law) -> tuple[str, ...]:
    """Return in what the heated element is not the model."""
    heating = model.heating
    heat_factor = (law.heat_scale, law.heat_rate, law.heat_floor)
    found = {
        "its factor of temperature is 0.789 (0.7^(T/50) + 0.4)": heat_factor != _ELEMENT_HEAT_FACTOR,
        "its factor of velocity is 1 - 0.5 exp(-rate v)": law.speed_drop not in (0.0, ELEMENT_SPEED_DROP),
        "it heats one point of the plate": heating.name != "simplified",
        "its plate is endlessly thick": heating.thickness is not None,
        f"it begins at {ELEMENT_AMBIENT:g} degC, not {heating.ambient:g}": heating.ambient != ELEMENT_AMBIENT,
        UNEQUAL: _unequal(model),
    }
    return tuple(words for words, differs in found.items() if differs)


def _unequal(model: System) -> bool:
    return len(set(model.bearing.radii)) > 1


def _share(model: System) -> float:
    """Share of the relative speed that a law takes, as if the plates were equal [-]."""
    return 1.0 / len(model.bearing.radii) if model.friction.speed_is_of_surface else 1.0


def _fitted(motion: GroundMotion | Station, model: System, law: Law, reasons: tuple[str, ...]) -> Element:
    """Return the heated element that comes nearest to a model along its analysis under a ground motion."""
    bearing, steel = model.bearing, model.heating
    count = len(bearing.radii)
    plates = replace(bearing, radii=(bearing.effective_radius / count,) * count)  # equal ones
    heating = SimplifiedHeating(steel.conductivity, steel.diffusivity, steel.ambient)
    response = respond(motion, System(plates, model.friction, heating))
    drop = ELEMENT_SPEED_DROP if law.speed_drop else 0.0
    start = (law.reference, law.speed_rate * _share(model))
    of_friction, of_rate, rise_factor = _fit(response, start, drop)
    friction, rate = start[0] * of_friction, start[1] * of_rate
    hotter = SimplifiedHeating(steel.conductivity / rise_factor, steel.diffusivity, ELEMENT_AMBIENT)
    stand_in = System(plates, ElementFriction(friction, drop, rate), hotter)
    return Element(
        Kind.HEATED,
        friction,
        rate=rate if drop else 0.0,
        rise_factor=rise_factor,
        stand_in=stand_in,
        reasons=reasons,
    )


def _fit(response: Analysis, start: tuple[float, float], drop: float) -> tuple[float, float, float]:
    """Return coefficient and rate over those of the law, and the factor of the rise."""
    law: FrictionLaw = response.friction_law
    slides = response.sliding != 0.0
    speed, temperature = np.abs(response.velocity[slides]), response.temperature[slides]
    share = response.bearing.shares[0] if law.speed_is_of_surface else 1.0
    coefficient = law.coefficient(response.bearing.pressure, share * speed, temperature)
    weight, rise = np.sqrt(coefficient * speed), temperature - response.heating.ambient
    if speed.size < _FEWEST_SAMPLES or not weight.any():
        return 1.0, 1.0, 1.0

    def misfit(factors: FloatArray) -> FloatArray:
        velocity_factor = 1.0 - drop * np.exp(-start[1] * factors[1] * speed)
        heat_factor = Kumar2015.temperature_law.factor(ELEMENT_AMBIENT + factors[2] * rise)
        return weight * (start[0] * factors[0] * velocity_factor * heat_factor / coefficient - 1.0)

    result = cast("Any", optimize).least_squares(misfit, (1.0, 1.0, 1.0), bounds=(_LOWEST, _HIGHEST))
    friction, rate, rise_factor = (float(value) for value in result.x)
    return friction, rate, rise_factor


@declared
class ElementFriction(FrictionLaw):
    """Friction of an element as a law of this package, to say how far it is from another.

    Parameters
    ----------
    friction
        Coefficient at high speed, and where it heats at about 20 degC [-].
    drop
        The part that is missing at zero speed [-].
    rate
        Of the velocity factor, for the relative speed of the plates [s/mm].
    heated
        Whether it falls with temperature as the law of Kumar et al. (2015).
    """

    friction: float
    drop: float
    rate: float
    heated: bool = True
    name: ClassVar[str] = "opensees"
    citation: ClassVar[str] = "kumar_2015"

    @property
    def reference(self) -> float:
        """Coefficient at high speed [-]."""
        return self.friction

    def at_pressure(self, pressure: float) -> Law:
        """Return the constants for the kernels; the coefficient is already that at the pressure."""
        del pressure
        heat_factor = _ELEMENT_HEAT_FACTOR if self.heated else (0.0, 0.0, 1.0)
        return exponential_law(self.friction, self.drop, self.rate, *heat_factor)
