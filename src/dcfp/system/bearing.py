"""The bearing: one or two concave plates and a slider."""

import math
from dataclasses import replace
from typing import Annotated, Any

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.schema.declared import Declared, declared
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import KN_PER_MM, MM, N_PER_MM2

#: Stretch of spring (b) under a tenth of the vertical force above which a wrong unit is suspected [mm]; real bearings yield within some millimetres.
LARGEST_STRETCH = 30.0
#: Limits of the vertical force on one bearing, which a slip of the pressure or the slider would pass [N].
LEAST_LOAD, LARGEST_LOAD = 100.0, 1e9
#: Fields that make other plates.
PLATES = frozenset({"radii", "slider_diameter"})


@declared
class Bearing(Declared):
    """A friction pendulum bearing under its vertical load, with the rigid mass that it carries; what is not given is that of Li et al. (2020).

    Parameters
    ----------
    radii
        Effective spherical radius of each concave plate [mm]: two for a double concave bearing, in the
        order lower, upper; one for a single concave one. A plain number is that of both plates.
    elastic_stiffness
        kf of spring (b), the whole bearing before it slides [N/mm].

    Raises
    ------
    InputError
        If a value is not within its limits, or the values do not go together.

    Notes
    -----
    Of a relative displacement y each plate takes the share of its radius in their sum, as it does when both have the
    same coefficient of friction. With equal radii that is y/2 (Li et al. 2020, section 4.2).
    """

    noun = "a bearing"

    radii: Annotated[
        tuple[float, ...],
        Parameter(
            "effective radius of both plates, or of the lower and the upper one",
            MM, 100.0, 1e6, symbol="R_s", key="radius", aliases=("radii",), counts=(1, 2), repeat=2, step=100.0,
        ),
    ] = (4500.0, 4500.0)  # fmt: skip
    slider_diameter: Annotated[
        float, Parameter("diameter of the slider", MM, 10.0, 1e4, symbol=r"\phi", key="slider", step=10.0)
    ] = 400.0
    pressure: Annotated[
        float, Parameter("pressure on the slider", N_PER_MM2, 0.1, 1000.0, symbol=r"\sigma", step=1.0)
    ] = 60.0
    elastic_stiffness: Annotated[
        float,
        Parameter(
            "stiffness before sliding", KN_PER_MM, 1e-4, 1e6, symbol="k_f", key="stiffness", step=100.0
        ),
    ] = 1.9e6
    displacement_capacity: Annotated[
        float | None,
        Parameter("displacement capacity", MM, 1.0, 1e5, symbol="D_c", key="capacity", step=10.0, vary=False, absent="not known"),
    ] = None  # fmt: skip
    capacity_note: Annotated[str, Parameter("where the capacity comes from", option=False, vary=False)] = ""
    name: Annotated[str, Parameter("name of the bearing", option=False, vary=False)] = "bearing"

    def check_relations(self) -> None:
        """Refuse a slider larger than the sphere, a load or a stiffness that no bearing has."""
        sphere = 2.0 * min(self.radii)
        if self.slider_diameter >= sphere:
            msg = (
                f"The slider diameter, {self.slider_diameter:g} mm, must be smaller than"
                f" the diameter of the sphere, {sphere:g} mm."
            )
            raise InputError(msg)
        if not LEAST_LOAD <= self.vertical_force <= LARGEST_LOAD:
            msg = (
                f"A pressure of {self.pressure:g} N/mm2 on a slider of {self.slider_diameter:g} mm makes a vertical force of {self.vertical_force / 1e3:.3g} kN;"
                f" it must be from {LEAST_LOAD / 1e3:g} to {LARGEST_LOAD / 1e3:g} kN."
            )
            raise InputError(msg)
        stretch = 0.1 * self.vertical_force / self.elastic_stiffness
        if stretch > LARGEST_STRETCH:
            msg = (
                f"With a stiffness before sliding of {self.elastic_stiffness / 1e3:g} kN/mm the bearing would give way by {stretch:.3g} mm under a tenth of its load"
                f" before it slides; it must be at most {LARGEST_STRETCH:g} mm (were MN/mm meant?)."
            )
            raise InputError(msg)

    def changed(self, **changes: Any) -> "Bearing":
        """Return the bearing with other values; other plates do not have the capacity that the paper's bearing stands in for.

        Raises
        ------
        InputError
            If a value is out of range.
        """
        if "displacement_capacity" in changes:
            changes = {"capacity_note": "", **changes}
        elif PLATES & changes.keys() and self.capacity_note == LI_2020.capacity_note:
            changes = {"displacement_capacity": None, "capacity_note": "", **changes}
        return replace(self, **changes)

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

    def __str__(self) -> str:
        radii = " + ".join(f"{radius:g}" for radius in self.radii)
        capacity = self.displacement_capacity
        return (
            f"{self.name}: radius {radii} mm, slider {self.slider_diameter:g} mm,"
            f" {self.pressure:g} N/mm², {self.elastic_stiffness / 1e3:g} kN/mm,"
            f" W {self.vertical_force / 1e3:.0f} kN, period {self.period:.2f} s,"
            f" capacity {'not given' if capacity is None else f'{capacity:g} mm'}"
        )

    def card_facts(self) -> dict[str, Any]:
        """Return what follows from the parameters."""
        return {"vertical_force [N]": self.vertical_force, "mass [t]": self.mass, "period [s]": self.period}


#: The bearing of Li et al. (2020), sections 4 and 5.1. The paper prints no displacement capacity; its largest test
#: amplitude stands in for one (Table 2, T10 and T11).
LI_2020 = Bearing(
    displacement_capacity=440.0,
    capacity_note="largest amplitude tested by Li et al. (2020), Table 2; the paper prints no capacity",
    name="Li et al. (2020), phi 400",
)
