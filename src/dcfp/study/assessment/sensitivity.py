"""Sobol indices: which sampled factor the variance of a result comes from.

First order: the part of the variance that goes if the factor is known; total: the part that stays if all others are. Estimated by SALib from samples in the
scheme of Saltelli et al. (2010).
"""

import json
from importlib import import_module
from itertools import product
from typing import Any

import numpy as np
import xarray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.study.assessment.completeness import (
    few_records,
    quantiles_over_records,
    remarks_of,
    usable,
    with_references,
    with_remarks,
)
from dcfp.study.assessment.selection import coordinates_of, select

#: How the records are taken together, if not by a quantile.
GEOMETRIC_MEAN = "geometric-mean"
#: Draws for the confidence, and where their random numbers start; SALib takes no seed of 0.
DRAWS, SEED = 200, 2010
#: Results without a zero from which ratios could be taken, or that may be zero.
_NO_RATIOS = frozenset({"peak_temperature", "residual_displacement"})
_MEDIAN = 0.5
_INDICES = (
    ("S1", "first-order Sobol index"),
    ("ST", "total Sobol index"),
)


def sensitivity(
    dataset: xarray.Dataset,
    quantity: str = "peak_displacement",
    over_records: str | float | None = None,
    *,
    logarithm: bool = False,
    confidence: float = 0.95,
    draws: int = DRAWS,
    seed: int = SEED,
) -> xarray.Dataset:
    """Return Sobol indices of a result for each intensity, and for each value of whatever else is in the grid of a study.

    Parameters
    ----------
    dataset
        A study whose samples are in the scheme of Saltelli, without those for the second order.
    quantity
        The result.
    over_records
        How the records are taken together: ``"geometric-mean"``, or a quantile [-]; by default the geometric mean, and the median where a result may be
        zero or has no natural zero. What is sampled together with the record stays as it is.
    logarithm
        Whether the variance is that of the logarithm.
    confidence
        Of the intervals [-].
    draws, seed
        Samples are drawn with replacement for the intervals.

    Returns
    -------
    xarray.Dataset
        ``S1``, ``ST`` [-] over ``factor`` and what is left of the grid, and ``S1_confidence``, ``ST_confidence``, half of the widths of their intervals. Not a
        number where the result does not vary.

    Raises
    ------
    InputError
        If the study has no such samples, an analysis is missing or SALib is not installed.
    """
    factors = _factors(dataset)
    chosen = select(dataset, {}, keep=("sample",))
    found = usable(chosen, [quantity], unfinished=None)
    _check_samples(found.sizes["sample"], factors)
    values, remarks = _over_records(found, quantity, over_records)
    table = values.transpose("sample", ...).to_numpy()
    if not np.isfinite(table).all():
        msg = f"{int((~np.isfinite(table)).any(axis=0).sum())} sets of samples have an analysis that failed, and Sobol indices need all of them."
        raise InputError(msg)
    if logarithm:
        _check_positive(table, quantity, "no logarithm")
        table = np.log(table)
    result = _dataset(values, factors, _analyses(table, factors, confidence, draws, seed))
    remarks = [*remarks_of(found), *remarks, *_precision(result, found.sizes["sample"], factors, confidence)]
    result = result.assign_attrs(
        {
            **found.attrs,
            "quantity": quantity,
            "over_records": _words(found, quantity, over_records),
            "logarithm": int(logarithm),
            "confidence": confidence,
            "draws": draws,
            "seed": seed,
        }
    )
    return with_remarks(with_references(result, "sobol_2001", "saltelli_2010"), remarks)


def _factors(dataset: xarray.Dataset) -> list[str]:
    method = str(dataset.attrs.get("sampling_method", "grid"))
    if method != "saltelli" or "sample" not in dataset.dims:
        msg = f"Sobol indices need samples of the method 'saltelli', and this study has {method!r}; say method = \"saltelli\" under [sampling]."
        raise InputError(msg)
    return [str(one["name"]) for one in json.loads(str(dataset.attrs["sampling_factors"]))]


def _check_samples(samples: int, factors: list[str]) -> None:
    if samples % (len(factors) + 2):
        msg = f"{samples} samples are not a multiple of {len(factors) + 2}, as the scheme of Saltelli has them for {len(factors)} factors."
        raise InputError(msg)


