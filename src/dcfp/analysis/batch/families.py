"""Models of a batch that one call of the kernel can take, as its tables."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.kernels import batch as k
from dcfp.kernels.friction import CyclingLaw, ExponentialLaw, Law
from dcfp.kernels.heat_state import BANK_ROWS, Heat
from dcfp.kernels.memory import MODES
from dcfp.system import Heating, Model
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

_Kind: TypeAlias = tuple[Any, int, int, int]


@dataclass(frozen=True, eq=False)
class Family:
    """Models of one kind of law, of heating and of plates.

    Attributes
    ----------
    law, heating
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

    law: Law
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


def families_of(models: Sequence[Model]) -> list[Family]:
    """Sort models into families, in the order in which they come first."""
    laws = [model.friction.at_pressure(model.bearing.pressure) for model in models]
    kinds: dict[_Kind, list[int]] = {}
    for number, (model, law) in enumerate(zip(models, laws, strict=True)):
        kinds.setdefault(_kind(model, law), []).append(number)
    return [_family(kind, numbers, models, laws) for kind, numbers in kinds.items()]


def _kind(model: Model, law: Law) -> _Kind:
    own: Any = type(law) if isinstance(law, (ExponentialLaw, CyclingLaw)) else law
    plates = len(set(model.bearing.radii))
    return own, model.heating.kind, plates, cells_across(model.heating)


def _family(kind: _Kind, numbers: list[int], models: Sequence[Model], laws: Sequence[Law]) -> Family:
    members = [models[number] for number in numbers]
    banks: dict[bytes, int] = {}
    stored: list[FloatArray] = []
    table = np.zeros((len(members), k.MODEL_SIZE))
    for row, number in zip(table, numbers, strict=True):
        bank, instant = _bank(models[number].heating)
        place = banks.setdefault(bank.tobytes(), len(stored))
        if place == len(stored):
            stored.append(bank)
        _write(row, models[number], laws[number])
        row[k.INSTANT], row[k.BANK] = instant, place
    return Family(
        law=laws[numbers[0]],
        heating=members[0].heating,
        plates=kind[2],
        members=numbers,
        table=table,
        banks=np.array(stored),
        margin=max(margin_for(one.bearing, one.heating, FIRST_REACH) for one in members),
    )


def _bank(heating: Heating) -> tuple[FloatArray, float]:
    rates, weights, instant = modes_of(heating)
    return np.array([rates, weights * heating.rise_factor]), instant * heating.rise_factor


def _write(row: FloatArray, model: Model, law: Law) -> None:
    """Write a model into its row, but for the modes."""
    if isinstance(law, (ExponentialLaw, CyclingLaw)):
        row[: len(law)] = law
    structure = structure_of(model.bearing, model.friction)
    row[k.RESTORING], row[k.ELASTIC] = structure.restoring, structure.elastic
    row[k.GRAVITY], row[k.PRESSURE], row[k.REACH] = structure.gravity, structure.pressure, structure.reach
    row[k.FIRST_SHARE], row[k.SECOND_SHARE] = structure.first_share, structure.second_share
    row[k.FIRST_SPEED], row[k.SECOND_SPEED] = structure.first_speed, structure.second_speed
    row[k.AMBIENT] = model.heating.ambient
    row[k.HALF_CONTACT] = model.bearing.contact_half_side
    row[k.CELL] = cell_width(model.bearing, model.heating)
