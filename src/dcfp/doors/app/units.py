"""Units in which results are shown; what is put in keeps the units beside its fields."""

import math
from dataclasses import dataclass, field
from typing import Any

from dcfp.schema.quantities import Quantity
from dcfp.schema.units import (
    CM,
    CM_PER_S,
    DEGC,
    DEGF,
    INCH,
    INCH_PER_S,
    KIP,
    KIP_FT,
    KN,
    KN_M,
    M_PER_S,
    METRE,
    MM,
    MM_PER_S,
    N_MM,
    N_PER_MM,
    NEWTON,
    Unit,
)  # fmt: skip

#: What a visitor can choose from, by the package's own unit, the first at first; each with the decimals that it has more than the first.
CHOICES: dict[Unit, tuple[str, dict[Unit, int]]] = {
    MM: ("lengths", {MM: 0, CM: 1, INCH: 1}),
    NEWTON: ("forces", {KN: 0, KIP: 1}),
    MM_PER_S: ("velocities", {M_PER_S: 0, CM_PER_S: -2, INCH_PER_S: -1}),
    DEGC: ("temperatures", {DEGC: 0, DEGF: 0}),
}


def _first() -> dict[Unit, Unit]:
    return {own: next(iter(few)) for own, (_, few) in CHOICES.items()}


@dataclass
class Units:
    """The units that a visitor has chosen.

    Attributes
    ----------
    chosen
        By the package's own unit.
    """

    chosen: dict[Unit, Unit] = field(default_factory=_first)

    def of(self, one: Quantity) -> Unit:
        """Return the unit in which a quantity is shown: what is chosen for its dimension, or follows from that, or its own."""
        own, force, length = one.unit.inner_unit, self.chosen[NEWTON], self.chosen[MM]
        if own is N_MM:
            return KIP_FT if force is KIP else KN_M
        if own is N_PER_MM:
            return Unit(f"{force.name}/{length.name}", force.size / length.size, "N mm-1", base=N_PER_MM)
        # what is so long that metres are declared for it stays in metres
        return one.shown if one.shown is METRE else self.chosen.get(own, one.shown)

    def name(self, one: Quantity) -> str:
        """Return the name of the unit in which a quantity is shown; empty for words."""
        return self.of(one).name

    def text(self, one: Quantity, result: Any) -> str:
        """Return a quantity of a result as it is shown, without its unit."""
        return self.written(one, one.of(result))

    def written(self, one: Quantity, value: Any) -> str:
        """Return a value of a quantity as it is shown, without its unit."""
        unit = self.of(one)
        _, few = CHOICES.get(one.unit.inner_unit, ("", dict[Unit, int]()))
        if one.decimals is None or not few or unit is one.shown:
            return one.written(value, unit, one.decimals)
        finer = round(math.log10(unit.size / one.shown.size))
        more = few[unit] - few[one.shown] if one.shown in few else finer
        return one.written(value, unit, max(0, one.decimals + more))
