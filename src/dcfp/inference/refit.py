"""The constants of the simplified and the design method, fitted to analyses: how the paper came by them, and by least squares."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from scipy import optimize

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.case import Case
from dcfp.methods import Prediction
from dcfp.methods.li_2020 import LI_2020, Constants, predict_from_pgv, predict_simplified
from dcfp.methods.li_2020.simplified_method import absorbed_velocity_ratio

#: How far the fitted constants may go: part of, and times the paper's.
_LEAST, _MOST = 0.05, 20.0
#: The slope that Eq. (28) divides by must stay above mu_n g by this factor [-].
_ABOVE_FRICTION = 1.02
#: How close to such a limit a fit counts as there [-].
_AT_LIMIT = 0.01
#: How far a PGV may be from the one that is meant [-].
_SAME_PGV = 1e-3

_optimize: Any = optimize


def governing(cases: Sequence[Case]) -> tuple[FloatArray, FloatArray]:
    """Return velocity change [mm/s] and slope [mm/s2] of the pulse behind the largest displacement of each case that has one."""
    known = [(case.pulses, case.analysed.pulse) for case in cases if case.analysed.pulse is not None]
    changes = np.array([abs(pulses.changes[i]) for pulses, i in known])
    slopes = np.array([abs(pulses.mean_accelerations[i]) for pulses, i in known])
    return changes, slopes


def _with_pulse(cases: Sequence[Case]) -> list[Case]:
    """Return the cases with a governing pulse.

    Raises
    ------
    InputError
        If there is none.
    """
    known = [case for case in cases if case.analysed.pulse is not None]
    if not known:
        msg = "No pulse is behind any of the displacements, so there is nothing to fit the constants to."
        raise InputError(msg)
    return known


def average_slope(cases: Sequence[Case], reference_pgv: float = LI_2020.reference_pgv) -> float:
    """Return kg_ave [mm/s2] as Li et al. (2020), section 6.2.2, found it: the mean slope of the governing pulses at one PGV.

    `reference_pgv` is that PGV [mm/s]; cases at another one do not count.

    Raises
    ------
    InputError
        If no case at that PGV has a governing pulse.
    """
    _, slopes = governing(
        [case for case in cases if math.isclose(case.pgv, reference_pgv, rel_tol=_SAME_PGV)]
    )
    if slopes.size == 0:
        msg = f"kg_ave needs analyses at a PGV of {reference_pgv / 1e3:g} m/s; give at least one in which a pulse is behind the largest swing."
        raise InputError(msg)
    return float(slopes.mean())


def change_ratio(cases: Sequence[Case]) -> float:
    """Return zeta [-], the mean of |dvg| / PGV of the governing pulses: Li et al. (2020), Figure 25."""
    known = _with_pulse(cases)
    changes, _ = governing(known)
    return float(np.mean(changes / np.array([case.pgv for case in known])))


def fall_ratio(cases: Sequence[Case], constants: Constants = LI_2020) -> float:
    """Return the eps [-] whose curve, Eq. (27), is closest to the analyses: Li et al. (2020), Figure 19."""
    known = [case for case in _with_pulse(cases) if case.analysed.governing.input_velocity > 0.0]
    _, slopes = governing(known)
    absorbed = np.array(
        [
            case.analysed.governing.hysteretic_velocity / case.analysed.governing.input_velocity
            for case in known
        ]
    )
    ratio = constants.friction_deceleration / slopes

    def misfit(logarithm: float) -> float:
        return float(np.sum((absorbed_velocity_ratio(ratio, math.exp(logarithm)) - absorbed) ** 2))

    limits = (math.log(_LEAST * constants.fall_ratio), math.log(_MOST * constants.fall_ratio))
    return math.exp(_optimize.minimize_scalar(misfit, bounds=limits, method="bounded").x)


def refit_as_paper(cases: Sequence[Case], constants: Constants = LI_2020) -> Constants:
    """Return eps, zeta and kg_ave from the governing pulses of the analyses, each as Li et al. (2020) found it."""
    return replace(
        constants,
        average_slope=max(
            average_slope(cases, constants.reference_pgv), _ABOVE_FRICTION * constants.friction_deceleration
        ),
        change_ratio=change_ratio(cases),
        fall_ratio=fall_ratio(cases, constants),
    )


def refit_simplified(cases: Sequence[Case], constants: Constants = LI_2020) -> Constants:
    """Return the kg_ave and eps with which the simplified method is closest to V_dE and V_dEhr, by least squares of the logarithms."""

    def made(slope: float, eps: float) -> Constants:
        least = _ABOVE_FRICTION * constants.friction_deceleration
        return replace(constants, average_slope=max(slope, least), fall_ratio=eps)

    return _fitted(
        made,
        (constants.average_slope, constants.fall_ratio),
        lambda case, trial: predict_simplified(case.pulses, trial).largest,
        cases,
    )


def refit_design(cases: Sequence[Case], constants: Constants = LI_2020) -> Constants:
    """Return the zeta and eps with which the design method is closest to V_dE and V_dEhr, by least squares of the logarithms.

    kg_ave is kept: in Eq. (31) it does what zeta does, and in Eq. (32) what eps does.
    """

    def made(zeta: float, eps: float) -> Constants:
        return replace(constants, change_ratio=zeta, fall_ratio=eps)

    return _fitted(
        made,
        (constants.change_ratio, constants.fall_ratio),
        lambda case, trial: predict_from_pgv(case.pgv, trial),
        cases,
    )


def at_limit(fitted: Constants, given: Constants = LI_2020) -> bool:
    """Return whether a fit from the constants `given` ended where the search ends, so that the data do not determine it."""
    pairs = [
        (fitted.average_slope, given.average_slope),
        (fitted.fall_ratio, given.fall_ratio),
        (fitted.change_ratio, given.change_ratio),
    ]
    near = (
        math.isclose(one, part * other, rel_tol=_AT_LIMIT) for one, other in pairs for part in (_LEAST, _MOST)
    )
    lowest = _ABOVE_FRICTION * given.friction_deceleration
    return any(near) or math.isclose(fitted.average_slope, lowest, rel_tol=_AT_LIMIT)


def _fitted(
    made: Callable[[float, float], Constants],
    start: tuple[float, float],
    predict: Callable[[Case, Constants], Prediction],
    cases: Sequence[Case],
) -> Constants:
    """Return the constants with the least squares of ln (prediction / analysis) of V_dE and V_dEhr."""
    known = [case for case in cases if case.analysed.whole.hysteretic_velocity > 0.0 and case.pulses.count]
    if not known:
        msg = "Nothing moves in any of the cases, so there is nothing to fit the constants to."
        raise InputError(msg)
    whole = [case.analysed.whole for case in known]
    analysed = np.log([[one.input_velocity, one.hysteretic_velocity] for one in whole])

    def misfit(logarithms: FloatArray) -> FloatArray:
        trial = made(*np.exp(logarithms).tolist())
        said = [predict(case, trial) for case in known]
        found = np.log([[one.input_velocity, one.hysteretic_velocity] for one in said])
        return (found - analysed).ravel()

    first = np.log(start)
    solution = _optimize.least_squares(
        misfit, first, bounds=(first + np.log(_LEAST), first + np.log(_MOST)), diff_step=1e-3, xtol=1e-6
    )
    return made(*np.exp(solution.x).tolist())
