"""Quantities of results, each declared once: key, symbol, units, digits, words, and how to get it from a result; and the nomenclature, all of them by their names."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import Enum
from operator import attrgetter
from typing import Any, cast

import numpy as np

from dcfp.schema.registry import Registry
from dcfp.schema.units import (
    DEGC,
    KN,
    KN_M,
    M_PER_S,
    M_PER_S2,
    MM,
    MM_PER_S,
    MM_PER_S2,
    N_MM,
    NEWTON,
    NONE,
    SECOND,
    WORDS,
    Unit,
)  # fmt: skip

#: Printed where there is no value.
NOTHING = "–"


@dataclass(frozen=True)
class Quantity:
    r"""One quantity of a result.

    Attributes
    ----------
    key, name, head
        Name in JSON, with its unit at the end where it has one; in CSV and data sets, by default the key; and over its column on a console.
    words, symbol
        What it is, in full; in LaTeX.
    unit, shown
        Unit in JSON, CSV, data sets and workbooks, `WORDS` for what is no number; in tables, on axes and in reports, by default the same.
    decimals, digits
        Digits behind the point in tables, or significant ones where these are not given; None for the shortest form.
    places, precision
        Digits behind the point, or significant ones, that data keep; None for all.
    get
        Returns the value from a result, in the units of the package; or the name of the attribute that is it.
    printed, stored
        Whether it is in tables that are read by people, and in JSON, CSV, data sets and workbooks.
    signed
        Whether a plus sign stands before positive values.
    flat
        Whether it is one value; what is not stands in JSON alone.
    """

    key: str
    words: str
    unit: Unit = WORDS
    shown: Unit = WORDS
    decimals: int | None = None
    digits: int | None = None
    places: int | None = None
    precision: int | None = None
    symbol: str = ""
    name: str = ""
    head: str = ""
    get: Callable[[Any], Any] | str | None = None
    printed: bool = True
    stored: bool = True
    signed: bool = False
    flat: bool = True

    def __post_init__(self) -> None:
        if self.shown is WORDS:
            object.__setattr__(self, "shown", self.unit)
        if isinstance(self.get, str):
            object.__setattr__(self, "get", attrgetter(self.get))

    @property
    def is_number(self) -> bool:
        """Whether its values are numbers."""
        return self.unit is not WORDS

    @property
    def title(self) -> str:
        """Name in CSV and data sets."""
        return self.name or self.key

    @property
    def label(self) -> str:
        """Label of an axis."""
        unit = f" [{self.shown.name}]" if self.shown.has_dimension else ""
        return f"${self.symbol}${unit}"

    @property
    def attributes(self) -> dict[str, str]:
        """Attributes of a variable in a data set."""
        found = {"long_name": self.words}
        if self.is_number:
            found["units"] = self.unit.udunits
        return found | ({"symbol": self.symbol} if self.symbol else {})

    def display(self, values: Any) -> Any:
        """Return numbers or arrays in the package's units in the unit in which they are shown."""
        return self.shown.shown(values)

    def of(self, result: Any) -> Any:
        """Return the value of a result in the package's units; what is not a number is returned as it is."""
        value = self.get(result) if callable(self.get) else result[self.key]
        return value.value if isinstance(value, Enum) else value

    def datum(self, result: Any) -> Any:
        """Return the value as data hold it: a number in `unit`, or a list of them; None where there is none."""
        value = self.of(result)
        if isinstance(value, np.ndarray):
            value = value.tolist()
        if isinstance(value, (list, tuple)):
            return [self._datum(one) for one in cast("list[Any]", value)]
        return self._datum(value)

    def _datum(self, value: Any) -> Any:
        if not self.is_number or not isinstance(value, (int, float)) or isinstance(value, bool):
            return value
        number = self.unit.shown(value)
        if not math.isfinite(number):
            return None
        if self.precision is not None:
            return float(f"{number:.{self.precision}g}")
        return number if self.places is None else round(number, self.places)

    def text(self, result: Any, unit: Unit | None = None, decimals: int | None = None) -> str:
        """Return the value as people read it, in `unit` with `decimals` (by default the declared ones), without the unit."""
        return self.written(self.of(result), unit, decimals)

    def written(self, value: Any, unit: Unit | None = None, decimals: int | None = None) -> str:
        """Return a value in the package's units as people read it."""
        if value is None:
            return NOTHING
        if isinstance(value, (bool, np.bool_)):
            return "yes" if value else "no"
        if not self.is_number or isinstance(value, str):
            return str(value)
        number = (unit or self.shown).shown(value)
        if not math.isfinite(number):
            return NOTHING
        digits = self.decimals if decimals is None else decimals
        if digits is None:
            return f"{number:g}" if self.digits is None else f"{number:.{self.digits}g}"
        text = f"{number:{'+' if self.signed else ''}.{digits}f}"
        return text.removeprefix("-") if float(text) == 0.0 else text

    def heading(self, unit: Unit | None = None) -> str:
        """Return the head of its column on a console: a name, and the unit below it where it does not have two lines itself."""
        name = self.head or self.title
        if "\n" in name or not self.is_number:
            return name
        unit = unit or self.shown
        return f"{name}\n[{unit.name if unit.has_dimension else '-'}]"


# ----- the nomenclature: axis labels, heads of tables and the attributes of data sets come from here -----

#: Every quantity by its name in data sets; in the units of the package, and how it is shown.
NOMENCLATURE: Registry[Quantity] = Registry("quantity")


