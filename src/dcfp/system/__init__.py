"""Bearings, friction laws and heating models, and the system that they make."""

from dcfp.system.bearing import LI_2020 as LI_2020
from dcfp.system.bearing import Bearing as Bearing
from dcfp.system.friction import FRICTION_LAWS as FRICTION_LAWS
from dcfp.system.friction import ConstantFriction as ConstantFriction
from dcfp.system.friction import Constantinou1990 as Constantinou1990
from dcfp.system.friction import FittedFriction as FittedFriction
from dcfp.system.friction import FrictionLaw as FrictionLaw
from dcfp.system.friction import Kumar2015 as Kumar2015
from dcfp.system.friction import Li2020 as Li2020
from dcfp.system.friction import Lomiento2013 as Lomiento2013
from dcfp.system.friction import UserFriction as UserFriction
from dcfp.system.heating import HEATINGS as HEATINGS
from dcfp.system.heating import Heating as Heating
from dcfp.system.heating import NoHeating as NoHeating
from dcfp.system.heating import PreciseHeating as PreciseHeating
from dcfp.system.heating import SimplifiedHeating as SimplifiedHeating
from dcfp.system.heating import plates_of as plates_of
from dcfp.system.system import System as System
from dcfp.system.system import SystemLike as SystemLike
from dcfp.system.system import friction_law as friction_law
from dcfp.system.system import heating_model as heating_model
from dcfp.system.system import read_bearing as read_bearing
from dcfp.system.system import system_parameters as system_parameters
