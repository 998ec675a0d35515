"""What stands on the ground: a bearing with its friction law and its heating model."""

from dataclasses import dataclass, field

from dcfp.schema.notebook import fields_card
from dcfp.system.bearing import LI_2020, Bearing
from dcfp.system.friction import FrictionLaw, Li2020
from dcfp.system.heating import Heating, SimplifiedHeating


@dataclass(frozen=True)
class Model:
    """A bearing, its friction law and its heating model; by default those of Li et al. (2020), the heating simplified."""

    bearing: Bearing = LI_2020
    friction: FrictionLaw = field(default_factory=Li2020)
    heating: Heating = field(default_factory=SimplifiedHeating)

    def _repr_html_(self) -> str:
        facts = {"friction": repr(self.friction), "heating": repr(self.heating)}
        return fields_card(self.bearing, self.bearing.name, facts)
