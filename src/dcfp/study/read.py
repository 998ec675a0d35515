"""A study from a TOML file, and the values and distributions of its factors as it writes them."""

from collections.abc import Mapping
from dataclasses import replace
from math import inf
from pathlib import Path
from typing import Any, cast

import numpy as np

from dcfp.analysis.integration import Integration, usual_heating
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_records, seen_from
from dcfp.motion.station import Station
from dcfp.motion.treatment import record_treated
from dcfp.schema.declared import build, read_table
from dcfp.schema.parameters import HIGH_PASS, TIME_STEP, Parameter, read_values, table_in, unknown
from dcfp.schema.reading import complaints_name, read_toml
from dcfp.schema.units import NONE
from dcfp.study.factors import OF_LAW, Choice, Distribution, Normal, Sampling, Uniform, Value, factor
from dcfp.study.study import RECORD, Study
from dcfp.system import System, read_bearing

BEARING = "bearing"
_TITLE = Parameter("title of the study", key="title", kind=str)
_VERTICAL = Parameter("whether the vertical force follows the vertical components of stations", key="vertical", kind=bool)  # fmt: skip
_TABLES = ("title", "bearing", "motion", "factors", "sampling", "analysis", "keep", "report")
_MOTION = (
    Parameter("component of a file that holds several", key="component", kind=str),
    Parameter("unit of a plain file", key="units", kind=str),
    TIME_STEP,
    Parameter("whether a linear baseline in velocity is removed", key="baseline", kind=bool),
    HIGH_PASS,
)


def read_study(path: str | Path) -> Study:
    """Read a study file: TOML as ``docs/studies.md`` describes it. Files named in it are looked for from its folder.

    Parameters
    ----------
    path
        TOML with ``title`` and the tables ``[factors]``, of which ``record`` is a must, ``[bearing]`` (keys of a bearing file, or
        ``file``), ``[sampling]``, ``[motion]``, ``[analysis]`` and ``[keep]``; ``[report]`` is for `dcfp.study.scenario`; see ``docs/studies.md``. Files named in it are looked for
        from the folder of the study file.

    Raises
    ------
    InputError
        If the file cannot be read, or anything in it cannot be used; the sentence begins with its name.
    """
    content = read_toml(path, "a study is a TOML file; dcfp study new FILE.toml writes one to start from")
    with complaints_name(path):
        # to make the plan finds what cannot be, here where the file is known
        return _study(content, Path(path)).plan.study


def _study(content: Mapping[str, Any], place: Path) -> Study:
    for key in content:
        if key not in _TABLES:
            raise InputError(unknown(key, _TABLES, "part of a study file"))
    grid = _flat(table_in(content, "factors"))
    sampling = table_in(content, "sampling")
    sampled = _flat(table_in(sampling, "factors", shown="sampling.factors"))
    motions = _motions(grid, sampled, table_in(content, "motion"), place.parent)
    usual = usual_heating(motions)
    analysis = table_in(content, "analysis")
    vertical = _VERTICAL.read(analysis.pop(_VERTICAL.key, False), f"[analysis]: {_VERTICAL.key}")
    names = [motion.name for motion in motions]
    return Study(
        motions=motions,
        factors={
            name: names if name == RECORD else values_from(factor(name), given)
            for name, given in grid.items()
        },
        sampling=_sampling(sampling, sampled, names),
        model=_model(table_in(content, "bearing"), place, usual),
        bearings=_bearings(grid, sampled, place.parent, usual),
        title=_TITLE.read(content.get("title", place.stem), "title"),
        name=place.stem,
        settings=Integration.from_table(analysis, "[analysis]"),
        vertical=vertical,
        histories=_histories(table_in(content, "keep")),
        text=place.read_text(encoding="utf-8"),
    )


