"""A bearing, its friction law and its heating model as a bearing file."""

import json
from dataclasses import asdict

from dcfp.errors import InputError
from dcfp.system import Bearing, FrictionLaw, Heating, UserFriction


def bearing_file(bearing: Bearing, law: FrictionLaw, heating: Heating, notes: tuple[str, ...] = ()) -> str:
    """Return the text of a bearing file that `read_bearing` reads back.

    The numbers are the same, but for the elastic stiffness, whose last digit may change: the file has it in kN/mm.

    Parameters
    ----------
    bearing, law, heating
        What it holds; the law is one that has a name.
    notes
        Lines of comment at its head.

    Raises
    ------
    InputError
        If the law is a function of its own, which a file cannot hold.
    """
    if isinstance(law, UserFriction):
        msg = f"The law {law.label!r} is a function, which a bearing file cannot hold; give one of the laws that have a name."
        raise InputError(msg)
    top: dict[str, object] = {
        "name": bearing.name,
        "radii": list(bearing.radii),
        "slider": bearing.slider_diameter,
        "pressure": bearing.pressure,
        "stiffness": bearing.elastic_stiffness / 1e3,
    }
    if bearing.displacement_capacity is not None:
        top |= {"capacity": bearing.displacement_capacity, "capacity_note": bearing.capacity_note}
    parameters: dict[str, object] = asdict(law)  # pyright: ignore[reportArgumentType]
    tables = {
        "friction": {"law": law.name, **parameters},
        "heating": {"model": heating.name, **asdict(heating)},
    }
    lines = [f"# {' '.join(note.split())}" for note in notes]
    lines += [f"{key} = {_value(value)}" for key, value in top.items()]
    for table, entries in tables.items():
        lines += [
            "",
            f"[{table}]",
            *(f"{key} = {_value(value)}" for key, value in entries.items() if value is not None),
        ]
    return "\n".join(lines) + "\n"


def _value(value: object) -> str:
    """Write a value as TOML does: as JSON, but for characters beyond the keyboard, which stay as they are."""
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
