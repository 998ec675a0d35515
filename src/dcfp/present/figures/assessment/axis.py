"""Labels and values of factors and results on axes."""

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import xarray

    from dcfp.arrays import FloatArray


def axis_label(variable: "xarray.DataArray") -> str:
    """Return the label of an axis: words, symbol and unit."""
    from dcfp.study.assessment.selection import described  # late: the package imports the kernels

    entry = described(variable)
    symbol = "" if entry.symbol.startswith(r"\mathrm") else f", ${entry.symbol}$"
    unit = f" [{entry.shown.name}]" if entry.shown.has_dimension else ""
    return f"{entry.words}{symbol}{unit}"


def shown(variable: "xarray.DataArray", values: "xarray.DataArray | None" = None) -> "FloatArray":
    """Return the values of a variable, or others of its unit, as they are shown."""
    from dcfp.study.assessment.selection import described

    numbers = (variable if values is None else values).to_numpy()
    return described(variable).display(np.asarray(numbers, dtype=np.float64))
