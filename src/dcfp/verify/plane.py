"""The plane in closed form: the steady circle of a ground acceleration that turns."""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np

from dcfp.analysis import PlaneResponse, respond
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station
from dcfp.system import LI_2020, Bearing, ConstantFriction
from dcfp.verify.check import Found

#: Samples in a turn, turns in which the acceleration grows, and all turns.
_SAMPLES, _GROWING, _TURNS = 1000, 10, 40


@dataclass(frozen=True)
class Circle:
    """A ground acceleration A (cos wt, sin wt) [mm/s2], its period [s], and the coefficient of friction of a bearing that follows it on a circle."""

    amplitude: float
    period: float
    mu: float
    bearing: Bearing = LI_2020

    @property
    def strength(self) -> float:
        """Friction Y = mu N [N]."""
        return self.mu * self.bearing.vertical_force

    @property
    def _lag(self) -> float:
        """What the pendulum lacks to the frequency, w_f^2 - w^2 [1/s2]."""
        return self.bearing.restoring_stiffness / self.bearing.mass - (2.0 * math.pi / self.period) ** 2

    @property
    def rigid_plastic_radius(self) -> float:
        """Radius with an endlessly stiff spring (b) [mm]: sqrt(A^2 - (mu g)^2) / |w^2 - w_f^2|."""
        return math.sqrt(self.amplitude**2 - (self.strength / self.bearing.mass) ** 2) / abs(self._lag)

    @property
    def radius(self) -> float:
        """Radius r [mm], of [m (w_f^2 - w^2) r + Y^2 / (kf r)]^2 + Y^2 [1 - (Y / (kf r))^2] = (m A)^2, in which the terms with 1 / r^2 cancel."""
        mass, strength, lag = self.bearing.mass, self.strength, self._lag
        of_spring = 1.0 + 2.0 * mass * lag / self.bearing.elastic_stiffness
        return math.sqrt(self.amplitude**2 - (strength / mass) ** 2 * of_spring) / abs(lag)

    @property
    def energy(self) -> float:
        """Energy that friction dissipates in a turn [N mm]: 2 pi r_p Y, on the circle r_p of the anchor of spring (b)."""
        anchor = math.sqrt(self.radius**2 - (self.strength / self.bearing.elastic_stiffness) ** 2)
        return 2.0 * math.pi * anchor * self.strength

    def response(self) -> PlaneResponse:
        """Return the analysis of many turns, in the first of which the acceleration grows; the last is steady."""
        step = self.period / _SAMPLES
        turns = np.arange(_TURNS * _SAMPLES) / _SAMPLES
        grown = self.amplitude * np.minimum(1.0, turns / _GROWING)
        x, y = (
            GroundMotion(grown * turned(2.0 * math.pi * turns), step, name)
            for turned, name in ((np.cos, "cosine"), (np.sin, "sine"))
        )
        return respond(
            Station(x, y, name="turning acceleration"),
            self.bearing,
            ConstantFriction(self.mu),
            "none",
            tail=0.0,
        )


#: Accelerations that differ.
CIRCLES = {
    f"A {one.amplitude:g} mm/s2, T {one.period:g} s, mu {one.mu:g}": one
    for one in (
        Circle(1500.0, 2.0, 0.043),
        Circle(1000.0, 3.0, 0.08),
        Circle(600.0, 1.0, 0.043),
        Circle(3000.0, 1.5, 0.1),
    )
}


@cache
def _response(case: str) -> PlaneResponse:
    return CIRCLES[case].response()


def circle(case: str, quantity: str) -> Found:
    """Return of the last turn the distance from the middle that differs most from the radius [mm], or the energy [kN m]; and the closed form."""
    exact, response = CIRCLES[case], _response(case)
    words = {"rigid": exact.rigid_plastic_radius, "turns": _TURNS, "samples": _SAMPLES}
    if quantity == "radius":
        last = response.displacement[-_SAMPLES:]
        worst = float(last[np.abs(last - exact.radius).argmax()])
        return Found(worst, exact.radius, words=words | {"unit": "mm"})
    energy = response.energy.hysteretic
    turned = float(energy[-1] - energy[-1 - _SAMPLES])
    return Found(1e-6 * turned, 1e-6 * exact.energy, words=words | {"unit": "kN m"})
