"""The two equivalent-linear methods and the energy balance of the AIJ recommendations for isolated buildings (2016), and the spectrum of the notifications (2000).

The recommendations themselves were not read: Li et al. (2020), section 2, describe the methods, and the equations follow from that. F_h is that of
Notification 2009 and agrees in five sources; its floor of 0.4 is in one, word for word. The part of 0.8 of the loop's damping was found nowhere (the calculation
basis of matsumok/Squid-N takes the whole).
"""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Annotated, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from dcfp.arrays import FloatArray
from dcfp.methods.code import (
    MECHANICS,
    OF_RECORD,
    CodeInputs,
    CodeMethod,
    CodeResult,
    decimals_of,
    demand_formula,
    equivalent_formulas,
    iterated,
    millimetres,
    shear_formula,
)
from dcfp.methods.equivalent_linear import PendulumWithFriction, halved
from dcfp.methods.method import Look
from dcfp.methods.spectra.elastic import DesignSpectrum, ElasticSpectrum, velocity
from dcfp.schema.declared import declared
from dcfp.schema.formulas import Formula, number
from dcfp.schema.parameters import POSITIVE, Parameter
from dcfp.schema.units import NONE

METHOD_1, METHOD_2, ENERGY_BALANCE = "AIJ method 1", "AIJ method 2", "AIJ energy balance"
#: Part of the damping of a steady loop that counts in an earthquake [-].
_LOOP_PART = 0.8
#: Least damping correction [-].
_LEAST_CORRECTION = 0.4
#: Shortest period over which the velocity of a spectrum is averaged for method 2 [s], and number of periods of that mean.
_SHORTEST, _PERIODS = 2.0, 25
#: Steady loops at the largest displacement that dissipate the energy of the earthquake [-]: Akiyama (1985).
LOOPS = 2.0
UNCONFIRMED = ("the part of 0.8 of the loop's damping", "the least F_h of 0.4, which one source gives")
_WHICH_ENERGY = "two loops at the largest displacement, and which V_E belongs to them"


def equivalent_damping(pendulum: PendulumWithFriction, displacement: float) -> float:
    """Damping ratio h_eq = 0.8 / (4 pi) dW / W [-] at a displacement [mm]: 0.8 of that of the steady loop, unconfirmed."""
    return _LOOP_PART * pendulum.effective_damping(displacement)


def damping_correction(damping: float) -> float:
    """Factor F_h = 1.5 / (1 + 10 h) [-] at a damping ratio [-], at least 0.4 (one source); above 1 only below a damping of 5 %."""
    return max(1.5 / (1.0 + 10.0 * damping), _LEAST_CORRECTION)


def method_1(pendulum: PendulumWithFriction, spectrum: ElasticSpectrum) -> CodeResult:
    """Iterate on equivalent period and damping against a response spectrum.

    Raises
    ------
    AnalysisError
        If the iteration has no solution.
    """
    found = iterated(METHOD_1, pendulum, spectrum, damping_correction, _LOOP_PART)
    return replace(found, unconfirmed=(*found.unconfirmed, *UNCONFIRMED))


def reduction_curve(ratio: FloatArray) -> tuple[FloatArray, FloatArray]:
    r"""Return displacement and base shear over those of the frictionless pendulum under a constant velocity spectrum [-], shape (n,).

    `ratio` is alpha = mu R / D [-], the friction over the pendulum's force. With :math:`\omega_{eq} = \omega_f \sqrt{1 + \alpha}` and h_eq, which
    depends on alpha alone,

    .. math:: D / D_f = F_h / \sqrt{1 + \alpha}, \qquad Q / Q_f = F_h \sqrt{1 + \alpha}
    """
    damping = _LOOP_PART * 2.0 / np.pi * ratio / (1.0 + ratio)
    F_h = np.array([damping_correction(float(h)) for h in np.atleast_1d(damping)])
    return F_h / np.sqrt(1.0 + ratio), F_h * np.sqrt(1.0 + ratio)


