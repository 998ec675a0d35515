"""Friction laws, one module for each paper."""

from dcfp.system.friction.constant import ConstantFriction as ConstantFriction
from dcfp.system.friction.constantinou_1990 import Constantinou1990 as Constantinou1990
from dcfp.system.friction.fitted import FittedFriction as FittedFriction
from dcfp.system.friction.kumar_2015 import KimConstantinou2023Third as KimConstantinou2023Third
from dcfp.system.friction.kumar_2015 import KimConstantinou2023TwoThirds as KimConstantinou2023TwoThirds
from dcfp.system.friction.kumar_2015 import Kumar2015 as Kumar2015
from dcfp.system.friction.law import FRICTION_LAWS as FRICTION_LAWS
from dcfp.system.friction.law import FrictionLaw as FrictionLaw
from dcfp.system.friction.li_2020 import Li2020 as Li2020
from dcfp.system.friction.lomiento_2013 import Lomiento2013 as Lomiento2013
from dcfp.system.friction.user import UserFriction as UserFriction
