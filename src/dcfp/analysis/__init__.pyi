from .integration import Integration as Integration
from .integration import Keep as Keep
from .plane_response import PlaneResponse as PlaneResponse
from .response import Response as Response
from .response import Status as Status
from .response_history import respond as respond
from .result import EnergyBalance as EnergyBalance