def method_2(pendulum: PendulumWithFriction, pseudo_velocity: float) -> CodeResult:
    """Read the response off the reduction curve of a velocity spectrum that is constant over the period, without iteration on a spectrum.

    `pseudo_velocity` S_v at a damping of 5 % [mm/s].
    """
    S_v = POSITIVE.checked(pseudo_velocity, "The pseudo-velocity [mm/s]")
    free = S_v / pendulum.free_frequency

    def displacement(alpha: float) -> float:
        return free * float(reduction_curve(np.array([alpha]))[0][0])

    # the point of the curve whose alpha is that of the bearing at its displacement: alpha D(alpha) = mu R
    D = displacement(halved(lambda alpha: alpha * displacement(alpha) < pendulum.rest, 1e-12, 1e12))
    return CodeResult(
        method=METHOD_2,
        displacement=D,
        base_shear=pendulum.force(D),
        period=pendulum.effective_period(D),
        damping=equivalent_damping(pendulum, D),
        unconfirmed=UNCONFIRMED,
    )


def energy_balance(
    pendulum: PendulumWithFriction, equivalent_velocity: float, loops: float = LOOPS
) -> CodeResult:
    r"""Return the displacement at which spring and friction take up the energy of the earthquake.

    .. math:: \tfrac12 k_f D^2 + 4 n_1 \mu W D = \tfrac12 M V_E^2

    `equivalent_velocity` V_E [mm/s]; `loops` n_1 [-], two steady loops at the largest displacement. With
    :math:`\omega_f = \sqrt{g/R}` and :math:`a = \mu g / (\omega_f V_E)`, :math:`D \omega_f / V_E = \sqrt{(4 n_1 a)^2 + 1} - 4 n_1 a`.
    """
    V_E = POSITIVE.checked(equivalent_velocity, "The equivalent velocity V_E [mm/s]")
    n_1 = POSITIVE.checked(loops, "The number of loops")
    omega = pendulum.free_frequency
    a = pendulum.friction * pendulum.radius * omega / V_E  # mu g / (omega V_E), with g = omega^2 R
    b = 4.0 * n_1 * a
    D = V_E / omega / (b + math.hypot(b, 1.0))  # the difference of the roots, without cancelling
    return CodeResult(ENERGY_BALANCE, D, pendulum.force(D))


def constant_velocity(spectrum: ElasticSpectrum, pendulum: PendulumWithFriction) -> float:
    """Return the level of a velocity spectrum as if it were constant [mm/s]: its mean from 2 s to the period of the pendulum."""
    longest = max(pendulum.free_period, _SHORTEST)
    return float(velocity(spectrum, np.linspace(_SHORTEST, longest, _PERIODS)).mean())


def _remarks_2(results: Sequence[CodeResult], inputs: CodeInputs) -> tuple[str, ...]:
    """Return the level that method 2 rests on."""
    period, longest = results[0].period, max(inputs.pendulum.free_period, _SHORTEST)
    level = constant_velocity(inputs.spectrum, inputs.pendulum)
    outside = period is not None and not _SHORTEST <= period <= longest
    note = ", a band in which its own effective period is not" if outside else ""
    return (f"S_v {level:.0f} mm/s, the mean from {_SHORTEST:g} to {longest:.1f} s{note}.",)


def _remarks_energy(results: Sequence[CodeResult], inputs: CodeInputs) -> tuple[str, ...]:
    """Return the V_E that the energy balance rests on."""
    del results
    words = (
        "largest relative input energy at the period of the pendulum and a damping of 10 %"
        if inputs.energy_velocity is not None or inputs.motion is not None
        else "the largest pseudo-velocity of the spectrum, which is a lower bound"
    )
    return (f"V_E {inputs.input_velocity:.0f} mm/s: {words}.",)


def _correction_formula(h: float) -> Formula:
    reduction, least = damping_correction(h), f"{_LEAST_CORRECTION:g}"
    is_least = reduction > 1.5 / (1.0 + 10.0 * h)
    return Formula(f"Damping correction, at least {least}", f'F_h = max(1.5 / (1 + 10 h_"eq"), {least})', f"max(1.5 / (1 + 10 times {number(h, 4)}), {least})", reduction, 4, "", "Notification 2009 (Japan)", confirmed=not is_least)  # fmt: skip