def _flat(table: dict[str, Any]) -> dict[str, Any]:
    """Return factors with the table ``friction`` as ``friction.NAME`` each, in the same order."""
    found: dict[str, Any] = {}
    for key, given in table.items():
        if key == OF_LAW.rstrip(".") and isinstance(given, dict):
            found |= {OF_LAW + name: one for name, one in cast("dict[str, Any]", given).items()}
        else:
            found[key] = given
    for name in found:
        factor(name)  # it is known
    return found


def _motions(
    grid: dict[str, Any], sampled: dict[str, Any], table: dict[str, Any], folder: Path
) -> list[GroundMotion | Station]:
    options = read_values(_MOTION, table, "[motion]", "parameter of a ground motion")
    given = grid.get(RECORD, sampled.get(RECORD))
    if given is None:
        msg = "there is no factor 'record'; name at least one, for example record = [\"NCC\"] in [factors]."
        raise InputError(msg)
    names = [seen_from(folder, str(name)) for name in values_from(factor(RECORD), given)]
    baseline, corner = options.pop("baseline", False), options.pop("high_pass", None)
    return [record_treated(one, baseline=baseline, corner=corner) for one in load_records(names, **options)]


def _bearings(grid: dict[str, Any], sampled: dict[str, Any], folder: Path, usual: str) -> dict[str, System]:
    """Read the files that the factor ``bearing`` names, each once."""
    given = grid.get(BEARING, sampled.get(BEARING))
    names = [] if given is None else values_from(factor(BEARING), given)
    return {str(name): read_bearing(folder / str(name), usual) for name in names}


def _sampling(table: dict[str, Any], factors: dict[str, Any], records: list[str]) -> Sampling | None:
    if not table:
        return None
    found: dict[str, Distribution] = {
        name: Choice(tuple(records)) if name == RECORD else distribution_from(factor(name), given)
        for name, given in factors.items()
    }
    rest = {key: value for key, value in table.items() if key != "factors"}
    values = read_table(Sampling, rest, "[sampling]", also=("factors",))
    if "count" not in values:
        msg = "[sampling] needs a count, the number of samples."
        raise InputError(msg)
    return build(Sampling, {"factors": found, **values}, "")


def _model(table: dict[str, Any], place: Path, usual: str) -> System:
    file = table.pop("file", None)
    if file is not None:
        if table:
            msg = f"[bearing] names a file, so that {next(iter(table))!r} has no place beside it."
            raise InputError(msg)
        return read_bearing(place.parent / str(file), usual)
    name = "bearing of the study" if table else None
    return System.from_table(table, f"{place}: [bearing]", name, usual)


def _histories(table: dict[str, Any]) -> tuple[str, ...]:
    names = table.pop("histories", [])
    if table:
        raise InputError(unknown(next(iter(table)), ("histories",), "part of [keep]"))
    if not isinstance(names, list):
        msg = f'histories must be a list, for example ["displacement"], not {names!r}.'
        raise InputError(msg)
    one = Parameter("history", key="histories", kind=str)
    return tuple(dict.fromkeys(one.read(name, "a name in histories") for name in cast("list[Any]", names)))


_DEVIATION = "standard_deviation"
#: What each distribution needs.
_DISTRIBUTIONS = {
    "uniform": ("from", "to"),
    "log-uniform": ("from", "to"),
    "normal": ("mean", _DEVIATION),
    "lognormal": ("median", "dispersion"),
}
#: What is no number of the factor itself.
_KEYS = {
    one.key: one
    for one in (
        Parameter("number of values", NONE, 1, 1_000_000, key="count", kind=int),
        Parameter("spacing", choices=("linear", "log"), key="spacing", kind=str),
        Parameter("unit of plain numbers", key="unit", kind=str),
        Parameter("dispersion", NONE, 0.0, key="dispersion", above=True),
        Parameter("distribution", choices=tuple(_DISTRIBUTIONS), key="distribution", kind=str),
    )
}


