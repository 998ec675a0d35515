"""Test programs: what is done to a bearing, one test after another, and under which vertical load; by name, from TOML files and from measured displacements."""

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, cast

import numpy as np

from dcfp.analysis.assumptions import LARGEST_ANGLE
from dcfp.analysis.rig.measured_path import MeasuredPath, is_path, read_path
from dcfp.analysis.rig.measurement import Measurement, read_measurement
from dcfp.analysis.rig.plane_path import PATHS, PlanePath, RecordedPath
from dcfp.analysis.rig.waveform import Recorded, Sine, Triangle, Wave, Waveform
from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.declared import Declared, build, declared, parameters, read_table
from dcfp.schema.notebook import card
from dcfp.schema.parameters import Parameter, unknown
from dcfp.schema.reading import read_toml
from dcfp.schema.registry import Registry
from dcfp.schema.units import KN, N_PER_MM2, SECOND
from dcfp.system import Bearing

if TYPE_CHECKING:
    from dcfp.analysis.rig.codes import PrototypeTests

#: Pressures on the slider that a wrong unit would pass [N/mm2].
LEAST_PRESSURE, LARGEST_PRESSURE = 0.1, 1000.0


@dataclass(frozen=True)
class VerticalLoad:
    """A vertical load, linear between its times [s] and constant before and after them: pressures on the slider [N/mm2], or forces [N]."""

    values: tuple[float, ...]
    times: tuple[float, ...] = (0.0,)
    is_pressure: bool = True

    def __post_init__(self) -> None:
        if len(self.values) != len(self.times) or not self.values:
            msg = f"A vertical load has {len(self.times)} times but {len(self.values)} values."
            raise InputError(msg)
        if not np.isfinite([*self.values, *self.times]).all() or (np.diff(self.times) <= 0.0).any():
            msg = "The times of a vertical load must increase, and all its numbers must be finite."
            raise InputError(msg)
        if min(self.values) <= 0.0:
            what = "pressure" if self.is_pressure else "vertical force"
            msg = (
                f"The {what} falls to {min(self.values):g}: a sliding bearing takes no tension, so the load"
                " must stay above zero (compression is positive)."
            )
            raise InputError(msg)

    def at(self, time: FloatArray, bearing: Bearing) -> FloatArray:
        """Return the force [N] at times [s], if it passes `check_load`.

        Raises
        ------
        InputError
            If the pressure is out of any sensible range, as it is where a unit was wrong.
        """
        factor = bearing.slider_area if self.is_pressure else 1.0
        forces = np.asarray(np.interp(time, self.times, np.array(self.values) * factor))
        check_load(forces, bearing)
        return forces


def check_load(forces: FloatArray, bearing: Bearing) -> None:
    """Refuse vertical forces [N] under which the pressure on the slider is out of any sensible range, as it is where a unit was wrong.

    Raises
    ------
    InputError
        If it is.
    """
    pressures = forces / bearing.slider_area
    for extreme in (float(pressures.min()), float(pressures.max())):
        if not LEAST_PRESSURE <= extreme <= LARGEST_PRESSURE:
            msg = (
                f"A vertical load of {extreme * bearing.slider_area / 1e3:.4g} kN puts {extreme:.3g} N/mm2 on a slider of"
                f" {bearing.slider_diameter:g} mm; from {LEAST_PRESSURE:g} to {LARGEST_PRESSURE:g} N/mm2 is possible:"
                " look at the unit of the load."
            )
            raise InputError(msg)


_ROLES = ("wind", "increment", "maximum", "endurance", "stability")


@declared
class RigTest(Declared):
    """One test: a displacement in one direction or a path in the plane, under the vertical load of the bearing or another.

    Parameters
    ----------
    pause
        Time of cooling between the test before and this one [s]; None where the plates begin at the ambient temperature.
    role
        What it is to the checks of a code: wind, increment, maximum, endurance or stability; None where it is nothing.
    """

    noun = "a test"

    name: Annotated[str, Parameter("name of the test")]
    waveform: Waveform | PlanePath | RecordedPath
    load: VerticalLoad | None = None
    pause: Annotated[float | None, Parameter("pause before the test", SECOND, 0.0, 7 * 24 * 3600.0)] = None
    purpose: Annotated[str, Parameter("what the test is for")] = ""
    role: Annotated[str | None, Parameter("what it is to the checks of a code", choices=_ROLES)] = None


