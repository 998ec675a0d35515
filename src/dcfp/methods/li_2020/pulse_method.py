"""Displacement and energy from the pulses of the ground velocity: Li et al. (2020), section 6.1, Eqs (17)-(25).

Within a pulse the ground's velocity is two straight lines and the structure's is one: from that of the ground at the start, which
is conservative, Eq. (17), with the slope that friction gives it. All slopes are taken with the sign that makes kg_i positive, so that kg_(i+1) is negative.
"""

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.methods.li_2020.cautions import cautions
from dcfp.methods.li_2020.constants import LI_2020, PAPER, PULSE, Constants
from dcfp.methods.method import Information, Look
from dcfp.methods.prediction import Ground, Methods, Predicted, PredictionMethod
from dcfp.methods.pulses import PulsePrediction, Pulses
from dcfp.schema.formulas import Formula, number


def displacement_change(
    change: FloatArray, slope: FloatArray, next_slope: FloatArray, structure_slope: FloatArray
) -> FloatArray:
    """Change of displacement dy_pre between two of its peaks [mm]: Eq. (20), for 0 < ku/kg <= 1.

    `change` dvg_i [mm/s], `slope` kg_i, `next_slope` kg_(i+1) and `structure_slope` ku_i [mm/s2].
    """
    dv_g, k_g, k_next, k_u = change, slope, next_slope, structure_slope
    return (k_g - k_u) * (k_g - k_next) / (2.0 * k_g**2 * (k_u - k_next)) * dv_g**2


def input_velocity(change: FloatArray, slope: FloatArray, structure_slope: FloatArray) -> FloatArray:
    """Equivalent velocity V_dE_pre of the input energy [mm/s]: Eq. (23); arguments as in `displacement_change`."""
    dv_g, k_g, k_u = change, slope, structure_slope
    return np.sqrt(1.0 - k_u / k_g) * np.abs(dv_g)


def hysteretic_velocity(
    change: FloatArray, slope: FloatArray, next_slope: FloatArray, structure_slope: FloatArray
) -> FloatArray:
    """Equivalent velocity V_dEhr_pre of the dissipated energy [mm/s]: Eq. (24); arguments as in `displacement_change`."""
    k_g, k_next, k_u = slope, next_slope, structure_slope
    absorbed = k_u * (k_g - k_next) / (k_g * (k_u - k_next))
    return input_velocity(change, slope, structure_slope) * np.sqrt(absorbed)


def amplification(ratio: FloatArray, constants: Constants = LI_2020) -> FloatArray:
    """Factor [-] on the velocities and slopes of a pulse before Eqs (20)-(25) are applied: Figure 17, for 0.8 <= ku/kg <= 1.

    `ratio` ku/kg [-]. The paper says it of Eq. (20); the energies here are those of the same amplified pulse.
    """
    amplified = (constants.amplified_from <= ratio) & (ratio <= 1.0)
    return np.where(amplified, constants.amplification, 1.0)


def predict_from_pulses(pulses: Pulses, constants: Constants = LI_2020) -> PulsePrediction:
    """Return what every pulse of a record does by itself: Li et al. (2020), section 6.1.

    A pulse with ku/kg above 1 moves nothing: the paper says nothing of that case; with straight lines the structure keeps up with the ground.
    """
    slope = pulses.mean_accelerations
    sign, k_g = np.sign(slope), np.abs(slope)
    k_u = np.full_like(k_g, constants.friction_deceleration)  # Eq. (19), with the sign of kg
    factor = amplification(k_u / k_g, constants)
    slides = k_u <= k_g
    k_g = np.where(slides, factor * k_g, 1.0)  # any number where nothing slides
    k_u = np.where(slides, k_u, 1.0)
    k_next = factor * sign * pulses.next_mean_accelerations
    dv_g = factor * np.abs(pulses.changes)
    return PulsePrediction(
        pulses=pulses,
        displacement_change=np.where(slides, displacement_change(dv_g, k_g, k_next, k_u), 0.0),
        input_velocity=np.where(slides, input_velocity(dv_g, k_g, k_u), 0.0),
        hysteretic_velocity=np.where(slides, hysteretic_velocity(dv_g, k_g, k_next, k_u), 0.0),
    )


def _of_pulses(pulses: Pulses, methods: Methods) -> PulsePrediction:
    return predict_from_pulses(pulses, methods.constants)


def _predict(ground: Ground, methods: Methods) -> Predicted:
    by_pulse = _of_pulses(ground.pulses(methods.threshold), methods)
    name = "" if ground.motion is None else ground.motion.name
    remark = cautions(PULSE, ground, methods, by_pulse, predict_from_pulses)
    if by_pulse.pulses.count == 0:
        remark = (f"{name}: the ground velocity has no pulse, so nothing is predicted to move.",)
    elif by_pulse.largest.displacement_change == 0.0:
        remark = (
            f"{name}: by the pulse method nothing moves, since every pulse has a ku/kg above 1; its straight lines leave out that the"
            " ground accelerates more in the middle of a pulse.",
        )
    return Predicted(by_pulse.largest, by_pulse, remark)


