"""Procedures as a factor of a study: the analysis, and the methods that predict what it gives."""

from dataclasses import replace

import numpy as np

from dcfp.inference.case import (
    Method,
    Setting,
    design_prediction,
    march,
    pendulum_of,
    pulse_predictions,
)
from dcfp.inference.nominal import Nominal, nominal_coefficient
from dcfp.methods import NOTHING, Prediction, find_pulses
from dcfp.methods.li_2020 import LI_2020
from dcfp.methods.panel import answers_for_motion
from dcfp.motion.ground_motion import GroundMotion
from dcfp.system import System

#: The analysis itself.
ANALYSIS = "analysis"
#: Names of the procedures in a study, and what they stand for.
_PREDICTIONS: dict[str, Method] = {
    "pulse": Method.PULSE,
    "simplified": Method.SIMPLIFIED,
    "design": Method.DESIGN,
    "march": Method.MARCH,
    "asce7": Method.ASCE,
    "eurocode8": Method.EUROCODE,
    "aij1": Method.AIJ_1,
    "aij2": Method.AIJ_2,
    "aij-energy": Method.AIJ_ENERGY,
    "iwan": Method.IWAN,
}
PROCEDURES = (ANALYSIS, *_PREDICTIONS)
_OF_PULSES = (Method.PULSE, Method.SIMPLIFIED)


def setting_of(model: System) -> tuple[Setting, Nominal]:
    """Return how records are predicted on a model, and the nominal coefficient that stands for its law."""
    nominal = nominal_coefficient(model.bearing, model.friction, model.heating)
    constants = replace(LI_2020, nominal_friction=nominal.value)
    return Setting(model.bearing, model.friction, model.heating, constants), nominal


def predict(motion: GroundMotion, setting: Setting, name: str) -> Prediction:
    """Return what a method of that name says of a ground motion, without knowing the analysis."""
    method = _PREDICTIONS[name]
    if method in _OF_PULSES:
        predicted = pulse_predictions(find_pulses(motion, setting.threshold), setting).get(method)
        return NOTHING if predicted is None else predicted.largest
    if method is Method.DESIGN:
        return next(iter(design_prediction(motion, setting).values()), NOTHING)
    if method is Method.MARCH:
        return march(motion, setting).prediction
    answers = answers_for_motion(motion, pendulum_of(setting), bearing=setting.bearing)
    said = answers.get(method.value)
    return NOTHING if said is None else replace(NOTHING, displacement=said.displacement)


def peaks_of(said: Prediction) -> dict[str, float]:
    """Return what a prediction says of the quantities of a study; not a number where it says nothing."""
    return {
        "peak_displacement": said.bound,
        "peak_change": said.displacement_change,
        "input_velocity": np.nan if said.total_velocity is None else said.total_velocity,
    }
