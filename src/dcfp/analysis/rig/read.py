"""Test programs by name, from TOML files and from measured displacements."""

import difflib
import math
import tomllib
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any, cast

import numpy as np

from dcfp.analysis.rig.codes import prototype_programs
from dcfp.analysis.rig.measurement import Measurement, read_measurement
from dcfp.analysis.rig.program import Program, RigTest, VerticalLoad
from dcfp.analysis.rig.waveform import Recorded, Sine, Triangle, Waveform
from dcfp.errors import InputError
from dcfp.schema.parameters import refuse_other
from dcfp.schema.reading import read_toml

#: Programs that come with the package.
NAMED = {"dependency": "li_2020_dependency.toml", "asce": "li_2020_asce.toml"}
_KILO = 1e3
#: Part of the samples of a measured displacement that may be turns [-].
_MOST_TURNS = 0.1
_PROGRAM_KEYS = ("name", "source", "citation", "code", "test")
_KEYS = (
    "name", "purpose", "role", "waveform", "amplitude", "peak_velocity", "period", "cycles", "start", "ramp_cycles",
    "file", "pressure", "load", "load_points", "pause",
)  # fmt: skip
_LOADS = ("pressure", "load", "load_points")


def load_program(name: str | Path) -> Program:
    """Return a test program.

    Parameters
    ----------
    name
        ``dependency`` or ``asce``, the two of Li et al. (2020); a TOML file; or a CSV file with a measured displacement (and load), which is
        one test.

    Raises
    ------
    InputError
        If there is no such program, or the file is not one.
    """
    key = str(name).strip().lower()
    if key in NAMED:
        text = files("dcfp.analysis.rig").joinpath("programs", NAMED[key]).read_text(encoding="utf-8")
        return parse_program(tomllib.loads(text), key, Path())
    path = _path(name)
    if path.suffix.lower() == ".csv":
        measurement = read_measurement(path)
        return Program(
            measurement.name, (measured_test(measurement),), source=f"measured displacement, {path.name}"
        )
    if not path.exists():
        programs = (*NAMED, *prototype_programs())
        near = difflib.get_close_matches(key, programs, n=1)
        hint = (
            f"did you mean {near[0]!r}?"
            if near
            else f"the programs are {', '.join(programs)}, or give a .toml or .csv file."
        )
        msg = f"{name}: there is no such test program or file; {hint}"
        raise InputError(msg)
    content = read_toml(path, "a test program is TOML with [[test]] tables")
    return parse_program(content, str(path), path.parent)


def program_of(program: Program | str | Path) -> Program:
    """Return a test program, by name or from a file unless it is one; raises as `load_program`."""
    if isinstance(program, (str, Path)):
        return load_program(program)
    refuse_other(program, Program, "program", "a Program, the name of one or a file")
    return program


def _path(name: str | Path) -> Path:
    """Return the path of that name, if the system can look for it at all."""
    path = Path(name)
    try:
        path.exists()
    except (OSError, ValueError) as error:
        msg = f"{str(name)[:60]!r}: this cannot be the name of a file."
        raise InputError(msg) from error
    return path


def measured_test(measurement: Measurement) -> RigTest:
    """Return the test that a measurement was: its displacement, and its vertical load where it has one."""
    load = None
    if measurement.optional_load is not None:
        load = VerticalLoad(
            tuple(measurement.optional_load.tolist()), tuple(measurement.time.tolist()), is_pressure=False
        )
    turns = np.count_nonzero(np.diff(np.sign(np.diff(measurement.displacement))))
    if turns > _MOST_TURNS * measurement.time.size:
        msg = (
            f"{measurement.name}: the displacement changes its direction at {100.0 * turns / measurement.time.size:.0f} % of the samples;"
            " it is too noisy to be driven, smooth it or take fewer samples."
        )
        raise InputError(msg)
    waveform = Recorded(measurement.time, measurement.displacement, measurement.name)
    return RigTest(measurement.name, waveform, load)


def parse_program(content: Mapping[str, Any], where: str, folder: Path) -> Program:
    """Return the program that a TOML document describes.

    Parameters
    ----------
    content
        ``name``, ``source``, ``code`` (whose checks are made: ``asce7-16`` or ``en15129``), and a list of ``[[test]]`` with ``name``, ``waveform`` (``sine``, ``triangle`` or ``file``), ``amplitude`` [mm],
        ``peak_velocity`` [mm/s] or ``period`` [s], ``cycles``, ``start`` (``speed``, ``peak`` or ``ramp``), ``ramp_cycles``; ``file`` (CSV) for the third
        waveform; ``pressure`` [N/mm2], ``load`` [kN] or ``load_points`` (pairs of s and kN), else the bearing's own; ``pause`` [s],
        ``purpose`` and ``role``.
    where
        What to call the document in a sentence.
    folder
        Which files are relative to.

    Raises
    ------
    InputError
        If a key is not known or missing, or a value is out of range.
    """
    for key in content:
        if key not in _PROGRAM_KEYS:
            msg = f"{where}: {key!r} is not known; a test program has {', '.join(_PROGRAM_KEYS[:-1])} and [[test]] tables."
            raise InputError(msg)
    tables = content.get("test")
    if (
        not isinstance(tables, list)
        or not tables
        or not all(isinstance(t, dict) for t in cast("list[Any]", tables))
    ):
        msg = f"{where}: a test program needs at least one [[test]] table."
        raise InputError(msg)
    tests = [
        _test(cast("dict[str, Any]", table), number, where, folder)
        for number, table in enumerate(cast("list[Any]", tables), start=1)
    ]
    code = str(content.get("code", ""))
    if code and code not in prototype_programs():
        msg = f"{where}: there are no checks of the code {code!r}; the choices are {', '.join(prototype_programs())}."
        raise InputError(msg)
    try:
        words = {key: str(content.get(key, "")) for key in ("source", "citation", "code")}
        return Program(str(content.get("name", Path(where).stem)), tuple(tests), **words)
    except InputError as error:
        msg = f"{where}: {error}"
        raise InputError(msg) from error


