"""Double concave friction pendulum bearings under recorded earthquakes.

The names below are in the order in which data flow: a record, a bearing, its response; a test program, its loops; pulses, a prediction, a comparison; a study of many. Each is imported when it is
first used, so that ``dcfp --help`` does not wait for the compiler of the kernels.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from dcfp.errors import AnalysisError as AnalysisError
from dcfp.errors import DcfpError as DcfpError
from dcfp.errors import InputError as InputError
from dcfp.version import version as version

if TYPE_CHECKING:
    from dcfp.bearing import LI_2020 as LI_2020
    from dcfp.bearing import Bearing as Bearing
    from dcfp.bearing import ConstantFriction as ConstantFriction
    from dcfp.bearing import Constantinou1990 as Constantinou1990
    from dcfp.bearing import FittedFriction as FittedFriction
    from dcfp.bearing import Kumar2015 as Kumar2015
    from dcfp.bearing import Li2020 as Li2020
    from dcfp.bearing import Lomiento2013 as Lomiento2013
    from dcfp.bearing import NoHeating as NoHeating
    from dcfp.bearing import PreciseHeating as PreciseHeating
    from dcfp.bearing import SimplifiedHeating as SimplifiedHeating
    from dcfp.bearing import UserFriction as UserFriction
    from dcfp.bearing import read_bearing as read_bearing
    from dcfp.building import ShearBuilding as ShearBuilding
    from dcfp.building import respond_building as respond_building
    from dcfp.comparison import compare as compare
    from dcfp.identification import identify as identify
    from dcfp.prediction import find_pulses as find_pulses
    from dcfp.prediction import march_through_pulses as march_through_pulses
    from dcfp.record.ground_motion import GroundMotion as GroundMotion
    from dcfp.record.load import load_motion as load_motion
    from dcfp.response import Response as Response
    from dcfp.response import respond as respond
    from dcfp.rig import Loops as Loops
    from dcfp.rig import Program as Program
    from dcfp.rig import load_program as load_program
    from dcfp.rig import read_measurement as read_measurement
    from dcfp.rig import run_program as run_program
    from dcfp.study import Sampling as Sampling
    from dcfp.study import Study as Study
    from dcfp.study import open_store as open_store
    from dcfp.study import read_study as read_study
    from dcfp.study import run_study as run_study

_HOMES = {
    "GroundMotion": "dcfp.record.ground_motion",
    "load_motion": "dcfp.record.load",
    "Bearing": "dcfp.bearing",
    "LI_2020": "dcfp.bearing",
    "read_bearing": "dcfp.bearing",
    "Li2020": "dcfp.bearing",
    "ConstantFriction": "dcfp.bearing",
    "Constantinou1990": "dcfp.bearing",
    "FittedFriction": "dcfp.bearing",
    "Kumar2015": "dcfp.bearing",
    "Lomiento2013": "dcfp.bearing",
    "UserFriction": "dcfp.bearing",
    "NoHeating": "dcfp.bearing",
    "SimplifiedHeating": "dcfp.bearing",
    "PreciseHeating": "dcfp.bearing",
    "respond": "dcfp.response",
    "Response": "dcfp.response",
    "Program": "dcfp.rig",
    "load_program": "dcfp.rig",
    "run_program": "dcfp.rig",
    "Loops": "dcfp.rig",
    "read_measurement": "dcfp.rig",
    "identify": "dcfp.identification",
    "ShearBuilding": "dcfp.building",
    "respond_building": "dcfp.building",
    "find_pulses": "dcfp.prediction",
    "march_through_pulses": "dcfp.prediction",
    "compare": "dcfp.comparison",
    "Study": "dcfp.study",
    "Sampling": "dcfp.study",
    "read_study": "dcfp.study",
    "run_study": "dcfp.study",
    "open_store": "dcfp.study",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        msg = f"module {__name__!r} has no attribute {name!r}"
        raise AttributeError(msg)
    value = getattr(import_module(_HOMES[name]), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOMES})
