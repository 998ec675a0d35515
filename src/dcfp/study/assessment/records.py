"""What part of the records does not exceed."""

from collections.abc import Sequence

import numpy as np
import xarray

from dcfp.errors import InputError
from dcfp.inference.intervals import quantile
from dcfp.study.assessment.described import coordinates_of


def quantiles_over_records(values: xarray.DataArray, parts: Sequence[float]) -> xarray.DataArray:
    """Return quantiles over the dimension ``record``, along a new first dimension ``quantile``.

    A quantile is the value that another record will be below with a probability of `parts` [-], see `dcfp.inference.intervals.quantile`. Records
    without a value do not count; of none the quantile is not a number.

    Raises
    ------
    InputError
        If a part is not above 0 and below 1.
    """
    for part in parts:
        if not 0.0 < part < 1.0:
            msg = f"A quantile must lie between 0 and 1, not {part:g}."
            raise InputError(msg)
    table = np.asarray(values.to_numpy(), dtype=np.float64)
    axis = values.get_axis_num("record")
    found = [np.apply_along_axis(_known_quantile, axis, table, part) for part in parts]
    dimensions = ["quantile", *(name for name in values.dims if name != "record")]
    coordinates = {name: one for name, one in coordinates_of(values).items() if "record" not in one.dims}
    return xarray.DataArray(
        np.stack(found), {"quantile": list(parts), **coordinates}, dimensions, attrs=values.attrs
    )


def few_records(parts: Sequence[float], records: int) -> list[str]:
    """Return a sentence for each quantile that lies beyond the outermost of so many records."""
    return [
        f"{records} records are too few for a quantile of {part:g}; it is that of the outermost record."
        for part in parts
        if not 1.0 <= part * (records + 1) <= records
    ]


def _known_quantile(values: np.ndarray, part: float) -> float:
    known = values[np.isfinite(values)]
    return quantile(known, part) if known.size else np.nan
