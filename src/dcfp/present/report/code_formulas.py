"""The methods of codes worked out for one case: the last round of each iteration."""

import numpy as np

from dcfp.inference.case import pendulum_of
from dcfp.methods import aij_2016, asce_2016, eurocode_8, iwan_1980
from dcfp.methods.bilinear import Bilinear
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.panel import constant_velocity, input_velocity
from dcfp.methods.result import Answer
from dcfp.methods.spectra import response_spectrum
from dcfp.methods.spectra.elastic import displacement
from dcfp.schema.formulas import Formula, number
from dcfp.study.scenario import Calculation, ScenarioResult

_MECHANICS = "mechanics"


def code_formulas(calculation: Calculation, result: ScenarioResult) -> dict[str, tuple[Formula, ...]]:
    """Return the formulas of every method that has an answer, by its name."""
    pendulum = pendulum_of(calculation.setting)
    found: dict[str, tuple[Formula, ...]] = {}
    for name, said in result.case.answers.items():
        if name == asce_2016.NAME:
            found[name] = _asce(pendulum, said, result)
        elif name == eurocode_8.NAME:
            found[name] = _eurocode(pendulum, said, result)
        elif name == aij_2016.METHOD_1:
            found[name] = _method_1(pendulum, said, result)
        elif name == aij_2016.METHOD_2:
            found[name] = _method_2(pendulum, said, result)
        elif name == aij_2016.ENERGY_BALANCE:
            found[name] = _energy_balance(pendulum, said, result)
        elif name == iwan_1980.NAME:
            found[name] = _iwan(calculation, said)
    return found


def _equivalent(
    pendulum: PendulumWithFriction, said: Answer, period: str, damping: str, source: str
) -> tuple[Formula, ...]:
    """Return secant stiffness, period and damping at the displacement of an answer; `period` and `damping` are their symbols."""
    at, mu, radius = _millimetres(said.displacement), f"{pendulum.friction:.5f}", number(pendulum.radius, 1)
    stiffness = pendulum.effective_stiffness(said.displacement)
    per_metre = 1e3 * stiffness
    return (
        Formula("Effective stiffness over the weight", 'k_"eff" / W = 1 / R + mu_n / D', f"1000 times (1 / {radius} + {mu} / {at})", per_metre, 4, "1/m", _MECHANICS),
        Formula("Effective period", f'{period} = 2 pi sqrt(W / (k_"eff" g))', f"2 pi sqrt(1 / ({number(per_metre, 4)} times 9.80665))", pendulum.effective_period(said.displacement), 3, "s", source),
        Formula("Effective damping", f"{damping} = 2 / pi mu_n / (mu_n + D / R)", f"2 / pi times {mu} / ({mu} + {at} / {radius})", pendulum.effective_damping(said.displacement), 4, "", source),
    )  # fmt: skip


def _demand(said: Answer, result: ScenarioResult) -> Formula:
    """Return the ordinate of the record's spectrum at the effective period of an answer."""
    spectrum = response_spectrum(result.motion)
    ordinate = float(displacement(spectrum, np.array([said.period]))[0])
    return Formula(
        "Spectral displacement of the record at this period and a damping of 5 %",
        "S_d",
        "",
        ordinate,
        _decimals(ordinate),
        "mm",
        "spectrum of the record",
    )


def _shear(pendulum: PendulumWithFriction, said: Answer, source: str, symbol: str = "V_b / W") -> Formula:
    numbers = f"{pendulum.friction:.5f} + {_millimetres(said.displacement)} / {number(pendulum.radius, 1)}"
    return Formula(
        "Base shear over the weight", f"{symbol} = mu_n + D / R", numbers, said.base_shear, 4, "", source
    )


def _asce(pendulum: PendulumWithFriction, said: Answer, result: ScenarioResult) -> tuple[Formula, ...]:
    demand, beta = _demand(said, result), said.damping or 0.0
    factor = asce_2016.damping_factor(beta)
    return (
        *_equivalent(pendulum, said, "T_M", "beta_M", "ASCE/SEI 7-16, section 17.5"),
        demand,
        Formula("Damping factor, straight lines between", "B_M", "", factor, 4, "", "ASCE/SEI 7-16, Table 17.5-1"),
        Formula("Maximum displacement", "D_M = (S_d (T_M)) / B_M", f"{_millimetres(demand.value)} / {number(factor, 4)}", said.displacement, _decimals(said.displacement), "mm", "ASCE/SEI 7-16, Eq. (17.5-1)"),
        Formula("Least total maximum displacement", 'D_"TM" = 1.15 D_M', f"1.15 times {_millimetres(said.displacement)}", 1.15 * said.displacement, 1, "mm", "ASCE/SEI 7-16, 17.5.3.3", confirmed=False),
        _shear(pendulum, said, "ASCE/SEI 7-16, section 17.5"),
    )  # fmt: skip


