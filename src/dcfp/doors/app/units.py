"""Units in which results are shown; what is put in keeps the units beside its fields."""

from dataclasses import dataclass
from typing import Any

from dcfp.arrays import FloatArray
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import DEGC, MM, MM_PER_S, N_MM, NEWTON


@dataclass(frozen=True)
class Unit:
    """A unit to show a quantity in: shown value = value * factor + offset.

    Attributes
    ----------
    name
        As shown.
    factor, offset
        On a value in the units of the package.
    decimals
        Of a number in a table.
    """

    name: str
    factor: float
    decimals: int
    offset: float = 0.0

    def of(self, values: FloatArray) -> FloatArray:
        """Return values in this unit."""
        return values * self.factor + self.offset

    def text(self, value: float) -> str:
        """Return a value in this unit as text, without the unit."""
        shown = f"{value * self.factor + self.offset:.{self.decimals}f}"
        return shown.removeprefix("-") if float(shown) == 0.0 else shown


_INCH, _KIP = 25.4, 4448.2216152605

LENGTHS = {one.name: one for one in (Unit("mm", 1.0, 1), Unit("cm", 0.1, 2), Unit("in", 1.0 / _INCH, 2))}
FORCES = {one.name: one for one in (Unit("kN", 1e-3, 0), Unit("kip", 1.0 / _KIP, 1))}
VELOCITIES = {
    one.name: one for one in (Unit("m/s", 1e-3, 3), Unit("cm/s", 0.1, 1), Unit("in/s", 1.0 / _INCH, 2))
}
TEMPERATURES = {one.name: one for one in (Unit("°C", 1.0, 0), Unit("°F", 1.8, 0, 32.0))}
#: Energy that goes with a force.
_ENERGIES = {"kN": Unit("kN m", 1e-6, 0), "kip": Unit("kip ft", 1.0 / (_KIP * 12.0 * _INCH), 0)}


@dataclass
class Units:
    """The units that a visitor has chosen, by name."""

    length_name: str = "mm"
    force_name: str = "kN"
    velocity_name: str = "m/s"
    temperature_name: str = "°C"

    @property
    def length(self) -> Unit:
        """Of displacements."""
        return LENGTHS[self.length_name]

    @property
    def force(self) -> Unit:
        """Of forces."""
        return FORCES[self.force_name]

    @property
    def velocity(self) -> Unit:
        """Of velocities."""
        return VELOCITIES[self.velocity_name]

    @property
    def temperature(self) -> Unit:
        """Of temperatures."""
        return TEMPERATURES[self.temperature_name]

    @property
    def energy(self) -> Unit:
        """Of energies."""
        return _ENERGIES[self.force_name]

    def of(self, one: Quantity) -> Unit | None:
        """Return the unit that is chosen for a quantity; None where there is no choice."""
        chosen = {
            MM: self.length,
            NEWTON: self.force,
            MM_PER_S: self.velocity,
            DEGC: self.temperature,
            N_MM: self.energy,
        }
        return chosen.get(one.unit.inner_unit)

    def name(self, one: Quantity) -> str:
        """Return the name of the unit in which a quantity is shown; empty for words."""
        return (self.of(one) or one.shown).name

    def text(self, one: Quantity, result: Any) -> str:
        """Return a quantity of a result as it is shown, without its unit."""
        unit, value = self.of(one), one.of(result)
        return one.written(value) if unit is None or value is None else unit.text(value)
