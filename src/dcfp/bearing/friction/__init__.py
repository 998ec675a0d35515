"""Friction laws, one module for each paper."""

from dcfp.bearing.friction.constant import ConstantFriction as ConstantFriction
from dcfp.bearing.friction.constantinou_1990 import Constantinou1990 as Constantinou1990
from dcfp.bearing.friction.fitted import FittedFriction as FittedFriction
from dcfp.bearing.friction.kim_constantinou_2023 import KimConstantinou2023Third as KimConstantinou2023Third
from dcfp.bearing.friction.kim_constantinou_2023 import (
    KimConstantinou2023TwoThirds as KimConstantinou2023TwoThirds,
)
from dcfp.bearing.friction.kumar_2015 import Kumar2015 as Kumar2015
from dcfp.bearing.friction.law import FrictionLaw as FrictionLaw
from dcfp.bearing.friction.li_2020 import Li2020 as Li2020
from dcfp.bearing.friction.lomiento_2013 import Lomiento2013 as Lomiento2013
from dcfp.bearing.friction.named import friction_law as friction_law
from dcfp.bearing.friction.named import friction_names as friction_names
from dcfp.bearing.friction.user import UserFriction as UserFriction
