"""Displacement and energy of the isolation layer from the ground velocity alone, without a response history analysis."""

from dcfp.prediction.pulse_march import PulseMarch as PulseMarch
from dcfp.prediction.pulse_march import march_through_pulses as march_through_pulses
from dcfp.prediction.pulses import Pulses as Pulses
from dcfp.prediction.pulses import find_pulses as find_pulses
from dcfp.prediction.result import NOTHING as NOTHING
from dcfp.prediction.result import Prediction as Prediction
from dcfp.prediction.result import PulsePrediction as PulsePrediction
