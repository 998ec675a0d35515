"""Procedures as a factor of a study: the analysis, and the methods that predict what it gives."""

from dataclasses import replace

import numpy as np

from dcfp.inference.case import code_inputs
from dcfp.methods import METHODS, NOTHING, Prediction
from dcfp.methods.code import CodeMethod
from dcfp.methods.code_comparison import code_results
from dcfp.methods.prediction import Ground, Methods, PredictionMethod
from dcfp.motion.ground_motion import GroundMotion

#: The analysis itself.
ANALYSIS = "analysis"


def procedures() -> tuple[str, ...]:
    """Return the names of the procedures: the analysis, and every method by its key."""
    return (ANALYSIS, *METHODS)


def predict(motion: GroundMotion, methods: Methods, key: str) -> Prediction:
    """Return what a method says of a ground motion, without knowing the analysis."""
    method = METHODS[key]
    if isinstance(method, CodeMethod):
        result = code_results(code_inputs(motion, methods), only=(method,)).get(method.name)
        return NOTHING if result is None else replace(NOTHING, displacement=result.displacement)
    predicted = method.predict(Ground.of(motion), methods) if isinstance(method, PredictionMethod) else None
    return NOTHING if predicted is None else predicted.prediction


def peaks_of(said: Prediction) -> dict[str, float]:
    """Return what a prediction says of the quantities of a study; not a number where it says nothing."""
    return {
        "peak_displacement": said.bound,
        "peak_change": said.displacement_change,
        "input_velocity": np.nan if said.total_velocity is None else said.total_velocity,
    }
