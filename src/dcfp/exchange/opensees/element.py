"""Which bearing element of OpenSees stands for a model, with which constants, and what is different."""

import math
from dataclasses import dataclass, replace
from enum import Enum

from dcfp.errors import InputError
from dcfp.exchange.opensees.fit import (
    ELEMENT_AMBIENT,
    ELEMENT_SPEED_DROP,
    ElementFriction,
    fit_element_law,
    has_the_elements_temperature_factor,
)
from dcfp.kernels.law import EXPONENTIAL, Law
from dcfp.motion.ground_motion import GroundMotion
from dcfp.system import System

_UNEQUAL = "it has one sliding surface, so that two different plates become two equal ones"


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
    kind
        Which element.
    friction
        Coefficient at high speed, and where it heats at about 20 degC [-].
    slow
        Coefficient at zero speed [-].
    rate
        Of the velocity factor, for the relative speed of the plates [s/mm]; zero for none.
    rise_factor
        By which the rise of the temperature is multiplied to come nearest to another law [-].
    stand_in
        The model of this package that the element is; None where that is the model itself.
    reasons
        Why it is not, in words.
    """

    kind: Kind
    friction: float
    slow: float = 0.0
    rate: float = 0.0
    rise_factor: float = 1.0
    stand_in: System | None = None
    reasons: tuple[str, ...] = ()


def element_for(motion: GroundMotion, model: System) -> Element:
    """Return the element that is a model, or comes nearest to it under a ground motion.

    Raises
    ------
    InputError
        If OpenSees has nothing like the friction law.
    """
    law = model.friction.at_pressure(model.bearing.pressure)
    if law.form != EXPONENTIAL:
        msg = (
            f"OpenSees has no element that comes near the friction law {model.friction.name};"
            " choose another, for example kumar2015 or constant."
        )
        raise InputError(msg)
    heats = law.heat_scale * law.heat_rate != 0.0 and model.heating.name != "none"
    return _heated(motion, model, law) if heats else _cold(model, law)


def _cold(model: System, law: Law) -> Element:
    """Return an element whose friction knows no temperature but that at the start."""
    ambient = model.heating.ambient
    fast = law.reference * (law.heat_scale * math.exp(-law.heat_rate * ambient) + law.heat_floor)
    if law.speed_drop == 0.0:
        return Element(Kind.COULOMB, fast)
    slow = fast * (1.0 - law.speed_drop)
    rate = law.speed_rate * _share(model)
    if not model.friction.speed_is_of_surface or not _unequal(model):
        return Element(Kind.VELOCITY, fast, slow, rate)
    stand_in = replace(model, friction=ElementFriction(fast, law.speed_drop, rate, heated=False))
    return Element(Kind.VELOCITY, fast, slow, rate, 1.0, stand_in, (_UNEQUAL,))


def _heated(motion: GroundMotion, model: System, law: Law) -> Element:
    reasons = _differences(model, law)
    if not reasons:
        rate = law.speed_rate * _share(model) if law.speed_drop else 0.0
        return Element(Kind.HEATED, law.reference, rate=rate)
    fit = fit_element_law(motion, model)
    return Element(
        Kind.HEATED,
        fit.friction,
        rate=fit.rate,
        rise_factor=fit.rise_factor,
        stand_in=fit.model,
        reasons=reasons,
    )


def _differences(model: System, law: Law) -> tuple[str, ...]:
    """Return in what the heated element is not the model."""
    heating = model.heating
    found = {
        "its factor of temperature is 0.789 (0.7^(T/50) + 0.4)": not has_the_elements_temperature_factor(law),
        "its factor of velocity is 1 - 0.5 exp(-rate v)": law.speed_drop not in (0.0, ELEMENT_SPEED_DROP),
        "it heats one point of the plate": heating.name != "simplified",
        "its plate is endlessly thick": heating.thickness is not None,
        f"it begins at {ELEMENT_AMBIENT:g} degC, not {heating.ambient:g}": heating.ambient != ELEMENT_AMBIENT,
        _UNEQUAL: _unequal(model),
    }
    return tuple(words for words, differs in found.items() if differs)


def _unequal(model: System) -> bool:
    return len(set(model.bearing.radii)) > 1


def _share(model: System) -> float:
    """Share of the relative speed that a law takes, as if the plates were equal [-]."""
    return 1.0 / len(model.bearing.radii) if model.friction.speed_is_of_surface else 1.0
