"""Response history analysis and its energy balance."""

from dcfp.response.energy import EnergyBalance as EnergyBalance
from dcfp.response.respond import respond as respond
from dcfp.response.response import Response as Response
from dcfp.response.status import Status as Status
