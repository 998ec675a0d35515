"""Whether the analyses of a study are there, what is missing being refused or counted; and what part of the records does not exceed."""

from collections.abc import Sequence

import numpy as np
import xarray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.inference.statistics import quantile
from dcfp.schema.citations import citations_of
from dcfp.study.assessment.selection import coordinates_of

#: Results whose sign says a direction, so that only their size is assessed.
_SIGNED = frozenset({"residual_displacement"})


def usable(
    dataset: xarray.Dataset, names: Sequence[str], *, unfinished: bool | None = False
) -> xarray.Dataset:
    """Return some results of a study as numbers in memory, with remarks on what is missing in its attributes.

    Of a residual displacement the size is kept, not the direction.

    Parameters
    ----------
    dataset
        What is assessed of a study; what was not selected may be missing.
    names
        The results.
    unfinished
        Whether analyses that have not been run are left out and counted rather than refused; None where that cannot be.

    Raises
    ------
    InputError
        If there is no such result, no analysis at all, or the study is not finished.
    """
    for name in names:
        if name not in dataset.data_vars or name == "status":
            known = ", ".join(str(one) for one in dataset.data_vars if one != "status")
            msg = f"{name!r} is no result of this study; its results are {known}."
            raise InputError(msg)
    found = dataset[[*names, "status"]].load()
    counts = _counts(found["status"])
    whole = found["status"].size
    missing, failed = counts["not_run"], counts["failed"]
    if missing and not unfinished:
        instead = "" if unfinished is None else ", or leave them out (unfinished)"
        msg = f"{missing} of the {whole} analyses have not been run; finish the study first{instead}."
        raise InputError(msg)
    if missing + failed == whole:
        msg = f"None of the {whole} analyses has a result."
        raise InputError(msg)
    remarks = remarks_of(dataset)
    if missing:
        remarks.append(f"{missing} of the {whole} analyses have not been run, and are left out.")
    if failed:
        remarks.append(f"{failed} of the {whole} analyses failed, and are left out.")
    if counts["still_moving"] and _SIGNED.intersection(names):
        remarks.append(
            f"In {counts['still_moving']} of the {whole} analyses it still moves at the end, so that the residual displacement is not final."
        )
    for name in _SIGNED.intersection(names):
        remarks.append(f"Of the {name.replace('_', ' ')} the size is taken, not the direction.")
        found[name] = (found[name].dims, np.abs(values_of(found, name)), found[name].attrs)
    return with_remarks(found, remarks)


def is_beyond_capacity(dataset: xarray.Dataset) -> xarray.DataArray:
    """Return in which analyses the displacement is beyond the capacity of the bearing."""
    return dataset["status"] == _flags(dataset["status"])["beyond_capacity"]


def remarks_of(dataset: xarray.Dataset) -> list[str]:
    """Return the remarks in the attributes of a data set."""
    return [line for line in str(dataset.attrs.get("remarks", "")).splitlines() if line.strip()]


def with_remarks(dataset: xarray.Dataset, remarks: Sequence[str]) -> xarray.Dataset:
    """Return a data set with these remarks in its attributes, one on each line."""
    return dataset.assign_attrs(remarks="\n".join(dict.fromkeys(remarks)))


def with_references(dataset: xarray.Dataset, *keys: str) -> xarray.Dataset:
    """Return a data set with these references added to those in its attributes, one on each line."""
    known = str(dataset.attrs.get("references", "")).splitlines()
    return dataset.assign_attrs(references="\n".join(dict.fromkeys([*known, *citations_of(*keys)])))


def values_of(dataset: xarray.Dataset, name: str) -> FloatArray:
    """Return a variable as numbers."""
    return np.asarray(dataset[name].to_numpy(), dtype=np.float64)


def _flags(status: xarray.DataArray) -> dict[str, int]:
    """Return the codes of a status by their meanings, as the CF conventions write them."""
    codes = np.atleast_1d(status.attrs["flag_values"]).tolist()
    return dict(zip(str(status.attrs["flag_meanings"]).split(), codes, strict=True))


def _counts(status: xarray.DataArray) -> dict[str, int]:
    values = status.to_numpy()
    return {meaning: int((values == code).sum()) for meaning, code in _flags(status).items()}


# What part of the records does not exceed.


def quantiles_over_records(values: xarray.DataArray, parts: Sequence[float]) -> xarray.DataArray:
    """Return quantiles over the dimension ``record``, along a new first dimension ``quantile``.

    A quantile is the value that another record will be below with a probability of `parts` [-], see `dcfp.inference.statistics.quantile`. Records
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