@declared
class Program(Declared):
    """Tests in their order, at least one."""

    noun = "a test program"

    name: Annotated[str, Parameter("what to call it")]
    tests: tuple[RigTest, ...]
    source: Annotated[str, Parameter("where it comes from")] = ""
    citation: Annotated[str, Parameter("key of the source in the bibliography")] = ""
    code: Annotated[str, Parameter("code whose checks the tests are to pass")] = ""

    def check_relations(self) -> None:
        """Refuse a program without a test, and two tests of one name."""
        if not self.tests:
            msg = f"{self.name}: a test program needs at least one test."
            raise InputError(msg)
        names = [test.name for test in self.tests]
        for name in names:
            if names.count(name) > 1:
                msg = f"{self.name}: two tests have the name {name!r}; give each its own."
                raise InputError(msg)

    @property
    def plane(self) -> bool:
        """Whether any test goes in two directions; then all are run in the plane, those in one direction along x."""
        return any(isinstance(test.waveform, (PlanePath, RecordedPath)) for test in self.tests)

    @property
    def sequences(self) -> tuple[tuple[RigTest, ...], ...]:
        """Runs of tests through which the plates keep their heat."""
        sequences: list[list[RigTest]] = []
        for test in self.tests:
            if test.pause is None or not sequences:
                sequences.append([])
            sequences[-1].append(test)
        return tuple(tuple(tests) for tests in sequences)

    def only(self, names: Sequence[str]) -> "Program":
        """Return the program with some of its tests, in its own order, and with those before them whose heat is still in the plates.

        Raises
        ------
        InputError
            If it has no test of such a name.
        """
        known = [test.name for test in self.tests]
        for name in names:
            if name not in known:
                msg = f"{self.name} has no test {name!r}; it has {', '.join(known)}."
                raise InputError(msg)
        kept: list[RigTest] = []
        for tests in self.sequences:
            wanted = [place for place, test in enumerate(tests) if test.name in names]
            kept.extend(tests[: max(wanted) + 1] if wanted else ())
        return replace(self, tests=tuple(kept))

    def _repr_html_(self) -> str:
        rows = [
            {"test": one.name, "waveform": one.waveform.kind, "pause [s]": one.pause, "purpose": one.purpose}
            for one in self.tests
        ]
        return card(f"Test program {self.name}", {"source": self.source}, rows=rows)


def check_stroke(test: RigTest, bearing: Bearing) -> None:
    """Refuse a test with a stroke above the bearing's capacity, or above half of its effective radius.

    Raises
    ------
    InputError
        If the amplitude is above the bearing's capacity, or, where that is not known, above half of its effective radius.
    """
    stroke = test.waveform.travel().largest
    capacity = bearing.displacement_capacity
    if capacity is not None and stroke > capacity * (1.0 + 1e-9):
        msg = (
            f"{test.name}: a stroke of {stroke:.4g} mm goes beyond the plate, whose capacity is {capacity:g} mm; choose a smaller"
            " amplitude, or give the bearing its true capacity."
        )
        raise InputError(msg)
    furthest = LARGEST_ANGLE * bearing.effective_radius
    if stroke > furthest:
        msg = (
            f"{test.name}: a stroke of {stroke:.4g} mm is more than half of the bearing's effective radius of"
            f" {bearing.effective_radius:g} mm; look at the unit of the displacement."
        )
        raise InputError(msg)