def _formulas_1(result: CodeResult, inputs: CodeInputs) -> tuple[Formula, ...]:
    demand, D, h = demand_formula(result, inputs), result.displacement, result.damping or 0.0
    loop, source, part = inputs.pendulum.effective_damping(D), "AIJ (2016), method 1", f"{_LOOP_PART:g}"
    reduction = number(damping_correction(h), 4)
    return (
        *equivalent_formulas(result, inputs, 'T_"eq"', "h", source),
        Formula("Damping that counts", f'h_"eq" = {part} h', f"{part} times {number(loop, 4)}", h, 4, "", source, confirmed=False),
        demand,
        _correction_formula(h),
        Formula("Displacement", 'D = F_h thin S_d (T_"eq")', f"{reduction} times {millimetres(demand.value)}", D, decimals_of(D), "mm", source),
        shear_formula(result, inputs, source, "Q / W"),
    )  # fmt: skip


def _formulas_2(result: CodeResult, inputs: CodeInputs) -> tuple[Formula, ...]:
    pendulum, D, h = inputs.pendulum, result.displacement, result.damping or 0.0
    level, omega = constant_velocity(inputs.spectrum, pendulum), pendulum.free_frequency
    alpha, source, part = pendulum.rest / D, "AIJ (2016), method 2", f"{_LOOP_PART:g}"
    a, reduction, radius = number(alpha, 4), number(damping_correction(h), 4), number(pendulum.radius, 1)
    return (
        Formula("Level of the velocity spectrum, its mean from 2 s to the period of the pendulum", "S_v", "", level, 1, "mm/s", OF_RECORD),
        Formula("Frequency of the pendulum", "omega_f = sqrt(g / R)", f"sqrt(9806.65 / {radius})", omega, 5, "rad/s", MECHANICS),
        Formula("Friction over the pendulum's force", "alpha = (mu_n R) / D", f"({pendulum.friction:.5f} times {radius}) / {millimetres(D)}", alpha, 4, "", source),
        Formula("Damping that counts", f'h_"eq" = {part} times 2 / pi alpha / (1 + alpha)', f"{part} times 2 / pi times {a} / (1 + {a})", h, 4, "", source, confirmed=False),
        _correction_formula(h),
        Formula("Displacement", "D = S_v / omega_f F_h / sqrt(1 + alpha)", f"{number(level, 1)} / {number(omega, 5)} times {reduction} / sqrt(1 + {a})", D, decimals_of(D), "mm", source),
        shear_formula(result, inputs, source, "Q / W"),
    )  # fmt: skip


def _formulas_energy(result: CodeResult, inputs: CodeInputs) -> tuple[Formula, ...]:
    pendulum, D, source = inputs.pendulum, result.displacement, "AIJ (2016), energy balance"
    V_E, omega = inputs.input_velocity, pendulum.free_frequency
    b = 4.0 * LOOPS * pendulum.friction * pendulum.radius * omega / V_E
    radius, v, w, b_digits = number(pendulum.radius, 1), number(V_E, 1), number(omega, 5), number(b, 4)
    return (
        Formula("Equivalent velocity of the record's input energy, at the period of the pendulum and a damping of 10 %", "V_E", "", V_E, 1, "mm/s", f"{OF_RECORD}; Akiyama (1985)", confirmed=False),
        Formula("Frequency of the pendulum", "omega_f = sqrt(g / R)", f"sqrt(9806.65 / {radius})", omega, 5, "rad/s", MECHANICS),
        Formula("Work of friction in two loops over the energy", "b = (8 mu_n R omega_f) / V_E", f"(8 times {pendulum.friction:.5f} times {radius} times {w}) / {v}", b, 4, "", source, confirmed=False),
        Formula("Displacement, from the balance of energies", "D = V_E / omega_f (sqrt(b^2 + 1) - b)", f"{v} / {w} times 1 / ({b_digits} + sqrt({b_digits}^2 + 1))", D, decimals_of(D), "mm", source),
        shear_formula(result, inputs, source, "Q / W"),
    )  # fmt: skip


