"""Friction laws from measured tests."""

from dcfp.identification.bearing_file import bearing_file as bearing_file
from dcfp.identification.friction_history import FrictionHistory as FrictionHistory
from dcfp.identification.friction_history import friction_history as friction_history
from dcfp.identification.identify import DEFAULT as DEFAULT
from dcfp.identification.identify import identify as identify
from dcfp.identification.parameters import PARAMETERS as PARAMETERS
from dcfp.identification.predict import Prediction as Prediction
from dcfp.identification.predict import predict as predict
from dcfp.identification.result import Estimate as Estimate
from dcfp.identification.result import Held as Held
from dcfp.identification.result import Identification as Identification
