"""The same from the PGV alone: Li et al. (2020), section 6.3, Eqs (29)-(33)."""

import math
from dataclasses import replace

from dcfp.errors import InputError
from dcfp.methods.li_2020.constants import DESIGN, LI_2020, PAPER, Constants
from dcfp.methods.li_2020.simplified_method import change_formula, check_slope, dissipated_formula
from dcfp.methods.method import Information, Look, register
from dcfp.methods.prediction import Ground, Methods, Predicted, PredictionMethod
from dcfp.methods.pulses import Prediction
from dcfp.schema.formulas import Formula, number

#: Halvings after which a coefficient is found to the last digit.
_HALVINGS = 60


def velocity_change(pgv: float, change_ratio: float) -> float:
    """Velocity change |dvg| of the largest pulse [mm/s]: Eq. (29).

    `pgv` [mm/s]; `change_ratio` zeta [-].
    """
    return change_ratio * pgv


def slope(pgv: float, average_slope: float, reference_pgv: float) -> float:
    """Slope kg of that pulse [mm/s2]: Eq. (30).

    `pgv` [mm/s]; `average_slope` kg_ave [mm/s2] at `reference_pgv` [mm/s].
    """
    return average_slope * pgv / reference_pgv


def input_velocity(
    pgv: float, friction_deceleration: float, average_slope: float, change_ratio: float
) -> float:
    """Equivalent velocity V_dE_pre of the input energy [mm/s]: Eq. (31), which is Eq. (28) with Eq. (29).

    `pgv` [mm/s]; `friction_deceleration` mu_n g and `average_slope` kg_ave [mm/s2]; `change_ratio` zeta [-].
    """
    k_u, zeta = friction_deceleration, change_ratio
    return math.sqrt(1.0 - k_u / average_slope) * velocity_change(pgv, zeta)


def hysteretic_velocity(
    input_velocity: float, friction_deceleration: float, slope: float, fall_ratio: float
) -> float:
    """Equivalent velocity V_dEhr_pre of the dissipated energy [mm/s]: Eq. (32), which is Eq. (27) with Eq. (30).

    `input_velocity` V_dE_pre [mm/s]; `friction_deceleration` mu_n g and `slope` kg [mm/s2]; `fall_ratio` eps [-].
    """
    k_u, k_g, eps = friction_deceleration, slope, fall_ratio
    if k_u > k_g:
        return input_velocity
    return input_velocity * math.sqrt((1.0 + eps) * k_u / (k_u + eps * k_g))


def displacement_change(hysteretic_velocity: float, friction_deceleration: float) -> float:
    """Change of displacement dy_pre [mm]: Eq. (33).

    `hysteretic_velocity` V_dEhr_pre [mm/s]; `friction_deceleration` mu_n g [mm/s2].
    """
    return hysteretic_velocity**2 / (2.0 * friction_deceleration)


def predict_from_pgv(pgv: float, constants: Constants = LI_2020) -> Prediction:
    """Return what the largest pulse of earthquakes with a PGV [mm/s] does: Li et al. (2020), section 6.3.

    Raises
    ------
    InputError
        If the PGV is not positive, or mu_n g is not below kg_ave.
    """
    if not (math.isfinite(pgv) and pgv > 0.0):
        msg = f"The PGV must be positive, not {pgv / 1000.0:g} m/s."
        raise InputError(msg)
    check_slope(constants)
    k_u, k_ave = constants.friction_deceleration, constants.average_slope
    put_in = input_velocity(pgv, k_u, k_ave, constants.change_ratio)
    k_g = slope(pgv, k_ave, constants.reference_pgv)
    dissipated = hysteretic_velocity(put_in, k_u, k_g, constants.fall_ratio)
    return Prediction(displacement_change(dissipated, k_u), put_in, dissipated)


def friction_that_holds(allowed: float, pgv: float, constants: Constants = LI_2020) -> float | None:
    """Return the nominal coefficient mu_n with which dy_pre is `allowed` [mm] at a PGV [mm/s]: Eq. (33) turned round.

    None where no coefficient below kg_ave / g does. The radius of the plates does not come into it.

    Raises
    ------
    InputError
        If `allowed` or the PGV is not positive.
    """
    if not (math.isfinite(allowed) and allowed > 0.0):
        msg = f"The displacement to be held must be positive, not {allowed!r} mm."
        raise InputError(msg)

    def change(mu: float) -> float:
        return predict_from_pgv(pgv, replace(constants, nominal_friction=mu)).displacement_change

    most = min(constants.average_slope / constants.gravity, 1.0)
    low, high = 1e-6 * most, (1.0 - 1e-9) * most
    if not change(high) <= allowed <= change(low):
        return None
    for _ in range(_HALVINGS):  # dy falls as mu grows
        middle = 0.5 * (low + high)
        low, high = (middle, high) if change(middle) > allowed else (low, middle)
    return high


def _predict(ground: Ground, methods: Methods) -> Predicted | None:
    if not (methods.constants.slides_on_average and ground.pgv > 0.0):
        return None
    return Predicted(predict_from_pgv(ground.pgv, methods.constants))


def _formulas(ground: Ground, methods: Methods) -> tuple[Formula, ...]:
    """Return the method with its numbers; nothing where it cannot be used."""
    predicted, constants, pgv = _predict(ground, methods), methods.constants, ground.pgv
    if predicted is None:
        return ()
    said, k_u = predicted.prediction, constants.friction_deceleration
    k_g = slope(pgv, constants.average_slope, constants.reference_pgv)
    dv = velocity_change(pgv, constants.change_ratio)
    u, s, put_in = number(k_u, 1), number(k_g, 1), number(said.input_velocity, 1)
    eps, ave, zeta = (f"{value:g}" for value in (constants.fall_ratio, constants.average_slope, constants.change_ratio))  # fmt: skip
    absorbed = ("sqrt(((1 + epsilon) k_u) / (k_u + epsilon k_g))", f"{put_in} times sqrt(((1 + {eps}) times {u}) / ({u} + {eps} times {s}))")  # fmt: skip
    return (
        Formula("Change of ground velocity of the largest pulse", 'Delta v_g = zeta "PGV"', f"{zeta} times {number(pgv, 1)}", dv, 1, "mm/s", f"{PAPER}, Eq. (29)"),
        Formula("Its slope", 'k_g = k_(g,"ave") "PGV" / "PGV"_0', f"{ave} times {number(pgv, 1)} / {constants.reference_pgv:g}", k_g, 1, "mm/s²", f"{PAPER}, Eq. (30)"),
        Formula("Equivalent velocity of the energy put in", 'V_(Delta E) = sqrt(1 - k_u / k_(g,"ave")) thin zeta "PGV"', f"sqrt(1 - {u} / {ave}) times {number(dv, 1)}", said.input_velocity, 1, "mm/s", f"{PAPER}, Eq. (31)"),
        dissipated_formula(*(absorbed if k_u <= k_g else ("", put_in)), said.hysteretic_velocity, "Eq. (32)"),
        change_formula(said.hysteretic_velocity, u, said.displacement_change, "Eq. (33)"),
    )  # fmt: skip


DESIGN_METHOD = register(
    PredictionMethod(
        key="design",
        name=DESIGN,
        knows=(Information.PGV,),
        citations=("li_2020",),
        look=Look("s", "grey", 0.9, order=2),
        predict=_predict,
        formulas=_formulas,
    )
)
