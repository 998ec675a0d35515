"""What a batch is made of: lanes, each a record at a scale on a model; the records and the models as the kernel steps through them."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from dcfp.analysis.integration import DEFAULT, Integration
from dcfp.analysis.response_history import halvings
from dcfp.arrays import FloatArray, IntArray
from dcfp.kernels import batch as k
from dcfp.kernels.batch import Ground
from dcfp.kernels.heat_state import BANK_ROWS, Heat
from dcfp.kernels.law import Law
from dcfp.kernels.memory import MODES
from dcfp.motion.ground_motion import LONGEST_TAIL, GroundMotion, parts_in, refined
from dcfp.system import Heating, System
from dcfp.system.plates import (
    FIRST_REACH,
    cell_width,
    cells_across,
    cold_notes,
    margin_for,
    modes_of,
    no_heat,
    structure_of,
)


@dataclass(frozen=True, eq=False)
class Lanes:
    """Analyses to be made, each one lane.

    Attributes
    ----------
    record
        Number of the record in the `GroundSet`, shape (lanes,).
    scale
        Factor on its acceleration [-], shape (lanes,).
    model
        Number of the model in `models`, shape (lanes,).
    models
        Bearings with their friction laws and heating models.
    """

    record: IntArray
    scale: FloatArray
    model: IntArray
    models: Sequence[System]

    def __len__(self) -> int:
        return self.record.size

    @classmethod
    def grid(cls, records: int, scales: FloatArray, models: Sequence[System]) -> "Lanes":
        """Return every record at its scales on every model, the model varying fastest.

        Parameters
        ----------
        records
            Number of records.
        scales
            Of each record, shape (records, scales) [-].
        models
            As in `Lanes`.
        """
        shape = (records, scales.shape[1], len(models))
        record, _, model = (axis.ravel() for axis in np.indices(shape, dtype=np.intp))
        return cls(record, np.repeat(scales.ravel(), len(models)), model, models)


# The records of a batch as its kernel steps through them.


@dataclass(frozen=True, eq=False)
class GroundSet:
    """Records side by side, unscaled.

    Attributes
    ----------
    ground
        As the kernel takes them.
    longest
        Samples of the longest with the rest after it.
    integration
        How finely and how far each is analysed.
    """

    ground: Ground
    longest: int
    integration: Integration

    @classmethod
    def of(cls, motions: Sequence[GroundMotion], integration: Integration = DEFAULT) -> "GroundSet":
        """Put records side by side, to be analysed as finely and as far as `integration` says."""
        values = [_stepped(motion, integration.tail, integration.step) for motion in motions]
        sizes = np.array([one.acceleration.size for one in values], dtype=np.intp)
        rests = np.array([one.rest for one in values], dtype=np.intp)
        ground = Ground(
            acceleration=np.concatenate([one.acceleration for one in values]),
            first=np.concatenate(([0], np.cumsum(sizes)[:-1])).astype(np.intp),
            samples=sizes,
            rest=rests,
            free_from=np.array([one.free_from for one in values], dtype=np.intp),
            interval=np.array([one.interval for one in values]),
            coarsest=np.array([halvings(one.interval) for one in values], dtype=np.intp),
        )
        return cls(ground, int((sizes + rests).max()), integration)

    @property
    def steps(self) -> "np.ndarray[tuple[int], np.dtype[np.intp]]":
        """Samples of each record, a measure of what an analysis under it costs."""
        return self.ground.samples


@dataclass(frozen=True, eq=False)
class _Stepped:
    """One record with the steps that an analysis takes."""

    acceleration: "np.ndarray[tuple[int], np.dtype[np.float64]]"
    rest: int
    free_from: int
    interval: float


def _stepped(motion: GroundMotion, tail: float | None, step: float | None) -> _Stepped:
    """Return what `dcfp.respond` makes of a record, but the zeros after it as their number alone."""
    parts = 1 if step is None else parts_in(motion.time_step, step)
    after = round((LONGEST_TAIL if tail is None else tail) / motion.time_step)
    total = (motion.acceleration.size + after - 1) * parts + 1
    ends_at_rest = np.append(motion.acceleration, 0.0) if after else motion.acceleration
    acceleration = refined(ends_at_rest, parts)
    return _Stepped(
        acceleration=acceleration,
        rest=total - acceleration.size,
        free_from=motion.acceleration.size * parts if tail is None else total,
        interval=motion.time_step / parts,
    )


# Models of a batch that one call of the kernel can take, as its tables.


_Kind: TypeAlias = tuple[int, int, int]


@dataclass(frozen=True, eq=False)
class Family:
    """Models of one kind of heating and of plates.

    Attributes
    ----------
    heating
        Of one of them.
    plates
        That differ.
    members
        Numbers of the models, in the order of the rows of the table.
    table
        As `dcfp.kernels.batch` names its columns.
    banks
        Rates and weights of the modes, shape (banks, 2, modes).
    margin
        Cells on each side of the contact that all of them need at first.
    """

    heating: Heating
    plates: int
    members: list[int]
    table: FloatArray
    banks: FloatArray
    margin: int

    def heat(self, margin: int) -> Heat:
        """Return arrays to work in, with so many cells on each side; the numbers are those of the table."""
        return Heat(
            kind=self.heating.kind,
            ambient=0.0,
            half_contact=0.0,
            cell=0.0,
            instant=0.0,
            bank=np.zeros((BANK_ROWS, MODES)),
            notes=cold_notes(0.0),
            cells=no_heat(self.plates, self.heating, margin),
        )


def families_of(models: Sequence[System]) -> list[Family]:
    """Sort models into families, in the order in which they come first."""
    kinds: dict[_Kind, list[int]] = {}
    for number, model in enumerate(models):
        kinds.setdefault(_kind(model), []).append(number)
    return [_family(kind, numbers, models) for kind, numbers in kinds.items()]


def _kind(model: System) -> _Kind:
    return model.heating.kind, len(set(model.bearing.radii)), cells_across(model.heating)


def _family(kind: _Kind, numbers: list[int], models: Sequence[System]) -> Family:
    members = [models[number] for number in numbers]
    banks: dict[bytes, int] = {}
    stored: list[FloatArray] = []
    table = np.zeros((len(members), k.MODEL_SIZE))
    for row, number in zip(table, numbers, strict=True):
        bank, instant = _bank(models[number].heating)
        place = banks.setdefault(bank.tobytes(), len(stored))
        if place == len(stored):
            stored.append(bank)
        _write(row, models[number])
        row[k.INSTANT], row[k.BANK] = instant, place
    return Family(
        heating=members[0].heating,
        plates=kind[1],
        members=numbers,
        table=table,
        banks=np.array(stored),
        margin=max(margin_for(one, FIRST_REACH) for one in members),
    )


def _bank(heating: Heating) -> tuple[FloatArray, float]:
    rates, weights, instant = modes_of(heating)
    return np.array([rates, weights * heating.rise_factor]), instant * heating.rise_factor


def _write(row: FloatArray, model: System) -> None:
    """Write a model into its row, but for the modes."""
    row[: len(Law._fields)] = model.friction.at_pressure(model.bearing.pressure)
    structure = structure_of(model)
    row[k.RESTORING], row[k.ELASTIC] = structure.restoring, structure.elastic
    row[k.GRAVITY], row[k.PRESSURE], row[k.REACH] = structure.gravity, structure.pressure, structure.reach
    row[k.FIRST_SHARE], row[k.SECOND_SHARE] = structure.first_share, structure.second_share
    row[k.FIRST_SPEED], row[k.SECOND_SPEED] = structure.first_speed, structure.second_speed
    row[k.AMBIENT] = model.heating.ambient
    row[k.HALF_CONTACT] = model.bearing.contact_half_side
    row[k.CELL] = cell_width(model)
