"""One record at one PGV: what the analysis gives, and what each method says of it."""

from dataclasses import dataclass, field, replace
from enum import StrEnum

import numpy as np

from dcfp.analysis import Response, respond
from dcfp.analysis.swings import Swing, swings_of
from dcfp.inference.earthquake import event_of
from dcfp.methods import (
    NOTHING,
    Prediction,
    PulseMarch,
    PulsePrediction,
    Pulses,
    aij_2016,
    asce_2016,
    eurocode_8,
    find_pulses,
    iwan_1980,
    march_through_pulses,
)
from dcfp.methods import li_2020 as paper
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.panel import answers_for_motion
from dcfp.methods.pulse_march import MARCH_THRESHOLD
from dcfp.methods.pulses import THRESHOLD
from dcfp.methods.result import Answer
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import Motion, motion_of
from dcfp.schema.notebook import card, fields_card
from dcfp.schema.parameters import refuse_other
from dcfp.system import LI_2020, Bearing, FrictionLaw, Heating, Li2020, SimplifiedHeating


class Basis(StrEnum):
    """What a prediction knows."""

    PGV = "PGV only"
    BLIND = "blind"
    INFORMED = "informed"
    SPECTRUM = "spectrum"


class Method(StrEnum):
    """The methods that are compared."""

    PULSE = "pulse"
    SIMPLIFIED = "simplified"
    DESIGN = "design"
    MARCH = "pulse march"
    ASCE = asce_2016.NAME
    EUROCODE = eurocode_8.NAME
    AIJ_1 = aij_2016.METHOD_1
    AIJ_2 = aij_2016.METHOD_2
    AIJ_ENERGY = aij_2016.ENERGY_BALANCE
    IWAN = iwan_1980.NAME


