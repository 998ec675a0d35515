"""The same from a pulse's velocity change and slope alone, section 6.2, and from the PGV alone, section 6.3: Li et al. (2020), Eqs (26)-(33)."""

import math

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.methods.li_2020.cautions import cautions
from dcfp.methods.li_2020.constants import DESIGN, LI_2020, PAPER, SIMPLIFIED, Constants
from dcfp.methods.li_2020.pulse_method import printed_velocities
from dcfp.methods.method import Information, Look
from dcfp.methods.prediction import Ground, Methods, Predicted, PredictionMethod
from dcfp.methods.pulses import Prediction, PulsePrediction, Pulses
from dcfp.schema.formulas import Formula, number
from dcfp.schema.parameters import POSITIVE


def absorbed_velocity_ratio(ratio: FloatArray, fall_ratio: float) -> FloatArray:
    """V_dEhr_pre over V_dE_pre [-]: Eq. (27), which has the slope kg_(i+1) = -eps kg_i of Eq. (26), and 1 where ku/kg exceeds 1.

    `ratio` ku/kg [-]; `fall_ratio` eps [-].
    """
    eps = fall_ratio
    return np.where(ratio > 1.0, 1.0, np.sqrt((1.0 + eps) * ratio / (eps + ratio)))


def input_velocity(change: FloatArray, friction_deceleration: float, average_slope: float) -> FloatArray:
    """Equivalent velocity V_dE_pre of the input energy [mm/s]: Eq. (28), and Eq. (31) with the change of Eq. (29).

    `change` dvg_i [mm/s]; `friction_deceleration` |ku| = mu_n g and `average_slope` kg_ave [mm/s2].
    """
    k_u, k_ave = friction_deceleration, average_slope
    return np.sqrt(1.0 - k_u / k_ave) * np.abs(change)


def displacement_change(hysteretic_velocity: FloatArray, friction_deceleration: float) -> FloatArray:
    """Change of displacement dy_pre [mm] whose friction work has this equivalent velocity [mm/s]: Figure 21, and Eq. (33).

    `friction_deceleration` mu_n g [mm/s2].
    """
    return hysteretic_velocity**2 / (2.0 * friction_deceleration)


def hysteretic_velocity(
    input_velocity: float, friction_deceleration: float, slope: float, fall_ratio: float
) -> float:
    """Equivalent velocity V_dEhr_pre of the dissipated energy [mm/s]: Eq. (32), which is Eq. (27) with Eq. (30).

    `input_velocity` V_dE_pre [mm/s]; `friction_deceleration` mu_n g and `slope` kg [mm/s2]; `fall_ratio` eps [-].
    """
    k_u, k_g, eps = friction_deceleration, slope, fall_ratio
    return input_velocity * math.sqrt((1.0 + eps) * k_u / (k_u + eps * k_g)) if k_u <= k_g else input_velocity


def _check_slope(constants: Constants) -> None:
    """Check that Eq. (28) has a meaning."""
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
    _check_slope(constants)
    k_u = constants.friction_deceleration
    ratio = k_u / np.abs(pulses.mean_accelerations)
    put_in = input_velocity(pulses.changes, k_u, constants.average_slope)
    dissipated = put_in * absorbed_velocity_ratio(ratio, constants.fall_ratio)
    return PulsePrediction(pulses, displacement_change(dissipated, k_u), put_in, dissipated)


def predict_from_pgv(pgv: float, constants: Constants = LI_2020) -> Prediction:
    """Return what the largest pulse of earthquakes with a PGV [mm/s] does: Li et al. (2020), section 6.3.

    Raises
    ------
    InputError
        If the PGV is not positive, or mu_n g is not below kg_ave.
    """
    pgv = POSITIVE.checked(pgv, "The PGV [mm/s]")
    _check_slope(constants)
    k_u, k_ave = constants.friction_deceleration, constants.average_slope
    put_in = float(input_velocity(np.array(constants.velocity_change(pgv)), k_u, k_ave))
    k_g = constants.slope(pgv)
    dissipated = hysteretic_velocity(put_in, k_u, k_g, constants.fall_ratio)
    return Prediction(float(displacement_change(np.array(dissipated), k_u)), put_in, dissipated)