#: Codes whose prototype tests can be made and judged, by name.
PROTOTYPE_TESTS: "Registry[PrototypeTests]" = Registry("code with prototype tests")
#: Programs that come with the package.
NAMED = {"dependency": "li_2020_dependency.toml", "asce": "li_2020_asce.toml", "plane": "plane.toml"}
#: Part of the samples of a measured displacement that may be turns [-].
_MOST_TURNS = 0.1
_WAVES: dict[str, type[Wave]] = {"sine": Sine, "triangle": Triangle, **PATHS.defined}
#: What a waveform may have in a file.
_OF_WAVES = tuple(dict.fromkeys((*(key for wave in _WAVES.values() for key in parameters(wave)), "period")))
_PERIOD = Parameter("period", SECOND, 0.0, above=True)
_TIME = Parameter("time of a vertical load", SECOND)
#: Ways to give the vertical load.
_LOADS = {
    "pressure": Parameter("pressure on the slider", N_PER_MM2),
    "load": Parameter("vertical force", KN),
    "load_points": Parameter("times and vertical forces", KN),
}
#: What a test may have in a file.
_KEYS = (*parameters(RigTest), "waveform", "file", *_OF_WAVES, *_LOADS)


def load_program(name: str | Path) -> Program:
    """Return a test program.

    Parameters
    ----------
    name
        ``dependency`` or ``asce``, the two of Li et al. (2020), or ``plane``, paths in two directions; a CSV file with a measured displacement or path (and load), which is
        one test; or a TOML file with the fields of a `Program`, and a list of ``[[test]]`` with those of a `RigTest`, and: ``waveform`` (``sine``, ``triangle``, a path such as
        ``circle``, or ``file``) with the fields of a `Sine` or of the path, of which ``period`` [s] may stand for ``peak_velocity``, or a ``file`` (CSV); ``pressure`` [N/mm2],
        ``load`` [kN] or ``load_points`` (pairs of s and kN), else the bearing's own.

    Raises
    ------
    InputError
        If there is no such program, the file is not one, a key is not known or missing, or a value is out of range.
    """
    key = str(name).strip().lower()
    if key in NAMED:
        text = files("dcfp.analysis.rig").joinpath("programs", NAMED[key]).read_text(encoding="utf-8")
        return _parsed(tomllib.loads(text), key, Path())
    path = Path(name)
    try:
        is_there = path.exists()
    except (OSError, ValueError) as error:
        msg = f"{str(name)[:60]!r}: this cannot be the name of a file."
        raise InputError(msg) from error
    if path.suffix.lower() == ".csv":
        test = recorded_test(path)
        return Program(test.name, (test,), source=f"measured displacement, {path.name}")
    if not is_there:
        programs = (*NAMED, *PROTOTYPE_TESTS)
        near = get_close_matches(key, programs, n=1)
        hint = (
            f"did you mean {near[0]!r}?"
            if near
            else f"the programs are {', '.join(programs)}, or give a .toml or .csv file."
        )
        msg = f"{name}: there is no such test program or file; {hint}"
        raise InputError(msg)
    content = read_toml(path, "a test program is TOML with [[test]] tables")
    return _parsed(content, str(path), path.parent)


def recorded_test(path: Path) -> RigTest:
    """Return the test that a CSV file holds: a measured displacement in one direction, or a path in the plane."""
    return measured_test(read_path(path) if is_path(path) else read_measurement(path))


def measured_test(measurement: Measurement | MeasuredPath) -> RigTest:
    """Return the test that a measurement was: its displacement or path, and its vertical load where it has one."""
    load = None
    if measurement.optional_load is not None:
        load = VerticalLoad(
            tuple(measurement.optional_load.tolist()), tuple(measurement.time.tolist()), is_pressure=False
        )
    if isinstance(measurement, MeasuredPath):
        wave = RecordedPath(measurement.time, measurement.position)
        moves = np.diff(measurement.position)
        turns = np.count_nonzero((moves[1:] * moves[:-1].conj()).real < 0.0)
    else:
        wave = Recorded(measurement.time, measurement.displacement)
        turns = np.count_nonzero(np.diff(np.sign(np.diff(measurement.displacement))))
    if turns > _MOST_TURNS * measurement.time.size:
        msg = (
            f"{measurement.name}: the displacement changes its direction at {100.0 * turns / measurement.time.size:.0f} % of the samples;"
            " it is too noisy to be driven, smooth it or take fewer samples."
        )
        raise InputError(msg)
    return RigTest(measurement.name, wave, load)


