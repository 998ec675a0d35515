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
    from dcfp.analysis import Response as Response
    from dcfp.analysis import respond as respond
    from dcfp.analysis.building import ShearBuilding as ShearBuilding
    from dcfp.analysis.building import respond_building as respond_building
    from dcfp.analysis.rig import Loops as Loops
    from dcfp.analysis.rig import Program as Program
    from dcfp.analysis.rig import load_program as load_program
    from dcfp.analysis.rig import read_measurement as read_measurement
    from dcfp.analysis.rig import run_program as run_program
    from dcfp.inference import compare as compare
    from dcfp.inference.identification import identify as identify
    from dcfp.methods import find_pulses as find_pulses
    from dcfp.methods import march_through_pulses as march_through_pulses
    from dcfp.motion.ground_motion import GroundMotion as GroundMotion
    from dcfp.motion.load import load_motion as load_motion
    from dcfp.study import Sampling as Sampling
    from dcfp.study import Study as Study
    from dcfp.study import open_store as open_store
    from dcfp.study import read_study as read_study
    from dcfp.study import run_study as run_study
    from dcfp.system import LI_2020 as LI_2020
    from dcfp.system import Bearing as Bearing
    from dcfp.system import ConstantFriction as ConstantFriction
    from dcfp.system import Constantinou1990 as Constantinou1990
    from dcfp.system import FittedFriction as FittedFriction
    from dcfp.system import Kumar2015 as Kumar2015
    from dcfp.system import Li2020 as Li2020
    from dcfp.system import Lomiento2013 as Lomiento2013
    from dcfp.system import NoHeating as NoHeating
    from dcfp.system import PreciseHeating as PreciseHeating
    from dcfp.system import SimplifiedHeating as SimplifiedHeating
    from dcfp.system import UserFriction as UserFriction
    from dcfp.system import read_bearing as read_bearing

_HOMES = {
    "GroundMotion": "dcfp.motion.ground_motion",
    "load_motion": "dcfp.motion.load",
    "Bearing": "dcfp.system",
    "LI_2020": "dcfp.system",
    "read_bearing": "dcfp.system",
    "Li2020": "dcfp.system",
    "ConstantFriction": "dcfp.system",
    "Constantinou1990": "dcfp.system",
    "FittedFriction": "dcfp.system",
    "Kumar2015": "dcfp.system",
    "Lomiento2013": "dcfp.system",
    "UserFriction": "dcfp.system",
    "NoHeating": "dcfp.system",
    "SimplifiedHeating": "dcfp.system",
    "PreciseHeating": "dcfp.system",
    "respond": "dcfp.analysis",
    "Response": "dcfp.analysis",
    "Program": "dcfp.analysis.rig",
    "load_program": "dcfp.analysis.rig",
    "run_program": "dcfp.analysis.rig",
    "Loops": "dcfp.analysis.rig",
    "read_measurement": "dcfp.analysis.rig",
    "identify": "dcfp.inference.identification",
    "ShearBuilding": "dcfp.analysis.building",
    "respond_building": "dcfp.analysis.building",
    "find_pulses": "dcfp.methods",
    "march_through_pulses": "dcfp.methods",
    "compare": "dcfp.inference",
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
