"""A study from a TOML file."""

from collections.abc import Mapping
from difflib import get_close_matches
from pathlib import Path
from typing import Any, cast

from dcfp.analysis.integration import Integration
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_motions
from dcfp.motion.treatment import treated
from dcfp.schema.reading import read_toml
from dcfp.study.factors import OF_LAW, Value, factor
from dcfp.study.sampling import LATIN_HYPERCUBE, Choice, Distribution, Sampling
from dcfp.study.study import RECORD, Study
from dcfp.study.values import distribution_from, values_from
from dcfp.system import System, read_bearing

BEARING = "bearing"
_TABLES = ("title", "bearing", "motion", "factors", "sampling", "analysis", "keep", "report")
_MOTION_KEYS = ("component", "units", "time_step", "baseline", "high_pass")
_ANALYSIS_KEYS = ("tail", "tolerance", "step")
_SAMPLING_KEYS = ("method", "count", "seed", "factors")
_KEEP_KEYS = ("histories",)
#: What can be kept besides the peaks.
HISTORIES = ("displacement", "velocity", "force", "friction", "temperature", "structure_acceleration")


def read_study(path: str | Path) -> Study:
    """Read a study file.

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
    place = Path(path)
    try:
        # to make the plan finds what cannot be, here where the file is known
        return _study(content, place).plan.study
    except InputError as error:
        text = str(error)
        msg = text if text.startswith(str(path)) else f"{path}: {text}"
        raise InputError(msg) from error


def _study(content: Mapping[str, Any], place: Path) -> Study:
    _refuse_unknown(content, _TABLES, "a study file")
    grid = _flat(_table(content, "factors"))
    sampling = _table(content, "sampling")
    _refuse_unknown(sampling, _SAMPLING_KEYS, "[sampling]")
    sampled = _flat(_table(sampling, "factors", "sampling.factors"))
    motions = _motions(grid, sampled, _table(content, "motion"), place.parent)
    return Study(
        motions=motions,
        factors={name: _grid_values(name, given, motions) for name, given in grid.items()},
        sampling=_sampling(sampling, sampled, motions),
        model=_model(_table(content, "bearing"), place),
        bearings=_bearings(grid, sampled, place.parent),
        title=_title(content, place),
        name=place.stem,
        settings=Integration.from_table(_table(content, "analysis"), "[analysis]"),
        histories=_histories(_table(content, "keep")),
        text=place.read_text(encoding="utf-8"),
    )


# ----- tables -----


def _table(content: Mapping[str, Any], key: str, shown: str = "") -> dict[str, Any]:
    table = content.get(key, {})
    if not isinstance(table, dict):
        msg = f"{key!r} must be a table, written [{shown or key}]."
        raise InputError(msg)
    return dict(cast("dict[str, Any]", table))


def _refuse_unknown(table: Mapping[str, Any], known: tuple[str, ...], where: str) -> None:
    for key in table:
        if key not in known:
            near = get_close_matches(key, known, n=1)
            meant = f"did you mean {near[0]!r}?" if near else f"it has {', '.join(known)}."
            msg = f"{where} has no {key!r}; {meant}"
            raise InputError(msg)


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


def _title(content: Mapping[str, Any], place: Path) -> str:
    title = content.get("title", place.stem)
    if not isinstance(title, str):
        msg = f"the title must be words in quotes, not {title!r}."
        raise InputError(msg)
    return title


# ----- ground motions -----


def _motions(
    grid: dict[str, Any], sampled: dict[str, Any], options: dict[str, Any], folder: Path
) -> list[GroundMotion]:
    _refuse_unknown(options, _MOTION_KEYS, "[motion]")
    given = grid.get(RECORD, sampled.get(RECORD))
    if given is None:
        msg = "there is no factor 'record'; name at least one, for example record = [\"NCC\"] in [factors]."
        raise InputError(msg)
    names = [_found_from(folder, str(name)) for name in values_from(factor(RECORD), given)]
    motions = load_motions(
        names,
        _option(options, "component", str),
        units=_option(options, "units", str),
        time_step=_option(options, "time_step", float),
    )
    baseline, corner = _option(options, "baseline", bool), _option(options, "high_pass", float)
    return [treated(motion, baseline=bool(baseline), corner=corner) for motion in motions]


def _found_from(folder: Path, name: str) -> str:
    """Return the name of a record; of a file that is there, as seen from the folder of the study file."""
    file, mark, component = name.partition("::")
    beside = folder / file
    try:
        there = beside.is_file()
    except (OSError, ValueError):
        there = False
    return f"{beside}{mark}{component}" if there else name


def _option(table: dict[str, Any], key: str, kind: type) -> Any:
    value = table.get(key)
    if value is None:
        return None
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if not isinstance(value, kind):
        words = {str: "words in quotes", float: "a number", bool: "true or false"}[kind]
        msg = f"{key!r} must be {words}, not {value!r}."
        raise InputError(msg)
    return value


# ----- factors -----


def _grid_values(name: str, given: Any, motions: list[GroundMotion]) -> list[Value]:
    if name == RECORD:
        return [motion.name for motion in motions]
    return values_from(factor(name), given)


def _bearings(grid: dict[str, Any], sampled: dict[str, Any], folder: Path) -> dict[str, System]:
    """Read the files that the factor ``bearing`` names, each once."""
    given = grid.get(BEARING, sampled.get(BEARING))
    names = [] if given is None else values_from(factor(BEARING), given)
    return {str(name): read_bearing(folder / str(name)) for name in names}


def _sampling(table: dict[str, Any], factors: dict[str, Any], motions: list[GroundMotion]) -> Sampling | None:
    if not table:
        return None
    found: dict[str, Distribution] = {}
    for name, given in factors.items():
        if name == RECORD:
            found[name] = Choice(tuple(motion.name for motion in motions))
        else:
            found[name] = distribution_from(factor(name), given)
    if "count" not in table:
        msg = "[sampling] needs a count, the number of samples."
        raise InputError(msg)
    return Sampling(found, table["count"], str(table.get("method", LATIN_HYPERCUBE)), table.get("seed", 1))


# ----- the rest -----


def _model(table: dict[str, Any], place: Path) -> System:
    file = table.pop("file", None)
    if file is not None:
        if table:
            msg = f"[bearing] names a file, so that {next(iter(table))!r} has no place beside it."
            raise InputError(msg)
        return read_bearing(place.parent / str(file))
    return System.from_table(table, f"{place}: [bearing]", "bearing of the study" if table else None)


def _histories(table: dict[str, Any]) -> tuple[str, ...]:
    _refuse_unknown(table, _KEEP_KEYS, "[keep]")
    names = table.get("histories", [])
    if not isinstance(names, list):
        msg = f'histories must be a list, for example ["displacement"], not {names!r}.'
        raise InputError(msg)
    for name in cast("list[Any]", names):
        if name not in HISTORIES:
            msg = f"there is no history {name!r}; those that can be kept are {', '.join(HISTORIES)}."
            raise InputError(msg)
    return tuple(dict.fromkeys(cast("list[str]", names)))