#: What is compared with the analysis, in the order of tables: blind reads the record, informed also which pulse the analysis found to govern, and the methods of
#: codes its spectrum.
VIEWS = (
    (Method.PULSE, Basis.BLIND),
    (Method.PULSE, Basis.INFORMED),
    (Method.SIMPLIFIED, Basis.BLIND),
    (Method.SIMPLIFIED, Basis.INFORMED),
    (Method.DESIGN, Basis.PGV),
    (Method.MARCH, Basis.BLIND),
    *(
        (method, Basis.SPECTRUM)
        for method in (
            Method.ASCE,
            Method.EUROCODE,
            Method.AIJ_1,
            Method.AIJ_2,
            Method.AIJ_ENERGY,
            Method.IWAN,
        )
    ),
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
    answers
        What the methods of codes say under the record's own spectrum, with their verdicts, by name; empty where they were not asked.
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
    answers: dict[str, Answer] = field(default_factory=dict[str, Answer])
    remarks: tuple[str, ...] = ()
    response: Response | None = None

    def _repr_html_(self) -> str:
        rows = [
            {
                "method": method.value,
                "knows": basis.value,
                "y_max [mm]": said.bound,
                "verdict": self.answers[method].verdict if method in self.answers else "",
            }
            for (method, basis), said in self.predicted.items()
        ]
        facts = {"PGV [mm/s]": self.pgv, "y_max by analysis [mm]": self.analysed.whole.bound}
        return card(f"Predictions of {self.record}", facts, rows=rows, remarks=self.remarks)


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

    def _repr_html_(self) -> str:
        return fields_card(self, "How records are predicted")


def compare(
    motion: Motion,
    setting: Setting | None = None,
    *,
    codes: bool = False,
    keep_response: bool = False,
    response: Response | None = None,
) -> Case:
    """Analyse a ground motion, and predict the same by every method that can be used.

    Parameters
    ----------
    motion
        The ground motion; or the name of a record, or a file.
    setting
        By default the bearing of Li et al. (2020) with its law and the simplified heating model.
    codes
        Whether the methods of codes are asked too, under the record's own spectrum.
    keep_response
        Whether the case keeps the analysis.
    response
        The analysis, where it is at hand.
    """
    motion, setting = motion_of(motion), Setting() if setting is None else setting
    refuse_other(setting, Setting, "setting", "a Setting")
    if response is None:
        response = respond(motion, setting.bearing, setting.friction, setting.heating)
    pulses = find_pulses(motion, setting.threshold)
    analysed = analysed_of(response, pulses)
    predicted = predictions(motion, setting, pulses, analysed.pulse)
    answers = answers_for_motion(motion, pendulum_of(setting), bearing=setting.bearing) if codes else {}
    return Case(
        record=motion.name,
        event=event_of(motion),
        pgv=motion.peak_velocity,
        pulses=pulses,
        analysed=analysed,
        predicted=predicted
        | {(Method(name), Basis.SPECTRUM): _of_code(said) for name, said in answers.items()},
        answers=answers,
        remarks=response.remarks,
        response=response if keep_response else None,
    )


def pendulum_of(setting: Setting) -> PendulumWithFriction:
    """Return what the methods of codes take of a bearing: its radius and the nominal coefficient."""
    return PendulumWithFriction(setting.bearing.effective_radius, setting.constants.nominal_friction)


def _of_code(said: Answer) -> Prediction:
    return replace(NOTHING, displacement=said.displacement)


def predictions(
    motion: GroundMotion, setting: Setting, pulses: Pulses, pulse: int | None
) -> dict[View, Prediction]:
    """Return what every method says that can be used.

    `pulses` are those of the motion for the methods of Li et al. (2020); `pulse` is the number of the one that the
    analysis found to govern, for the informed ones, or None.
    """
    found: dict[View, Prediction] = {}
    for method, said in pulse_predictions(pulses, setting).items():
        found[method, Basis.BLIND] = said.largest
        found[method, Basis.INFORMED] = said.of(pulse)
    found |= design_prediction(motion, setting)
    found[Method.MARCH, Basis.BLIND] = march(motion, setting).prediction
    return found


def pulse_predictions(pulses: Pulses, setting: Setting) -> dict[Method, PulsePrediction]:
    """Return what the pulse method, and the simplified one where it can be used, say of every pulse."""
    found = {Method.PULSE: paper.predict_from_pulses(pulses, setting.constants)}
    if setting.constants.slides_on_average:
        found[Method.SIMPLIFIED] = paper.predict_simplified(pulses, setting.constants)
    return found


def design_prediction(motion: GroundMotion, setting: Setting) -> dict[View, Prediction]:
    """Return what the design method says of the PGV of a motion; nothing where it cannot be used."""
    if not (setting.constants.slides_on_average and motion.peak_velocity > 0.0):
        return {}
    return {(Method.DESIGN, Basis.PGV): paper.predict_from_pgv(motion.peak_velocity, setting.constants)}


def march(motion: GroundMotion, setting: Setting, *, with_path: bool = False) -> PulseMarch:
    """March through the pulses of a motion; `with_path` as for `march_through_pulses`."""
    pulses = find_pulses(motion, setting.march_threshold)
    return march_through_pulses(
        pulses, setting.bearing, setting.friction, setting.heating, with_path=with_path
    )


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
    governing = replace(
        whole, input_velocity=swing.input_velocity, hysteretic_velocity=swing.hysteretic_velocity
    )
    return Analysed(whole, governing, swing, pulse_behind(swing, pulses))


# Which pulse of the ground a swing of the structure belongs to.


#: Part of a swing that lies in the rise of a pulse, from which on the pulse is behind it even if it has its peak later [-].
_MOST = 0.5


def pulse_behind(swing: Swing, pulses: Pulses) -> int | None:
    """Return the number of the pulse that caused a swing, counted from zero; None where there is none.

    While the ground velocity rises to a peak the structure stays behind, so that y falls, and it goes on falling until it has caught up,
    as a rule some time after the peak. The pulse of a swing therefore has the sign opposite to the swing's, and its peak within the swing; or, where the
    structure catches up before the peak, at least half of the swing in its rise. Of several the one with the largest velocity change is meant. There is
    none where ripples below the threshold, or the pendulum alone, have moved the structure.
    """
    if swing.change == 0.0:
        return None
    peak_within = (swing.start <= pulses.peaks) & (pulses.peaks <= swing.end)
    together = np.minimum(swing.end, pulses.peaks) - np.maximum(swing.start, pulses.starts)
    fits = peak_within | (together >= _MOST * (swing.end - swing.start))
    fits &= np.sign(pulses.changes) == -np.sign(swing.change)
    if not fits.any():
        return None
    return int(np.argmax(np.where(fits, np.abs(pulses.changes), 0.0)))


@dataclass(frozen=True)
class Quantity:
    """One of them.

    Attributes
    ----------
    name
        Short, as in tables.
    key
        In JSON and data, with its unit.
    unit
        "mm" or "mm/s".
    """

    name: str
    key: str
    unit: str


#: Largest change of displacement between two successive peaks, and largest displacement.
CHANGE, DISPLACEMENT = Quantity("dy", "dy_mm", "mm"), Quantity("y", "y_mm", "mm")
#: Equivalent velocities of the energies put in and dissipated during a swing, and of all the energy put in.
INPUT, HYSTERETIC = Quantity("V_dE", "V_dE_mm_s", "mm/s"), Quantity("V_dEhr", "V_dEhr_mm_s", "mm/s")
TOTAL = Quantity("V_E", "V_E_mm_s", "mm/s")
#: In the order of tables.
QUANTITIES = (CHANGE, DISPLACEMENT, INPUT, HYSTERETIC, TOTAL)
