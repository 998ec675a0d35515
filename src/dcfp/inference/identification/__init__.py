"""Friction laws from measured tests."""

from dcfp.inference.identification.fit import PARAMETERS as PARAMETERS
from dcfp.inference.identification.friction_history import FrictionHistory as FrictionHistory
from dcfp.inference.identification.friction_history import friction_history as friction_history
from dcfp.inference.identification.identify import DEFAULT as DEFAULT
from dcfp.inference.identification.identify import identify as identify
from dcfp.inference.identification.result import Estimate as Estimate
from dcfp.inference.identification.result import Held as Held
from dcfp.inference.identification.result import Identification as Identification
from dcfp.inference.identification.result import Prediction as Prediction
from dcfp.inference.identification.result import bearing_file as bearing_file
from dcfp.inference.identification.result import predict as predict