class Quantities(Registry[Quantity]):
    """What is told of one kind of result, by name, in the order of its columns; its numbers are in the nomenclature too."""

    def add(self, name: str, thing: Quantity) -> Quantity:
        """Add a quantity, of the result's attribute of that name unless it says how to get it."""
        if thing.is_number and name not in NOMENCLATURE.defined:
            NOMENCLATURE.add(name, replace(thing, key=name, name="", unit=thing.unit.inner_unit, get=None))
        return super().add(name, thing if thing.get else replace(thing, get=attrgetter(name)))

    def tell(self, name: str, key: str = "", /, **changes: Any) -> Quantity:
        """Add a quantity of the nomenclature, under a key of JSON and with other changes."""
        return self.add(name, replace(NOMENCLATURE.defined[name], key=key or name, **changes))

    def take(self, other: "Quantities", *names: str, **changes: Any) -> None:
        """Add quantities of another kind of result as they are there, but for some `changes`."""
        for name in names:
            self.add(name, replace(other.defined[name], **changes) if changes else other.defined[name])


def quantity(name: str) -> Quantity:
    """Return one quantity by its name."""
    return NOMENCLATURE[name]


for _one in (
    Quantity("time", "time", SECOND, symbol="t"),
    Quantity("displacement", "displacement of the isolation layer", MM, symbol="y"),
    Quantity("velocity", "relative velocity", MM_PER_S, M_PER_S, symbol="v"),
    Quantity("structure_velocity", "absolute velocity of the structure", MM_PER_S, M_PER_S, symbol="v_u"),
    Quantity("ground_velocity", "ground velocity", MM_PER_S, M_PER_S, symbol="v_g"),
    Quantity("ground_displacement", "ground displacement", MM, symbol="y_g"),
    Quantity("ground_acceleration", "ground acceleration", MM_PER_S2, M_PER_S2, symbol="a_g"),
    Quantity("structure_acceleration", "absolute acceleration of the structure", MM_PER_S2, M_PER_S2, symbol="a_u"),
    Quantity("force", "horizontal force", NEWTON, KN, symbol="F"),
    Quantity("friction", "coefficient of friction", NONE, symbol=r"\mu"),
    Quantity("temperature", "temperature of the contact", DEGC, symbol="T"),
    Quantity("plate_temperature", "temperature of the plate's surface", DEGC, symbol="T"),
    Quantity("plate_position", "position on the plate", MM, symbol="x"),
    Quantity("input_energy", "input energy", N_MM, KN_M, symbol="E"),
    Quantity("absolute_input_energy", "absolute input energy", N_MM, KN_M, symbol="E_{abs}"),
    Quantity("kinetic_energy", "kinetic energy", N_MM, KN_M, symbol="E_k"),
    Quantity("strain_energy", "elastic strain energy", N_MM, KN_M, symbol="E_s"),
    Quantity("hysteretic_energy", "hysteretic energy", N_MM, KN_M, symbol="E_h"),
    Quantity("energy_residual", "residual of the energy balance", N_MM, KN_M, symbol="E - E_s - E_k - E_h"),
    Quantity("sliding", "direction of sliding, 0 while sticking", NONE, symbol="s"),
    Quantity("load", "vertical force, compression positive", NEWTON, KN, symbol="N"),
    Quantity("work", "work of the machine on the bearing", N_MM, KN_M, symbol="W"),
    Quantity("displacement_change", "change of displacement between two successive peaks", MM, symbol=r"\Delta y"),
    Quantity("ground_velocity_change", "change of ground velocity from the peak before a pulse to its own", MM_PER_S, M_PER_S, symbol=r"\Delta v_g"),
    Quantity("ground_velocity_slope", "slope of the ground velocity before the peak of a pulse", MM_PER_S2, M_PER_S2, symbol="k_g"),
    Quantity("slope_ratio", "slope that friction gives the structure over that of the ground", NONE, symbol="k_u / k_g"),
    Quantity("swing_input_velocity", "equivalent velocity of the energy put in during a swing", MM_PER_S, M_PER_S, symbol=r"V_{\Delta E}"),
    Quantity("swing_hysteretic_velocity", "equivalent velocity of the energy dissipated during a swing", MM_PER_S, M_PER_S, symbol=r"V_{\Delta E_{hr}}"),
    Quantity("peak_ground_velocity", "peak ground velocity", MM_PER_S, M_PER_S, symbol=r"\mathrm{PGV}"),
    Quantity("peak_displacement", "largest displacement of the isolation layer", MM, symbol=r"y_{\mathrm{max}}"),
    Quantity("peak_change", "largest change of displacement between two successive peaks", MM, symbol=r"\Delta y_{\mathrm{max}}"),
    Quantity("peak_velocity", "largest relative velocity", MM_PER_S, M_PER_S, symbol=r"v_{\mathrm{max}}"),
    Quantity("peak_force", "largest horizontal force", NEWTON, KN, symbol=r"F_{\mathrm{max}}"),
    Quantity("force_ratio", "largest horizontal force over the weight", NONE, symbol=r"F_{\mathrm{max}} / W"),
    Quantity("peak_temperature", "highest temperature of the contact", DEGC, symbol=r"T_{\mathrm{max}}"),
    Quantity("least_friction", "smallest coefficient of friction while sliding", NONE, symbol=r"\mu_{\mathrm{min}}"),
    Quantity("residual_displacement", "residual displacement", MM, symbol="y_r"),
    Quantity("input_velocity", "equivalent velocity of the input energy", MM_PER_S, M_PER_S, symbol="V_E"),
    Quantity("hysteretic_velocity", "equivalent velocity of the hysteretic energy", MM_PER_S, M_PER_S, symbol="V_{E_h}"),
    Quantity("relative_energy_residual", "residual of the energy balance over the largest input energy", NONE),
    Quantity("elapsed", "computing time of the analysis", SECOND, name="elapsed", printed=False),
):  # fmt: skip
    NOMENCLATURE.add(_one.key, _one)