def values_from(one: Parameter, given: Any) -> list[Value]:
    """Return the values of a factor: from one, a list, or a table with ``values`` or ``from``, ``to`` and ``count``.

    Raises
    ------
    InputError
        If there is none, or one that is not allowed.
    """
    unit: str | None = None
    if isinstance(given, dict):
        table = cast("dict[str, Any]", given)
        if "values" not in table:
            return _range(one, table)
        rest = {key: value for key, value in table.items() if key != "values"}
        unit = read_values((_KEYS["unit"],), rest, _label(one), "key beside values").get("unit")
        given = table["values"]
    listed = cast("list[Any]", given) if isinstance(given, list) else [given]
    if unit is not None and not one.is_number:
        msg = f"{_label(one)} takes words, which have no unit."
        raise InputError(msg)
    return [_rounded(one.read(value, _label(one), unit)) for value in listed]


def _label(one: Parameter) -> str:
    return f"factor {one.key!r}"


def _rounded(value: Value) -> Value:
    """Return a number with the digits that were meant: 0.07 m/s are 70 mm/s, not 70.00000000000001."""
    return float(f"{value:.13g}") if isinstance(value, float) else value


def distribution_from(one: Parameter, given: Any) -> Distribution:
    """Return the distribution of a sampled factor: a list or ``values`` are a choice, ``from`` and ``to`` a range.

    Raises
    ------
    InputError
        As for `values_from`, and if the distribution is not known.
    """
    if not isinstance(given, dict) or "values" in given:
        return Choice(tuple(values_from(one, given)))
    table = cast("dict[str, Any]", given)
    name = _KEYS["distribution"].read(
        table.get("distribution", "uniform"), f"{_label(one)}: the distribution"
    )
    values = _of_table(one, table, _DISTRIBUTIONS[name], ("distribution", "unit"))
    first, second = (values[key] for key in _DISTRIBUTIONS[name])
    with complaints_name(_label(one)):
        if name in ("uniform", "log-uniform"):
            return Uniform(first, second, name == "log-uniform")
        return Normal(first, second, name == "lognormal")


def _range(one: Parameter, table: Mapping[str, Any]) -> list[Value]:
    values = _of_table(one, table, ("from", "to", "count"), ("spacing", "unit"))
    first, last, count = float(values["from"]), float(values["to"]), int(values["count"])
    logarithmic = values.get("spacing") == "log"
    if logarithmic and not (first > 0.0 and last > 0.0):
        msg = f"{_label(one)}: a logarithmic range must be of positive numbers."
        raise InputError(msg)
    places = np.geomspace(first, last, count) if logarithmic else np.linspace(first, last, count)
    # 0.1 to 2.0 in 20 steps means 0.3, not 0.30000000000000004
    return [float(f"{place:.12g}") for place in places.tolist()]


def _of_table(
    one: Parameter, table: Mapping[str, Any], needed: tuple[str, ...], further: tuple[str, ...]
) -> dict[str, Any]:
    """Return what stands in the table of a factor that takes numbers: what is `needed`, and what may be there besides."""
    label = _label(one)
    if not one.is_number:
        msg = f"{label} takes words; give it a list of them."
        raise InputError(msg)
    missing = [key for key in needed if key not in table]
    known = [_KEYS[key] for key in (*needed, *further) if key in _KEYS]
    own = {key: replace(one, key=key, name=key) for key in needed if key not in _KEYS}
    if _DEVIATION in own:
        own[_DEVIATION] = replace(own[_DEVIATION], least=0.0, most=inf, above=True, difference=True)
    rest = {key: value for key, value in table.items() if key not in own}
    found = read_values(known, rest, label, "key of a range", also=needed)
    if missing:
        msg = f"{label} needs {missing[0]!r}; it has {', '.join((*needed, *further))}."
        raise InputError(msg)
    unit = found.get("unit")
    return found | {
        key: _rounded(item.read(table[key], f"{label}: {key}", unit)) for key, item in own.items()
    }