def _eurocode(pendulum: PendulumWithFriction, said: Answer, result: ScenarioResult) -> tuple[Formula, ...]:
    demand, xi = _demand(said, result), said.damping or 0.0
    eta = eurocode_8.damping_correction(xi)
    return (
        *_equivalent(pendulum, said, 'T_"eff"', "xi", "EN 1998-1, 10.9.3"),
        demand,
        Formula("Damping correction, at least 0.55", "eta = max(sqrt(10 / (5 + 100 xi)), 0.55)", f"max(sqrt(10 / (5 + 100 times {number(xi, 4)})), 0.55)", eta, 4, "", "EN 1998-1, Eq. (3.6)"),
        Formula("Displacement of the centre of stiffness", 'd_"dc" = eta thin S_d (T_"eff")', f"{number(eta, 4)} times {_millimetres(demand.value)}", said.displacement, _decimals(said.displacement), "mm", "EN 1998-1, 10.9.3", confirmed=False),
        Formula("Design displacement of the devices", 'gamma_x d_"dc"', f"{eurocode_8.RELIABILITY:g} times {_millimetres(said.displacement)}", eurocode_8.RELIABILITY * said.displacement, 1, "mm", "EN 1998-1, 10.3(2)", confirmed=False),
        _shear(pendulum, said, "EN 1998-1, 10.9.3"),
    )  # fmt: skip


def _method_1(pendulum: PendulumWithFriction, said: Answer, result: ScenarioResult) -> tuple[Formula, ...]:
    demand, h = _demand(said, result), said.damping or 0.0
    reduction = aij_2016.damping_correction(h)
    loop = pendulum.effective_damping(said.displacement)
    held = reduction > 1.5 / (1.0 + 10.0 * h)
    return (
        *_equivalent(pendulum, said, 'T_"eq"', "h", "AIJ (2016), method 1"),
        Formula("Damping that counts", 'h_"eq" = 0.8 h', f"0.8 times {number(loop, 4)}", h, 4, "", "AIJ (2016), method 1", confirmed=False),
        demand,
        Formula("Damping correction, at least 0.4", 'F_h = max(1.5 / (1 + 10 h_"eq"), 0.4)', f"max(1.5 / (1 + 10 times {number(h, 4)}), 0.4)", reduction, 4, "", "Notification 2009 (Japan)", confirmed=not held),
        Formula("Displacement", 'D = F_h thin S_d (T_"eq")', f"{number(reduction, 4)} times {_millimetres(demand.value)}", said.displacement, _decimals(said.displacement), "mm", "AIJ (2016), method 1"),
        _shear(pendulum, said, "AIJ (2016), method 1", "Q / W"),
    )  # fmt: skip


def _method_2(pendulum: PendulumWithFriction, said: Answer, result: ScenarioResult) -> tuple[Formula, ...]:
    level = constant_velocity(response_spectrum(result.motion), pendulum)
    alpha, h = pendulum.rest / said.displacement, said.damping or 0.0
    reduction, omega = aij_2016.damping_correction(h), pendulum.free_frequency
    held = reduction > 1.5 / (1.0 + 10.0 * h)
    return (
        Formula("Level of the velocity spectrum, its mean from 2 s to the period of the pendulum", "S_v", "", level, 1, "mm/s", "spectrum of the record"),
        Formula("Frequency of the pendulum", "omega_f = sqrt(g / R)", f"sqrt(9806.65 / {number(pendulum.radius, 1)})", omega, 5, "rad/s", _MECHANICS),
        Formula("Friction over the pendulum's force", "alpha = (mu_n R) / D", f"({pendulum.friction:.5f} times {number(pendulum.radius, 1)}) / {_millimetres(said.displacement)}", alpha, 4, "", "AIJ (2016), method 2"),
        Formula("Damping that counts", 'h_"eq" = 0.8 times 2 / pi alpha / (1 + alpha)', f"0.8 times 2 / pi times {number(alpha, 4)} / (1 + {number(alpha, 4)})", h, 4, "", "AIJ (2016), method 2", confirmed=False),
        Formula("Damping correction, at least 0.4", 'F_h = max(1.5 / (1 + 10 h_"eq"), 0.4)', f"max(1.5 / (1 + 10 times {number(h, 4)}), 0.4)", reduction, 4, "", "Notification 2009 (Japan)", confirmed=not held),
        Formula("Displacement", "D = S_v / omega_f F_h / sqrt(1 + alpha)", f"{number(level, 1)} / {number(omega, 5)} times {number(reduction, 4)} / sqrt(1 + {number(alpha, 4)})", said.displacement, _decimals(said.displacement), "mm", "AIJ (2016), method 2"),
        _shear(pendulum, said, "AIJ (2016), method 2", "Q / W"),
    )  # fmt: skip


