"""A table: results in rows, quantities in columns; as JSON objects, CSV and a data set, and as text for whoever draws it."""

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from dcfp.schema.quantities import Quantity
from dcfp.schema.units import Unit

if TYPE_CHECKING:
    import xarray


@dataclass(frozen=True)
class Table:
    """Results, one for each row, with the quantities that are to be shown of them."""

    columns: tuple[Quantity, ...]
    results: Sequence[Any]
    title: str = ""

    @property
    def printed(self) -> tuple[Quantity, ...]:
        """Columns that people read."""
        return tuple(one for one in self.columns if one.printed)

    @property
    def stored(self) -> tuple[Quantity, ...]:
        """Columns that data hold."""
        return tuple(one for one in self.columns if one.stored)

    @property
    def flat(self) -> tuple[Quantity, ...]:
        """Columns that lines of text and data sets hold."""
        return tuple(one for one in self.stored if one.flat)

    def objects(self) -> list[dict[str, Any]]:
        """Return the rows as JSON holds them, by keys that end with their units."""
        return [{one.key: one.datum(result) for one in self.stored} for result in self.results]

    def heads(self, units: Mapping[str, Unit] | None = None) -> list[str]:
        """Return the heads of the columns that people read; `units` by keys go before the declared ones."""
        units = units or {}
        return [one.heading(units.get(one.key)) for one in self.printed]

    def cells(self, units: Mapping[str, Unit] | None = None) -> list[list[str]]:
        """Return the rows as text that people read; `units` by keys go before the declared ones."""
        units = units or {}
        return [[one.text(result, units.get(one.key)) for one in self.printed] for result in self.results]

    def csv(self) -> str:
        """Return the rows as CSV, with units in the head; what there is not leaves its cell empty."""
        return csv_text(
            [csv_head(one) for one in self.flat],
            ([one.datum(result) for one in self.flat] for result in self.results),
        )

    def dataset(
        self,
        dimension: str,
        names: Sequence[object] | None = None,
        attributes: Mapping[str, Any] | None = None,
    ) -> "xarray.Dataset":
        """Return the rows as variables over one dimension, with units; `names` are the coordinate along it."""
        xarray: Any = import_module("xarray")  # late: it takes a third of a second to import
        variables = {one.title: (dimension, self._column(one), one.attributes) for one in self.flat}
        coordinates = {} if names is None else {dimension: (dimension, np.array(names, dtype=object))}
        return xarray.Dataset(variables, coords=coordinates, attrs=dict(attributes or {}))

    def _column(self, one: Quantity) -> Any:
        values = [one.datum(result) for result in self.results]
        if one.is_number:
            return np.array([np.nan if value is None else float(value) for value in values])
        return np.array([_cell(value) for value in values], dtype=object)


def csv_head(one: Quantity) -> str:
    """Return the head of a column of CSV: the name, and the unit as UDUNITS writes it."""
    return csv_head_of(one.title, one.unit.udunits) if one.is_number else one.title


def csv_head_of(name: str, unit: str) -> str:
    """Return the head of a column of CSV of numbers; the unit is as UDUNITS writes it."""
    return f"{name} [{'-' if unit == '1' else unit}]"


def csv_text(heads: Sequence[str], rows: Iterable[Iterable[object]]) -> str:
    """Return heads and rows as CSV; what is None leaves its cell empty."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows([[_cell(value) for value in row] for row in rows])
    return stream.getvalue()


def _cell(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list):
        words = cast("list[str]", value)
        return (" " if all(one.endswith(".") for one in words) else "; ").join(words)
    return f"{value:.9g}" if isinstance(value, float) else str(value)
