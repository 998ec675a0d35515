"""Why a prediction is where it is: the facts of a case that the methods of Li et al. (2020) leave out."""

import math
from dataclasses import replace

import numpy as np

from dcfp.bearing import LI_2020 as BEARING
from dcfp.comparison.case import Case, Method, View, analysed_of
from dcfp.comparison.quantities import Quantity
from dcfp.comparison.statistics import value_of
from dcfp.constants import STANDARD_GRAVITY
from dcfp.prediction.li_2020 import LI_2020, predict_from_pulses, predict_simplified
from dcfp.response import Response
from dcfp.response.swings import Swing

#: Duration of a swing over half the period of the pendulum from which on the pendulum is said to have a part in it [-].
_SLOW = 0.8


def explain(case: Case, precise: Response, view: View, quantity: Quantity) -> str:
    """Return in a sentence what sets a case apart, each clause with its number.

    Parameters
    ----------
    case
        Of the paper's bearing.
    precise
        The same analysis with precise heating.
    view
        The pulse or the simplified method, blind.
    quantity
        dy or one of the two energies.
    """
    swing, method = case.analysed.swing, view[0]
    if swing is None:
        return "the response never turns."
    clauses = [_friction(swing)]
    place = _governing(case, method, quantity)
    if place is not None:
        clauses.insert(0, _pulse(case, method, place, quantity))
    half = 0.5 * BEARING.period
    length = swing.end - swing.start
    if length > _SLOW * half:
        clauses.append(
            f"the largest swing, from {swing.start:.1f} to {swing.end:.1f} s, lasts {length:.1f} s, and half a period of the pendulum"
            f" {half:.1f} s: slow waves have set the pendulum swinging, and the method has no spring (a)"
        )
        behind = case.analysed.pulse
        if behind is not None:
            ratio = LI_2020.friction_deceleration / abs(float(case.pulses.mean_accelerations[behind]))
            clauses.append(f"the pulse behind that swing has ku/kg {ratio:.2f}")
    said = value_of(case.predicted[view], quantity)
    clauses.append(
        f"with precise heating it is {said / value_of(analysed_of(precise, case.pulses).whole, quantity):.2f} of the analysis"
    )
    return "; ".join(clauses) + "."


def _governing(case: Case, method: Method, quantity: Quantity) -> int | None:
    found = predict_from_pulses(case.pulses) if method is Method.PULSE else predict_simplified(case.pulses)
    of_pulse = [value_of(found.of(i), quantity) for i in range(case.pulses.count)]
    return int(np.argmax(of_pulse)) if of_pulse else None


def _pulse(case: Case, method: Method, place: int, quantity: Quantity) -> str:
    pulses = case.pulses
    ratio = LI_2020.friction_deceleration / abs(float(pulses.mean_accelerations[place]))
    words = f"the pulse at {pulses.starts[place]:.2f}–{pulses.peaks[place]:.2f} s has ku/kg {ratio:.2f}"
    if method is Method.PULSE and LI_2020.amplified_from <= ratio <= 1.0:
        without = predict_from_pulses(pulses, replace(LI_2020, amplification=1.0)).of(place)
        analysed = value_of(case.analysed.whole, quantity)
        words += (
            f", where velocities and slopes are multiplied by 1.5 (Figure 17); without that it would give"
            f" {value_of(without, quantity) / analysed:.2f} of the analysis"
        )
    return words


def _friction(swing: Swing) -> str:
    """Return the mean coefficient while the largest swing slid, beside mu_n."""
    mean = swing.hysteretic_velocity**2 / (2.0 * STANDARD_GRAVITY * abs(swing.change))
    note = (
        ""
        if math.isclose(mean, LI_2020.nominal_friction, rel_tol=0.05)
        else f", mu_n is {LI_2020.nominal_friction:g}"
    )
    return f"the mean coefficient in the largest swing is {mean:.3f}{note}"