def printed_velocities(pulses: Pulses, pulse: int) -> list[str]:
    """Return the ground velocities [mm/s] at the three peaks of a pulse, mirrored so that kg is positive, as they are printed."""
    sign = float(np.sign(pulses.mean_accelerations[pulse]))
    return [number(sign * float(v), 2) for v in pulses.velocities[pulse : pulse + 3]]


def _formulas(ground: Ground, methods: Methods) -> tuple[Formula, ...]:
    """Return the governing pulse with its numbers; nothing where nothing is predicted to move."""
    pulses, constants, m = ground.pulses(methods.threshold), methods.constants, methods.system.bearing.mass
    by_pulse = predict_from_pulses(pulses, constants)
    i = by_pulse.governing
    if i is None:
        return ()
    said, sign, k_u = by_pulse.of(i), np.sign(pulses.mean_accelerations[i]), constants.friction_deceleration
    dv, before, after = (
        float(sign * values[i])
        for values in (pulses.changes, pulses.mean_accelerations, pulses.next_mean_accelerations)
    )
    f = float(amplification(np.array([k_u / before]), constants)[0])
    taken = m * k_u * said.displacement_change / 1e6
    put_in = 0.5 * m * (1.0 - k_u / (f * before)) * (f * dv) ** 2 / 1e6
    u, g, n, d = (number(value, 1) for value in (k_u, f * before, f * after, f * dv))
    amplified = "" if f == 1.0 else " of the amplified pulse"
    times = [number(float(at), 4) for at in pulses.times[i : i + 3]]
    speeds, mass, dy = printed_velocities(pulses, i), number(m, 2), number(said.displacement_change, 1)
    gravity, v_in = f"{constants.gravity:.10g}", number(said.input_velocity, 1)
    return (
        Formula("Change of ground velocity to the peak of the pulse", "Delta v_g = v_(g,i) - v_(g,i-1)", f"{speeds[1]} - ({speeds[0]})", dv, 1, "mm/s", f"{PAPER}, Eq. (14)"),
        Formula("Slope before the peak", "k_g = (Delta v_g) / (t_i - t_(i-1))", f"{number(dv, 1)} / ({times[1]} - {times[0]})", before, 1, "mm/s²", f"{PAPER}, Eq. (18)"),
        Formula("Slope after the peak", "k_(g,i+1) = (v_(g,i+1) - v_(g,i)) / (t_(i+1) - t_i)", f"({speeds[2]} - ({speeds[1]})) / ({times[2]} - {times[1]})", after, 1, "mm/s²", f"{PAPER}, Eq. (18)"),
        Formula(f"Slope that friction gives the velocity of the structure, with the g of {gravity} mm/s² of these methods (elsewhere 9806.65 mm/s²)", "k_u = mu_n g", f"{constants.nominal_friction:.5f} times {gravity}", k_u, 1, "mm/s²", f"{PAPER}, Eq. (19)"),
        Formula("Ratio of the slopes", "k_u / k_g", f"{u} / {number(before, 1)}", k_u / before, 3, "", f"{PAPER}, section 6.1"),
        Formula("Factor on velocities and slopes (0.8 to 1: amplified)", "f", "", f, 2, "", f"{PAPER}, Figure 17"),
        Formula(f"Change of displacement{amplified}", "Delta y = ((k_g - k_u) (k_g - k_(g,i+1))) / (2 k_g^2 (k_u - k_(g,i+1))) (Delta v_g)^2", f"(({g} - {u}) times ({g} - ({n}))) / (2 times {g}^2 times ({u} - ({n}))) times {d}^2", said.displacement_change, 1, "mm", f"{PAPER}, Eq. (20)"),
        Formula("Equivalent velocity of the energy put in", "V_(Delta E) = sqrt(1 - k_u / k_g) thin Delta v_g", f"sqrt(1 - {u} / {g}) times {d}", said.input_velocity, 1, "mm/s", f"{PAPER}, Eq. (23)"),
        Formula("Equivalent velocity of the energy dissipated", 'V_(Delta E "hr") = V_(Delta E) sqrt((k_u (k_g - k_(g,i+1))) / (k_g (k_u - k_(g,i+1))))', f"{v_in} times sqrt(({u} times ({g} - ({n}))) / ({g} times ({u} - ({n}))))", said.hysteretic_velocity, 1, "mm/s", f"{PAPER}, Eq. (24)"),
        Formula("Energy put in", "Delta E = m / 2 (1 - k_u / k_g) (Delta v_g)^2", f"{mass} / 2 times (1 - {u} / {g}) times {d}^2 / 1000000", put_in, 2, "kN m", f"{PAPER}, Eq. (22)"),
        Formula("Energy dissipated", 'Delta E_"hr" = m k_u Delta y', f"{mass} times {u} times {dy} / 1000000", taken, 2, "kN m", f"{PAPER}, Eqs (21), (25)"),
    )  # fmt: skip


PULSE_METHOD = PredictionMethod(
    key="pulse",
    name=PULSE,
    knows=(Information.BLIND, Information.INFORMED),
    citations=("li_2020",),
    look=Look("o", "blue", order=4),
    predict=_predict,
    of_pulses=_of_pulses,
    formulas=_formulas,
    without="every pulse has a ratio above 1, so nothing is predicted to move",
)
