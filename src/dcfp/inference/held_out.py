"""How well constants and intervals from half of the earthquakes serve the other half."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from dcfp.errors import InputError
from dcfp.inference.calibration import BLIND_VIEWS
from dcfp.inference.case import CHANGE, QUANTITIES, Case, Method, Quantity, View
from dcfp.inference.intervals import Coverage, coverage, errors, fewest, halves
from dcfp.inference.refit import at_limit, refit_as_paper, refit_design, refit_simplified
from dcfp.inference.statistics import scatter, value_of
from dcfp.methods import Prediction
from dcfp.methods.li_2020 import Constants, predict_from_pgv, predict_simplified

#: Splits by which a refit is judged; each takes a second or less.
REFIT_SPLITS = 20
#: Earthquakes without which halves mean nothing.
FEWEST_EVENTS = 6


@dataclass(frozen=True)
class Refit:
    """A method with given constants, or with constants fitted to a training half, on the other half.

    Attributes
    ----------
    method
        Simplified or design.
    words
        Where the constants come from.
    constants
        Fitted to all cases.
    bias, dispersion
        Of dy of held-out cases [-], mean of the splits: geometric mean of prediction over analysis, and standard deviation of its logarithm.
    """

    method: Method
    words: str
    constants: Constants
    bias: float
    dispersion: float


def check_enough(groups: Sequence[Sequence[Case]]) -> None:
    """Check that cases can be halved.

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


def coverages(groups: Sequence[Sequence[Case]]) -> dict[tuple[View | None, Quantity], Coverage]:
    """Return the coverage of the intervals of every blind view, and of the PGV alone (None), for every quantity that it has."""
    found: dict[tuple[View | None, Quantity], Coverage] = {}
    for view in (None, *BLIND_VIEWS):
        for quantity in QUANTITIES:
            known = [np.isfinite(errors(cases, view, quantity)).sum() for cases in groups]
            if min(known) >= 2 * fewest():
                found[view, quantity] = coverage(groups, view, quantity)
    return found


def refits(cases: Sequence[Case], constants: Constants) -> list[Refit]:
    """Return the simplified and the design method before and after a refit, on held-out halves.

    Raises
    ------
    InputError
        If there is no case at the PGV that kg_ave belongs to.
    """
    fits = {
        Method.SIMPLIFIED: (_simplified, refit_simplified),
        Method.DESIGN: (_design, refit_design),
    }
    found: list[Refit] = []
    for method, (predict, by_squares) in fits.items():
        for words, fit in (
            ("as given", _as_given),
            ("as the paper fits", refit_as_paper),
            ("least squares", by_squares),
        ):
            found.append(_judged(method, words, fit, predict, cases, constants))
    return found


def _simplified(case: Case, constants: Constants) -> Prediction:
    return predict_simplified(case.pulses, constants).largest


def _design(case: Case, constants: Constants) -> Prediction:
    return predict_from_pgv(case.pgv, constants)


def _as_given(cases: Sequence[Case], constants: Constants) -> Constants:
    del cases
    return constants


def _judged(
    method: Method,
    words: str,
    fit: Callable[[Sequence[Case], Constants], Constants],
    predict: Callable[[Case, Constants], Prediction],
    cases: Sequence[Case],
    given: Constants,
) -> Refit:
    biases: list[float] = []
    dispersions: list[float] = []
    for training in halves([case.event for case in cases], REFIT_SPLITS):
        constants = fit([case for case, trained in zip(cases, training, strict=True) if trained], given)
        ratios = [
            value_of(predict(case, constants), CHANGE) / case.analysed.whole.displacement_change
            for case, trained in zip(cases, training, strict=True)
            if not trained and case.analysed.whole.displacement_change > 0.0
        ]
        held_out = scatter(np.array(ratios))
        biases.append(np.log(held_out.bias))
        dispersions.append(held_out.dispersion)
    final = fit(cases, given)
    if at_limit(final, given):
        words += ", at the limit of the search"
    return Refit(method, words, final, float(np.exp(np.mean(biases))), float(np.mean(dispersions)))