def _reduction(quantity: str, over_records: str | float | None) -> str | float:
    if over_records is None:
        return _MEDIAN if quantity in _NO_RATIOS else GEOMETRIC_MEAN
    if isinstance(over_records, str) and over_records != GEOMETRIC_MEAN:
        msg = f"Records are taken together by {GEOMETRIC_MEAN!r} or a quantile between 0 and 1, not by {over_records!r}."
        raise InputError(msg)
    return over_records


def _words(found: xarray.Dataset, quantity: str, over_records: str | float | None) -> str:
    if "record" not in found.dims:
        return "none"
    way = _reduction(quantity, over_records)
    number = found.sizes["record"]
    return f"{way} of {number} records" if isinstance(way, str) else f"quantile {way:g} of {number} records"


def _over_records(
    found: xarray.Dataset, quantity: str, over_records: str | float | None
) -> tuple[xarray.DataArray, list[str]]:
    """Return a result without the records, and what is to be said of it; a record that failed in one sample is left out of all."""
    values = found[quantity]
    way = _reduction(quantity, over_records)
    if "record" not in values.dims:
        return values, []
    values = values.where(values.notnull().all("sample"))
    if not isinstance(way, str):
        reduced = quantiles_over_records(values, [way]).isel(quantile=0, drop=True)
        return reduced, few_records([way], values.sizes["record"])
    _check_positive(values.to_numpy(), quantity, "no geometric mean; take a quantile over the records")
    logarithms = values.copy(data=np.log(values.to_numpy()))
    mean = logarithms.mean("record")
    return mean.copy(data=np.exp(mean.to_numpy())), []


def _check_positive(values: np.ndarray, quantity: str, so: str) -> None:
    wrong = int((values <= 0.0).sum())
    if wrong:
        msg = f"{wrong} values of {quantity} are not above zero, so that there is {so}."
        raise InputError(msg)


def _analyses(
    table: FloatArray, factors: list[str], confidence: float, draws: int, seed: int
) -> dict[str, FloatArray]:
    """Return the indices of every column of a table over the samples, shape (factors, ...)."""
    if not 0.0 < confidence < 1.0:
        msg = f"The confidence must lie between 0 and 1, not {confidence:g}."
        raise InputError(msg)
    if seed < 1 or draws < 2:
        msg = f"The seed must be a positive whole number and the draws at least 2, not {seed} and {draws}."
        raise InputError(msg)
    analyse = _salib().analyze
    problem = {"num_vars": len(factors), "names": factors, "bounds": [[0.0, 1.0]] * len(factors)}
    rest = table.shape[1:]
    keys = ("S1", "S1_conf", "ST", "ST_conf")
    indices = {key: np.full((len(factors), *rest), np.nan) for key in keys}
    for place in product(*map(range, rest)):
        column = np.ascontiguousarray(table[(slice(None), *place)])
        if np.ptp(column) <= 1e-12 * np.abs(column).max():
            continue
        found = analyse(
            problem,
            column,
            calc_second_order=False,
            num_resamples=draws,
            conf_level=confidence,
            seed=seed,
        )
        for key in keys:
            indices[key][(slice(None), *place)] = found[key]
    return indices


def _salib() -> Any:
    try:
        return import_module("SALib.analyze.sobol")
    except ImportError as error:
        msg = "Sobol indices need SALib, which is not installed; pip install 'dcfp[studies]' brings it."
        raise InputError(msg) from error


def _dataset(values: xarray.DataArray, factors: list[str], indices: dict[str, FloatArray]) -> xarray.Dataset:
    rest = [str(name) for name in values.dims if name != "sample"]
    variables: dict[str, Any] = {}
    for name, words in _INDICES:
        variables[name] = (("factor", *rest), indices[name], {"units": "1", "long_name": words})
        half = {"units": "1", "long_name": f"half of the interval of the {words}"}
        variables[f"{name}_confidence"] = (("factor", *rest), indices[f"{name}_conf"], half)
    coordinates: dict[str, Any] = {
        name: one for name, one in coordinates_of(values).items() if "sample" not in one.dims
    }
    return xarray.Dataset(variables, {"factor": factors, **coordinates})


def _precision(result: xarray.Dataset, samples: int, factors: list[str], confidence: float) -> list[str]:
    base = samples // (len(factors) + 2)
    widest = float(result["ST_confidence"].max())
    remarks = [
        f"From {base} base samples; {100.0 * confidence:g} % intervals of the total indices are up to ± {widest:.2f} wide, by drawing samples with replacement."
    ]
    if not np.isfinite(result["ST"].to_numpy()).all():
        remarks.append("– where the result does not vary with any factor.")
    return remarks
