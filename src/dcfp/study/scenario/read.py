"""A scenario from a TOML file: a study file of one bearing, with a heading."""

from dataclasses import fields
from datetime import date
from pathlib import Path
from typing import Any, cast

from dcfp.errors import InputError
from dcfp.schema.reading import read_toml
from dcfp.study import read_study
from dcfp.study.scenario.scenario import Heading, Scenario

_KEYS = tuple(item.name for item in fields(Heading))


def read_scenario(path: str | Path) -> Scenario:
    """Read a scenario file.

    Parameters
    ----------
    path
        TOML as for `dcfp.read_study`, in which only ``record`` and one of ``pgv``, ``pga`` and ``scale`` may have several values, and a table
        ``[report]`` with any of ``project``, ``client``, ``author``, ``checker``, ``number``, ``date`` and ``notes``.

    Raises
    ------
    InputError
        If the file cannot be read, or anything in it cannot be used; the sentence begins with its name.
    """
    study = read_study(path)
    try:
        table = read_toml(path, "a scenario is a TOML file").get("report", {})
        return Scenario(study, _heading(table))
    except InputError as error:
        text = str(error)
        msg = text if text.startswith(str(path)) else f"{path}: {text}"
        raise InputError(msg) from error


def _heading(table: Any) -> Heading:
    if not isinstance(table, dict):
        msg = "'report' must be a table, written [report]."
        raise InputError(msg)
    words: dict[str, str] = {}
    for key, value in cast("dict[str, Any]", table).items():
        if key not in _KEYS:
            msg = f"[report] has no {key!r}; it has {', '.join(_KEYS)}."
            raise InputError(msg)
        words[key] = _words(key, value)
    return Heading(**words)


def _words(key: str, value: Any) -> str:
    """Return a value of the heading; a date of TOML stands for its own text."""
    if key == "date" and isinstance(value, date):
        return value.isoformat()
    if not isinstance(value, str):
        msg = f"[report] {key} must be words in quotes, not {value}."
        raise InputError(msg)
    return value
