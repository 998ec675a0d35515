"""Tables as text, with units in their heads."""

import csv
import io
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import xarray

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence


@dataclass(frozen=True)
class Column:
    """One column of a table: its key in a row, and its name, unit (UDUNITS; empty for text) and words."""

    key: str
    name: str
    unit: str = ""
    words: str = ""


def table_text(columns: "Sequence[Column]", rows: "Sequence[Mapping[str, object]]") -> str:
    """Return rows as CSV, with units in the head; what is None leaves its cell empty."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([head_of(column.name, column.unit) if column.unit else column.name for column in columns])
    writer.writerows([[_cell(row[column.key]) for column in columns] for row in rows])
    return stream.getvalue()


def head_of(name: str, unit: str) -> str:
    """Return the head of a column."""
    return f"{name} [{'-' if unit == '1' else unit}]"


def _cell(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "true" if value else "false"
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def compressed(data: xarray.Dataset) -> xarray.Dataset:
    """Return a data set whose variables will be written compressed."""
    for variable in data.variables.values():
        variable.encoding.update(zlib=True, complevel=1, shuffle=True)
    return data


def histories_csv(data: xarray.Dataset) -> str:
    """Return the variables of a data set over ``time`` as CSV, with units in the head."""
    names = ["time", *(str(name) for name in data.data_vars)]
    columns = [Column(name, name, str(data[name].attrs["units"])) for name in names]
    table = np.column_stack([data[name].to_numpy() for name in names])
    return table_text(columns, [dict(zip(names, row, strict=True)) for row in table.tolist()])
