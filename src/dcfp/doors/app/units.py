"""Units in which results are shown; what is put in keeps the units beside its fields."""

import math
from dataclasses import dataclass, field
from typing import Any

from dcfp.schema import units as known
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import Unit

#: What a visitor can choose from, by the package's own unit, the first at first; each with the decimals that it has more than the first.
CHOICES: dict[Unit, tuple[str, dict[Unit, int]]] = {
    known.MM: ("lengths", {known.MM: 0, known.CM: 1, known.INCH: 1}),
    known.NEWTON: ("forces", {known.KN: 0, known.KIP: 1}),
    known.MM_PER_S: ("velocities", {known.M_PER_S: 0, known.CM_PER_S: -2, known.INCH_PER_S: -1}),
    known.DEGC: ("temperatures", {known.DEGC: 0, known.DEGF: 0}),
}


@dataclass
class Units:
    """The units that a visitor has chosen, by the package's own unit."""

    chosen: dict[Unit, Unit] = field(
        default_factory=lambda: {own: next(iter(few)) for own, (_, few) in CHOICES.items()}
    )

    def of(self, one: Quantity) -> Unit:
        """Return the unit in which a quantity is shown: what is chosen for its dimension, or follows from that, or its own."""
        own, force, length = one.unit.inner_unit, self.chosen[known.NEWTON], self.chosen[known.MM]
        if own is known.N_MM:
            return known.KIP_FT if force is known.KIP else known.KN_M
        if own is known.N_PER_MM:
            return Unit(
                f"{force.name}/{length.name}", force.size / length.size, "N mm-1", base=known.N_PER_MM
            )
        # what is so long that metres are declared for it stays in metres
        return one.shown if one.shown is known.METRE else self.chosen.get(own, one.shown)

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
