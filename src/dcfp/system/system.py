"""The system that is analysed: bearing, friction law and heating model as one object, and how its parts are changed by name."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any, TypeAlias, TypeVar

from dcfp.errors import InputError
from dcfp.schema.declared import build, described, parameters, read_table
from dcfp.schema.notebook import fields_card
from dcfp.schema.parameters import Parameter, refuse_other, table_in, unknown
from dcfp.schema.reading import read_toml
from dcfp.schema.toml_places import inside
from dcfp.schema.units import NONE
from dcfp.system.bearing import LI_2020, Bearing
from dcfp.system.friction import FRICTION_LAWS, FrictionLaw, Li2020
from dcfp.system.friction.law import coefficient_parameter
from dcfp.system.heating import HEATINGS, Heating, SimplifiedHeating, plates_of

Part = TypeVar("Part", FrictionLaw, Heating)

#: Before the name of a parameter of the friction law.
OF_LAW = "friction."
#: The radius of one of two plates, by its place.
#: Those of a system in which none is given: made once, for they never change.
_LAW, _HEATING = Li2020(), SimplifiedHeating()
_RADII = {"lower_radius": 0, "upper_radius": 1}
_MU = replace(coefficient_parameter("reference coefficient of the friction law"), key="mu")
_LAMBDA = Parameter("property factor on the reference coefficient", NONE, 0.05, 20.0, symbol=r"\lambda", key="lambda", option=False)  # fmt: skip


@dataclass(frozen=True)
class System:
    """A rigid structure on a bearing under its load, with the friction law and the heating model that rule its friction."""

    bearing: Bearing = LI_2020
    friction: FrictionLaw = _LAW
    heating: Heating = _HEATING

    @classmethod
    def of(
        cls,
        bearing: "System | Bearing | str | Path | None" = None,
        friction: FrictionLaw | str | None = None,
        heating: Heating | str | None = None,
        usual: str = SimplifiedHeating.name,
    ) -> "System":
        """Return the system of parts or of their names; what is None is that of Li et al. (2020), or of the bearing file.

        Parameters
        ----------
        bearing, friction, heating
            The parts.
        usual
            Heating model where neither `heating` nor a system or file says which.

        Raises
        ------
        InputError
            If a part is none, or there is none of that name.
        """
        for name, part, kinds, wanted, names in (
            ("bearing", bearing, (System, Bearing, str, Path), "a Bearing, a System or the path of a bearing file", ()),
            ("friction", friction, (FrictionLaw, str), "a friction law or its name", FRICTION_LAWS),
            ("heating", heating, (Heating, str), "a heating model or its name", HEATINGS),
        ):  # fmt: skip
            if part is not None:
                refuse_other(part, kinds, name, wanted, names)
        if isinstance(bearing, (str, Path)):
            bearing = read_bearing(bearing, usual)
        base = (
            bearing if isinstance(bearing, System) else cls(bearing or LI_2020, heating=_usual_heating(usual))
        )
        if isinstance(friction, str):
            friction = friction_law(friction)
        if isinstance(heating, str):
            heating = heating_model(heating, plates_of(base.heating))
        return cls(base.bearing, friction or base.friction, heating or base.heating)

    @classmethod
    def from_table(
        cls,
        content: Mapping[str, Any],
        where: str,
        name: str | None = None,
        usual: str = SimplifiedHeating.name,
    ) -> "System":
        """Return the system of a bearing file; what it leaves out is that of Li et al. (2020).

        Parameters
        ----------
        content
            As `read_bearing` reads it.
        where
            What to begin a complaint with.
        name
            Of the bearing, unless it has one of its own; None for that of Li et al. (2020).
        usual
            Heating model where the file says none.

        Raises
        ------
        InputError
            If there is an unknown key or a value out of range.
        """
        tables = {key: table_in(content, key, where) for key in ("friction", "heating")}
        rest = {key: value for key, value in content.items() if key not in tables}
        values = read_table(Bearing, rest, where, also=("friction", "heating"))
        law = friction_law(
            tables["friction"].pop("law", Li2020.name), tables["friction"], inside(where, "friction")
        )
        of_heating = inside(where, "heating")
        kind = HEATINGS.find(tables["heating"].pop("model", usual), of_heating)
        heating = kind.from_table(tables["heating"], of_heating)
        bearing = build(LI_2020.changed, values, where)
        return cls(replace(bearing, name=values.get("name", name or LI_2020.name)), law, heating)

    def to_table(self) -> dict[str, Any]:
        """Return the content of a bearing file that reads back as the same system."""
        friction = {"law": self.friction.name, **self.friction.to_table()}
        heating = {"model": self.heating.name, **self.heating.to_table()}
        return self.bearing.to_table() | {"friction": friction, "heating": heating}

    def changed(self, values: Mapping[str, Any]) -> "System":
        """Return the system with parameters changed by their keys, as `system_parameters` names them; values in the package's units.

        Raises
        ------
        InputError
            If a value is out of range, or the law has no such parameter.
        """
        known = system_parameters()
        in_order = {
            name: values[name] for name in (*known, *(values.keys() - known.keys())) if name in values
        }
        of_heating = {name for kind in HEATINGS.values() for name in parameters(kind)}
        friction, heating, changes = self.friction, self.heating, dict[str, Any]()
        for name, value in in_order.items():
            if name == "heating":
                heating = heating if value == heating.name else heating_model(value, plates_of(heating))
            elif name in of_heating:
                heating = _with_parameter(heating, name, value)
            elif name in ("law", "mu", "lambda") or name.startswith(OF_LAW):
                friction = _changed_law(friction, name, value)
            else:
                radii = changes.get("radii", self.bearing.radii)
                changes |= _change_of_bearing(radii, name, value)
        bearing = self.bearing.changed(**changes) if changes else self.bearing
        return System(bearing, friction, heating)

    def _repr_html_(self) -> str:
        facts = {"friction": repr(self.friction), "heating": repr(self.heating)}
        return fields_card(self.bearing, self.bearing.name, facts)


#: What is taken for a system: one, a bearing, or the path of a bearing file; None for that of Li et al. (2020).
SystemLike: TypeAlias = System | Bearing | str | Path | None


def _changed_law(friction: FrictionLaw, name: str, value: Any) -> FrictionLaw:
    if name == "law":
        return friction if value == friction.name else friction_law(value)
    if name == "mu":
        return friction.with_reference(value)
    if name == "lambda":
        return friction.with_reference(value * friction.reference)
    return _with_parameter(friction, name.removeprefix(OF_LAW), value)


def _change_of_bearing(radii: tuple[float, ...], name: str, value: Any) -> dict[str, Any]:
    """Return the field of a bearing that a parameter changes, with its value; `radii` are those that it has."""
    if name in _RADII:
        if len(radii) != 2:
            msg = (
                "lower_radius and upper_radius are of a double concave bearing; of a single one vary radius."
            )
            raise InputError(msg)
        return {"radii": (value, radii[1]) if _RADII[name] == 0 else (radii[0], value)}
    if name == "radius" and isinstance(value, (int, float)):
        return {"radii": (value,) * len(radii)}
    fields = {one.key: one.name for one in parameters(Bearing).values()}
    if name not in fields:
        msg = unknown(name, system_parameters(), "parameter of a system")
        raise InputError(msg)
    return {fields[name]: value}


def system_parameters() -> dict[str, Parameter]:
    """Return every parameter of a system by its key, in the order in which they are applied: bearing, law, what changes a law, heating."""
    return _system_parameters(tuple(FRICTION_LAWS.items()), tuple(HEATINGS.items()))


@cache
def _system_parameters(
    laws: tuple[tuple[str, type[FrictionLaw]], ...], heatings: tuple[tuple[str, type[Heating]], ...]
) -> dict[str, Parameter]:
    law = Parameter("friction law", choices=tuple(dict(laws)), key="law", kind=str, default=Li2020.name)
    heating = Parameter("heating model", choices=tuple(dict(heatings)), key="heating", kind=str, default=SimplifiedHeating.name)  # fmt: skip
    of_laws: dict[str, Parameter] = {}
    for name, kind in laws:
        for one in parameters(kind).values():
            key = OF_LAW + one.key
            known = of_laws.get(key)
            # of several laws with the same name for a parameter the first says what it is, and each has limits of its own
            of_laws[key] = (
                replace(one, key=key, default=None, more=f"of {name}")
                if known is None
                else replace(
                    known,
                    least=min(known.least, one.least),
                    most=max(known.most, one.most),
                    more=f"{known.more}, {name}",
                )
            )
    of_bearing = {one.key: one for one in parameters(Bearing).values()}
    radius = of_bearing.pop("radius")
    plates = {
        name: replace(radius, words=f"effective radius of the {name.partition('_')[0]} plate", key=name, counts=(), option=False)
        for name in _RADII
    }  # fmt: skip
    of_heatings = {one.key: one for _, kind in heatings for one in parameters(kind).values()}
    first = {"radius": radius, **plates, **of_bearing, "law": law, "mu": _MU, "lambda": _LAMBDA}
    return {**first, **of_laws, "heating": heating, **of_heatings}


@cache
def _usual_heating(name: str) -> Heating:
    return _HEATING if name == _HEATING.name else heating_model(name)


def read_bearing(path: str | Path, usual: str = SimplifiedHeating.name) -> System:
    """Read a bearing file; what it leaves out is that of Li et al. (2020).

    Parameters
    ----------
    path
        TOML with any of the keys of a `Bearing` and the tables ``[friction]`` (``law`` and its parameters) and ``[heating]`` (``model`` and its parameters). A plain number is
        in the declared unit; a text may name another, as in ``radius = "4.5 m"``.
    usual
        Heating model where the file says none.

    Raises
    ------
    InputError
        If the file cannot be read, or has an unknown key or a value out of range.
    """
    content = read_toml(path, "a bearing file is TOML with keys such as radius and slider")
    return System.from_table(content, str(path), Path(path).stem, usual)


def friction_law(name: object, table: Mapping[str, Any] | None = None, where: str = "") -> FrictionLaw:
    """Return a friction law by name, with the parameters that a table of a file changes.

    Parameters
    ----------
    name
        Of the law.
    table
        Parameters by their keys, as a file holds them.
    where
        What to begin a complaint with.

    Raises
    ------
    InputError
        If there is no law of that name, or it has no such parameter, or a value is out of range.
    """
    return FRICTION_LAWS.find(name, where).from_table(table or {}, where or f"friction law {name}")


def heating_model(name: object, values: Mapping[str, Any] | None = None) -> Heating:
    """Return a heating model by name, with values by the names of its fields, in the package's units; raises as `friction_law`."""
    return HEATINGS.find(name)(**(values or {}))


def _with_parameter(part: Part, key: str, value: Any) -> Part:
    known = {one.key: one.name for one in parameters(type(part)).values()}
    if key not in known:
        msg = unknown(key, known, f"parameter of {described(type(part))}")
        raise InputError(msg)
    made: Any = part
    return replace(made, **{known[key]: value})
