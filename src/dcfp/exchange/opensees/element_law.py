"""The friction of OpenSees's elements as a law of this package, to say how far it is from another."""

from dataclasses import dataclass
from typing import ClassVar

from dcfp.kernels.friction import ExponentialLaw
from dcfp.system import FrictionLaw, Kumar2015

#: What is written into FPBearingPTV: the temperature at the start [degC], and the part of the coefficient that is missing at zero speed [-].
ELEMENT_AMBIENT = 20.0
ELEMENT_SPEED_DROP = 0.5


@dataclass(frozen=True)
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

    def at_pressure(self, pressure: float) -> ExponentialLaw:
        """Return the constants for the kernels; the coefficient is already that at the pressure."""
        del pressure
        factor = Kumar2015.temperature_law
        if not self.heated:
            return ExponentialLaw(self.friction, self.drop, self.rate, 0.0, 0.0, 1.0)
        return ExponentialLaw(self.friction, self.drop, self.rate, factor.scale, factor.rate, factor.floor)


def has_the_elements_temperature_factor(law: ExponentialLaw) -> bool:
    """Return whether a law falls with temperature as the heated element does."""
    factor = Kumar2015.temperature_law
    return (law.heat_scale, law.heat_rate, law.heat_floor) == (factor.scale, factor.rate, factor.floor)
