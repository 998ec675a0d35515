"""A study, which analyses and what of each is kept; and its plan: dimensions, blocks, the analyses of each block."""

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np

from dcfp.analysis.batch import GroundSet, Lanes
from dcfp.analysis.integration import DEFAULT, Integration, usual_heating
from dcfp.analysis.plane_batch import StationSet
from dcfp.arrays import FloatArray, IntArray
from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import refuse_a_drift
from dcfp.motion.station import Station, stations_of
from dcfp.schema.notebook import card
from dcfp.schema.parameters import Parameter, unknown
from dcfp.study.factors import (
    ANALYSIS,
    Choice,
    Distribution,
    Sampling,
    Uniform,
    Value,
    changed,
    factor,
    is_of_system,
)
from dcfp.study.results import INTENSITIES, histories_of
from dcfp.system import System

RECORD, SAMPLE = "record", "sample"
#: Analyses in a block at most, the same of stations, and blocks in a study at least, as far as it has so many analyses.
LARGEST_BLOCK, LARGEST_PLANE_BLOCK, FEWEST_BLOCKS = 4096, 512, 64
#: Values of histories in a block at most: 64 MiB.
LARGEST_HISTORIES = 8 * 2**20
#: Analyses that a study may have.
MOST_ANALYSES = 1_000_000_000
#: Models that are tried beforehand; of more only those with the smallest and largest values.
_MOST_TRIED = 5000
_FACTOR_OF_SCALE = "scale"


#: The system of a study that says none.
_USUAL = System()


@dataclass(frozen=True, eq=False)
class Study:
    """Analyses of every combination of the factors.

    Parameters
    ----------
    motions
        The ground motions, unscaled: single components, or stations, which are analysed in the plane.
    factors
        Values of each factor of the grid in the units of the package, in the order of the dimensions of the
        results; ``record`` stands first unless it is named here (then with the names of the motions). Those
        of one value are a dimension too.
    sampling
        Factors that vary together instead of each with each.
    model, bearings
        The bearing, law and heating that the factors change, and those that the factor ``bearing`` names. By default those of Li et al. (2020), with
        the precise heating model of stations.
    title, name, text
        For people, and for files; and the study file, where it came from one.
    settings
        How each analysis goes.
    vertical
        Whether the vertical force follows the vertical components of the stations.
    histories
        Names of the histories that are kept besides the peaks, over the length of each record.

    Raises
    ------
    InputError
        If a factor is not known, has no value, has one twice, or a value that cannot be.
    """

    motions: Sequence[GroundMotion | Station]
    factors: Mapping[str, Sequence[Value]] = field(default_factory=dict[str, Sequence[Value]])
    sampling: Sampling | None = None
    model: System = _USUAL
    bearings: Mapping[str, System] = field(default_factory=dict[str, System])
    title: str = "Study"
    name: str = "study"
    settings: Integration = DEFAULT
    vertical: bool = False
    histories: tuple[str, ...] = ()
    text: str = ""

    def __post_init__(self) -> None:
        names = [motion.name for motion in self.motions]
        if not names:
            msg = "factor 'record' has no value; name at least one record, for example NCC."
            raise InputError(msg)
        if self.model is _USUAL:
            object.__setattr__(self, "model", System.of(usual=usual_heating(self.motions)))
        _refuse_twice(self.motions)
        given, sampled = dict(self.factors), self.sampled
        grid = given if RECORD in given or RECORD in sampled else {RECORD: names, **given}
        both = sorted(set(grid) & set(sampled))
        if both:
            msg = f"factor {both[0]!r} is both in the grid and sampled; give it once."
            raise InputError(msg)
        known = {name: self._factor(name) for name in (*grid, *sampled)}
        checked = {name: _checked(known[name], values) for name, values in grid.items()}
        object.__setattr__(self, "factors", checked)
        if self.sampling is not None:
            drawn = {name: _checked_distribution(known[name], one) for name, one in sampled.items()}
            object.__setattr__(self, "sampling", replace(self.sampling, factors=drawn))
        known_histories = histories_of(in_plane=self.in_plane)
        for name in self.histories:
            if name not in known_histories:
                raise InputError(unknown(name, known_histories, "history"))
        _refuse_without_effect(self)
        if self.intensity in ("pgv", "pga"):
            for motion in self.motions:
                refuse_a_drift(motion)
                if motion.peak_velocity == 0.0:
                    msg = f"{motion.name}: every value is zero, so the record cannot be scaled."
                    raise InputError(msg)

    @property
    def in_plane(self) -> bool:
        """Whether the ground motions are stations, which are analysed in the plane."""
        return bool(stations_of(self.motions))

    @property
    def sampled(self) -> Mapping[str, Distribution]:
        """Distribution of each factor that is sampled."""
        return {} if self.sampling is None else self.sampling.factors

    def _factor(self, name: str) -> Parameter:
        """Return a factor with the words that it may have here."""
        one = factor(name)
        choices = {
            RECORD: tuple(motion.name for motion in self.motions),
            "bearing": tuple(self.bearings),
        }
        return replace(one, choices=choices.get(name, one.choices))

    def values_of(self, name: str) -> list[Value] | None:
        """Return the values that a factor can have: of the grid, or of a choice that is sampled; None where it is not varied or has a range."""
        if name in self.factors:
            return list(self.factors[name])
        one = self.sampled.get(name)
        return list(one.values) if isinstance(one, Choice) else None

    @cached_property
    def plan(self) -> "Plan":
        """What the study comes to.

        Raises
        ------
        InputError
            If a bearing, law or heating that it needs cannot be.
        """
        return Plan(self)

    def __getstate__(self) -> dict[str, Any]:
        # the plan is made again where the study is unpacked
        return {name: value for name, value in vars(self).items() if name != "plan"}

    @property
    def intensity(self) -> str | None:
        """Name of the factor that scales the ground motions."""
        names = {*self.factors, *self.sampled}
        return next((name for name in INTENSITIES if name in names), None)

    def _repr_html_(self) -> str:
        facts = {
            "records": tuple(motion.name for motion in self.motions),
            **{name: tuple(values) for name, values in self.factors.items() if name != RECORD},
            "analyses": self.plan.count,
            "bearing": self.model.bearing.name,
        }
        return card(self.title, facts)


