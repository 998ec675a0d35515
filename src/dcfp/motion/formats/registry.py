"""The formats of record files, which of them a file is in, and its components: ground motions with names."""

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.motion.formats.directions import direction, plain
from dcfp.motion.formats.source import SourceText, unit_size
from dcfp.motion.ground_motion import GroundMotion, Origin
from dcfp.schema.registry import Registry

#: Time steps that a record can have [s]; anything else is a damaged header.
SHORTEST_STEP = 1e-5
LONGEST_STEP = 10.0

#: Largest acceleration that is believed [mm/s2]: some 100 000 g.
LARGEST_ACCELERATION = 1e9


@dataclass(frozen=True, eq=False)
class Series:
    """One component of a record, as its file has it, and what the file says for the `Origin` of its motion."""

    values: FloatArray  #: acceleration in the file's unit
    unit: str  #: that unit, as `canonical_unit` spells it
    time_step: float  #: interval between two values [s]
    component: str = ""  #: its name in the file; empty where it has none
    names: tuple[str, ...] = ()  #: further names by which it can be asked for
    event: str = ""
    station: str = ""
    processing: str = ""
    citation: str = ""
    start: str = ""  #: when the first value was recorded, as `moment` writes it
    scale: float = 1.0  #: how many units one value stands for [-]


@dataclass(frozen=True, eq=False)
class Component:
    """A ground motion, and the names by which it can be asked for."""

    motion: GroundMotion
    names: tuple[str, ...]


def printed_resolution(word: str) -> float:
    """Return the last digit's place in a printed number: 0.01 for ``"1.25"`` and for ``"1.25e0"``."""
    mantissa, _, exponent = word.strip().upper().replace("D", "E").partition("E")
    decimals = len(mantissa.partition(".")[2])
    power = int(exponent) if re.fullmatch(r"[+-]?\d{1,3}", exponent) else 0
    return float(10.0 ** max(min(power - decimals, 300), -300))


def check_times(source: SourceText, time: FloatArray, time_step: float, resolution: float) -> None:
    """Refuse times [s] that do not go up by `time_step` [s], within the rounding of their printed digits, `resolution` [s].

    Raises
    ------
    InputError
        If a time is off by more than `resolution` [s].
    """
    with np.errstate(over="ignore", invalid="ignore"):
        expected = time[0] + np.arange(time.size) * time_step
        off = ~(np.abs(time - expected) <= 1.001 * resolution + 1e-9 * np.abs(expected))
    if off.any():
        place = int(np.flatnonzero(off)[0])
        source.fail(
            f"the times are not equally spaced: time {place + 1} is {time[place]:g} s where "
            f"{expected[place]:g} s was expected."
        )


def uniform_step(source: SourceText, time: FloatArray, resolution: float) -> float:
    """Return the step [s] of times, which must be equally spaced: the roundest step or rate that agrees with them.

    Raises
    ------
    InputError
        If the times do not go up, are printed with too few digits, or are not equally spaced.
    """
    if time.size < 2:
        source.fail("the file holds fewer than two times.")
    with np.errstate(over="ignore"):
        steps = np.diff(time)
    if not (steps > 0.0).all():
        place = int(np.flatnonzero(~(steps > 0.0))[0])
        source.fail(
            f"time {place + 2} ({time[place + 1]:g} s) is not later than the one before it; "
            "times must go up and be printed with enough digits."
        )
    mean_step = (float(time[-1]) - float(time[0])) / (time.size - 1)
    step, tolerance = next(_fitting_steps(time, mean_step, resolution), (mean_step, resolution))
    if tolerance > 0.0 and resolution > 0.5 * mean_step:
        source.fail("the times are printed with too few digits to tell their step; print more digits.")
    check_times(source, time, step, resolution)
    return step


def _fitting_steps(time: FloatArray, mean_step: float, resolution: float) -> Iterator[tuple[float, float]]:
    """Yield steps, or rates, of few digits and how far the times are off: not at all, rounded, or cut off."""
    if not 1e-9 < mean_step < 1e9:
        return
    place = np.arange(time.size)
    for tolerance in (0.0, 0.5 * resolution, resolution):
        for digits in range(1, 10):
            for step in (float(f"{mean_step:.{digits}g}"), 1.0 / float(f"{1.0 / mean_step:.{digits}g}")):
                off = np.abs(time - time[0] - place * step).max()
                if off <= tolerance + 1e-3 * resolution:
                    yield step, tolerance