def _parsed(content: Mapping[str, Any], where: str, folder: Path) -> Program:
    """Return the program of a TOML document, called `where` in a sentence, whose files are relative to a folder."""
    rest = {key: value for key, value in content.items() if key != "test"}
    values = {"name": Path(where).stem} | read_table(Program, rest, where, also=("test",))
    tables = content.get("test")
    if not isinstance(tables, list) or not all(isinstance(one, dict) for one in cast("list[Any]", tables)):
        msg = f"{where}: a test program needs at least one [[test]] table."
        raise InputError(msg)
    if values.get("code"):
        PROTOTYPE_TESTS.find(values["code"], where)
    tests: list[RigTest] = []
    for number, table in enumerate(cast("list[dict[str, Any]]", tables), start=1):
        name = str(table.get("name", f"test {number}"))
        try:
            tests.append(_test({"name": name, **table}, folder))
        except InputError as error:
            msg = f"{where}, {name}: {error}"
            raise InputError(msg) from error
    return build(Program, {**values, "tests": tuple(tests)}, where)


def _test(table: dict[str, Any], folder: Path) -> RigTest:
    for key in table:
        if key not in _KEYS:
            raise InputError(unknown(key, _KEYS, "key of a test"))
    values = read_table(RigTest, {key: table[key] for key in parameters(RigTest) if key in table}, "a test")
    waveform, load = _waveform(table, folder)
    return build(RigTest, {**values, "waveform": waveform, "load": _load(table) or load}, "")


def _waveform(
    table: dict[str, Any], folder: Path
) -> tuple[Waveform | PlanePath | RecordedPath, VerticalLoad | None]:
    """Return the displacement, and the load that was measured with it."""
    kind = table.get("waveform", "file" if "file" in table else "sine")
    given = {key: table[key] for key in _OF_WAVES if key in table}
    if kind == "file":
        if given:
            msg = f"a displacement from a file has no {next(iter(given))!r}; leave it out."
            raise InputError(msg)
        if "file" not in table:
            msg = 'the waveform is file, so file = "NAME.csv" must name it.'
            raise InputError(msg)
        test = recorded_test(folder / str(table["file"]))
        return test.waveform, test.load
    if kind not in _WAVES:
        msg = f"the waveform must be {', '.join(_WAVES)} or file, not {kind!r}."
        raise InputError(msg)
    wave, period = _WAVES[kind], given.pop("period", None)
    values = read_table(wave, given, wave.noun)
    for one in parameters(wave).values():
        if one.default is None and not one.optional and one.name not in (*values, "peak_velocity"):
            msg = f"{one.key} is missing; it must be {one.rule()}."
            raise InputError(msg)
    if ("peak_velocity" in values) == (period is not None):
        msg = "give either peak_velocity [mm/s] or period [s]."
        raise InputError(msg)
    if period is not None:
        length = _PERIOD.read(period, "period")
        values["peak_velocity"] = build(wave, {**values, "peak_velocity": 1.0}, "").period / length
    return cast("Sine | Triangle | PlanePath", build(wave, values, "")), None


def _load(table: dict[str, Any]) -> VerticalLoad | None:
    given = [key for key in _LOADS if key in table]
    if len(given) > 1:
        msg = f"give one of {', '.join(_LOADS)}, not {' and '.join(given)}."
        raise InputError(msg)
    if not given:
        return None
    (key,) = given
    if key != "load_points":
        return VerticalLoad((_LOADS[key].read(table[key], key),), is_pressure=key == "pressure")
    points = table[key]
    if not isinstance(points, list) or not all(
        isinstance(one, list) and len(cast("list[Any]", one)) == 2 for one in cast("list[Any]", points)
    ):
        msg = "load_points must be a list of pairs of time [s] and load [kN], such as [[0, 7540], [5, 9000]]."
        raise InputError(msg)
    times, forces = zip(*cast("list[list[Any]]", points), strict=True)
    return VerticalLoad(
        tuple(_LOADS[key].read(one, key) for one in forces),
        tuple(_TIME.read(one, key) for one in times),
        is_pressure=False,
    )