def friction_that_holds(allowed: float, pgv: float, constants: Constants = LI_2020) -> float | None:
    """Return the nominal coefficient mu_n with which dy_pre is `allowed` [mm] at a PGV [mm/s]: Eq. (33) turned round.

    None where no coefficient below kg_ave / g does. The radius of the plates does not come into it.

    Raises
    ------
    InputError
        If `allowed` or the PGV is not positive.
    """
    POSITIVE.checked(allowed, "The displacement to be held [mm]")
    dv, eps = constants.velocity_change(POSITIVE.checked(pgv, "The PGV [mm/s]")), constants.fall_ratio
    k_ave, k_g = constants.average_slope, constants.slope(pgv)
    # Eqs (31)-(33) together: dy = dv^2 (1 - k_u / k_ave) (1 + eps) / (2 (k_u + eps k_g)), and eps = 0 where k_u > k_g
    k_u = (dv**2 * (1.0 + eps) - 2.0 * allowed * eps * k_g) / (2.0 * allowed + dv**2 * (1.0 + eps) / k_ave)
    if k_u > k_g:
        k_u = dv**2 / (2.0 * allowed + dv**2 / k_ave)
    mu = k_u / constants.gravity
    return mu if 0.0 < mu < 1.0 else None


def _of_pulses(pulses: Pulses, methods: Methods) -> PulsePrediction | None:
    return predict_simplified(pulses, methods.constants) if methods.constants.slides_on_average else None


def _predict_simplified(ground: Ground, methods: Methods) -> Predicted | None:
    by_pulse = _of_pulses(ground.pulses(methods.threshold), methods)
    if by_pulse is None:
        return None
    remarks = cautions(SIMPLIFIED, ground, methods, by_pulse, predict_simplified)
    return Predicted(by_pulse.largest, by_pulse, remarks)


def _dissipated_formula(symbols: str, numbers: str, velocity: float, equation: str) -> Formula:
    """Return the equivalent velocity of the energy dissipated [mm/s], of which the right side is given."""
    left = 'V_(Delta E "hr") = V_(Delta E)'
    name = "Equivalent velocity of the energy dissipated"
    return Formula(name, f"{left} {symbols}".rstrip(), numbers, velocity, 1, "mm/s", f"{PAPER}, {equation}")


def _change_formula(hysteretic_velocity: float, friction: str, change: float, equation: str) -> Formula:
    """Return the change of displacement [mm] from the energy dissipated; `friction` mu_n g in digits."""
    numbers = f"{number(hysteretic_velocity, 1)}^2 / (2 times {friction})"
    symbols = 'Delta y = V_(Delta E "hr")^2 / (2 k_u)'
    return Formula("Change of displacement", symbols, numbers, change, 1, "mm", f"{PAPER}, {equation}")


def _formulas_simplified(ground: Ground, methods: Methods) -> tuple[Formula, ...]:
    """Return the governing pulse with its numbers; nothing where the method cannot be used."""
    predicted, constants = _predict_simplified(ground, methods), methods.constants
    if predicted is None or predicted.by_pulse is None or predicted.by_pulse.governing is None:
        return ()
    pulses, i = predicted.by_pulse.pulses, predicted.by_pulse.governing
    said, k_g = predicted.by_pulse.of(i), abs(float(pulses.mean_accelerations[i]))
    dv, speeds = abs(float(pulses.changes[i])), printed_velocities(pulses, i)
    k_u = constants.friction_deceleration
    ratio, put_in = k_u / k_g, number(said.input_velocity, 1)
    u, r = number(k_u, 1), number(ratio, 3)
    eps, ave = f"{constants.fall_ratio:g}", f"{constants.average_slope:g}"
    absorbed = ("sqrt(((1 + epsilon) k_u / k_g) / (epsilon + k_u / k_g))", f"{put_in} times sqrt(((1 + {eps}) times {r}) / ({eps} + {r}))")  # fmt: skip
    return (
        Formula("Change of ground velocity of the governing pulse", "Delta v_g = v_(g,i) - v_(g,i-1)", f"{speeds[1]} - ({speeds[0]})", dv, 1, "mm/s", f"{PAPER}, Eq. (14)"),
        Formula("Ratio of the slopes", "k_u / k_g", f"{u} / {number(k_g, 1)}", ratio, 3, "", f"{PAPER}, section 6.2"),
        Formula("Equivalent velocity of the energy put in", 'V_(Delta E) = sqrt(1 - k_u / k_(g,"ave")) thin Delta v_g', f"sqrt(1 - {u} / {ave}) times {number(dv, 1)}", said.input_velocity, 1, "mm/s", f"{PAPER}, Eq. (28)"),
        _dissipated_formula(*(absorbed if ratio <= 1.0 else ("", put_in)), said.hysteretic_velocity, "Eqs (26), (27)"),
        _change_formula(said.hysteretic_velocity, u, said.displacement_change, "Figure 21"),
    )  # fmt: skip


