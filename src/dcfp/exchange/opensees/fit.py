"""Constants with which the heated element of OpenSees comes nearest to another law.

Its factors of velocity and temperature are written into its source. Free are the coefficient, the rate of the velocity factor, and the
conductivity of the plates, which multiplies the rise of the temperature: a law that falls faster than the element's is met by a contact that is
hotter than it would be. The three are fitted to the coefficient of the law along an analysis, each sample weighted with the energy
that friction dissipates there.
"""

from dataclasses import dataclass, replace
from typing import Any, ClassVar, cast

import numpy as np
from scipy import optimize

from dcfp.analysis import Response, respond
from dcfp.arrays import FloatArray
from dcfp.kernels.law import Law, exponential_law
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.parameters import declared
from dcfp.system import Bearing, FrictionLaw, Kumar2015, SimplifiedHeating, System

#: Fewest samples of sliding for a fit; below, the law's own constants are taken.
_FEWEST_SAMPLES = 10
#: Within which the constants are looked for: coefficient over that of the law [-], rate over that of the law [-], factor of the rise [-].
_LOWEST, _HIGHEST = (0.2, 0.05, 0.05), (5.0, 20.0, 20.0)


@dataclass(frozen=True)
class Fit:
    """The constants.

    Attributes
    ----------
    friction
        Coefficient at high speed and about 20 degC [-].
    rate
        Of the velocity factor, for the relative speed of the plates [s/mm]; zero for none.
    rise_factor
        By which the rise of the temperature is multiplied [-].
    model
        The model of this package with these constants.
    """

    friction: float
    rate: float
    rise_factor: float
    model: System


@dataclass(frozen=True)
class _Samples:
    """What a law says along an analysis: speed [mm/s], rise of the temperature [degC], coefficient [-], weight [-], shape (n,)."""

    speed: FloatArray
    rise: FloatArray
    coefficient: FloatArray
    weight: FloatArray


def fit_element_law(motion: GroundMotion, model: System) -> Fit:
    """Fit the element to a model along its analysis under a ground motion."""
    plates = _equal_plates(model.bearing)
    steel = model.heating
    heating = SimplifiedHeating(steel.conductivity, steel.diffusivity, steel.ambient)
    samples = _samples(respond(motion, System(plates, model.friction, heating)))
    law: Any = model.friction.at_pressure(model.bearing.pressure)
    share = 1.0 / len(plates.radii) if model.friction.speed_is_of_surface else 1.0
    start = (law.reference, law.speed_rate * share)
    factors = _fitted(samples, start, depends_on_speed=law.speed_drop != 0.0)
    friction, rate, rise_factor = start[0] * factors[0], start[1] * factors[1], factors[2]
    drop = ELEMENT_SPEED_DROP if law.speed_drop else 0.0
    hotter = SimplifiedHeating(steel.conductivity / rise_factor, steel.diffusivity, ELEMENT_AMBIENT)
    stand_in = System(plates, ElementFriction(friction, drop, rate), hotter)
    return Fit(friction, rate if drop else 0.0, rise_factor, stand_in)


def _equal_plates(bearing: Bearing) -> Bearing:
    """Return the bearing with as many equal plates of the same effective radius."""
    count = len(bearing.radii)
    return replace(bearing, radii=(bearing.effective_radius / count,) * count)


def _samples(response: Response) -> _Samples:
    slides = response.sliding != 0.0
    speed = np.abs(response.velocity[slides])
    temperature = response.temperature[slides]
    law: FrictionLaw = response.friction_law
    share = response.bearing.shares[0] if law.speed_is_of_surface else 1.0
    coefficient = law.coefficient(response.bearing.pressure, share * speed, temperature)
    weight = np.sqrt(coefficient * speed)
    return _Samples(speed, temperature - response.heating.ambient, coefficient, weight)


def _fitted(
    samples: _Samples, start: tuple[float, float], *, depends_on_speed: bool
) -> tuple[float, float, float]:
    """Return coefficient and rate over those of the law, and the factor of the rise."""
    if samples.speed.size < _FEWEST_SAMPLES or not samples.weight.any():
        return 1.0, 1.0, 1.0
    drop = ELEMENT_SPEED_DROP if depends_on_speed else 0.0

    def misfit(factors: FloatArray) -> FloatArray:
        law = ElementFriction(start[0] * factors[0], drop, start[1] * factors[1])
        found = _coefficient(law.at_pressure(0.0), samples.speed, ELEMENT_AMBIENT + factors[2] * samples.rise)
        return samples.weight * (found / samples.coefficient - 1.0)

    result = cast("Any", optimize).least_squares(misfit, (1.0, 1.0, 1.0), bounds=(_LOWEST, _HIGHEST))
    friction, rate, rise = (float(value) for value in result.x)
    return friction, rate, rise


def _coefficient(law: Law, speed: FloatArray, temperature: FloatArray) -> FloatArray:
    """Coefficient of the heated element [-]."""
    velocity_factor = 1.0 - law.speed_drop * np.exp(-law.speed_rate * speed)
    return law.reference * velocity_factor * Kumar2015.temperature_law.factor(temperature)


# The friction of OpenSees's elements as a law of this package, to say how far it is from another.


#: What is written into FPBearingPTV: the temperature at the start [degC], and the part of the coefficient that is missing at zero speed [-].
ELEMENT_AMBIENT = 20.0
ELEMENT_SPEED_DROP = 0.5


@declared
class ElementFriction(FrictionLaw):
    """Friction of an element.

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
        factor = Kumar2015.temperature_law
        if not self.heated:
            return exponential_law(self.friction, self.drop, self.rate, 0.0, 0.0, 1.0)
        return exponential_law(self.friction, self.drop, self.rate, factor.scale, factor.rate, factor.floor)


def has_the_elements_temperature_factor(law: Law) -> bool:
    """Return whether a law falls with temperature as the heated element does."""
    factor = Kumar2015.temperature_law
    return (law.heat_scale, law.heat_rate, law.heat_floor) == (factor.scale, factor.rate, factor.floor)
