"""Response history analysis and its energy balance."""

from dcfp.analysis.energy import EnergyBalance as EnergyBalance
from dcfp.analysis.respond import respond as respond
from dcfp.analysis.response import Response as Response
from dcfp.analysis.response import Status as Status
