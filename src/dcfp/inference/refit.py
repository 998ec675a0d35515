"""The constants of the simplified and the design method, fitted to analyses as the paper did and by least squares; and how they and intervals from half of the earthquakes serve the other half."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TypeAlias

import numpy as np
from scipy import optimize

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.case import Case
from dcfp.inference.coverage import Coverage, coverage, grouped_splits
from dcfp.inference.forecast import BY_SPECTRUM, blind_variants
from dcfp.inference.statistics import errors, fewest, scatter
from dcfp.methods import Prediction
from dcfp.methods.li_2020 import LI_2020, Constants, predict_from_pgv, predict_simplified
from dcfp.methods.li_2020.constants import DESIGN, SIMPLIFIED
from dcfp.methods.li_2020.simplified_method import absorbed_velocity_ratio
from dcfp.methods.method import Variant
from dcfp.methods.prediction import Methods
from dcfp.methods.pulses import CHANGE, PREDICTION_QUANTITIES, value_of
from dcfp.schema.declared import parameters
from dcfp.schema.quantities import Quantity

#: How far the fitted constants may go: part of, and times the paper's.
_LEAST, _MOST = 0.05, 20.0
#: The slope that Eq. (28) divides by must stay above mu_n g by this factor [-].
_ABOVE_FRICTION = 1.02
#: How close to such a limit a fit counts as there [-].
_AT_LIMIT = 0.01
#: How far a PGV may be from the one that is meant [-].
_SAME_PGV = 1e-3

_optimize: Any = optimize
_Fit: TypeAlias = Callable[[Sequence[Case], Constants], Constants]


def governing(cases: Sequence[Case]) -> tuple[FloatArray, FloatArray]:
    """Return velocity change [mm/s] and slope [mm/s2] of the pulse behind the largest displacement of each case that has one."""
    known = [(case.pulses, case.analysed.pulse) for case in cases if case.analysed.pulse is not None]
    changes = np.array([abs(pulses.changes[i]) for pulses, i in known])
    slopes = np.array([abs(pulses.mean_accelerations[i]) for pulses, i in known])
    return changes, slopes


def _known(cases: Sequence[Case], known: Callable[[Case], object], nothing: str) -> list[Case]:
    found = [case for case in cases if known(case)]
    if not found:
        msg = f"{nothing}, so there is nothing to fit the constants to."
        raise InputError(msg)
    return found


def _with_pulse(cases: Sequence[Case]) -> list[Case]:
    nothing = "No pulse is behind any of the displacements"
    return _known(cases, lambda case: case.analysed.pulse is not None, nothing)


def average_slope(cases: Sequence[Case], reference_pgv: float = LI_2020.reference_pgv) -> float:
    """Return kg_ave [mm/s2] as Li et al. (2020), section 6.2.2, found it: the mean of the governing pulses at a PGV.

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
    velocities = [case.analysed.governing for case in known]
    absorbed = np.array([one.hysteretic_velocity / one.input_velocity for one in velocities])
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


def refit_by_squares(
    cases: Sequence[Case], constants: Constants = LI_2020, method: str = SIMPLIFIED
) -> Constants:
    """Return the constants with which a method is closest to V_dE and V_dEhr, by least squares of the logarithms.

    Free are kg_ave and eps of the simplified method, zeta and eps of the design method; there kg_ave is kept:
    it does what zeta does in Eq. (31), and what eps does in Eq. (32).
    """
    predict, names = _METHODS[method]
    nothing = "Nothing moves in any of the cases"
    known = _known(
        cases, lambda case: case.analysed.whole.hysteretic_velocity > 0.0 and case.pulses.count, nothing
    )
    analysed = _logarithms([case.analysed.whole for case in known])

    def made(logarithms: FloatArray) -> Constants:
        found = dict(zip(names, np.exp(logarithms).tolist(), strict=True))
        if "average_slope" in found:
            least = _ABOVE_FRICTION * constants.friction_deceleration
            found["average_slope"] = max(found["average_slope"], least)
        return replace(constants, **found)

    def misfit(logarithms: FloatArray) -> FloatArray:
        trial = made(logarithms)
        return (_logarithms([predict(case, trial) for case in known]) - analysed).ravel()

    first = np.log([getattr(constants, name) for name in names])
    limits = np.log([parameters(Constants)[name].limits for name in names]).T
    least, most = np.maximum(first + np.log(_LEAST), limits[0]), np.minimum(first + np.log(_MOST), limits[1])
    solution = _optimize.least_squares(misfit, first, bounds=(least, most), diff_step=1e-3, xtol=1e-6)
    return made(solution.x)