def _refuse_twice(motions: Sequence[GroundMotion | Station]) -> None:
    seen: dict[str, str] = {}
    names: set[str] = set()
    for motion in motions:
        other = seen.setdefault(motion.digest, motion.name)
        if motion.name in names or other != motion.name:
            what = "named twice" if motion.name in names else f"the same record as {other}"
            msg = f"{motion.name}: this is {what}; name it once, or it would count twice."
            raise InputError(msg)
        names.add(motion.name)


def _refuse_without_effect(study: Study) -> None:
    """Refuse factors that would change nothing, or undo each other."""
    names = {*study.factors, *study.sampled}
    chosen = [name for name in INTENSITIES if name in names]
    if len(chosen) > 1:
        msg = f"{' and '.join(chosen)} both scale the ground motions; give one of them."
        raise InputError(msg)
    if "radius" in names and names & {"lower_radius", "upper_radius"}:
        msg = "radius is that of each plate, so that lower_radius and upper_radius have no place beside it."
        raise InputError(msg)
    heatings = study.values_of("heating") or [study.model.heating.name]
    idle = sorted(names & {"conductivity", "diffusivity", "thickness"})
    if idle and heatings == ["none"] and not study.bearings:
        msg = f"without heating {idle[0]!r} changes nothing; leave it out, or choose another heating."
        raise InputError(msg)
    if study.vertical:
        if not study.in_plane:
            msg = "vertical is for stations; a single component has no other direction."
            raise InputError(msg)
        for station in stations_of(study.motions):
            station.require_vertical()
    predicted = [name for name in study.values_of("procedure") or [] if name != ANALYSIS]
    if predicted and study.in_plane:
        msg = f"the procedure {predicted[0]!r} is of one direction, and the records are stations; leave it out, or name single components."
        raise InputError(msg)
    if study.histories and ANALYSIS not in (study.values_of("procedure") or [ANALYSIS]):
        msg = f"histories are of the procedure {ANALYSIS!r}, which is not among those of the study."
        raise InputError(msg)


def _checked(one: Parameter, values: Sequence[Value]) -> list[Value]:
    """Return the values of a factor, also of an array, as Python's own numbers, and words as they are declared."""
    given: list[Value] = values.tolist() if isinstance(values, np.ndarray) else list(values)
    if not given:
        msg = f"factor {one.key!r} has no value; give it at least one."
        raise InputError(msg)
    allowed = [_allowed(one, value) for value in given]
    found = given if one.is_number else allowed  # a number keeps its last digit
    if len(set(found)) != len(found):
        twice = next(value for value in found if found.count(value) > 1)
        shown = repr(twice) if isinstance(twice, str) else one.text(twice)
        msg = f"factor {one.key!r} has the value {shown} twice; give it once."
        raise InputError(msg)
    return found


def _allowed(one: Parameter, value: Any) -> Any:
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    return one.checked(one.unit.shown(value) if is_number else value, f"factor {one.key!r}", one.unit)


