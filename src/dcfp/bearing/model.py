"""What stands on the ground: a bearing with its friction law and its heating model."""

from dataclasses import dataclass, field

from dcfp.bearing.bearing import LI_2020, Bearing
from dcfp.bearing.friction import FrictionLaw, Li2020
from dcfp.bearing.heating import Heating, SimplifiedHeating


@dataclass(frozen=True)
class Model:
    """A bearing, its friction law and its heating model; by default those of Li et al. (2020), the heating simplified."""

    bearing: Bearing = LI_2020
    friction: FrictionLaw = field(default_factory=Li2020)
    heating: Heating = field(default_factory=SimplifiedHeating)
