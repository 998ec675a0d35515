"""One record at one PGV: what the analysis gives, and what each method says of it."""

import re
from dataclasses import dataclass, field
from enum import StrEnum

from dcfp.bearing import LI_2020, Bearing, FrictionLaw, Heating, Li2020, SimplifiedHeating
from dcfp.comparison.matching import pulse_behind
from dcfp.prediction import Prediction, Pulses, find_pulses, march_through_pulses
from dcfp.prediction import li_2020 as paper
from dcfp.prediction.pulse_march import MARCH_THRESHOLD
from dcfp.prediction.pulses import THRESHOLD
from dcfp.record.ground_motion import GroundMotion
from dcfp.response import Response, respond
from dcfp.response.swings import Swing, swings_of


class Basis(StrEnum):
    """What a prediction knows."""

    PGV = "PGV only"
    BLIND = "blind"
    INFORMED = "informed"


class Method(StrEnum):
    """The methods that are compared."""

    PULSE = "pulse"
    SIMPLIFIED = "simplified"
    DESIGN = "design"
    MARCH = "pulse march"


#: What is compared with the analysis, in the order of tables: blind reads the record, informed also which pulse the analysis found to govern.
VIEWS = (
    (Method.PULSE, Basis.BLIND),
    (Method.PULSE, Basis.INFORMED),
    (Method.SIMPLIFIED, Basis.BLIND),
    (Method.SIMPLIFIED, Basis.INFORMED),
    (Method.DESIGN, Basis.PGV),
    (Method.MARCH, Basis.BLIND),
)
View = tuple[Method, Basis]


@dataclass(frozen=True)
class Analysed:
    """What the response history analysis gives.

    Attributes
    ----------
    whole
        Largest of all swings, each quantity by itself, as a blind prediction gives it.
    governing
        The swing of the largest change of displacement, as an informed prediction gives it.
    swing
        That swing; None where the response never turns.
    pulse
        Number of the pulse behind it, counted from zero, or None.
    """

    whole: Prediction
    governing: Prediction
    swing: Swing | None
    pulse: int | None

    def beside(self, basis: Basis) -> Prediction:
        """Return what a prediction with this basis is to be compared with."""
        return self.governing if basis is Basis.INFORMED else self.whole


@dataclass(frozen=True, eq=False)
class Case:
    """One record at one PGV.

    Attributes
    ----------
    record, event
        Names; records of one earthquake have the same event.
    pgv
        [mm/s].
    pulses
        Of the ground velocity, as the methods of Li et al. (2020) take them.
    analysed
        What the analysis gives.
    predicted
        What each method says, by method and basis; a method that cannot be used is not there.
    remarks
        Sentences that a reader of the analysis must know.
    response
        The analysis itself, where it was to be kept.
    """

    record: str
    event: str
    pgv: float
    pulses: Pulses
    analysed: Analysed
    predicted: dict[View, Prediction]
    remarks: tuple[str, ...] = ()
    response: Response | None = None


@dataclass(frozen=True)
class Setting:
    """What stands on the ground, and how it is predicted.

    Attributes
    ----------
    bearing, friction, heating
        As for `dcfp.respond`.
    constants
        Of the methods of Li et al. (2020).
    threshold, march_threshold
        Of the pulses that those methods and the march through the pulses take; see `find_pulses`.
    """

    bearing: Bearing = LI_2020
    friction: FrictionLaw = field(default_factory=Li2020)
    heating: Heating = field(default_factory=SimplifiedHeating)
    constants: paper.Constants = paper.LI_2020
    threshold: float = THRESHOLD
    march_threshold: float = MARCH_THRESHOLD


def compare(motion: GroundMotion, setting: Setting | None = None, *, keep_response: bool = False) -> Case:
    """Analyse a ground motion, and predict the same by every method that can be used.

    Parameters
    ----------
    motion
        The ground motion.
    setting
        By default the bearing of Li et al. (2020) with its law and the simplified heating model.
    keep_response
        Whether the case keeps the analysis.
    """
    setting = Setting() if setting is None else setting
    response = respond(motion, setting.bearing, setting.friction, setting.heating)
    pulses = find_pulses(motion, setting.threshold)
    analysed = analysed_of(response, pulses)
    return Case(
        record=motion.name,
        event=event_of(motion),
        pgv=motion.peak_velocity,
        pulses=pulses,
        analysed=analysed,
        predicted=predictions(motion, setting, pulses, analysed.pulse),
        remarks=response.remarks,
        response=response if keep_response else None,
    )


def predictions(
    motion: GroundMotion, setting: Setting, pulses: Pulses, pulse: int | None
) -> dict[View, Prediction]:
    """Return what every method says that can be used.

    `pulses` are those of the motion for the methods of Li et al. (2020); `pulse` is the number of the one that the
    analysis found to govern, for the informed ones, or None.
    """
    constants = setting.constants
    by_pulse = paper.predict_from_pulses(pulses, constants)
    found: dict[View, Prediction] = {
        (Method.PULSE, Basis.BLIND): by_pulse.largest,
        (Method.PULSE, Basis.INFORMED): by_pulse.of(pulse),
    }
    if constants.slides_on_average:
        simplified = paper.predict_simplified(pulses, constants)
        found[Method.SIMPLIFIED, Basis.BLIND] = simplified.largest
        found[Method.SIMPLIFIED, Basis.INFORMED] = simplified.of(pulse)
        if motion.peak_velocity > 0.0:
            found[Method.DESIGN, Basis.PGV] = paper.predict_from_pgv(motion.peak_velocity, constants)
    found[Method.MARCH, Basis.BLIND] = march_through_pulses(
        find_pulses(motion, setting.march_threshold), setting.bearing, setting.friction, setting.heating
    ).prediction
    return found


def analysed_of(response: Response, pulses: Pulses) -> Analysed:
    """Return what an analysis gives of the quantities that are predicted."""
    swings = swings_of(response)
    swing = swings.largest
    whole = Prediction(
        response.peak_change,
        swings.input_velocity,
        swings.hysteretic_velocity,
        response.peak_displacement,
        response.input_velocity,
    )
    if swing is None:
        return Analysed(whole, whole, None, None)
    governing = Prediction(
        response.peak_change,
        swing.input_velocity,
        swing.hysteretic_velocity,
        response.peak_displacement,
        response.input_velocity,
    )
    return Analysed(whole, governing, swing, pulse_behind(swing, pulses))


def event_of(motion: GroundMotion) -> str:
    """Return the earthquake of a motion, under one name where the sets of FEMA P-695 have two; the motion's own name where it is not known."""
    return re.sub(r"-\d\d(?=,? )", "", motion.origin.event) or motion.name
