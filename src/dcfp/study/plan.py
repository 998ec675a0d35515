"""The plan of a study: its dimensions, the blocks that it is worked off in, and the analyses of each block."""

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from dcfp.analysis.batch import GroundSet, Lanes
from dcfp.arrays import FloatArray, IntArray
from dcfp.errors import InputError
from dcfp.study.factors import ANALYSIS, Value, changed, factor, is_of_system
from dcfp.study.study import RECORD, SAMPLE, Study
from dcfp.system import System

#: Analyses in a block at most, and blocks in a study at least, as far as it has so many analyses.
LARGEST_BLOCK, FEWEST_BLOCKS = 4096, 64
#: Values of histories in a block at most: 64 MiB.
LARGEST_HISTORIES = 8 * 2**20
#: Analyses that a study may have.
MOST_ANALYSES = 1_000_000_000
#: Models that are tried beforehand; of more only those with the smallest and largest values.
_MOST_TRIED = 5000
_FACTOR_OF_SCALE = "scale"


@dataclass(frozen=True)
class Block:
    """Part of the grid: the analyses between two corners.

    Attributes
    ----------
    number
        In the order of the grid.
    region
        Along each dimension.
    """

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
    """The analyses of a block, in the order of the grid.

    Attributes
    ----------
    lanes
        What is analysed.
    procedures
        Number of the procedure of each in `Plan.procedures`, shape (analyses,).
    """

    lanes: Lanes
    procedures: IntArray


@dataclass(frozen=True, eq=False)
class Plan:
    """What a study comes to.

    Parameters
    ----------
    study
        The study.
    """

    study: Study
    samples: dict[str, Any] = field(init=False)

    def __post_init__(self) -> None:
        drawn = {} if self.study.sampling is None else self.study.sampling.values()
        object.__setattr__(self, "samples", drawn)
        if self.count > MOST_ANALYSES:
            msg = f"the study has {self.count:.3g} analyses, more than {MOST_ANALYSES:.0e}; give its factors fewer values."
            raise InputError(msg)
        self.models_at_ends()  # so that nothing fails on the way

    # ----- dimensions -----

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
        room = max(1, min(LARGEST_BLOCK, self.count // FEWEST_BLOCKS))
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

    # ----- what the analyses are of -----

    @cached_property
    def grounds(self) -> GroundSet:
        """The ground motions as the kernel takes them."""
        return GroundSet.of(self.study.motions, self.study.settings)

    @property
    def longest_record(self) -> int:
        """Samples of the longest ground motion."""
        return max(motion.acceleration.size for motion in self.study.motions)

    def cost(self, block: Block) -> float:
        """Return about how long a block takes, in samples of the ground motion."""
        cases = self._numbers(block)
        return float(self.grounds.steps[cases[RECORD]].sum())

    def cases(self, block: Block) -> Cases:
        """Return the analyses of a block."""
        numbers = self._numbers(block)
        record = numbers[RECORD]
        keys, model = self._distinct_models(numbers)
        models = [self._model(key) for key in keys]
        lanes = Lanes(record, self._scales(numbers, record), model, models)
        return Cases(lanes, numbers["procedure"])

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

    # ----- models -----

    @cached_property
    def _model_dimensions(self) -> list[str]:
        """Dimensions along which the model changes."""
        return list(dict.fromkeys(SAMPLE if name in self.samples else name for name in self._model_factors))

    @cached_property
    def _model_factors(self) -> list[str]:
        """Factors that change the model."""
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

    def _text(self, name: str, key: dict[str, int]) -> str:
        value = self._value(name, key)
        return value if isinstance(value, str) else f"{value:g}"

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
            range(size) if whole or not _is_number(name) else self._ends(name)
            for name, size in zip(names, sizes, strict=True)
        ]
        found: list[System] = []
        for places in itertools.islice(itertools.product(*along), _MOST_TRIED):
            key = dict(zip(names, places, strict=True))
            try:
                model = self._model(key)
                model.friction.at_pressure(model.bearing.pressure)
            except InputError as error:
                values = [f"{name} = {self._text(name, key)}" for name in self._model_factors]
                words = str(error)
                msg = f"{', '.join(values)}: {words[:1].lower()}{words[1:]}"
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


def _is_number(name: str) -> bool:
    return name == SAMPLE or factor(name).is_number
