"""What a study can vary: each factor with its unit, its limits, and what it changes."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields, replace
from difflib import get_close_matches
from enum import Enum
from typing import Any, TypeAlias

from dcfp.errors import InputError
from dcfp.system import (
    LI_2020,
    Bearing,
    Heating,
    Model,
    friction_law,
    friction_names,
    heating_model,
    heating_names,
    plates_of,
)

Value: TypeAlias = float | str


class Role(Enum):
    """What a factor is part of."""

    MOTION = "the ground motion"
    MODEL = "the bearing, its friction or its heating"
    PROCEDURE = "the procedure"


@dataclass(frozen=True)
class Factor:
    """Something that a study varies.

    Attributes
    ----------
    name
        As in a study file, and as the coordinate of the results.
    words
        What it is.
    role
        What it is part of.
    unit
        Inside the package, as a study file may write it; empty for a factor whose values are words.
    cf_unit
        The same as UDUNITS writes it.
    limits
        Smallest and largest value that a wrong unit would pass.
    change
        Returns a model with that value; None for what is not part of the model, or a part of the bearing.
    part
        Writes the value into fields of a bearing that are yet to be checked together; None for what is not a part of the bearing.
    """

    name: str
    words: str
    role: Role
    unit: str
    cf_unit: str
    limits: tuple[float, float]
    change: Callable[[Model, Any], Model] | None = None
    part: Callable[[dict[str, Any], Any], None] | None = None

    @property
    def is_number(self) -> bool:
        """Whether its values are numbers."""
        return bool(self.unit)

    @property
    def has_dimension(self) -> bool:
        """Whether its values need a unit."""
        return self.unit not in ("", "1")


def _number(
    name: str, words: str, units: tuple[str, str], limits: tuple[float, float], change: Any = None
) -> Factor:
    role = Role.MODEL if change is not None else Role.MOTION
    return Factor(name, words, role, *units, limits, change)


def _part(name: str, words: str, units: tuple[str, str], limits: tuple[float, float], part: Any) -> Factor:
    return Factor(name, words, Role.MODEL, *units, limits, part=part)


def _words(name: str, words: str, role: Role, change: Any = None) -> Factor:
    return Factor(name, words, role, "", "", (0.0, 0.0), change)


# ----- what a factor changes -----


def _both_radii(fields: dict[str, Any], value: float) -> None:
    fields["radii"] = (value,) * len(fields["radii"])


def _radius_of(plate: int) -> Callable[[dict[str, Any], float], None]:
    def part(fields: dict[str, Any], value: float) -> None:
        radii = list(fields["radii"])
        if len(radii) != 2:
            msg = (
                "lower_radius and upper_radius are of a double concave bearing; of a single one vary radius."
            )
            raise InputError(msg)
        radii[plate] = value
        fields["radii"] = tuple(radii)

    return part


def _field(name: str) -> Callable[[dict[str, Any], float], None]:
    def part(fields: dict[str, Any], value: float) -> None:
        fields[name] = value

    return part


def _law(model: Model, name: str) -> Model:
    return replace(model, friction=model.friction if name == model.friction.name else friction_law(name))


def _heating(model: Model, name: str) -> Model:
    heating: Heating = model.heating
    if name != heating.name:
        heating = heating_model(name, **plates_of(heating))
    return replace(model, heating=heating)


def _reference(model: Model, value: float) -> Model:
    return replace(model, friction=model.friction.with_reference(value))


def _property_factor(model: Model, value: float) -> Model:
    return _reference(model, value * model.friction.reference)


def _heating_parameter(name: str) -> Callable[[Model, float], Model]:
    return lambda model, value: replace(model, heating=replace(model.heating, **{name: value}))


_MILLIMETRE, _SPEED, _NONE = ("mm", "mm"), ("mm/s", "mm s-1"), ("1", "1")
_PRESSURE, _DEGREE = ("N/mm**2", "N mm-2"), ("degC", "degC")

#: In the order in which they are applied: a whole bearing first, then the law, then what changes a law.
CATALOGUE: tuple[Factor, ...] = (
    _words("record", "ground motion", Role.MOTION),
    _number("pgv", "peak ground velocity", _SPEED, (1.0, 2e4)),
    _number("pga", "peak ground acceleration", ("mm/s**2", "mm s-2"), (1.0, 2e5)),
    _number("scale", "factor on the ground motion", _NONE, (1e-3, 1e3)),
    _words("bearing", "bearing file", Role.MODEL),
    _part(
        "radius",
        "effective radius of each plate",
        _MILLIMETRE,
        (100.0, 1e6),
        _both_radii,
    ),
    _part(
        "lower_radius",
        "effective radius of the lower plate",
        _MILLIMETRE,
        (100.0, 1e6),
        _radius_of(0),
    ),
    _part(
        "upper_radius",
        "effective radius of the upper plate",
        _MILLIMETRE,
        (100.0, 1e6),
        _radius_of(1),
    ),
    _part(
        "slider",
        "diameter of the slider",
        _MILLIMETRE,
        (10.0, 1e4),
        _field("slider_diameter"),
    ),
    _part(
        "pressure",
        "pressure on the slider",
        _PRESSURE,
        (0.1, 1000.0),
        _field("pressure"),
    ),
    _part(
        "stiffness",
        "stiffness before sliding",
        ("N/mm", "N mm-1"),
        (1e3, 1e9),
        _field("elastic_stiffness"),
    ),
    _words("law", "friction law", Role.MODEL, _law),
    _number("mu", "reference coefficient of the friction law", _NONE, (1e-4, 0.9999), _reference),
    _number("lambda", "property factor on the reference coefficient", _NONE, (0.05, 20.0), _property_factor),
    _words("heating", "heating model", Role.MODEL, _heating),
    _number("ambient", "temperature at the start", _DEGREE, (-60.0, 200.0), _heating_parameter("ambient")),
    _number(
        "conductivity",
        "thermal conductivity of the plates",
        ("N/(s*K)", "N s-1 K-1"),
        (0.1, 1000.0),
        _heating_parameter("conductivity"),
    ),
    _number(
        "diffusivity",
        "thermal diffusivity of the plates",
        ("mm**2/s", "mm2 s-1"),
        (0.01, 1000.0),
        _heating_parameter("diffusivity"),
    ),
    _number(
        "thickness",
        "thickness of the plates",
        _MILLIMETRE,
        (10.0, 200.0),
        _heating_parameter("thickness"),
    ),
    _words("procedure", "response history analysis, or a method of prediction", Role.PROCEDURE),
)
_BY_NAME = {factor.name: factor for factor in CATALOGUE}
#: Factors that make other plates.
PLATES = frozenset({"radius", "lower_radius", "upper_radius", "slider"})
#: Before the name of a parameter of the friction law, in the units of this package.
OF_LAW = "friction."
#: Choices of the factors whose values are words out of a few.
CHOICES: Mapping[str, tuple[str, ...]] = {"law": friction_names(), "heating": heating_names()}


def factor(name: str) -> Factor:
    """Return a factor by its name; ``friction.`` and a name is that parameter of the friction law.

    Raises
    ------
    InputError
        If there is none of that name.
    """
    if name in _BY_NAME:
        return _BY_NAME[name]
    if name.startswith(OF_LAW):
        return _law_parameter(name.removeprefix(OF_LAW))
    near = get_close_matches(name, _BY_NAME, n=1)
    meant = (
        f"did you mean {near[0]!r}?"
        if near
        else f"the factors are {', '.join(_BY_NAME)} and {OF_LAW}PARAMETER."
    )
    msg = f"there is no factor {name!r}; {meant}"
    raise InputError(msg)


def changed(model: Model, values: Mapping[str, Value], bearings: Mapping[str, Model]) -> Model:
    """Return a model with the values of factors put before its own; `bearings` are those that the factor ``bearing`` names.

    Raises
    ------
    InputError
        If there cannot be such a model.
    """
    names = sorted(values, key=_order_of)
    if "bearing" in values:
        model = bearings[str(values["bearing"])]
    parts = {name: part for name in names if (part := factor(name).part) is not None}
    if parts:
        fields = vars(model.bearing).copy()
        for name, part in parts.items():
            part(fields, values[name])
        model = replace(model, bearing=_new_bearing(model.bearing, fields, parts))
    for name in names:
        change = factor(name).change
        if change is not None:
            model = change(model, values[name])
    return model


def _new_bearing(bearing: Bearing, fields: dict[str, Any], names: Iterable[str]) -> Bearing:
    """Return a bearing with those fields; where its plates are varied, none has the capacity of the paper's."""
    if PLATES & set(names) and bearing.capacity_note == LI_2020.capacity_note:
        fields |= {"displacement_capacity": None, "capacity_note": ""}
    return Bearing(**fields)


def _order_of(name: str) -> int:
    """Return the place of a factor in the order in which they are applied; parameters of the law come right after the law."""
    names = [one.name for one in CATALOGUE]
    return 2 * names.index(name) if name in names else 2 * names.index("law") + 1


def _law_parameter(name: str) -> Factor:
    def change(model: Model, value: float) -> Model:
        law: Any = model.friction
        known = [item.name for item in fields(law) if item.init]
        if name not in known:
            msg = f"the friction law {law.name} has no parameter {name!r}; it has {', '.join(known)}."
            raise InputError(msg)
        return replace(model, friction=replace(law, **{name: value}))

    limits = (-1e12, 1e12)
    return Factor(
        OF_LAW + name, f"parameter {name} of the friction law", Role.MODEL, "1", "1", limits, change
    )