def _predict_from_pgv(ground: Ground, methods: Methods) -> Predicted | None:
    if not (methods.constants.slides_on_average and ground.pgv > 0.0):
        return None
    return Predicted(predict_from_pgv(ground.pgv, methods.constants))


def _formulas_from_pgv(ground: Ground, methods: Methods) -> tuple[Formula, ...]:
    """Return the method with its numbers; nothing where it cannot be used."""
    predicted, constants, pgv = _predict_from_pgv(ground, methods), methods.constants, ground.pgv
    if predicted is None:
        return ()
    said, k_u = predicted.prediction, constants.friction_deceleration
    k_g = constants.slope(pgv)
    dv = constants.velocity_change(pgv)
    u, s, put_in = number(k_u, 1), number(k_g, 1), number(said.input_velocity, 1)
    eps, ave, zeta = (f"{value:g}" for value in (constants.fall_ratio, constants.average_slope, constants.change_ratio))  # fmt: skip
    absorbed = ("sqrt(((1 + epsilon) k_u) / (k_u + epsilon k_g))", f"{put_in} times sqrt(((1 + {eps}) times {u}) / ({u} + {eps} times {s}))")  # fmt: skip
    return (
        Formula("Change of ground velocity of the largest pulse", 'Delta v_g = zeta "PGV"', f"{zeta} times {number(pgv, 1)}", dv, 1, "mm/s", f"{PAPER}, Eq. (29)"),
        Formula("Its slope", 'k_g = k_(g,"ave") "PGV" / "PGV"_0', f"{ave} times {number(pgv, 1)} / {constants.reference_pgv:g}", k_g, 1, "mm/s²", f"{PAPER}, Eq. (30)"),
        Formula("Equivalent velocity of the energy put in", 'V_(Delta E) = sqrt(1 - k_u / k_(g,"ave")) thin zeta "PGV"', f"sqrt(1 - {u} / {ave}) times {number(dv, 1)}", said.input_velocity, 1, "mm/s", f"{PAPER}, Eq. (31)"),
        _dissipated_formula(*(absorbed if k_u <= k_g else ("", put_in)), said.hysteretic_velocity, "Eq. (32)"),
        _change_formula(said.hysteretic_velocity, u, said.displacement_change, "Eq. (33)"),
    )  # fmt: skip


SIMPLIFIED_METHOD = PredictionMethod(
    key="simplified",
    name=SIMPLIFIED,
    head="simpl.",
    knows=(Information.BLIND, Information.INFORMED),
    citations=("li_2020",),
    look=Look("^", "ochre", 1.25, order=3),
    predict=_predict_simplified,
    of_pulses=_of_pulses,
    formulas=_formulas_simplified,
)
DESIGN_METHOD = PredictionMethod(
    key="design",
    name=DESIGN,
    knows=(Information.PGV,),
    citations=("li_2020",),
    look=Look("s", "grey", 0.9, order=2),
    predict=_predict_from_pgv,
    formulas=_formulas_from_pgv,
)
