"""One record at one PGV: what the analysis gives, and what each method says of it."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from dcfp.analysis import Response, respond
from dcfp.analysis.swings import Swing, swings_of
from dcfp.inference.earthquake import event_of
from dcfp.methods import NOTHING, Prediction, Pulses
from dcfp.methods.code import CodeInputs, CodeResult, code_methods
from dcfp.methods.code_comparison import code_results
from dcfp.methods.method import Information, Variant
from dcfp.methods.prediction import Ground, Methods, Predicted, prediction_methods
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import Motion, motion_of
from dcfp.schema.notebook import card
from dcfp.schema.parameters import refuse_other

#: Part of a swing that lies in the rise of a pulse, from which on the pulse is behind it even if it has its peak later [-].
_MOST = 0.5


@dataclass(frozen=True)
class Analysed:
    """What the response history analysis gives.

    Attributes
    ----------
    whole, governing
        Largest of all swings, each quantity by itself; and of the governing one, as an informed prediction
        has it.
    swing, pulse
        The swing of the largest change of displacement, and the number of the pulse behind it, from zero; or
        None.
    """

    whole: Prediction
    governing: Prediction
    swing: Swing | None
    pulse: int | None

    def beside(self, information: Information) -> Prediction:
        """Return what a prediction with this information is to be compared with."""
        return self.governing if information is Information.INFORMED else self.whole


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
    predicted
        What each method says, by what it knows; a method that cannot be used is not there.
    codes
        What the methods of codes say under the record's own spectrum, by name; empty where they were not
        asked.
    response
        The analysis itself, where it was to be kept.
    motion
        The record; None where it is not at hand.
    """

    record: str
    event: str
    pgv: float
    pulses: Pulses
    analysed: Analysed
    predicted: dict[Variant, Prediction]
    codes: dict[str, CodeResult] = field(default_factory=dict[str, CodeResult])
    remarks: tuple[str, ...] = ()
    response: Response | None = None
    motion: GroundMotion | None = None

    def _repr_html_(self) -> str:
        rows = [
            {
                "method": variant.method,
                "knows": variant.information.value,
                "y_max [mm]": said.bound,
                "verdict": self.codes[variant.method].verdict if variant.method in self.codes else "",
            }
            for variant, said in self.predicted.items()
        ]
        facts = {"PGV [mm/s]": self.pgv, "y_max by analysis [mm]": self.analysed.whole.bound}
        return card(f"Predictions of {self.record}", facts, rows=rows, remarks=self.remarks)


def compare(
    motion: Motion,
    methods: Methods | None = None,
    *,
    codes: bool = False,
    keep_response: bool = False,
    response: Response | None = None,
) -> Case:
    """Analyse a ground motion, or a record by its name or file, and predict the same by every method that can be used.

    Parameters
    ----------
    methods
        By default for the bearing of Li et al. (2020) with its law and the simplified heating model.
    codes, keep_response
        Whether the methods of codes are asked too, and whether the case keeps the analysis.
    response
        The analysis, where it is at hand.
    """
    motion, methods = motion_of(motion), Methods() if methods is None else methods
    refuse_other(methods, Methods, "methods", "Methods")
    system, ground = methods.system, Ground.of(motion)
    if response is None:
        response = respond(motion, system)
    pulses = ground.pulses(methods.threshold)
    analysed = analysed_of(response, pulses)
    results: dict[str, CodeResult] = {}
    if codes:
        asked = code_inputs(motion, methods)
        results, ground = code_results(asked), replace(ground, spectrum=asked.spectrum)
    said = _said(ground, methods)
    by_codes = {
        variant: replace(NOTHING, displacement=result.displacement)
        for name, result in results.items()
        for variant in code_methods()[name].variants
    }
    return Case(
        record=motion.name,
        event=event_of(motion),
        pgv=motion.peak_velocity,
        pulses=pulses,
        analysed=analysed,
        predicted=_known(said, analysed.pulse) | by_codes,
        codes=results,
        remarks=(*response.remarks, *(remark for one in said.values() for remark in one.remarks)),
        response=response if keep_response else None,
        motion=motion,
    )


def code_inputs(motion: GroundMotion, methods: Methods) -> CodeInputs:
    """Return what the methods of codes are given of a record: its spectrum, the bearing and the nominal coefficient."""
    return CodeInputs.of_record(motion, methods.system.bearing, methods.constants.nominal_friction)


def predictions(ground: Ground, methods: Methods, pulse: int | None) -> dict[Variant, Prediction]:
    """Return what every method of prediction says that can be used; `pulse` as for `Predicted.knowing`."""
    return _known(_said(ground, methods), pulse)


def _said(ground: Ground, methods: Methods) -> dict[str, Predicted]:
    """Return what every method of prediction says that can be used, by its name."""
    said = {name: method.predict(ground, methods) for name, method in prediction_methods().items()}
    return {name: one for name, one in said.items() if one is not None}


def _known(said: Mapping[str, Predicted], pulse: int | None) -> dict[Variant, Prediction]:
    """Return it with each of what the methods know."""
    return {
        variant: one.knowing(variant.information, pulse)
        for name, one in said.items()
        for variant in prediction_methods()[name].variants
    }


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
    return Analysed(whole, governing, swing, governing_pulse(swing, pulses))


def governing_pulse(swing: Swing, pulses: Pulses) -> int | None:
    """Return the number of the pulse that caused a swing, from zero; None where ripples or the pendulum alone did.

    While the ground velocity rises to a peak the structure stays behind, so that y falls until it has caught
    up, as a rule after the peak. The pulse of a swing therefore has the opposite sign, and its peak within
    the swing; or, where the structure catches up before, at least half of the swing in its rise. Of several
    the one with the largest velocity change is meant.
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
