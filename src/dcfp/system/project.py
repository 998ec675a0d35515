"""PROJECT.toml: an isolated building as an engineer writes it down, with its types of bearings, their places, and the storeys."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from importlib.resources import files
from pathlib import Path
from typing import Annotated, Any, TypeAlias, cast

import numpy as np

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.schema.declared import Declared, build, declared, parameters, read_table
from dcfp.schema.parameters import Parameter, other, table_in, unknown
from dcfp.schema.reading import parse_toml, read_bytes
from dcfp.schema.toml_places import Place
from dcfp.schema.units import KN, METRE, NONE, SECOND
from dcfp.system.modes import read_modes
from dcfp.system.plan import Plan
from dcfp.system.storeys import Storey
from dcfp.system.system import System

_EXAMPLE, _GRID = '{ x = 0, y = 0, type = "A" }', 'grid = { x = [0, 6], y = [0, 6], type = "A" }'
#: What a project is made of; of ``[report]`` the report knows what it holds.
_PARTS = ("name", "bearing", "plan", "building", "storey", "report")
_WEIGHT = Parameter("weight", KN, 0.0, above=True, key="weight")
_COUNT = Parameter("number of such storeys", NONE, 1, 200, key="count", kind=int)
_PERIOD = Parameter("first period on a fixed base", SECOND, 0.01, 10.0, key="fixed_base_period")
_MODES = Parameter("CSV file with the modes on a fixed base", key="modes", kind=str)
_LINE = Parameter("place of a line of the grid", METRE, -1e4, 1e4)
_SPRING = parameters(Plan)["spring"]


@declared
class Support(Declared):
    """A bearing in the plan, as a project lists it."""

    noun = "a bearing in the plan"

    x: Annotated[float, Parameter("place in x", METRE, -1e4, 1e4)]
    y: Annotated[float, Parameter("place in y", METRE, -1e4, 1e4)]
    type: Annotated[str, Parameter("name of its type")]
    load: Annotated[float | None, Parameter("static load", KN, 0.0, above=True, absent="by statics")] = None


#: A bearing with the place in the file where it is written.
Written: TypeAlias = tuple[Support, Place]


def read_plan(path: str | Path) -> Plan:
    """Read the building of a project.

    Parameters
    ----------
    path
        TOML with tables ``[bearing.NAME]`` as in a bearing file, ``[plan]`` with a ``grid`` or a list of ``bearings``, ``[building]``, and ``[[storey]]`` from below; lengths of plan
        and building are in metres. A bearing that says no pressure is one at the mean static load of its type, to which its kf then belongs.

    Raises
    ------
    InputError
        If the file cannot be read, or says what no building is.
    """
    content = read_bytes(path, "a project is TOML with tables [bearing.NAME], [plan] and [building]")
    return plan_of(content, path, Path(path).parent)


def plan_of(project: bytes, path: str | Path, folder: Path | None) -> Plan:
    """Return the building of a project that is at hand; its `path` is for complaints, and the `folder` is that of the files that it names, None where there are none; raises as `read_plan`."""
    content, lines = parse_toml(project, path)
    whole = Place(str(path), lines)
    for key in content:
        if key not in _PARTS:
            msg = f"{whole.of(key)}: {unknown(key, _PARTS, 'part of a project')}"
            raise InputError(msg)
    name = content.get("name", Path(path).stem)
    if not isinstance(name, str):
        msg = f"{whole.of('name')}: {other(name, 'name', 'a text')}"
        raise InputError(msg)
    supports, spring = _supports(table_in(content, "plan", whole), whole.of("plan", label="[plan]"))
    values = _building(table_in(content, "building", whole), whole)
    period, modes = values.pop("fixed_base_period", None), values.pop("modes", None)
    where = whole.of("building", label="[building]")
    loads = _loads(supports)
    types = _types(table_in(content, "bearing", whole, "bearing.NAME"), supports, whole)
    storeys = _storeys(content.get("storey", []), whole, stiff=modes is None)
    if period is not None and not storeys:
        msg = f"{where.of('fixed_base_period')}: fixed_base_period is of storeys, and the project has no [[storey]]."
        raise InputError(msg)
    given = [key for key, (_, has_pressure) in types.items() if not has_pressure]
    if loads is None and "mass" not in values and given:
        msg = f"{where}: give the weight of the building, the load of each bearing, or the pressure of each type (bearing {given[0]} has none)."
        raise InputError(msg)
    own: dict[str, Any] = {
        **values,
        "places": np.array([(one.x, one.y) for one, _ in supports]),
        "types": tuple(types[one.type][0] for one, _ in supports),
        "loads": loads,
        "spring": spring,
        "storeys": storeys,
        "name": name,
    }
    if modes is not None:
        if folder is None:
            msg = f"{where.of('modes')}: the file of the modes is not at hand here; say the stiffness of the storeys."
            raise InputError(msg)
        own["modes"] = read_modes(folder / modes, storeys)
    plan = _told(where, supports, lambda: Plan(**own))
    plan = replace(plan, types=_at_their_loads(plan, supports, types, whole))
    return plan if period is None else _told(where, supports, lambda: plan.with_first_period(period))


def _told(where: Place, supports: Sequence[Written], make: Callable[[], Plan]) -> Plan:
    """Return what is made, or tell where in the file the value stands that is complained of."""
    try:
        return make()
    except InputError as error:
        key, _, number = error.at.partition(" ")
        key = "weight" if key == "mass" and "weight" in where.below else key
        place: str = where.of(key) if key else where
        if key == "places":
            place = supports[int(number)][1]
        msg = f"{place}: {error}"
        raise InputError(msg) from error


def _building(table: dict[str, Any], whole: Place) -> dict[str, Any]:
    """Return the values of [building] by the names of the fields of a plan."""
    where = whole.of("building", label="[building]")
    if "spring" in table:
        msg = f"{where.of('spring')}: spring is of [plan]."
        raise InputError(msg)
    others = (_WEIGHT, _PERIOD, _MODES)
    also, rest = _taken(table, where, *others)
    return _with_mass(also, read_table(Plan, rest, where, also=tuple(one.key for one in others)), where)


def _taken(
    table: Mapping[str, Any], where: Place, *several: Parameter
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the values of some parameters of a table, as far as they are there, and the rest of the table."""
    own = {one.key: one for one in several if one.key in table}
    read = {key: one.read(table[key], f"{where.of(key)}: {key}: {one.words}") for key, one in own.items()}
    return read, {key: value for key, value in table.items() if key not in own}


