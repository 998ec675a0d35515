"""A pendulum with Coulomb friction as an equivalent linear system at a displacement; it follows from the rigid-plastic loop."""

import math
from dataclasses import dataclass

from dcfp.constants import STANDARD_GRAVITY
from dcfp.system.checks import fraction, positive


@dataclass(frozen=True)
class PendulumWithFriction:
    """What the methods of codes take of a bearing: F / W = mu + D / R.

    Parameters
    ----------
    radius
        Effective radius R, 2 Rs for two equal plates [mm].
    friction
        Coefficient mu [-].
    """

    radius: float
    friction: float

    def __post_init__(self) -> None:
        positive(self.radius, "effective radius", "mm")
        fraction(self.friction, "coefficient of friction")

    @property
    def free_frequency(self) -> float:
        """Circular frequency of the pendulum without friction, sqrt(g / R) [rad/s]."""
        return math.sqrt(STANDARD_GRAVITY / self.radius)

    @property
    def free_period(self) -> float:
        """Period of the pendulum without friction [s]."""
        return 2.0 * math.pi / self.free_frequency

    def force(self, displacement: float) -> float:
        """Force over the weight at a displacement [mm], mu + D / R [-]."""
        return self.friction + displacement / self.radius

    def effective_stiffness(self, displacement: float) -> float:
        """Secant stiffness over the weight at a displacement [mm], 1/R + mu/D [1/mm]."""
        return 1.0 / self.radius + self.friction / displacement

    def effective_period(self, displacement: float) -> float:
        """Period of the secant stiffness at a displacement [mm], in s."""
        return 2.0 * math.pi / math.sqrt(STANDARD_GRAVITY * self.effective_stiffness(displacement))

    def effective_damping(self, displacement: float) -> float:
        """Damping ratio of the loop at a displacement [mm], (2/pi) mu / (mu + D/R) [-]."""
        return 2.0 / math.pi * self.friction / self.force(displacement)

    @property
    def rest(self) -> float:
        """Largest displacement at which it can stay at rest, mu R [mm]."""
        return self.friction * self.radius