AIJ_1 = CodeMethod(
    key="aij1",
    name=METHOD_1,
    citations=("aij_2016",),
    look=Look("h", "grey", order=3),
    calculate=lambda inputs: method_1(inputs.pendulum, inputs.spectrum),
    formulas=_formulas_1,
)
AIJ_2 = CodeMethod(
    key="aij2",
    name=METHOD_2,
    citations=("aij_2016",),
    look=Look("P", "ink", order=3),
    calculate=lambda inputs: method_2(inputs.pendulum, constant_velocity(inputs.spectrum, inputs.pendulum)),
    remarks=_remarks_2,
    formulas=_formulas_2,
)
AIJ_ENERGY = CodeMethod(
    key="aij-energy",
    name=ENERGY_BALANCE,
    citations=("aij_2016", "akiyama_1985"),
    look=Look("X", "red", order=4),
    calculate=lambda inputs: replace(
        energy_balance(inputs.pendulum, inputs.input_velocity), unconfirmed=(_WHICH_ENERGY,)
    ),
    remarks=_remarks_energy,
    formulas=_formulas_energy,
)


#: Corner periods [s] and levels [m/s2] of the spectrum on the engineering bedrock.
_RISE_END, _PLATEAU_END, _AT_ZERO, _SLOPE, _PLATEAU, _FALL = 0.16, 0.64, 3.2, 30.0, 8.0, 5.12
#: Amplification of soil class 1: largest, where it begins to fall [s], and least.
_CLASS_1 = (1.5, 0.576, 1.35)
#: Of classes 2 and 3: largest at short periods, and at long ones.
_SHORT, _LONG = 1.5, {2: 2.025, 3: 2.7}


@declared
class Notification2000Spectrum(DesignSpectrum):
    """Spectrum on the engineering bedrock times the amplification of the soil: Notifications 1457, 1461 and 2009 (2000), which were not read.

    The spectrum on the bedrock agrees in three public programs (the calculation basis of matsumok/Squid-N, a ``soil.py`` and a ``japan.js``), the amplification
    of all soil classes in the last two. Published points of class 1, and one of class 2, are in the tests.
    """

    noun = "a spectrum of Notification 1457"
    option: ClassVar[str] = "japan"
    words: ClassVar[str] = "very rare earthquake of Notification 1457 on soil class 1, 2 or 3"

    soil: Annotated[int, Parameter("soil class", NONE, 1, 3, more="1 is hard, 3 soft")] = 2
    zone: Annotated[float, Parameter("zone factor", NONE, 0.1, 10.0, symbol="Z", option=False)] = 1.0
    level: Annotated[
        float, Parameter("level, 0.2 for the rare earthquake", NONE, 0.01, 10.0, option=False)
    ] = 1.0

    @property
    def name(self) -> str:
        """What to call it."""
        return f"Notification 1457, soil {self.soil}"

    def acceleration(self, period: ArrayLike) -> FloatArray:
        """Pseudo-acceleration at a damping of 5 % [mm/s2] at a period [s]."""
        T = np.maximum(np.asarray(period, dtype=np.float64), 1e-9)
        rising = _AT_ZERO + _SLOPE * T
        bedrock = np.where(T < _RISE_END, rising, np.where(T < _PLATEAU_END, _PLATEAU, _FALL / T))
        return np.asarray(self.level * self.zone * bedrock * self.amplification(T) * 1e3)

    def amplification(self, period: FloatArray) -> FloatArray:
        """Amplification G_s of the soil [-] at a period [s]."""
        T = period
        if self.soil == 1:
            most, begins, least = _CLASS_1
            return np.asarray(np.clip(most * begins / T, least, most))
        return np.asarray(np.clip(_SHORT * T / _PLATEAU_END, _SHORT, _LONG[self.soil]))
