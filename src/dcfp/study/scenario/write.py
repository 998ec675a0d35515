"""A scenario as the text of a file that reads back as the same scenario."""

from dataclasses import asdict
from typing import Any

import tomli_w

from dcfp.study.scenario.scenario import Heading
from dcfp.system import Heating, Model

_KILO = 1000.0


def scenario_toml(
    records: list[str],
    model: Model,
    *,
    title: str,
    pgvs: list[float] | None = None,
    heading: Heading | None = None,
    motion: dict[str, Any] | None = None,
) -> str:
    """Return the text of a scenario file.

    Parameters
    ----------
    records
        Names of records or files.
    model
        The bearing, its friction law and its heating model.
    title
        Of the scenario.
    pgvs
        PGVs that each record is scaled to [mm/s]; None leaves the records as they are.
    heading
        Of the report.
    motion
        The table ``[motion]``: how files are read and treated.
    """
    content: dict[str, Any] = {"title": title, "factors": {"record": records}}
    if pgvs is not None:
        content["factors"]["pgv"] = {"values": [pgv / _KILO for pgv in pgvs], "unit": "m/s"}
    if motion:
        content["motion"] = motion
    content["bearing"] = _bearing(model)
    words = {} if heading is None else {key: value for key, value in asdict(heading).items() if value}
    if words:
        content["report"] = words
    return tomli_w.dumps(content)


def _bearing(model: Model) -> dict[str, Any]:
    bearing = model.bearing
    found: dict[str, Any] = {
        "name": bearing.name,
        "radii": list(bearing.radii),
        "slider": bearing.slider_diameter,
        "pressure": bearing.pressure,
        "stiffness": bearing.elastic_stiffness / _KILO,
    }
    if bearing.displacement_capacity is not None:
        found |= {"capacity": bearing.displacement_capacity, "capacity_note": bearing.capacity_note}
    return found | {"friction": _friction(model), "heating": _heating(model.heating)}


def _friction(model: Model) -> dict[str, Any]:
    law: Any = model.friction
    known = {key: value for key, value in asdict(law).items() if value is not None}
    return {"law": law.name, **known}


def _heating(heating: Heating) -> dict[str, Any]:
    known = {key: value for key, value in asdict(heating).items() if value is not None}
    return {"model": heating.name, **known}
