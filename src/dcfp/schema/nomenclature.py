"""Names, symbols and units of every quantity, read from ``nomenclature.toml``.

Axis labels, table heads and the attributes of data sets all come from here.
"""

import tomllib
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any

from dcfp.arrays import FloatArray


@dataclass(frozen=True)
class Quantity:
    """One quantity.

    Attributes
    ----------
    name
        As in data sets.
    symbol
        In the mathematics of Matplotlib and LaTeX.
    unit
        Inside the package, as UDUNITS writes it.
    words
        In full.
    shown
        Unit in tables and on axes.
    factor
        Shown value over value [-].
    """

    name: str
    symbol: str
    unit: str
    words: str
    shown: str
    factor: float

    @property
    def label(self) -> str:
        """Label of an axis."""
        unit = "" if self.shown == "–" else f" [{self.shown}]"
        return f"${self.symbol}${unit}"

    @property
    def attributes(self) -> dict[str, str]:
        """Attributes of a variable in a data set."""
        return {"long_name": self.words, "units": self.unit, "symbol": self.symbol}

    def display(self, values: FloatArray) -> FloatArray:
        """Return values in the unit in which they are shown."""
        return values * self.factor


@cache
def nomenclature() -> dict[str, Quantity]:
    """Return every quantity by its name."""
    text = files("dcfp.schema").joinpath("nomenclature.toml").read_text(encoding="utf-8")
    return {name: _quantity(name, entry) for name, entry in tomllib.loads(text).items()}


def quantity(name: str) -> Quantity:
    """Return one quantity by its name."""
    return nomenclature()[name]


def _quantity(name: str, entry: dict[str, Any]) -> Quantity:
    return Quantity(
        name=name,
        symbol=entry["symbol"],
        unit=entry["unit"],
        words=entry["words"],
        shown=entry.get("shown", entry["unit"]),
        factor=float(entry.get("factor", 1.0)),
    )
