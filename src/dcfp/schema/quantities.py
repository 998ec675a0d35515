"""Quantities of results, each declared once: key, symbol, units, digits, words, and how to get it from a result."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from operator import attrgetter
from typing import Any, cast

import numpy as np

from dcfp.schema.units import WORDS, Unit

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
