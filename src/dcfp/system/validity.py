"""What the model assumes, and whether histories stayed within it."""

from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.system.bearing import Bearing
from dcfp.system.friction import FrictionLaw
from dcfp.system.heating import Heating

#: Displacement over the effective radius up to which the pendulum's force is linear within some percent [-].
LARGEST_ANGLE = 0.5
#: Elongation of spring (b) before sliding above which heat and motion depend on how the two are split [mm].
LARGEST_YIELD_RADIUS = 1.0
#: Ratio of two plates' coefficients up to which they share the travel as their radii.
LARGEST_RATIO = 1.1
#: Time since the plates were cold up to which a plate is as good as a half-space [s]: where one of 50 mm is 1 % warmer after a constant flux.
LONGEST_HALF_SPACE = 196.0
#: How far the temperature at the start may be from that of the tests without a remark [degC].
LARGEST_AMBIENT_CHANGE = 15.0
#: How far beyond a law's tested range histories may go without a remark, relative [-].
_SLACK = 0.01


_AT_REST = "{name}: it never slides, so that forces, stiffness and friction are those of spring (b) alone."


@dataclass(frozen=True)
class History:
    """What is looked at.

    Attributes
    ----------
    name
        To begin each sentence with.
    bearing, friction_law, heating
        The model.
    velocity
        Relative velocity [mm/s], shape (n,).
    friction
        Coefficient [-].
    temperatures
        Of each plate that differs [degC], shape (n, plates).
    slides
        Whether it ever slides.
    load
        Vertical force [N].
    duration
        Time over which heat is remembered [s].
    memory
        Time for which the modes of a half-space remember heat within 1 % of the temperature [s].
    rests
        Whether the plates have cooled in a pause.
    """

    name: str
    bearing: Bearing
    friction_law: FrictionLaw
    heating: Heating
    velocity: FloatArray
    friction: FloatArray
    temperatures: FloatArray
    slides: bool
    load: FloatArray
    duration: float
    memory: float
    rests: bool = False


def assumption_remarks(history: History) -> list[str]:
    """Return a sentence for each assumption that the histories left."""
    if not history.slides:
        return [_AT_REST.format(name=history.name)] if history.velocity.any() else []
    return [
        sentence
        for find in (_law, _tested, _soft_spring, _unequal_plates, _half_space, _long_memory)
        if (sentence := find(history))
    ]


def _law(history: History) -> str:
    caution = history.friction_law.caution
    return f"Friction law {history.friction_law.name}: {caution}" if caution else ""


def _tested(history: History) -> str:
    tested = history.friction_law.tests()
    if tested is None:
        return ""
    pressure = history.load / history.bearing.slider_area
    beyond: list[str] = []
    if float(np.abs(history.velocity).max()) > tested.speed[1] * (1.0 + _SLACK):
        beyond.append(f"faster than {tested.speed[1]:.4g} mm/s")
    if float(pressure.max()) > tested.pressure[1] * (1.0 + _SLACK):
        beyond.append(f"above {tested.pressure[1]:.4g} N/mm2")
    if float(pressure.min()) < tested.pressure[0] * (1.0 - _SLACK):
        beyond.append(f"below {tested.pressure[0]:.4g} N/mm2")
    ambient = history.heating.ambient
    if tested.ambient is not None and abs(ambient - tested.ambient) > LARGEST_AMBIENT_CHANGE:
        beyond.append(f"on plates of {ambient:g} °C at the start, not {tested.ambient:g} °C")
    if not beyond:
        return ""
    return f"{history.name}: outside of the tests behind the law {history.friction_law.name} ({tested.source}): {', '.join(beyond)}."


def _soft_spring(history: History) -> str:
    stretch = history.friction * history.load / history.bearing.elastic_stiffness
    radius = float(stretch.max())
    if radius <= LARGEST_YIELD_RADIUS or history.heating.name == "none":
        return ""
    return (
        f"{history.name}: spring (b) is soft, it stretches {radius:.1f} mm before sliding; the heat of friction is taken"
        " from the whole relative velocity, so temperatures are uncertain."
    )


def _unequal_plates(history: History) -> str:
    ratio = _largest_ratio(history)
    if ratio <= LARGEST_RATIO:
        return ""
    return (
        f"{history.name}: the coefficients of the two plates differ by up to {100.0 * (ratio - 1.0):.0f} %, but the travel"
        " is shared as with equal ones."
    )


def _half_space(history: History) -> str:
    if history.heating.thickness is not None or history.heating.name == "none":
        return ""
    if history.duration <= LONGEST_HALF_SPACE and not history.rests:
        return ""
    return (
        f"{history.name}: so long after the plates were cold their thickness counts, but they are taken as endlessly thick; give the thickness"
        " of the plates, and what their backs do."
    )


def _long_memory(history: History) -> str:
    endless = history.heating.thickness is None
    if not endless or history.duration <= history.memory or history.heating.name == "none":
        return ""
    return f"{history.name}: the motion is longer than {history.memory:.0f} s; heat from longer ago fades too fast in the model."


def _largest_ratio(history: History) -> float:
    temperatures = history.temperatures
    if temperatures.shape[1] == 1:
        return 1.0
    law, pressure = history.friction_law, history.load / history.bearing.slider_area
    speed = np.abs(history.velocity)
    first, second = (
        law.coefficient(pressure, speed * (share if law.speed_is_of_surface else 1.0), temperatures[:, i])
        for i, share in enumerate(history.bearing.shares)
    )
    ratio = first / second
    return float(max(ratio.max(), (1.0 / ratio).max()))