def _logarithms(predictions: Sequence[Prediction]) -> FloatArray:
    return np.log([[one.input_velocity, one.hysteretic_velocity] for one in predictions])


def _simplified(case: Case, constants: Constants) -> Prediction:
    return predict_simplified(case.pulses, constants).largest


def _design(case: Case, constants: Constants) -> Prediction:
    return predict_from_pgv(case.pgv, constants)


#: How each method predicts a case, and which of its constants are fitted by least squares.
_METHODS = {
    SIMPLIFIED: (_simplified, ("average_slope", "fall_ratio")),
    DESIGN: (_design, ("change_ratio", "fall_ratio")),
}


def _at_limit(fitted: Constants, given: Constants) -> bool:
    """Return whether a fit ended where the search ends, so that the data do not determine it."""
    pairs = [
        (getattr(fitted, name), part * getattr(given, name))
        for name in ("average_slope", "fall_ratio", "change_ratio")
        for part in (_LEAST, _MOST)
    ]
    pairs.append((fitted.average_slope, _ABOVE_FRICTION * given.friction_deceleration))
    return any(math.isclose(one, limit, rel_tol=_AT_LIMIT) for one, limit in pairs)


#: Splits by which a refit is judged; each takes a second or less.
REFIT_SPLITS = 20
#: Earthquakes without which halves mean nothing.
FEWEST_EVENTS = 6


@dataclass(frozen=True)
class Refit:
    """A method with its constants; bias and dispersion are those of dy of held-out halves [-], mean of the splits."""

    method: str
    words: str
    constants: Constants
    bias: float
    dispersion: float


def check_enough(groups: Sequence[Sequence[Case]]) -> None:
    """Refuse cases of too few earthquakes, or too few records of a PGV, to be halved.

    Raises
    ------
    InputError
        If the earthquakes or the records of a PGV are too few.
    """
    events = {case.event for case in groups[0]}
    smallest = min(len(cases) for cases in groups)
    if len(events) < FEWEST_EVENTS or smallest < 2 * fewest():
        msg = (
            f"Held-out halves need at least {FEWEST_EVENTS} earthquakes and {2 * fewest()} records at each PGV, not"
            f" {len(events)} and {smallest}; P695 names a hundred components."
        )
        raise InputError(msg)


def coverages(
    groups: Sequence[Sequence[Case]], methods: Methods
) -> dict[tuple[Variant | None, Quantity], Coverage]:
    """Return the coverage of the intervals from the PGV alone (None), from it and the spectrum, and of every blind method, for every quantity that they have."""
    found: dict[tuple[Variant | None, Quantity], Coverage] = {}
    of_methods = [(one, one, methods) for one in blind_variants()]
    for key, variant, by in ((None, None, None), (BY_SPECTRUM, None, methods), *of_methods):
        for quantity in PREDICTION_QUANTITIES.values():
            known = [np.isfinite(errors(cases, variant, quantity)).sum() for cases in groups]
            if min(known) >= 2 * fewest():
                found[key, quantity] = coverage(groups, variant, quantity, by)
    return found


def refits(cases: Sequence[Case], constants: Constants) -> list[Refit]:
    """Return the simplified and the design method before and after a refit, on held-out halves.

    Raises
    ------
    InputError
        If there is no case at the PGV that kg_ave belongs to.
    """
    found: list[Refit] = []
    for method in _METHODS:
        fits: dict[str, _Fit] = {
            "as given": lambda cases, given: given,
            "as the paper fits": refit_as_paper,
            "least squares": partial(refit_by_squares, method=method),
        }
        found += [_judged(method, words, fit, cases, constants) for words, fit in fits.items()]
    return found


def _judged(
    method: str,
    words: str,
    fit: _Fit,
    cases: Sequence[Case],
    given: Constants,
) -> Refit:
    predict, _ = _METHODS[method]
    biases: list[float] = []
    dispersions: list[float] = []
    for training in grouped_splits([case.event for case in cases], REFIT_SPLITS):
        constants = fit([case for case, trained in zip(cases, training, strict=True) if trained], given)
        others = [case for case, trained in zip(cases, training, strict=True) if not trained]
        changes = [(case, case.analysed.whole.displacement_change) for case in others]
        ratios = [
            value_of(predict(case, constants), CHANGE) / change for case, change in changes if change > 0.0
        ]
        held_out = scatter(np.array(ratios))
        biases.append(np.log(held_out.bias))
        dispersions.append(held_out.dispersion)
    final = fit(cases, given)
    if _at_limit(final, given):
        words += ", at the limit of the search"
    return Refit(method, words, final, float(np.exp(np.mean(biases))), float(np.mean(dispersions)))
