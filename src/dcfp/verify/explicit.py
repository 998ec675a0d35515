"""A plain explicit integration in very small steps, which has nothing in common with the event-driven kernels but the modes of the heat.

Spring (b) is an elastoplastic spring that is cut back to the yield surface after every step; speed, temperature and
friction are those of the step before. Its error is of first order, and its steps are so small that this does not matter.
It can also heat while spring (b) only stretches, as OpenSees does.
"""

import math
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import numba
import numpy as np

from dcfp.analysis import Response, respond
from dcfp.arrays import FloatArray
from dcfp.kernels.sum_of_exponentials import half_space_modes
from dcfp.motion.ground_motion import GroundMotion
from dcfp.system import LI_2020, Bearing, FrictionLaw, Kumar2015, Li2020, SimplifiedHeating
from dcfp.verify.check import Found, scaled_record

#: Longest step [s].
STEP = 2e-5

#: The paper's bearing with one plate of the same effective radius.
SINGLE_CONCAVE = replace(LI_2020, radii=(LI_2020.effective_radius,), name="single concave")
#: Kumar, Whittaker and Constantinou (2015) at a constant pressure.
KUMAR = Kumar2015(pressure_dependent=False)


@dataclass(frozen=True)
class Peaks:
    """Largest displacement [mm] and temperature [degC]."""

    displacement: float
    temperature: float

    @classmethod
    def of(cls, response: Response) -> "Peaks":
        """Return those of a response."""
        return cls(response.peak_displacement, response.peak_temperature)


def integrate(
    motion: GroundMotion,
    bearing: Bearing,
    friction: FrictionLaw,
    heating: SimplifiedHeating,
    *,
    heats_while_sticking: bool = False,
) -> Peaks:
    """Integrate the motion of a bearing with one plate, or two equal ones, under a built-in law."""
    law = friction.at_pressure(bearing.pressure)
    share = bearing.shares[0]
    rates, weights, instant = half_space_modes()
    displacement, rise = _march(
        motion.acceleration,
        motion.time_step,
        math.ceil(motion.time_step / STEP),
        np.array([bearing.restoring_stiffness, bearing.elastic_stiffness, bearing.vertical_force])
        / bearing.mass,
        np.array(law[1:]),
        share if friction.speed_is_of_surface else 1.0,
        np.array([heating.ambient, heating.rise_factor, share * bearing.pressure, instant]),
        bearing.contact_half_side / share,
        heats_while_sticking,
        rates,
        weights,
    )
    return Peaks(displacement, heating.ambient + rise)


def _march_plainly(
    acceleration: FloatArray,
    interval: float,
    parts: int,
    structure: FloatArray,
    law: FloatArray,
    speed_factor: float,
    heat: FloatArray,
    half_contact: float,
    always: bool,
    rates: FloatArray,
    weights: FloatArray,
) -> tuple[float, float]:
    restoring, elastic, weight = structure
    reference, drop, rate, scale, fall, floor = law
    ambient, rise_factor, pressure, instant = heat
    h = interval / parts
    fade = np.exp(-rates * h)
    gain = (1.0 - fade) / rates * weights
    modes = np.zeros(rates.size)
    y, v, x, rise, largest, hottest = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for i in range(acceleration.size - 1):
        for j in range(parts):
            ground = acceleration[i] + (acceleration[i + 1] - acceleration[i]) * (j + 0.5) / parts
            speed = abs(v)
            friction = reference * (1.0 - drop * math.exp(-rate * speed_factor * speed))
            friction *= scale * math.exp(-fall * (ambient + rise)) + floor
            reach = friction * weight / elastic
            halfway = x + 0.5 * h * v
            slides = abs(halfway) > reach
            halfway = min(max(halfway, -reach), reach)
            # half of the way with the old velocity, half with the new one
            y += 0.5 * h * v
            v -= h * (ground + restoring * y + elastic * halfway)
            y += 0.5 * h * v
            largest = max(largest, abs(y))
            x = min(max(halfway + 0.5 * h * v, -reach), reach)
            flux = friction * pressure * abs(v) if (slides or always) and abs(y) <= half_contact else 0.0
            rise = 0.0
            for n in range(rates.size):
                modes[n] = fade[n] * modes[n] + gain[n] * flux
                rise += modes[n]
            rise = rise_factor * (rise + instant * flux)
            hottest = max(hottest, rise)
    return largest, hottest


_march: Any = numba.njit(_march_plainly)


#: Bearing and law of each check.
_CHECKED: dict[str, tuple[Bearing, FrictionLaw]] = {
    "li2020": (LI_2020, Li2020()),
    "kumar2015": (SINGLE_CONCAVE, KUMAR),
}


@cache
def _both(law: str) -> tuple[Peaks, Peaks]:
    """Return the peaks of the analysis and of the explicit integration."""
    motion, heating = scaled_record("NCC", 500.0), SimplifiedHeating()
    bearing, friction = _CHECKED[law]
    exact = respond(motion, bearing, friction, heating, step=1e-3, tolerance=1e-5, tail=0.0)
    plain = integrate(motion, bearing, friction, heating)
    return Peaks.of(exact), plain


def peak(law: str, quantity: str) -> Found:
    """Return the peak displacement [mm] or temperature [degC] of the analysis, and that of the explicit integration."""
    exact, plain = (getattr(peaks, quantity) for peaks in _both(law))
    return Found(exact, plain, words={"bearing": _CHECKED[law][0].name})