def _checked_distribution(one: Parameter, distribution: Distribution) -> Distribution:
    if isinstance(distribution, Choice):
        return Choice(tuple(_checked(one, distribution.values)))
    if not one.is_number:
        msg = f"factor {one.key!r} takes words; sample it from a list of values."
        raise InputError(msg)
    # what a sample will hardly ever leave: the whole range, or four standard deviations
    ends = np.array([0.0, 1.0]) if isinstance(distribution, Uniform) else np.array([3.2e-5, 1.0 - 3.2e-5])
    for value in distribution.at(ends).tolist():
        _allowed(one, value)
    return distribution


@dataclass(frozen=True)
class Block:
    """Part of the grid: its number in the order of the grid, and the region along each dimension."""

    number: int
    region: tuple[slice, ...]

    @property
    def shape(self) -> tuple[int, ...]:
        """Analyses along each dimension."""
        return tuple(part.stop - part.start for part in self.region)

    @property
    def size(self) -> int:
        """Number of analyses."""
        return math.prod(self.shape)


@dataclass(frozen=True, eq=False)
class Cases:
    """The analyses of a block, in the order of the grid, and the number of each procedure in `Plan.procedures`."""

    lanes: Lanes
    procedures: IntArray


@dataclass(frozen=True, eq=False)
class Plan:
    """What a study comes to."""

    study: Study
    samples: dict[str, Any] = field(init=False)

    def __post_init__(self) -> None:
        drawn = {} if self.study.sampling is None else self.study.sampling.values()
        object.__setattr__(self, "samples", drawn)
        if self.count > MOST_ANALYSES:
            msg = f"the study has {self.count:.3g} analyses, more than {MOST_ANALYSES:.0e}; give its factors fewer values."
            raise InputError(msg)
        self.models_at_ends()  # so that nothing fails on the way

    @cached_property
    def sizes(self) -> dict[str, int]:
        """Length of each dimension."""
        sizes = {name: len(values) for name, values in self.study.factors.items()}
        if self.samples:
            sizes[SAMPLE] = len(next(iter(self.samples.values())))
        return sizes

    @property
    def shape(self) -> tuple[int, ...]:
        """Length of each dimension, in their order."""
        return tuple(self.sizes.values())

    @property
    def count(self) -> int:
        """Number of analyses."""
        return math.prod(self.shape)

    @cached_property
    def chunks(self) -> tuple[int, ...]:
        """Length of a block along each dimension: whole along the last ones, as far as a block may have so many analyses."""
        largest = LARGEST_PLANE_BLOCK if self.study.in_plane else LARGEST_BLOCK
        room = max(1, min(largest, self.count // FEWEST_BLOCKS))
        kept = len(self.study.histories) * self.longest_record
        if kept:
            room = max(1, min(room, LARGEST_HISTORIES // kept))
        found: list[int] = []
        for size in reversed(self.shape):
            parts = math.ceil(size / max(1, min(size, room)))
            found.append(math.ceil(size / parts))
            room //= size
        return tuple(reversed(found))

    def blocks(self) -> Iterator[Block]:
        """Return every block, in the order of the grid."""
        along = [range(0, size, chunk) for size, chunk in zip(self.shape, self.chunks, strict=True)]
        for number, starts in enumerate(itertools.product(*along)):
            ends = (min(a + c, n) for a, c, n in zip(starts, self.chunks, self.shape, strict=True))
            yield Block(number, tuple(slice(a, b) for a, b in zip(starts, ends, strict=True)))

    @cached_property
    def grounds(self) -> GroundSet | StationSet:
        """The ground motions as the kernel takes them."""
        study = self.study
        return GroundSet.of(study.motions, study.settings, vertical=study.vertical)

    @cached_property
    def _samples(self) -> IntArray:
        return np.array([len(motion.acceleration) for motion in self.study.motions], dtype=np.intp)

    @property
    def longest_record(self) -> int:
        """Samples of the longest ground motion."""
        return int(self._samples.max())

    def cost(self, block: Block) -> float:
        """Return about how long a block takes, in samples of the ground motion."""
        cases = self._numbers(block)
        return float(self._samples[cases[RECORD]].sum())

    def cases(self, block: Block) -> Cases:
        """Return the analyses of a block."""
        numbers = self._numbers(block)
        record = numbers[RECORD]
        keys, model = self._distinct_models(numbers)
        models = [self._model(key) for key in keys]
        lanes = Lanes(record, self._scales(numbers, record), model, models)
        return Cases(lanes, numbers["procedure"])

    def motion(self, lanes: Lanes, lane: int) -> GroundMotion | Station:
        """Return the ground motion of an analysis as it shakes the bearing."""
        motion, scale = self.study.motions[int(lanes.record[lane])], float(lanes.scale[lane])
        return motion if scale == 1.0 else motion.scaled(scale)

    def _numbers(self, block: Block) -> dict[str, IntArray]:
        """Return the place of each analysis of a block along each dimension, and of its record and its procedure."""
        inside = np.indices(block.shape, dtype=np.intp).reshape(len(block.shape), -1)
        found = {
            name: axis + part.start for name, axis, part in zip(self.sizes, inside, block.region, strict=True)
        }
        none = np.zeros(inside.shape[1], dtype=np.intp)
        names = [motion.name for motion in self.study.motions]
        for name, known in ((RECORD, names), ("procedure", self.procedures)):
            if name in self.samples:
                places = {word: place for place, word in enumerate(known)}
                drawn = np.array([places[word] for word in self.samples[name].tolist()], dtype=np.intp)
                found[name] = drawn[found[SAMPLE]]
            else:
                found.setdefault(name, none)
        return found

    @cached_property
    def procedures(self) -> list[str]:
        """Names of the procedures."""
        drawn: list[str] = (
            sorted(set(self.samples["procedure"].tolist())) if "procedure" in self.samples else []
        )
        return [str(name) for name in self.study.factors.get("procedure", drawn or [ANALYSIS])]

    def _scales(self, numbers: dict[str, IntArray], record: IntArray) -> FloatArray:
        """Return the factor on each analysis's ground motion [-]."""
        name = self.study.intensity
        if name is None:
            return np.ones(record.size)
        if name in self.samples:
            values = np.asarray(self.samples[name], dtype=np.float64)[numbers[SAMPLE]]
        else:
            values = np.array(self.study.factors[name], dtype=np.float64)[numbers[name]]
        return values if name == _FACTOR_OF_SCALE else values / self._peaks[record]

    @cached_property
    def _peaks(self) -> FloatArray:
        name = "peak_velocity" if self.study.intensity == "pgv" else "peak_acceleration"
        return np.array([getattr(motion, name) for motion in self.study.motions])

    @cached_property
    def _model_dimensions(self) -> list[str]:
        return list(dict.fromkeys(SAMPLE if name in self.samples else name for name in self._model_factors))

    @cached_property
    def _model_factors(self) -> list[str]:
        return [name for name in (*self.study.factors, *self.samples) if is_of_system(name)]

    def _distinct_models(self, numbers: dict[str, IntArray]) -> tuple[list[dict[str, int]], IntArray]:
        """Return the places of each model that differs along the dimensions of models, and which of them each analysis has."""
        names = self._model_dimensions
        if not names:
            return [{}], np.zeros(numbers[RECORD].size, dtype=np.intp)
        unique, which = np.unique(np.stack([numbers[name] for name in names]), axis=1, return_inverse=True)
        keys = [dict(zip(names, key, strict=True)) for key in unique.T.tolist()]
        return keys, which.ravel().astype(np.intp)

    def _model(self, key: dict[str, int]) -> System:
        values = {name: self._value(name, key) for name in self._model_factors}
        return changed(self.study.model, values, self.study.bearings)

    def _value(self, name: str, key: dict[str, int]) -> Value:
        if name in self.samples:
            value: Value = self.samples[name][key[SAMPLE]].item()
            return value
        return self.study.factors[name][key[name]]

    def models_at_ends(self) -> list[System]:
        """Return every model, or of many those at the ends of every factor.

        Raises
        ------
        InputError
            If one of them cannot be; the sentence names the values.
        """
        names = self._model_dimensions
        sizes = [self.sizes[name] for name in names]
        whole = math.prod(sizes) <= _MOST_TRIED
        along: list[Sequence[int]] = [
            range(size) if whole or not (name == SAMPLE or factor(name).is_number) else self._ends(name)
            for name, size in zip(names, sizes, strict=True)
        ]
        found: list[System] = []
        for places in itertools.islice(itertools.product(*along), _MOST_TRIED):
            key = dict(zip(names, places, strict=True))
            try:
                model = self._model(key)
                model.friction.at_pressure(model.bearing.pressure)
            except InputError as error:
                values = {name: self._value(name, key) for name in self._model_factors}
                told = [
                    f"{name} = {value if isinstance(value, str) else f'{value:g}'}"
                    for name, value in values.items()
                ]
                words = str(error)
                msg = f"{', '.join(told)}: {words[:1].lower()}{words[1:]}"
                raise InputError(msg) from error
            found.append(model)
        return found

    def _ends(self, name: str) -> list[int]:
        if name != SAMPLE:
            order = np.argsort(np.array(self.study.factors[name], dtype=np.float64))
            return [int(order[0]), int(order[-1])]
        found: set[int] = set()
        for drawn in self.samples.values():
            if drawn.dtype.kind == "f":
                found |= {int(drawn.argmin()), int(drawn.argmax())}
        return sorted(found | set(range(min(100, self.sizes[SAMPLE]))))
