"""Friction laws: their equations, and the coefficient of one state worked out."""

import math
from dataclasses import dataclass

from dcfp.constants import STANDARD_GRAVITY
from dcfp.present.report.document import Formula, number
from dcfp.study.scenario import Calculation
from dcfp.system import (
    ConstantFriction,
    Constantinou1990,
    FittedFriction,
    FrictionLaw,
    Kumar2015,
    Li2020,
    Lomiento2013,
)
from dcfp.system.friction.kumar_2015 import VELOCITY_RATE

_FACTOR = 4


@dataclass(frozen=True)
class State:
    """Where a coefficient is worked out.

    Attributes
    ----------
    pressure
        [N/mm2].
    speed
        As the law means it [mm/s].
    temperature
        Of the contact [degC].
    """

    pressure: float
    speed: float
    temperature: float


def law_equations(law: FrictionLaw) -> tuple[str, ...]:
    """Return the equations of a law as mathematics; none for a law that is not built in."""
    if isinstance(law, ConstantFriction):
        return ('mu = "constant"',)
    if isinstance(law, Li2020):
        return tuple(
            equation
            for equation, used in (
                ("mu = mu_0 gamma alpha beta", True),
                ("gamma = 2.03 sigma^(-0.19) + 0.068", law.pressure_dependent),
                ("alpha = 1 - 0.55 exp(-0.019 v)", law.velocity_dependent),
                ("beta = 1.13 exp(-0.007 T)", law.temperature_dependent),
            )
            if used
        )
    if isinstance(law, Kumar2015):
        heat = law.temperature_law
        return (
            'mu = mu_"ref" k_p k_v k_T',
            "k_p = 0.7^(0.02 (p - p_0))",
            f"k_v = 1 - 0.5 exp(-{VELOCITY_RATE:g} v)",
            f"k_T = {heat.scale:g} times 0.7^({heat.power:g} T) + {heat.floor:g}",
        )
    if isinstance(law, Constantinou1990):
        return ('mu = f_"max" - (f_"max" - f_"min") exp(-a v)',)
    if isinstance(law, FittedFriction):
        return (
            "mu = mu_0 gamma alpha beta",
            'gamma = (1 - c) (p / p_"ref")^(-n) + c',
            "alpha = 1 - a exp(-b v)",
            'beta = exp(-r (T - T_"ref"))',
        )
    if isinstance(law, Lomiento2013):
        return (
            "mu = mu_0 f_N f_v f_c",
            'f_N = exp(-p / p_"ref")',
            'f_v = gamma + (1 - gamma) exp(-v / v_"ref")',
            'f_c = exp(-(c / c_"ref")^beta)',
        )
    return ()


def friction_formulas(law: FrictionLaw, state: State, source: str) -> tuple[Formula, ...]:
    """Return the factors of a law and its coefficient at a state, with numbers; none for a law that wears off or is not built in."""
    p, v, warm = number(state.pressure, 1), number(state.speed, 1), number(state.temperature, 1)
    pressure = float(law.pressure_factor(state.pressure))
    velocity = float(law.velocity_factor(state.speed))
    temperature = float(law.temperature_factor(state.temperature))
    coefficient = float(law.coefficient(state.pressure, state.speed, state.temperature))
    factors: list[tuple[str, str, str, str, float, str]] = []
    if isinstance(law, ConstantFriction):
        return (Formula("Coefficient of friction", "mu", "", coefficient, _FACTOR, "", source),)
    if isinstance(law, Constantinou1990):
        low, high = f"{law.slow:g}", f"{law.fast:g}"
        return (
            Formula(
                "Coefficient of friction",
                law_equations(law)[0],
                f"{high} - ({high} - {low}) exp(-{law.rate:g} times {v})",
                coefficient,
                _FACTOR,
                "",
                source,
            ),
        )
    if isinstance(law, Li2020):
        factors = [
            ("Factor of pressure", "gamma", "2.03 sigma^(-0.19) + 0.068", f"2.03 times {p}^(-0.19) + 0.068", pressure, ", Eq. (7)"),
            ("Factor of speed", "alpha", "1 - 0.55 exp(-0.019 v)", f"1 - 0.55 exp(-0.019 times {v})", velocity, ", Eq. (8)"),
            ("Factor of temperature", "beta", "1.13 exp(-0.007 T)", f"1.13 exp(-0.007 times {warm})", temperature, ", Eq. (9)"),
        ]  # fmt: skip
        used = (law.pressure_dependent, law.velocity_dependent, law.temperature_dependent)
        factors = [one for one, is_used in zip(factors, used, strict=True) if is_used]
    elif isinstance(law, Kumar2015):
        heat = law.temperature_law
        factors = [
            ("Factor of pressure", "k_p", "0.7^(0.02 (p - p_0))", f"0.7^(0.02 ({p} - {law.reference_pressure:g}))", pressure, ""),
            ("Factor of speed", "k_v", f"1 - 0.5 exp(-{VELOCITY_RATE:g} v)", f"1 - 0.5 exp(-{VELOCITY_RATE:g} times {v})", velocity, ""),
            ("Factor of temperature", "k_T", f"{heat.scale:g} times 0.7^({heat.power:g} T) + {heat.floor:g}", f"{heat.scale:g} times 0.7^({heat.power:g} times {warm}) + {heat.floor:g}", temperature, ""),
        ]  # fmt: skip
        used = (law.pressure_dependent, law.velocity_dependent, law.temperature_dependent)
        factors = [one for one, is_used in zip(factors, used, strict=True) if is_used]
    elif isinstance(law, FittedFriction):
        c, n, ref = f"{law.pressure_floor:g}", f"{law.pressure_exponent:g}", f"{law.reference_pressure:g}"
        start = number(law.reference_temperature, 2)
        factors = [
            ("Factor of pressure", "gamma", '(1 - c) (p / p_"ref")^(-n) + c', f"(1 - {c}) ({p} / {ref})^(-{n}) + {c}", pressure, ""),
            ("Factor of speed", "alpha", "1 - a exp(-b v)", f"1 - {law.speed_drop:g} exp(-{law.speed_rate:g} times {v})", velocity, ""),
            ("Factor of temperature", "beta", 'exp(-r (T - T_"ref"))', f"exp(-{law.temperature_rate:g} ({warm} - {start}))", temperature, ""),
        ]  # fmt: skip
    if not factors:
        return ()
    found = [
        Formula(name, f"{symbol} = {symbols}", numbers, value, _FACTOR, "", source + equation)
        for name, symbol, symbols, numbers, value, equation in factors
    ]
    reference = 'mu_"ref"' if isinstance(law, Kumar2015) else "mu_0"
    product = " ".join([reference, *(symbol for _, symbol, *_ in factors)])
    values = " times ".join([f"{law.reference:g}", *(number(value, _FACTOR) for *_, value, _ in factors)])
    last = ", Eq. (10)" if isinstance(law, Li2020) else ""
    return (
        *found,
        Formula(
            "Coefficient of friction", f"mu = {product}", values, coefficient, _FACTOR, "", source + last
        ),
    )


# The bearing worked out: Li et al. (2020), sections 4 and 5.1.


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