def _with_mass(also: dict[str, Any], values: dict[str, Any], where: Place) -> dict[str, Any]:
    """Return all values, with a mass in place of a weight."""
    if "weight" in also and "mass" in values:
        msg = f"{where.of('weight')}: give either weight or mass, not both."
        raise InputError(msg)
    mass = {"mass": also.pop("weight") / STANDARD_GRAVITY} if "weight" in also else {}
    return values | also | mass


def _supports(table: dict[str, Any], where: Place) -> tuple[list[Written], str]:
    """Return the bearings of [plan], and how kf follows from the type."""
    for key in table:
        if key not in (_SPRING.key, "grid", "bearings"):
            msg = f"{where.of(key)}: {unknown(key, ('grid', 'bearings', _SPRING.key), 'key of the plan')}"
            raise InputError(msg)
    of_spring = f"{where.of(_SPRING.key)}: {_SPRING.key}: {_SPRING.words}"
    spring = _SPRING.read(table.get(_SPRING.key, _SPRING.default), of_spring)
    found: list[Written] = []
    if "grid" in table:
        found += _of_grid(table_in(table, "grid", where), where.of("grid", label="[plan] grid"))
    for i, one in enumerate(_list(table.get("bearings", []), where.of("bearings"), _EXAMPLE)):
        place = where.of("bearings", i, label=f"[plan] bearing {i + 1} of the list")
        if not isinstance(one, Mapping):
            msg = f"{place}: {other(one, 'it', f'a table such as {_EXAMPLE}')}"
            raise InputError(msg)
        found.append((Support.from_table(cast("Mapping[str, Any]", one), place), place))
    if not found:
        msg = f"{where}: the plan has no bearings; give {_GRID} or bearings = [{_EXAMPLE}]."
        raise InputError(msg)
    seen: dict[tuple[float, float], int] = {}
    for i, (one, place) in enumerate(found, 1):
        before = seen.setdefault((one.x, one.y), i)
        if before != i:
            msg = f"{place}: bearings {before} and {i} both stand at ({one.x / 1e3:g}, {one.y / 1e3:g}) m."
            raise InputError(msg)
    return found, spring


def _list(value: Any, where: Place, example: str) -> list[Any]:
    if not isinstance(value, list):
        msg = f"{where}: {other(value, 'it', f'a list such as [{example}]')}"
        raise InputError(msg)
    return cast("list[Any]", value)


