"""Why a prediction is where it is: the facts of a case that the methods of Li et al. (2020) leave out."""

from dataclasses import replace

import numpy as np

from dcfp.analysis import Response, respond
from dcfp.constants import STANDARD_GRAVITY
from dcfp.inference import Case
from dcfp.inference.case import analysed_of
from dcfp.methods.li_2020 import LI_2020, predict_from_pulses, predict_simplified
from dcfp.methods.li_2020.constants import PULSE, SIMPLIFIED
from dcfp.methods.method import Variant
from dcfp.methods.pulses import value_of
from dcfp.schema.quantities import Quantity
from dcfp.system import LI_2020 as BEARING

#: Mean coefficient in a swing over mu_n, up or down, from which on it is said to differ [-].
_OTHER_FRICTION = 1.5
#: dy with spring (a) over dy without, from which on the spring is said to have a part in it [-].
_SPRING = 1.3
#: Radius over the bearing's, with which a plate is as good as flat [-].
_FLAT = 1e6


def explain(case: Case, precise: Response, constant: Response, variant: Variant, quantity: Quantity) -> str:
    """Return in a sentence what sets a case apart from one that a blind method predicts well, each clause with its number.

    Parameters
    ----------
    case
        Of the paper's bearing, with its response.
    precise, constant
        The same analysis with precise heating, and with the constant mu_n.
    variant, quantity
        The pulse or the simplified method, and dy or one of the two energies.
    """
    swing, method = case.analysed.swing, variant.method
    if swing is None:
        return "the response never turns."
    said = value_of(case.predicted[variant], quantity)

    def over(response: Response) -> str:
        return f"{said / value_of(analysed_of(response, case.pulses).whole, quantity):.2f}"

    place = _governing(case, method, quantity)
    clauses = [] if place is None else [_pulse(case, method, place, quantity)]
    clauses.append(
        f"against an analysis with the constant mu_n it is {over(constant)}, with precise heating {over(precise)}"
    )
    mean = swing.hysteretic_velocity**2 / (2.0 * STANDARD_GRAVITY * abs(swing.change))
    if not 1.0 / _OTHER_FRICTION < mean / LI_2020.nominal_friction < _OTHER_FRICTION:
        clauses.append(
            f"the mean coefficient in the largest swing is {mean:.3f}, where the method has {LI_2020.nominal_friction:g}"
        )
    flat = _without_spring(case)
    if case.analysed.whole.displacement_change > _SPRING * flat:
        clauses.append(
            f"the largest swing is at {swing.start:.1f}–{swing.end:.1f} s, and without spring (a), which the method has not, the largest would be"
            f" {flat:.0f} in place of {case.analysed.whole.displacement_change:.0f} mm"
        )
    return "; ".join(clauses) + "."


def _without_spring(case: Case) -> float:
    """Largest change of displacement on flat plates [mm]."""
    if case.response is None:
        return case.analysed.whole.displacement_change
    flat = BEARING.unchecked(
        radii=tuple(_FLAT * radius for radius in BEARING.radii), displacement_capacity=None
    )
    return respond(case.response.motion, flat, tail=0.0).peak_change


def _governing(case: Case, method: str, quantity: Quantity) -> int | None:
    found = predict_from_pulses(case.pulses) if method == PULSE else predict_simplified(case.pulses)
    of_pulse = [value_of(found.of(i), quantity) for i in range(case.pulses.count)]
    return int(np.argmax(of_pulse)) if of_pulse else None


def _pulse(case: Case, method: str, place: int, quantity: Quantity) -> str:
    pulses = case.pulses
    ratio = LI_2020.friction_deceleration / abs(float(pulses.mean_accelerations[place]))
    words = f"the pulse at {pulses.starts[place]:.2f}–{pulses.peaks[place]:.2f} s has ku/kg {ratio:.2f}"
    if method == PULSE and LI_2020.amplified_from <= ratio <= 1.0:
        without = predict_from_pulses(pulses, replace(LI_2020, amplification=1.0)).of(place)
        analysed = value_of(case.analysed.whole, quantity)
        words += (
            f", where velocities and slopes are multiplied by {LI_2020.amplification:g} (Figure 17); without that it would give"
            f" {value_of(without, quantity) / analysed:.2f} of the analysis"
        )
    if method == SIMPLIFIED:
        own = replace(LI_2020, average_slope=abs(float(pulses.mean_accelerations[place])))
        if own.slides_on_average:
            with_own = value_of(predict_simplified(pulses, own).of(place), quantity)
            words += (
                f" and a slope of {own.average_slope:.0f} mm/s²; with its own in place of the {LI_2020.average_slope:.0f} it would give"
                f" {with_own / value_of(case.analysed.whole, quantity):.2f} of the analysis"
            )
    return words
