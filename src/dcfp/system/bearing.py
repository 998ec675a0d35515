"""The bearing: one or two concave plates and a slider; and with its friction law and its heating model, what stands on the ground."""

import math
from dataclasses import dataclass, field

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.schema.notebook import fields_card
from dcfp.system.checks import positive
from dcfp.system.friction import FrictionLaw, Li2020
from dcfp.system.heating import Heating, SimplifiedHeating


@dataclass(frozen=True)
class Bearing:
    """A friction pendulum bearing under its vertical load, with the rigid mass that it carries.

    Parameters
    ----------
    radii
        Effective spherical radius of each concave plate [mm]: two for a double concave bearing, in the
        order lower, upper; one for a single concave one.
    slider_diameter
        phi [mm].
    pressure
        sigma, vertical force over the slider's area [N/mm2].
    elastic_stiffness
        kf of spring (b), the whole bearing before it slides [N/mm].
    displacement_capacity
        Displacement that the bearing must not exceed [mm]; None where it is not known.
    capacity_note
        Where the capacity comes from.
    name
        Name in tables.

    Notes
    -----
    Of a relative displacement y each plate takes the share of its radius in their sum, as it does when both have the
    same coefficient of friction. With equal radii that is y/2 (Li et al. 2020, section 4.2).
    """

    radii: tuple[float, ...]
    slider_diameter: float
    pressure: float
    elastic_stiffness: float
    displacement_capacity: float | None = None
    capacity_note: str = ""
    name: str = "bearing"

    def __post_init__(self) -> None:
        if len(self.radii) not in (1, 2):
            msg = f"A bearing has one radius (single concave) or two (double concave), not {len(self.radii)}."
            raise InputError(msg)
        radii = tuple(positive(radius, "radius of a concave plate", "mm") for radius in self.radii)
        object.__setattr__(self, "radii", radii)
        positive(self.slider_diameter, "slider diameter", "mm")
        positive(self.pressure, "pressure on the slider", "N/mm2")
        positive(self.elastic_stiffness, "elastic stiffness", "N/mm")
        if self.displacement_capacity is not None:
            positive(self.displacement_capacity, "displacement capacity", "mm")
        if self.slider_diameter >= 2.0 * min(radii):
            msg = (
                f"The slider diameter, {self.slider_diameter:g} mm, must be smaller than"
                f" the diameter of the sphere, {2.0 * min(radii):g} mm."
            )
            raise InputError(msg)

    @property
    def effective_radius(self) -> float:
        """Sum of the radii [mm]: 2 Rs for two equal plates."""
        return sum(self.radii)

    @property
    def slider_area(self) -> float:
        """Area of the slider [mm2]."""
        return math.pi * self.slider_diameter**2 / 4.0

    @property
    def vertical_force(self) -> float:
        """Vertical force N [N]."""
        return self.pressure * self.slider_area

    @property
    def mass(self) -> float:
        """Mass m of the rigid structure, N / g [t]."""
        return self.vertical_force / STANDARD_GRAVITY

    @property
    def restoring_stiffness(self) -> float:
        """Stiffness kra of spring (a), N / (2 Rs) for two equal plates [N/mm]."""
        return self.vertical_force / self.effective_radius

    @property
    def period(self) -> float:
        """Period of the pendulum [s]."""
        return 2.0 * math.pi * math.sqrt(self.effective_radius / STANDARD_GRAVITY)

    @property
    def contact_half_side(self) -> float:
        """Half side of the square with the area of the round contact, sqrt(pi) r / 2 [mm]: Eq. (12)."""
        return math.sqrt(math.pi) * self.slider_diameter / 4.0

    @property
    def shares(self) -> tuple[float, ...]:
        """Share of the relative displacement that each plate takes [-]."""
        return tuple(radius / self.effective_radius for radius in self.radii)

    def _repr_html_(self) -> str:
        facts = {"vertical_force [N]": self.vertical_force, "mass [t]": self.mass, "period [s]": self.period}
        return fields_card(self, f"Bearing {self.name}", facts)


#: The bearing of Li et al. (2020), sections 4 and 5.1. The paper prints no displacement capacity; its largest test
#: amplitude stands in for one (Table 2, T10 and T11).
LI_2020 = Bearing(
    radii=(4500.0, 4500.0),
    slider_diameter=400.0,
    pressure=60.0,
    elastic_stiffness=1.9e6,
    displacement_capacity=440.0,
    capacity_note="largest amplitude tested by Li et al. (2020), Table 2; the paper prints no capacity",
    name="Li et al. (2020), phi 400",
)


@dataclass(frozen=True)
class Model:
    """A bearing, its friction law and its heating model; by default those of Li et al. (2020), the heating simplified."""

    bearing: Bearing = LI_2020
    friction: FrictionLaw = field(default_factory=Li2020)
    heating: Heating = field(default_factory=SimplifiedHeating)

    def _repr_html_(self) -> str:
        facts = {"friction": repr(self.friction), "heating": repr(self.heating)}
        return fields_card(self.bearing, self.bearing.name, facts)
