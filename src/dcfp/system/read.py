"""A bearing, its friction law and its heating model from a TOML file."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, cast

from dcfp.errors import InputError
from dcfp.schema.reading import read_toml
from dcfp.system.bearing import LI_2020, Bearing, Model
from dcfp.system.friction import FrictionLaw, friction_law
from dcfp.system.heating import Heating, heating_model

#: Kilonewton per millimetre in newton per millimetre.
_KILO = 1000.0
_KEYS = ("name", "radius", "radii", "slider", "pressure", "stiffness", "capacity", "capacity_note")


def read_bearing(path: str | Path) -> Model:
    """Read a bearing file; what it leaves out is that of Li et al. (2020).

    Parameters
    ----------
    path
        TOML with any of the keys ``name``, ``radius`` [mm] (of both plates) or ``radii`` [mm] (a list of one or
        two), ``slider`` (diameter, mm), ``pressure`` [N/mm2], ``stiffness`` (kN/mm), ``capacity`` [mm] and
        ``capacity_note``, and the tables ``[friction]`` (``law`` and its parameters) and ``[heating]`` (``model``,
        ``conductivity`` [N/(s degC)], which is numerically W/(m degC), ``diffusivity`` [mm2/s], ``ambient`` [degC], ``thickness`` [mm], ``back``, ``cells``).

    Raises
    ------
    InputError
        If the file cannot be read, or has an unknown key or a value out of range.
    """
    content = read_toml(path, "a bearing file is TOML with keys such as radius and slider")
    return model_from(content, str(path), Path(path).stem)


def model_from(content: Mapping[str, Any], where: str, name: str | None) -> Model:
    """Return the model that a bearing file holds; what it leaves out is that of Li et al. (2020).

    Parameters
    ----------
    content
        As `read_bearing` reads it.
    where
        What to begin a complaint with.
    name
        Of the bearing, unless it has one of its own; None for that of Li et al. (2020).

    Raises
    ------
    InputError
        If there is an unknown key or a value out of range.
    """
    friction_table = _table(content, "friction", where)
    heating_table = _table(content, "heating", where)
    for key in content:
        if key not in (*_KEYS, "friction", "heating"):
            msg = f"{where}: {key!r} is not known; the keys are {', '.join(_KEYS)}, [friction] and [heating]."
            raise InputError(msg)
    try:
        return Model(
            _bearing(content, where, name or LI_2020.name), _friction(friction_table), _heating(heating_table)
        )
    except InputError as error:
        text = str(error)
        msg = text if text.startswith(where) else f"{where}: {text}"
        raise InputError(msg) from error


def _table(content: Mapping[str, Any], key: str, where: str) -> dict[str, Any]:
    table = content.get(key, {})
    if not isinstance(table, dict):
        msg = f"{where}: {key!r} must be a table, written [{key}]."
        raise InputError(msg)
    return dict(cast("dict[str, Any]", table))


def _bearing(content: Mapping[str, Any], where: str, name: str) -> Bearing:
    if "radius" in content and "radii" in content:
        msg = f"{where}: give either radius or radii, not both."
        raise InputError(msg)
    radii = content.get("radii", LI_2020.radii)
    if "radius" in content:
        radii = [content["radius"]] * 2
    if not isinstance(radii, (list, tuple)):
        msg = f"{where}: radii must be a list of one or two numbers of mm, not {radii!r}."
        raise InputError(msg)
    stiffness = content.get("stiffness", LI_2020.elastic_stiffness / _KILO)
    same_plates = "radius" not in content and "radii" not in content and "slider" not in content
    return Bearing(
        radii=tuple(cast("list[float]", radii)),
        slider_diameter=content.get("slider", LI_2020.slider_diameter),
        pressure=content.get("pressure", LI_2020.pressure),
        elastic_stiffness=kilonewton(stiffness),
        displacement_capacity=content.get("capacity", LI_2020.displacement_capacity if same_plates else None),
        capacity_note=str(
            content.get(
                "capacity_note", LI_2020.capacity_note if same_plates and "capacity" not in content else ""
            )
        ),
        name=str(content.get("name", name)),
    )


def kilonewton(stiffness: object) -> float:
    """Return a stiffness given in kN/mm in N/mm."""
    if isinstance(stiffness, bool) or not isinstance(stiffness, (int, float)):
        msg = f"The elastic stiffness must be a positive number of kN/mm, not {stiffness!r}."
        raise InputError(msg)
    return float(stiffness) * _KILO


def _friction(table: dict[str, Any]) -> FrictionLaw:
    law = table.pop("law", "li2020")
    return friction_law(str(law), table)


def _heating(table: dict[str, Any]) -> Heating:
    model = table.pop("model", "simplified")
    return heating_model(str(model), **table)
