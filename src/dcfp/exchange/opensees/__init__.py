"""A bearing, or a whole building on its bearings, under a ground motion as a script for OpenSeesPy that needs nothing of this package."""

from dcfp.exchange.opensees.plan import plan_script as plan_script
from dcfp.exchange.opensees.script import model_script as model_script
from dcfp.exchange.opensees.script import opensees_script as opensees_script