def _of_grid(table: dict[str, Any], where: Place) -> list[Written]:
    lines: list[list[float]] = []
    for axis in ("x", "y"):
        listed = _list(table.pop(axis, None), where.of(axis), "0, 6, 12")
        own = [_LINE.read(one, f"{where.of(axis, i)}: {axis}: {_LINE.words}") for i, one in enumerate(listed)]
        if not own:
            msg = f"{where.of(axis)}: {axis} has no lines; write for example {_GRID}."
            raise InputError(msg)
        lines.append(own)
    across, along = lines
    types: Any = table.pop("type", None)
    rows: list[Any] = (
        cast("list[Any]", types) if isinstance(types, list) else [[types] * len(across)] * len(along)
    )
    if [len(cast("list[Any]", row)) if isinstance(row, list) else 0 for row in rows] != [len(across)] * len(
        along
    ):
        msg = f"{where.of('type')}: type must be one name, or for each of the {len(along)} lines of y a list of {len(across)} names."
        raise InputError(msg)
    return [
        (Support.from_table({"x": x / 1e3, "y": y / 1e3, "type": rows[j][i], **table}, where), where)
        for j, y in enumerate(along)
        for i, x in enumerate(across)
    ]


def _loads(supports: Sequence[Written]) -> np.ndarray[Any, Any] | None:
    without = [place for one, place in supports if one.load is None]
    if len(without) == len(supports):
        return None
    if without:
        msg = f"{without[0]}: no load is given here, but of other bearings; give the load of every bearing or of none."
        raise InputError(msg)
    return np.array([one.load for one, _ in supports])


def _types(
    tables: dict[str, Any], supports: Sequence[Written], whole: Place
) -> dict[str, tuple[System, bool]]:
    """Return each type of bearing, and whether its file says its pressure."""
    found: dict[str, tuple[System, bool]] = {}
    for name in tables:
        table = table_in(tables, name, whole.of("bearing"), f"bearing.{name}")
        where = whole.of("bearing", name, label=f"[bearing.{name}]")
        found[name] = System.from_table(table, where, name), "pressure" in table
    for one, place in supports:
        if one.type not in found:
            msg = f"{place}: there is no type of bearing {one.type!r}; the project has {', '.join(found) or 'no [bearing.NAME]'}."
            raise InputError(msg)
    return found


def _storeys(value: Any, whole: Place, *, stiff: bool) -> tuple[Storey, ...]:
    """Return the storeys; `stiff` ones must say their stiffness."""
    listed: list[Any] = cast("list[Any]", value) if isinstance(value, list) else [None]
    found: list[Storey] = []
    for i, one in enumerate(listed):
        if not isinstance(one, Mapping):
            msg = f"{whole.of('storey')}: storeys are written [[storey]], one table for each from below."
            raise InputError(msg)
        where = whole.of("storey", i, label=f"[[storey]] {i + 1}")
        also, rest = _taken(cast("Mapping[str, Any]", one), where, _WEIGHT, _COUNT)
        count = also.pop(_COUNT.key, 1)
        if _WEIGHT.key in also and "mass" not in rest:
            rest["mass"] = also.pop(_WEIGHT.key) / STANDARD_GRAVITY
        if also:
            msg = f"{where.of('weight')}: give either weight or mass, not both."
            raise InputError(msg)
        storey = Storey.from_table(rest, where)
        if stiff and storey.stiffness is None:
            msg = f"{where}: stiffness is missing: give it in x and y [kN/mm], or the modes of the building."
            raise InputError(msg)
        found += [storey] * count
    return tuple(found)


def _at_their_loads(
    plan: Plan, supports: Sequence[Written], types: Mapping[str, tuple[System, bool]], whole: Place
) -> tuple[System, ...]:
    """Return the types, those without a pressure at the mean static load of their bearings."""
    made: dict[str, System] = {}
    for name, (system, has_pressure) in types.items():
        own = [load for load, (one, _) in zip(plan.static_loads, supports, strict=True) if one.type == name]
        if has_pressure or not own:
            made[name] = system
            continue
        load = math.fsum(own) / len(own)
        pressure = load / system.bearing.slider_area
        label = f"[bearing.{name}] under the mean load of its bearings, {load / 1e3:.0f} kN"
        where = whole.of("bearing", name, label=label)
        bearing = build(system.bearing.changed, {"pressure": pressure}, where)
        made[name] = replace(system, bearing=bearing)
    return tuple(made[one.type] for one, _ in supports)


def example_project() -> str:
    """Return the text of a project to start from: a hospital of nine storeys on 24 bearings."""
    return files("dcfp.system").joinpath("hospital.toml").read_text(encoding="utf-8")
