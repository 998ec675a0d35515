"""Displacement and energy from the pulses of the ground velocity: Li et al. (2020), section 6.1, Eqs (17)-(25).

Within a pulse the ground's velocity is two straight lines and the structure's is one: from that of the ground at the start, which
is conservative, Eq. (17), with the slope that friction gives it. All slopes are taken with the sign that makes kg_i positive, so that kg_(i+1) is negative.
"""

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.methods.li_2020.constants import LI_2020, Constants
from dcfp.methods.pulses import PulsePrediction, Pulses


def structure_slope(ground_slope: FloatArray, friction_deceleration: float) -> FloatArray:
    """Slope ku_i of the structure's velocity [mm/s2]: Eq. (19).

    `ground_slope` kg_i and `friction_deceleration` mu_n g [mm/s2].
    """
    k_g = ground_slope
    return friction_deceleration * np.sign(k_g)


def displacement_change(
    change: FloatArray, slope: FloatArray, next_slope: FloatArray, structure_slope: FloatArray
) -> FloatArray:
    """Change of displacement dy_pre between two of its peaks [mm]: Eq. (20), for 0 < ku/kg <= 1.

    `change` dvg_i [mm/s], `slope` kg_i, `next_slope` kg_(i+1) and `structure_slope` ku_i [mm/s2].
    """
    dv_g, k_g, k_next, k_u = change, slope, next_slope, structure_slope
    return (k_g - k_u) * (k_g - k_next) / (2.0 * k_g**2 * (k_u - k_next)) * dv_g**2


def hysteretic_energy(
    displacement_change: FloatArray, structure_slope: FloatArray, mass: float
) -> FloatArray:
    """Energy dissipated dEhr_pre [N mm]: Eqs (21) and (25), the work of the friction force on dy_pre [mm].

    `structure_slope` ku_i [mm/s2], `mass` [t].
    """
    dy, k_u = displacement_change, structure_slope
    return mass * np.abs(k_u) * np.abs(dy)


def input_energy(
    change: FloatArray, slope: FloatArray, structure_slope: FloatArray, mass: float
) -> FloatArray:
    """Energy that the ground has put in when it reaches its peak, dE_pre [N mm]: Eq. (22).

    `change` dvg_i [mm/s], `slope` kg_i and `structure_slope` ku_i [mm/s2], `mass` [t].
    """
    dv_g, k_g, k_u = change, slope, structure_slope
    return 0.5 * mass * (1.0 - k_u / k_g) * dv_g**2


def input_velocity(change: FloatArray, slope: FloatArray, structure_slope: FloatArray) -> FloatArray:
    """Equivalent velocity V_dE_pre of the input energy [mm/s]: Eq. (23); arguments as in `input_energy`."""
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

    A pulse with ku/kg above 1, in which the ground is slower to gather speed than friction would let the structure be,
    moves nothing: displacement and energies are zero. The paper says nothing of that case; with straight lines the structure keeps up with the ground.
    """
    sign = np.sign(pulses.mean_accelerations)
    k_g = sign * pulses.mean_accelerations
    k_u = structure_slope(k_g, constants.friction_deceleration)
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
