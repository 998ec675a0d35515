"""The same from a pulse's velocity change and slope alone: Li et al. (2020), section 6.2, Eqs (26)-(28)."""

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.methods.li_2020.constants import LI_2020, Constants
from dcfp.methods.pulses import PulsePrediction, Pulses


def next_slope(slope: FloatArray, fall_ratio: float) -> FloatArray:
    """Slope kg_(i+1) of the ground velocity after the peak [mm/s2]: Eq. (26).

    `slope` kg_i before it [mm/s2]; `fall_ratio` eps [-].
    """
    return -fall_ratio * slope


def absorbed_velocity_ratio(ratio: FloatArray, fall_ratio: float) -> FloatArray:
    """V_dEhr_pre over V_dE_pre [-]: Eq. (27), and 1 where ku/kg exceeds 1.

    `ratio` ku/kg [-]; `fall_ratio` eps [-].
    """
    eps = fall_ratio
    return np.where(ratio > 1.0, 1.0, np.sqrt((1.0 + eps) * ratio / (eps + ratio)))


def input_velocity(change: FloatArray, friction_deceleration: float, average_slope: float) -> FloatArray:
    """Equivalent velocity V_dE_pre of the input energy [mm/s]: Eq. (28).

    `change` dvg_i [mm/s]; `friction_deceleration` |ku| = mu_n g and `average_slope` kg_ave [mm/s2].
    """
    k_u, k_ave = friction_deceleration, average_slope
    return np.sqrt(1.0 - k_u / k_ave) * np.abs(change)


def displacement_change(hysteretic_velocity: FloatArray, friction_deceleration: float) -> FloatArray:
    """Change of displacement dy_pre [mm] whose friction work has this equivalent velocity [mm/s]: Figure 21.

    `friction_deceleration` mu_n g [mm/s2].
    """
    return hysteretic_velocity**2 / (2.0 * friction_deceleration)


def check_slope(constants: Constants) -> None:
    """Check that Eq. (28) has a meaning.

    Raises
    ------
    InputError
        If mu_n g is not below kg_ave.
    """
    if not constants.slides_on_average:
        msg = (
            f"The simplified and the design method need mu_n g, {constants.friction_deceleration:.0f} mm/s2, to be below"
            f" the average slope of {constants.average_slope:.0f} mm/s2; take a nominal coefficient below"
            f" {constants.average_slope / constants.gravity:.4f}."
        )
        raise InputError(msg)


def predict_simplified(pulses: Pulses, constants: Constants = LI_2020) -> PulsePrediction:
    """Return what every pulse of a record does by itself: Li et al. (2020), section 6.2.

    Raises
    ------
    InputError
        If mu_n g is not below kg_ave.
    """
    check_slope(constants)
    k_u = constants.friction_deceleration
    ratio = k_u / np.abs(pulses.mean_accelerations)
    put_in = input_velocity(pulses.changes, k_u, constants.average_slope)
    dissipated = put_in * absorbed_velocity_ratio(ratio, constants.fall_ratio)
    return PulsePrediction(pulses, displacement_change(dissipated, k_u), put_in, dissipated)
