"""What is put into the fields, and the model that it makes."""

from dataclasses import dataclass

from dcfp.errors import InputError
from dcfp.system import LI_2020, Bearing, System, friction_law, heating_model

#: Laws and heating models in words.
LAWS = {
    "li2020": "Li et al. (2020), the paper's",
    "constant": "constant",
    "constantinou1990": "Constantinou et al. (1990)",
    "kumar2015": "Kumar et al. (2015)",
    "kim2023-third": "Kim and Constantinou (2023), a third at 200 °C",
    "kim2023-two-thirds": "Kim and Constantinou (2023), two thirds at 200 °C",
    "lomiento2013": "Lomiento et al. (2013), unconfirmed",
}
HEATINGS = {
    "simplified": "one point at the centre (simplified)",
    "precise": "the whole line of the plate (precise)",
    "none": "none",
}


@dataclass(frozen=True)
class Limits:
    """Least and largest value of a field, and the step of its buttons."""

    least: float
    most: float
    step: float


#: Limits of the fields, in the units that stand beside them: what a wrong unit would pass.
LIMITS = {
    "lower_radius": Limits(100.0, 1e5, 100.0),
    "upper_radius": Limits(100.0, 1e5, 100.0),
    "slider": Limits(10.0, 5000.0, 10.0),
    "pressure": Limits(0.1, 500.0, 1.0),
    "stiffness": Limits(1.0, 1e6, 100.0),
    "capacity": Limits(1.0, 1e4, 10.0),
    "mu": Limits(0.001, 0.5, 0.005),
    "ambient": Limits(-60.0, 100.0, 5.0),
    "thickness": Limits(10.0, 200.0, 5.0),
}
_WORDS = {
    "lower_radius": ("radius of the lower plate", "mm"),
    "upper_radius": ("radius of the upper plate", "mm"),
    "slider": ("slider diameter", "mm"),
    "pressure": ("pressure on the slider", "N/mm²"),
    "stiffness": ("stiffness before sliding", "kN/mm"),
    "capacity": ("displacement capacity", "mm"),
    "mu": ("reference coefficient", "-"),
    "ambient": ("ambient temperature", "°C"),
    "thickness": ("thickness of the plates", "mm"),
}
#: Fields that may be empty.
_OPTIONAL = ("capacity", "thickness")


@dataclass
class BearingForm:
    """The fields of a bearing, with the paper's values.

    Attributes
    ----------
    lower_radius, upper_radius, slider, capacity, thickness
        [mm]; the last two may be None.
    pressure
        [N/mm2].
    stiffness
        Before sliding [kN/mm].
    law, heating
        Names.
    mu
        Reference coefficient of the law [-].
    ambient
        [degC].
    """

    lower_radius: float | None = LI_2020.radii[0]
    upper_radius: float | None = LI_2020.radii[1]
    slider: float | None = LI_2020.slider_diameter
    pressure: float | None = LI_2020.pressure
    stiffness: float | None = LI_2020.elastic_stiffness / 1e3
    capacity: float | None = LI_2020.displacement_capacity
    law: str = "li2020"
    mu: float | None = 0.075
    ambient: float | None = 20.0
    heating: str = "simplified"
    thickness: float | None = None

    def model(self) -> System:
        """Return the bearing with its law and heating model.

        Raises
        ------
        InputError
            If a field is empty or out of range.
        """
        values = {name: self._checked(name) for name in LIMITS}
        law = friction_law(self.law)
        if values["mu"] != law.reference:
            law = law.with_reference(values["mu"])
        thickness = None if self.thickness is None else values["thickness"]
        heating = heating_model(self.heating, {"ambient": values["ambient"], "thickness": thickness})
        return System(self._bearing(values), law, heating)

    def _bearing(self, values: dict[str, float]) -> Bearing:
        capacity = None if self.capacity is None else values["capacity"]
        numbers = (
            (values["lower_radius"], values["upper_radius"]),
            values["slider"],
            values["pressure"],
            values["stiffness"] * 1e3,
            capacity,
        )
        paper = (
            LI_2020.radii,
            LI_2020.slider_diameter,
            LI_2020.pressure,
            LI_2020.elastic_stiffness,
            LI_2020.displacement_capacity,
        )
        return LI_2020 if numbers == paper else Bearing(*numbers, name="bearing of the page")

    def _checked(self, name: str) -> float:
        value: float | None = getattr(self, name)
        words, unit = _WORDS[name]
        if value is None:
            if name in _OPTIONAL:
                return 0.0
            msg = f"The {words} [{unit}] is missing."
            raise InputError(msg)
        limits = LIMITS[name]
        if not limits.least <= value <= limits.most:
            shown = "" if unit == "-" else f" {unit}"
            msg = f"The {words} must be from {limits.least:g} to {limits.most:g}{shown}, not {value:.12g}."
            raise InputError(msg)
        return float(value)


def reference_of(law: str) -> float:
    """Return the reference coefficient that a law has of its own [-]."""
    return friction_law(law).reference