def _energy_balance(
    pendulum: PendulumWithFriction, said: Answer, result: ScenarioResult
) -> tuple[Formula, ...]:
    equivalent, omega = input_velocity(result.motion, pendulum), pendulum.free_frequency
    b = 4.0 * aij_2016.LOOPS * pendulum.friction * pendulum.radius * omega / equivalent
    source = "AIJ (2016), energy balance"
    return (
        Formula("Equivalent velocity of the record's input energy, at the period of the pendulum and a damping of 10 %", "V_E", "", equivalent, 1, "mm/s", "spectrum of the record; Akiyama (1985)", confirmed=False),
        Formula("Frequency of the pendulum", "omega_f = sqrt(g / R)", f"sqrt(9806.65 / {number(pendulum.radius, 1)})", omega, 5, "rad/s", _MECHANICS),
        Formula("Work of friction in two loops over the energy", "b = (8 mu_n R omega_f) / V_E", f"(8 times {pendulum.friction:.5f} times {number(pendulum.radius, 1)} times {number(omega, 5)}) / {number(equivalent, 1)}", b, 4, "", source, confirmed=False),
        Formula("Displacement, from the balance of energies", "D = V_E / omega_f (sqrt(b^2 + 1) - b)", f"{number(equivalent, 1)} / {number(omega, 5)} times 1 / ({number(b, 4)} + sqrt({number(b, 4)}^2 + 1))", said.displacement, _decimals(said.displacement), "mm", source),
        _shear(pendulum, said, source, "Q / W"),
    )  # fmt: skip


def _iwan(calculation: Calculation, said: Answer) -> tuple[Formula, ...]:
    system = Bilinear.of(calculation.scenario.model.bearing, calculation.nominal.value)
    ductility = said.steps[-1].displacement / system.yield_displacement
    factor, power = iwan_1980.PERIOD
    added, damped = iwan_1980.DAMPED
    source = iwan_1980.NAME
    start, d = number(system.initial_period, 5), number(ductility, _digits(ductility))
    capped = iwan_1980.added_damping(ductility) > (said.damping or 0.0) + 1e-9
    longest = system.initial_period * iwan_1980.lengthening(ductility) > (said.period or 0.0) * (1.0 + 1e-9)
    return (
        Formula("Period before yielding", 'T_0 = 2 pi sqrt(m / (k_"ra" + k_f))', "", system.initial_period, 5, "s", _MECHANICS),
        Formula("Ductility", "mu_d = D / r_f", f"{_millimetres(said.displacement)} / {number(system.yield_displacement, 5)}", ductility, _digits(ductility), "", source),
        Formula("Equivalent period", f'T_"eq" = T_0 (1 + {factor:g} (mu_d - 1)^{power:g})', "" if longest else f"{start} times (1 + {factor:g} times ({d} - 1)^{power:g})", said.period or 0.0, 3, "s", source, confirmed=False),
        Formula("Equivalent damping, less than critical", f'zeta_"eq" = {added:g} (mu_d - 1)^{damped:g}', "" if capped else f"{added:g} times ({d} - 1)^{damped:g}", said.damping or 0.0, 4, "", source, confirmed=False),
        Formula("Displacement of this oscillator under the record", "D", "", said.displacement, _decimals(said.displacement), "mm", "spectrum of the record"),
    )  # fmt: skip


def _decimals(length: float) -> int:
    """Return with how many decimals a length [mm] is put into a formula, so that its result comes out."""
    return 2 if length >= 10.0 else 4


def _millimetres(length: float) -> str:
    return number(length, _decimals(length))


def _digits(ductility: float) -> int:
    """Return the decimals of a ductility, which may be 2 or thousands [-]."""
    return 1 if ductility >= 100.0 else 3
