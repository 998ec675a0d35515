"""The constants of a script, with their units and where they come from."""

import math

from dcfp.analysis import Response
from dcfp.constants import STANDARD_GRAVITY
from dcfp.exchange.opensees.element import Element, Kind

#: How often a whole analysis is repeated in half the step, where a step that cannot be divided does not converge.
_HALVINGS = 3


def constant_lines(response: Response, element: Element, step: float) -> str:
    """Return the constants of a script, a line for each."""
    named = [*_bearing(response), *_friction(element), *_heat(response, element)]
    return "\n".join(
        [
            "# The bearing and what it carries.",
            *(f"{name} = {value!r}  # {words}" for name, value, words in named),
            "",
            "# How finely and how far.",
            *_integration(response, element, step),
            "",
            "# Peaks of the analysis that this script repeats, by dcfp.",
            f"DCFP_PEAK_DISPLACEMENT = {response.peak_displacement!r}  # mm",
            f"DCFP_PEAK_FORCE = {response.peak_force / 1e3!r}  # kN",
            *_temperature(response, element),
        ]
    )


def _bearing(response: Response) -> list[tuple[str, float, str]]:
    bearing = response.bearing
    both = bearing.elastic_stiffness + bearing.restoring_stiffness
    return [
        ("RADIUS", bearing.effective_radius, "mm, sum of the effective radii of the plates"),
        ("INITIAL_STIFFNESS", both, "N/mm, before sliding; for OpenSees with that of the pendulum"),
        ("VERTICAL_FORCE", bearing.vertical_force, "N"),
        ("MASS", bearing.mass, f"t, the vertical force over {STANDARD_GRAVITY:g} mm/s2"),
    ]


def _friction(element: Element) -> list[tuple[str, float, str]]:
    if element.kind is Kind.COULOMB:
        return [("FRICTION", element.friction, "-")]
    rate = ("RATE", element.rate, "s/mm, of how friction rises with the relative speed of the plates")
    if element.kind is Kind.VELOCITY:
        return [
            ("FRICTION_SLOW", element.slow, "-, at no speed"),
            ("FRICTION", element.friction, "-, at high speed"),
            rate,
        ]
    return [
        ("FRICTION", element.friction, "-, at high speed and 20 degC"),
        ("VELOCITY_DEPENDENT", int(element.rate > 0.0), "1 for yes"),
        rate,
    ]


def _heat(response: Response, element: Element) -> list[tuple[str, float, str]]:
    if element.kind is not Kind.HEATED:
        return []
    bearing, steel, plates = response.bearing, response.heating, len(response.bearing.radii)
    conductivity = steel.conductivity / plates / element.rise_factor
    of_steel = (
        f"N/(s degC); that of the plates is {steel.conductivity:g}, the head says why this is not the same"
    )
    return [
        (
            "CONTACT_RADIUS",
            0.5 * bearing.slider_diameter * plates,
            "mm, of the slider times the number of plates",
        ),
        ("PRESSURE", bearing.pressure / plates**2, "N/mm2, on that radius"),
        ("DIFFUSIVITY", steel.diffusivity, "mm2/s, of the plates"),
        ("AMBIENT", steel.ambient, "degC, where the plates begin"),
        (
            "RISE_FACTOR",
            element.rise_factor,
            "-, rise of the temperature of the element over that of the bearing",
        ),
        (
            "CONDUCTIVITY",
            conductivity,
            "N/(s degC), of the plates" if conductivity == steel.conductivity else of_steel,
        ),
    ]


def _integration(response: Response, element: Element, step: float) -> list[str]:
    duration = math.ceil(float(response.time[-1]) / step - 1e-6) * step
    lines = [
        f"STEP = {step!r}  # s, a whole part of the interval of the record",
        f"DURATION = {duration:.9g}  # s, until dcfp finds that it slides no more",
    ]
    again = f"HALVINGS = {_HALVINGS if element.kind is Kind.HEATED else 0}"
    return [
        *lines,
        f"{again}  # times that the whole analysis is repeated in half the step if one does not converge",
    ]


def _temperature(response: Response, element: Element) -> list[str]:
    if element.kind is not Kind.HEATED:
        return []
    return [f"DCFP_PEAK_TEMPERATURE = {response.peak_temperature!r}  # degC"]
