"""Displacement and energy of the isolation layer without a response history analysis: predictions, codes, spectra.

The names below predict from the ground velocity alone. What a code or another paper says is in the module that is named after it, each with the conditions under which it may be used.
"""

from dcfp.methods.pulse_march import PulseMarch as PulseMarch
from dcfp.methods.pulse_march import march_through_pulses as march_through_pulses
from dcfp.methods.pulses import NOTHING as NOTHING
from dcfp.methods.pulses import Prediction as Prediction
from dcfp.methods.pulses import PulsePrediction as PulsePrediction
from dcfp.methods.pulses import Pulses as Pulses
from dcfp.methods.pulses import find_pulses as find_pulses
