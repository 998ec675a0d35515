"""The same from a pulse's velocity change and slope alone: Li et al. (2020), section 6.2, Eqs (26)-(28)."""

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.methods.li_2020.constants import LI_2020, PAPER, SIMPLIFIED, Constants
from dcfp.methods.li_2020.pulse_method import printed_velocities
from dcfp.methods.method import Information, Look, register
from dcfp.methods.prediction import Ground, Methods, Predicted, PredictionMethod
from dcfp.methods.pulses import PulsePrediction, Pulses
from dcfp.schema.formulas import Formula, number


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


def _predict(ground: Ground, methods: Methods) -> Predicted | None:
    if not methods.constants.slides_on_average:
        return None
    by_pulse = predict_simplified(ground.pulses(methods.threshold), methods.constants)
    return Predicted(by_pulse.largest, by_pulse)


def dissipated_formula(symbols: str, numbers: str, velocity: float, equation: str) -> Formula:
    """Return the equivalent velocity of the energy dissipated [mm/s], of which the right side is given."""
    left = 'V_(Delta E "hr") = V_(Delta E)'
    name = "Equivalent velocity of the energy dissipated"
    return Formula(name, f"{left} {symbols}".rstrip(), numbers, velocity, 1, "mm/s", f"{PAPER}, {equation}")


def change_formula(hysteretic_velocity: float, friction: str, change: float, equation: str) -> Formula:
    """Return the change of displacement [mm] from the energy dissipated; `friction` mu_n g in digits."""
    numbers = f"{number(hysteretic_velocity, 1)}^2 / (2 times {friction})"
    symbols = 'Delta y = V_(Delta E "hr")^2 / (2 k_u)'
    return Formula("Change of displacement", symbols, numbers, change, 1, "mm", f"{PAPER}, {equation}")


def _formulas(ground: Ground, methods: Methods) -> tuple[Formula, ...]:
    """Return the governing pulse with its numbers; nothing where the method cannot be used."""
    predicted, constants = _predict(ground, methods), methods.constants
    if predicted is None or predicted.by_pulse is None or predicted.by_pulse.governing is None:
        return ()
    pulses, i = predicted.by_pulse.pulses, predicted.by_pulse.governing
    said, slope = predicted.by_pulse.of(i), abs(float(pulses.mean_accelerations[i]))
    dv, speeds = abs(float(pulses.changes[i])), printed_velocities(pulses, i)
    ratio = constants.friction_deceleration / slope
    u, r, put_in = (
        number(constants.friction_deceleration, 1),
        number(ratio, 3),
        number(said.input_velocity, 1),
    )
    eps, ave = f"{constants.fall_ratio:g}", f"{constants.average_slope:g}"
    absorbed = ("sqrt(((1 + epsilon) k_u / k_g) / (epsilon + k_u / k_g))", f"{put_in} times sqrt(((1 + {eps}) times {r}) / ({eps} + {r}))")  # fmt: skip
    return (
        Formula("Change of ground velocity of the governing pulse", "Delta v_g = v_(g,i) - v_(g,i-1)", f"{speeds[1]} - ({speeds[0]})", dv, 1, "mm/s", f"{PAPER}, Eq. (14)"),
        Formula("Ratio of the slopes", "k_u / k_g", f"{u} / {number(slope, 1)}", ratio, 3, "", f"{PAPER}, section 6.2"),
        Formula("Equivalent velocity of the energy put in", 'V_(Delta E) = sqrt(1 - k_u / k_(g,"ave")) thin Delta v_g', f"sqrt(1 - {u} / {ave}) times {number(dv, 1)}", said.input_velocity, 1, "mm/s", f"{PAPER}, Eq. (28)"),
        dissipated_formula(*(absorbed if ratio <= 1.0 else ("", put_in)), said.hysteretic_velocity, "Eqs (26), (27)"),
        change_formula(said.hysteretic_velocity, u, said.displacement_change, "Figure 21"),
    )  # fmt: skip


SIMPLIFIED_METHOD = register(
    PredictionMethod(
        key="simplified",
        name=SIMPLIFIED,
        head="simpl.",
        knows=(Information.BLIND, Information.INFORMED),
        citations=("li_2020",),
        look=Look("^", "ochre", 1.25, order=3),
        predict=_predict,
        formulas=_formulas,
    )
)
