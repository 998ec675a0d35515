"""The bearing worked out: Li et al. (2020), sections 4 and 5.1."""

import math

from dcfp.constants import STANDARD_GRAVITY
from dcfp.present.report.digits import number
from dcfp.present.report.document import Formula
from dcfp.study.scenario import Calculation

_KILO = 1e3
_PAPER = "Li et al. (2020)"


def bearing_formulas(calculation: Calculation) -> tuple[Formula, ...]:
    """Return load, mass, stiffness, period and what follows from the nominal coefficient."""
    bearing, heating = calculation.scenario.model.bearing, calculation.scenario.model.heating
    mu_n = calculation.nominal.value
    load, radius = bearing.vertical_force / _KILO, bearing.effective_radius
    phi, sigma = f"{bearing.slider_diameter:.10g}", f"{bearing.pressure:.10g}"
    k_f, g = f"{bearing.elastic_stiffness / _KILO:.10g}", f"{STANDARD_GRAVITY / _KILO:.5f}"
    radii = " + ".join(f"{one:.10g}" for one in bearing.radii)
    double = len(bearing.radii) > 1
    mass = number(bearing.mass, 2)
    return (
        Formula("Vertical force", "N = (sigma pi phi^2) / 4", f"({sigma} times pi times {phi}^2) / (4 times 1000)", load, 2, "kN", f"{_PAPER}, section 5.1"),
        Formula("Mass of the rigid structure", "m = N / g", f"{number(load, 2)} / {g}", bearing.mass, 2, "t", f"{_PAPER}, section 5.1"),
        Formula("Effective radius", "R = R_1 + R_2" if double else "R = R_1", radii if double else "", radius, 1, "mm", f"{_PAPER}, section 5.1 (2 Rs for two equal plates)"),
        Formula("Stiffness of the pendulum, spring (a)", 'k_"ra" = N / R', f"{number(load, 2)} / {number(radius, 1)}", bearing.restoring_stiffness / _KILO, 4, "kN/mm", f"{_PAPER}, section 5.1"),
        Formula("Period of the pendulum", "T = 2 pi sqrt(R / g)", f"2 pi sqrt({number(radius, 1)} / (1000 times {g}))", bearing.period, 3, "s", f"{_PAPER}, section 5.1"),
        Formula("The same from mass and stiffness", 'T = 2 pi sqrt(m / k_"ra")', f"2 pi sqrt({mass} / (1000 times {number(bearing.restoring_stiffness / _KILO, 4)}))", 2.0 * math.pi * math.sqrt(bearing.mass / bearing.restoring_stiffness), 3, "s", "mechanics"),
        Formula("Displacement at yield, with the nominal coefficient", "r_f = (mu_n N) / k_f", f"({mu_n:.5f} times {number(load, 2)}) / {k_f}", mu_n * bearing.vertical_force / bearing.elastic_stiffness, 4, "mm", f"{_PAPER}, section 5.1"),
        Formula("Largest displacement at rest, with the nominal coefficient (the check of the residual takes the coefficient at the end of each analysis)", "d_r = mu_n R", f"{mu_n:.5f} times {number(radius, 1)}", mu_n * radius, 1, "mm", "mechanics"),
        Formula("Half side of the square with the area of the contact", "(sqrt(pi) phi) / 4", f"(sqrt(pi) times {phi}) / 4", bearing.contact_half_side, 2, "mm", f"{_PAPER}, Eq. (12)"),
        *(() if heating.name == "none" else (Formula("Factor before the integral of the temperature, in °C mm √s / N", "sqrt(D) / (k sqrt(pi))", f"sqrt({heating.diffusivity:.10g}) / ({heating.conductivity:.10g} times sqrt(pi))", heating.rise_factor, 5, "", f"{_PAPER}, Eq. (11)"),)),
    )  # fmt: skip