def select_component(components: Sequence[Component], wanted: str | None, path: Path) -> Component:
    """Return the component that is asked for, which must be one alone.

    Raises
    ------
    InputError
        If there are several and none is asked for, or none or several have that name.
    """
    if wanted is None:
        if len(components) == 1:
            return components[0]
        msg = f"{path}: the file holds {len(components)} components; choose one of {_choices(components)}."
        raise InputError(msg)
    found = _matches(components, wanted)
    if len(found) == 1:
        return found[0]
    how = "has no component" if not found else "has more than one component"
    msg = f"{path}: the file {how} {wanted!r}; choose one of {_choices(components)}."
    raise InputError(msg)


def _matches(components: Sequence[Component], wanted: str) -> list[Component]:
    word = plain(wanted)
    by_name = [item for item in components if word in {plain(name) for name in item.names if name}]
    if by_name or direction(wanted) is None:
        return by_name
    return [item for item in components if direction(wanted) in {direction(name) for name in item.names}]


def _choices(components: Sequence[Component]) -> str:
    labels = [item.names[0] or f"channel {number}" for number, item in enumerate(components, 1)]
    return ", ".join(repr(label) for label in labels)


@dataclass(frozen=True)
class RecordFormat:
    """A format of record files; one that is made, in a module of its own, is in the registry.

    It reads every component of a file, and fails where the header is incomplete or does not agree with the values.
    """

    name: str
    words: str  #: whose files are in it, and what is in them
    recognises: Callable[[SourceText], bool]  #: whether a file is in it, from its content
    read: Callable[[SourceText], list[Series]]
    citation: str = ""  #: how its data ask to be cited; empty when nothing is asked
    one_of_several: bool = False  #: whether the components of a record may be in files of the same stem

    def __post_init__(self) -> None:
        FORMATS.add(self.name, self)


#: The formats by their names.
FORMATS: Registry[RecordFormat] = Registry("record format")
#: What a file is in that no format recognises.
PLAIN = "plain columns"


def read_components(source: SourceText) -> list[Component]:
    """Return every component of a record file.

    Raises
    ------
    InputError
        If the file is in no known format or damaged, or contradicts what the user says of it.
    """
    form = next((one for one in FORMATS.values() if one.recognises(source)), FORMATS[PLAIN])
    found = form.read(source)
    for series in found:
        _check_agreement(source, form.name, series)
    several = form.one_of_several or len(found) > 1
    return [_component(source, series, form, several=several) for series in found]


def _check_agreement(source: SourceText, name: str, series: Series) -> None:
    if source.units is not None and unit_size(source.units) != unit_size(series.unit):
        source.fail(f"the {name} file states its own unit, {series.unit}; leave out units={source.units!r}.")
    stated, given = series.time_step, source.time_step
    if given is not None and abs(given - stated) > 1e-6 * stated:
        source.fail(f"the {name} file states its own time step, {stated:g} s; leave out {given!r}.")


def _component(source: SourceText, series: Series, form: RecordFormat, *, several: bool) -> Component:
    """Return a component of a file, if it can be one of a ground motion; `several` says that the name of its motion must tell it from others."""
    if not SHORTEST_STEP <= series.time_step <= LONGEST_STEP:
        source.fail(
            f"the time step is {series.time_step:g} s; a record has one between {SHORTEST_STEP:g} and "
            f"{LONGEST_STEP:g} s."
        )
    if series.values.size < 2:
        source.fail("the file holds fewer than two acceleration values.")
    with np.errstate(over="ignore", under="ignore"):
        acceleration = series.values * (series.scale * unit_size(series.unit))
    wrong = np.flatnonzero(~(np.abs(acceleration) <= LARGEST_ACCELERATION))
    if wrong.size:
        source.fail(f"acceleration value {wrong[0] + 1} is beyond 100 000 g; the value or the unit is wrong.")
    origin = Origin(
        event=series.event,
        station=series.station,
        component=series.component,
        source=source.path.name,
        file_format=form.name,
        processing=series.processing,
        citation=series.citation or form.citation,
        start=series.start,
    )
    stem = source.path.stem or source.path.name
    name = f"{stem} {series.component}" if several and series.component else stem
    motion = GroundMotion(acceleration, series.time_step, name, origin)
    return Component(motion, (series.component, *series.names))
