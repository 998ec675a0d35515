"""What stands in the fields, in the units beside them, and the system that it makes."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import takewhile
from typing import Any

from dcfp.errors import InputError
from dcfp.schema.declared import Declared, build, parameters
from dcfp.schema.parameters import Parameter
from dcfp.schema.quantities import Quantity
from dcfp.system import (
    FRICTION_LAWS,
    HEATINGS,
    LI_2020,
    Bearing,
    FrictionLaw,
    Heating,
    System,
    system_parameters,
)
from dcfp.system.system import OF_LAW

#: Fields of the two plates, whose radii are one parameter of a bearing.
RADII = ("lower_radius", "upper_radius")
#: What the friction of a new page is, and its heat.
_BEGIN = System(LI_2020)


def label_of(one: Parameter | Quantity) -> str:
    """Return the label of a field or of a result."""
    return one.words[:1].upper() + one.words[1:]


def read_field(one: Parameter, value: Any) -> Any:
    """Return what stands in a field in the package's unit.

    Raises
    ------
    InputError
        If the field is empty, or its value is not allowed.
    """
    if value is None and not one.optional:
        msg = f"The {one.words}{f' {one.unit.heading}' if one.unit.has_dimension else ''} is missing."
        raise InputError(msg)
    if one.counts and isinstance(value, str):
        value = value.split(",")
    return one.read(value, f"The {one.words}")


def read_fields(fields: Mapping[str, Parameter], values: Mapping[str, Any]) -> dict[str, Any]:
    """Return what stands in some fields by the names of their parameters; raises as `read_field`."""
    return {one.name: read_field(one, values[key]) for key, one in fields.items()}


def bearing_fields() -> dict[str, Parameter]:
    """Return the parameters of a bearing that have a field, with a radius for each plate."""
    known = system_parameters()
    first = takewhile(lambda key: key != "law", known)
    return {key: known[key] for key in first if known[key].is_number and not known[key].counts}


def fields_of(kind: type[Declared], before: str = "") -> dict[str, Parameter]:
    """Return the parameters of a declared class that have a field: all but free words; keys begin with `before`."""
    found = parameters(kind).values()
    return {before + one.key: one for one in found if one.is_number or one.kind is bool or one.choices}


def _written(fields: Mapping[str, Parameter], thing: object) -> dict[str, Any]:
    return {key: one.written(getattr(thing, one.name)) for key, one in fields.items()}


@dataclass
class BearingForm:
    """The fields of a bearing, its friction law and its heating model; at first the paper's values.

    Attributes
    ----------
    values
        What stands in each field by its key, in the unit beside it; None in an empty one.
    """

    values: dict[str, Any] = field(default_factory=dict[str, Any])

    def __post_init__(self) -> None:
        self.values = self.values or self._of(_BEGIN)

    @property
    def law(self) -> type[FrictionLaw]:
        """The friction law that is chosen."""
        return FRICTION_LAWS.find(self.values["law"])

    @property
    def heating(self) -> type[Heating]:
        """The heating model that is chosen."""
        return HEATINGS.find(self.values["heating"])

    def law_fields(self) -> dict[str, Parameter]:
        """Return the parameters of the chosen law that have a field, its reference coefficient first."""
        fields = fields_of(self.law, OF_LAW)
        first = self.reference
        return fields if not first else {first: fields.pop(first), **fields}

    def heating_fields(self) -> dict[str, Parameter]:
        """Return the parameters of the chosen heating model that have a field."""
        return fields_of(self.heating)

    @property
    def reference(self) -> str:
        """Key of the reference coefficient of the chosen law; empty where it has none."""
        name = self.law.reference_parameter
        return next((key for key, one in fields_of(self.law, OF_LAW).items() if one.name == name), "")

    def put(self, key: str, value: Any) -> None:
        """Put a value into a field; another law or heating model brings its own parameters, and a reference coefficient scales its law."""
        if key == "law":
            self.values |= {
                key: value,
                **_written(fields_of(FRICTION_LAWS.find(value), OF_LAW), FRICTION_LAWS.find(value)()),
            }
        elif key == "heating":
            self.values[key] = value
            for name, one in self.heating_fields().items():
                self.values.setdefault(name, one.written(one.default))
        elif key == self.reference:
            self._scale(key, value)
        else:
            self.values[key] = value

    def reset(self) -> None:
        """Put the paper's values into every field."""
        self.values = self._of(_BEGIN)

    def system(self) -> System:
        """Return what the fields hold.

        Raises
        ------
        InputError
            If a field is empty, or its value is not allowed.
        """
        return System(
            self._bearing(),
            self._law(),
            build(self.heating, read_fields(self.heating_fields(), self.values), ""),
        )

    def _bearing(self) -> Bearing:
        known = {key: read_field(one, self.values[key]) for key, one in bearing_fields().items()}
        found: dict[str, Any] = {"radii": tuple(known[key] for key in RADII)}
        found |= {one.name: known[key] for key, one in bearing_fields().items() if key not in RADII}
        if all(getattr(LI_2020, name) == value for name, value in found.items()):
            return LI_2020
        return Bearing(**found, name="bearing of the page")

    def _law(self) -> FrictionLaw:
        return build(self.law, read_fields(self.law_fields(), self.values), "")

    def _scale(self, key: str, value: Any) -> None:
        """Put in a reference coefficient and, where it and the rest are allowed, what it makes of the law's other parameters."""
        try:
            law = self._law().with_reference(read_field(self.law_fields()[key], value))
        except InputError:
            self.values[key] = value
        else:
            self.values |= _written(self.law_fields(), law)

    @staticmethod
    def _of(system: System) -> dict[str, Any]:
        bearing = bearing_fields()
        radii = dict(zip(RADII, system.bearing.radii, strict=True))
        own = {key: one for key, one in bearing.items() if key not in RADII}
        return {
            **radii,
            **_written(own, system.bearing),
            "law": system.friction.name,
            **_written(fields_of(type(system.friction), OF_LAW), system.friction),
            "heating": system.heating.name,
            **_written(fields_of(type(system.heating)), system.heating),
        }  # fmt: skip
