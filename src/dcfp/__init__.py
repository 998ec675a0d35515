"""Double concave friction pendulum bearings under recorded earthquakes.

The names below are in the order in which data flow: a record, a bearing, its response.
"""

from dcfp.bearing import LI_2020 as LI_2020
from dcfp.bearing import Bearing as Bearing
from dcfp.bearing import ConstantFriction as ConstantFriction
from dcfp.bearing import Constantinou1990 as Constantinou1990
from dcfp.bearing import Kumar2015 as Kumar2015
from dcfp.bearing import Li2020 as Li2020
from dcfp.bearing import NoHeating as NoHeating
from dcfp.bearing import PreciseHeating as PreciseHeating
from dcfp.bearing import SimplifiedHeating as SimplifiedHeating
from dcfp.bearing import UserFriction as UserFriction
from dcfp.bearing import read_bearing as read_bearing
from dcfp.errors import AnalysisError as AnalysisError
from dcfp.errors import DcfpError as DcfpError
from dcfp.errors import InputError as InputError
from dcfp.record.ground_motion import GroundMotion as GroundMotion
from dcfp.record.load import load_motion as load_motion
from dcfp.response import Response as Response
from dcfp.response import respond as respond
from dcfp.version import version as version
