"""Sobol indices: which sampled factor the variance of a result comes from.

First order: the part of the variance that goes if the factor is known; total: the part that stays if all
others are. Estimated by SALib from samples in the scheme of Saltelli et al. (2010).
"""

import json

import numpy as np
import xarray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.study.assessment.selection import (
    check_part,
    few_records,
    noted,
    quantiles_over_records,
    select,
    usable,
)
from dcfp.study.factors import salib

#: How the records are taken together, if not by a quantile.
GEOMETRIC_MEAN = "geometric-mean"
#: Draws for the confidence, and where their random numbers start; SALib takes no seed of 0.
DRAWS, SEED = 200, 2010
#: Results without a zero from which ratios could be taken, or that may be zero.
_NO_RATIOS = frozenset({"peak_temperature", "residual_displacement"})
_MEDIAN = 0.5
#: The indices in the order of SALib's, and what they are.
_INDICES = {
    "S1": "first-order Sobol index",
    "S1_confidence": "half of the interval of the first-order Sobol index",
    "ST": "total Sobol index",
    "ST_confidence": "half of the interval of the total Sobol index",
}


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
    dataset, quantity
        A study whose samples are in the scheme of Saltelli, without those for the second order, and the
        result.
    over_records
        How the records are taken together: ``"geometric-mean"``, or a quantile [-]; by default the geometric
        mean, and the median where a result may be zero or has no natural zero. What is sampled together with
        the record stays as it is.
    logarithm
        Whether the variance is that of the logarithm.
    confidence, draws, seed
        Of the intervals [-], for which samples are drawn with replacement.

    Returns
    -------
    xarray.Dataset
        ``S1``, ``ST`` [-] over ``factor`` and what is left of the grid, and ``S1_confidence``,
        ``ST_confidence``, half of the widths of their intervals. Not a number where the result does not vary.

    Raises
    ------
    InputError
        If the study has no such samples, an analysis is missing or SALib is not installed.
    """
    check_part(confidence, "The confidence")
    if seed < 1 or draws < 2:
        msg = f"The seed must be a positive whole number and the draws at least 2, not {seed} and {draws}."
        raise InputError(msg)
    factors = _factors(dataset)
    found = usable(select(dataset, {}, keep=("sample",)), [quantity], unfinished=None)
    samples = found.sizes["sample"]
    if samples % (len(factors) + 2):
        msg = f"{samples} samples are not a multiple of {len(factors) + 2}, as the scheme of Saltelli has them for {len(factors)} factors."
        raise InputError(msg)
    values, words, remarks = _over_records(found[quantity], quantity, over_records)
    failed = values.isnull().any("sample")
    if failed.any():
        msg = f"{int(failed.sum())} sets of samples have an analysis that failed, and Sobol indices need all of them."
        raise InputError(msg)
    if logarithm:
        _check_positive(values, quantity, "no logarithm")
        values = values.copy(data=np.log(values.to_numpy()))
    options = {"factors": factors, "confidence": confidence, "draws": draws, "seed": seed}
    indices = xarray.apply_ufunc(
        _indices,
        values,
        kwargs=options,
        input_core_dims=[["sample"]],
        output_core_dims=[["factor"]] * len(_INDICES),
        vectorize=True,
        keep_attrs=False,
    )
    result = xarray.Dataset(
        {
            name: one.transpose("factor", ...).assign_attrs(units="1", long_name=long_name)
            for (name, long_name), one in zip(_INDICES.items(), indices, strict=True)
        },
        {"factor": factors},
        {
            **found.attrs,
            "quantity": quantity,
            "over_records": words,
            "logarithm": int(logarithm),
            "confidence": confidence,
            "draws": draws,
            "seed": seed,
        },
    )
    remarks += _precision(result, samples, confidence)
    return noted(result, remarks, "sobol_2001", "saltelli_2010")


def _factors(dataset: xarray.Dataset) -> list[str]:
    method = str(dataset.attrs.get("sampling_method", "grid"))
    if method != "saltelli" or "sample" not in dataset.dims:
        msg = f"Sobol indices need samples of the method 'saltelli', and this study has {method!r}; say method = \"saltelli\" under [sampling]."
        raise InputError(msg)
    return [str(one["name"]) for one in json.loads(str(dataset.attrs["sampling_factors"]))]


def _over_records(
    values: xarray.DataArray, quantity: str, over_records: str | float | None
) -> tuple[xarray.DataArray, str, list[str]]:
    """Return a result without the records, in what way, and what is to be said of it; a record that failed in one sample is left out of all."""
    way = over_records
    if way is None:
        way = _MEDIAN if quantity in _NO_RATIOS else GEOMETRIC_MEAN
    if isinstance(way, str) and way != GEOMETRIC_MEAN:
        msg = (
            f"Records are taken together by {GEOMETRIC_MEAN!r} or a quantile between 0 and 1, not by {way!r}."
        )
        raise InputError(msg)
    if "record" not in values.dims:
        return values, "none", []
    number = values.sizes["record"]
    values = values.where(values.notnull().all("sample"))
    if not isinstance(way, str):
        reduced = quantiles_over_records(values, [way]).isel(quantile=0, drop=True)
        return reduced, f"quantile {way:g} of {number} records", few_records([way], number)
    _check_positive(values, quantity, "no geometric mean; take a quantile over the records")
    mean = values.copy(data=np.log(values.to_numpy())).mean("record")
    return mean.copy(data=np.exp(mean.to_numpy())), f"{way} of {number} records", []


def _check_positive(values: xarray.DataArray, quantity: str, so: str) -> None:
    wrong = int((values <= 0.0).sum())
    if wrong:
        msg = f"{wrong} values of {quantity} are not above zero, so that there is {so}."
        raise InputError(msg)


def _indices(
    column: FloatArray, factors: list[str], confidence: float, draws: int, seed: int
) -> tuple[FloatArray, ...]:
    """Return the indices of results over the samples, each of shape (factors,), in the order of their names."""
    if np.ptp(column) <= 1e-12 * np.abs(column).max():
        return (np.full(len(factors), np.nan),) * len(_INDICES)
    problem = {"num_vars": len(factors), "names": factors, "bounds": [[0.0, 1.0]] * len(factors)}
    found = salib("analyze.sobol").analyze(
        problem,
        np.ascontiguousarray(column),
        calc_second_order=False,
        num_resamples=draws,
        conf_level=confidence,
        seed=seed,
    )
    return tuple(np.asarray(found[name.replace("confidence", "conf")]) for name in _INDICES)


def _precision(result: xarray.Dataset, samples: int, confidence: float) -> list[str]:
    base = samples // (result.sizes["factor"] + 2)
    widest = float(result["ST_confidence"].max())
    remarks = [
        f"From {base} base samples; {100.0 * confidence:g} % intervals of the total indices are up to ± {widest:.2f} wide, by drawing samples with replacement."
    ]
    if not np.isfinite(result["ST"].to_numpy()).all():
        remarks.append("– where the result does not vary with any factor.")
    return remarks