def _test(table: dict[str, Any], number: int, where: str, folder: Path) -> RigTest:
    name = str(table.get("name", f"test {number}"))
    place = f"{where}, {name}"
    for key in table:
        if key not in _KEYS:
            msg = f"{place}: {key!r} is not known; the keys of a test are {', '.join(_KEYS)}."
            raise InputError(msg)
    try:
        waveform, load = _waveform(table, folder)
        pause = _number(table, "pause", "s") if "pause" in table else None
        return RigTest(
            name,
            waveform,
            _load(table) or load,
            pause,
            str(table.get("purpose", "")),
            str(table.get("role", "")),
        )
    except InputError as error:
        msg = f"{place}: {error}"
        raise InputError(msg) from error


def _waveform(table: dict[str, Any], folder: Path) -> tuple[Waveform, VerticalLoad | None]:
    kind = table.get("waveform", "file" if "file" in table else "sine")
    if kind == "file":
        return _recorded(table, folder)
    if kind not in ("sine", "triangle"):
        msg = f"the waveform must be sine, triangle or file, not {kind!r}."
        raise InputError(msg)
    amplitude = _number(table, "amplitude", "mm")
    cycles = _number(table, "cycles", "cycles")
    if ("peak_velocity" in table) == ("period" in table):
        msg = "give either peak_velocity [mm/s] or period [s]."
        raise InputError(msg)
    # travel over the period times the peak velocity: 2 pi for a sine, 4 for a triangle
    way = amplitude * (2.0 * math.pi if kind == "sine" else 4.0)
    velocity = (
        _number(table, "peak_velocity", "mm/s")
        if "peak_velocity" in table
        else way / _positive(table, "period", "s")
    )
    if kind == "triangle":
        if "start" in table or "ramp_cycles" in table:
            msg = "a triangle always starts from zero; start and ramp_cycles are for a sine."
            raise InputError(msg)
        return Triangle(amplitude, velocity, cycles), None
    ramp = {"ramp_cycles": _number(table, "ramp_cycles", "cycles")} if "ramp_cycles" in table else {}
    return Sine(amplitude, velocity, cycles, table.get("start", "speed"), **ramp), None


def _recorded(table: dict[str, Any], folder: Path) -> tuple[Waveform, VerticalLoad | None]:
    for key in ("amplitude", "peak_velocity", "period", "cycles", "start", "ramp_cycles"):
        if key in table:
            msg = f"a displacement from a file has no {key!r}; leave it out."
            raise InputError(msg)
    if "file" not in table:
        msg = 'the waveform is file, so file = "NAME.csv" must name it.'
        raise InputError(msg)
    test = measured_test(read_measurement(folder / str(table["file"])))
    return test.waveform, test.load


def _load(table: dict[str, Any]) -> VerticalLoad | None:
    given = [key for key in _LOADS if key in table]
    if len(given) > 1:
        msg = f"give one of {', '.join(_LOADS)}, not {' and '.join(given)}."
        raise InputError(msg)
    if "pressure" in table:
        return VerticalLoad((_number(table, "pressure", "N/mm2"),))
    if "load" in table:
        return VerticalLoad.force(_number(table, "load", "kN") * _KILO)
    if "load_points" in table:
        points = table["load_points"]
        if not isinstance(points, list) or not all(_is_pair(point) for point in cast("list[Any]", points)):
            msg = "load_points must be a list of pairs of time [s] and load [kN], such as [[0, 7540], [5, 9000]]."
            raise InputError(msg)
        pairs = cast("list[list[float]]", points)
        return VerticalLoad(
            tuple(float(force) * _KILO for _, force in pairs),
            tuple(float(time) for time, _ in pairs),
            is_pressure=False,
        )
    return None


def _is_pair(point: object) -> bool:
    return (
        isinstance(point, list)
        and len(cast("list[Any]", point)) == 2
        and all(_is_number(v) for v in cast("list[Any]", point))
    )


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _number(table: Mapping[str, Any], key: str, unit: str) -> float:
    if key not in table:
        msg = f"{key} is missing; it must be a number of {unit}."
        raise InputError(msg)
    if not _is_number(table[key]):
        msg = f"{key} must be a number of {unit}, not {table[key]!r}."
        raise InputError(msg)
    return float(table[key])


def _positive(table: Mapping[str, Any], key: str, unit: str) -> float:
    value = _number(table, key, unit)
    if not value > 0.0:
        msg = f"{key} must be a positive number of {unit}, not {value!r}."
        raise InputError(msg)
    return value
