"""Property bounds: the envelope of a response over the values that the properties of a bearing may take.

ASCE 7-16 has an isolation system analysed with upper-bound and with lower-bound properties (section 17.2.8,
*unconfirmed*); usually the one governs the forces and the other the displacements. Here every combination of
the properties in a study is looked at, and it is said which one governs.
"""

from collections.abc import Mapping, Sequence
from itertools import product
from typing import Any

import numpy as np
import xarray

from dcfp.errors import InputError
from dcfp.study.assessment.selection import (
    few_records,
    is_number,
    noted,
    over_intensity,
    quantiles_over_records,
    select,
    shown_value,
    shown_values,
    values_of,
)

#: Factors of a study that are properties with bounds, and their nominal values.
NOMINAL: Mapping[str, float | str] = {"lambda": 1.0, "ambient": 20.0}
#: Results whose bounds are looked at.
QUANTITIES = ("peak_displacement", "force_ratio", "residual_displacement", "peak_temperature")
#: Parts of the records that do not exceed [-].
QUANTILES = (0.5, 0.84)
#: Factors that make the friction larger.
_FRICTION = ("lambda", "mu")


def bounds(
    dataset: xarray.Dataset,
    over: Sequence[str] | None = None,
    nominal: Mapping[str, float | str] = NOMINAL,
    quantities: Sequence[str] = QUANTITIES,
    quantiles: Sequence[float] = QUANTILES,
    *,
    unfinished: bool = False,
) -> xarray.Dataset:
    """Return the envelope of results over property factors, at each intensity.

    Parameters
    ----------
    dataset
        A study of which at most the properties, the records and the intensity have several values; see
        `dcfp.study.assessment.select`.
    over, nominal
        The property factors, by default those of ``lambda`` and ``ambient`` that have several values, and the
        value of each that is nominal.
    quantities, quantiles
        The results, of a residual displacement the size, and parts of the records that do not exceed [-].
    unfinished
        Whether analyses that have not been run are left out rather than refused.

    Returns
    -------
    xarray.Dataset
        Of each result over ``quantile``, the intensity and the properties: the value for each combination,
        under its own name; and over ``quantile`` and the intensity: ``<quantity>_least``, ``_largest`` and
        ``_nominal``, ``_ratio``, the largest over the nominal [-], not of temperatures, and ``_least_at`` and
        ``_largest_at``, the combinations that govern, in words.

    Raises
    ------
    InputError
        If a property does not vary or has no such nominal value, another factor has several values, or the
        study is not finished.
    """
    properties, what = _properties(dataset, over), "An envelope of property bounds"
    found, intensity = over_intensity(dataset, properties, what, quantities, unfinished=unfinished)
    without = [name for name in properties if name not in nominal]
    if without:
        shown = shown_values(found[without[0]])
        msg = f"Which {without[0]} is nominal must be said; the study has {shown}."
        raise InputError(msg)
    at = {name: nominal[name] for name in properties}
    variables: dict[str, Any] = {}
    for name in quantities:
        values = quantiles_over_records(found[name], quantiles).transpose("quantile", intensity, *properties)
        variables |= _envelope(values, name, at)
    about = {"over": ", ".join(properties), "nominal": _combination(found, at), "intensity": intensity}
    result = xarray.Dataset(variables, attrs={**found.attrs, **about, "quantities": ", ".join(quantities)})
    remarks = few_records(quantiles, found.sizes["record"]) + _governs(result, properties, quantities)
    return noted(result, remarks, "asce_7_2016")


def _properties(dataset: xarray.Dataset, over: Sequence[str] | None) -> list[str]:
    names = [name for name in NOMINAL if dataset.sizes.get(name, 1) > 1] if over is None else list(over)
    if not names:
        msg = f"None of {', '.join(NOMINAL)} has several values in this study; say over which factors the bounds are."
        raise InputError(msg)
    for name in names:
        if dataset.sizes.get(name, 1) < 2 or name in ("record", "sample"):
            varied = ", ".join(str(one) for one, size in dataset.sizes.items() if size > 1)
            msg = f"{name!r} has no bounds in this study, in which several values are of {varied}."
            raise InputError(msg)
    return names


def _envelope(values: xarray.DataArray, name: str, nominal: Mapping[str, float | str]) -> dict[str, Any]:
    """Return the variables of one result, whose values are over quantile, intensity and the properties."""
    cases = values.stack(case=list(nominal))
    combinations = product(*(values[one].to_numpy().tolist() for one in nominal))
    told = np.array([_combination(values, dict(zip(nominal, one, strict=True))) for one in combinations])
    least, largest = cases.min("case", keep_attrs=True), cases.max("case", keep_attrs=True)
    grid = [str(one) for one in values.dims[:2]]
    at_nominal = select(values.to_dataset(name=name), nominal, keep=grid)[name].drop_vars(nominal)
    # the zero of a temperature means nothing
    is_temperature = values.attrs.get("units") == "degC"
    ratio = largest / at_nominal.where((at_nominal > 0.0) & (not is_temperature))
    return {
        name: values,
        f"{name}_least": least,
        f"{name}_largest": largest,
        f"{name}_nominal": at_nominal,
        f"{name}_ratio": ratio.assign_attrs(units="1"),
        f"{name}_least_at": _where(cases.fillna(np.inf).argmin("case"), told, least),
        f"{name}_largest_at": _where(cases.fillna(-np.inf).argmax("case"), told, largest),
    }


def _where(
    places: xarray.DataArray, told: "np.ndarray[Any, Any]", extreme: xarray.DataArray
) -> xarray.DataArray:
    """Return which combinations govern, in words; none where there is no value."""
    return places.copy(data=np.where(extreme.notnull(), told[places.to_numpy()], ""))


def _combination(found: xarray.Dataset | xarray.DataArray, at: Mapping[str, object]) -> str:
    return ", ".join(f"{name} {shown_value(found[name], value)}" for name, value in at.items())


def _governs(result: xarray.Dataset, properties: Sequence[str], quantities: Sequence[str]) -> list[str]:
    """Return whether the bounds of the friction govern what they usually do: the lower the displacement, the upper the force."""
    name = next((one for one in properties if one in _FRICTION and is_number(result[one])), None)
    asked = [one for one in ("peak_displacement", "force_ratio") if one in quantities]
    if name is None or len(asked) < 2:
        return []
    lower, upper = float(result[name].min()), float(result[name].max())
    told: list[str] = []
    every = True
    for quantity, bound, words in (
        ("peak_displacement", lower, "displacement"),
        ("force_ratio", upper, "force"),
    ):
        values = result[quantity].max([one for one in properties if one != name])
        known = values.notnull().any(name).to_numpy()
        governing = values.fillna(-np.inf).argmax(name).to_numpy()[known]
        hits, whole = int((values_of(result, name)[governing] == bound).sum()), governing.size
        every = every and hits == whole
        side = "lower" if bound == lower else "upper"
        told.append(
            f"the {side} bound of {name} ({shown_value(result[name], bound)}) governs the {words} in {hits} of {whole}"
        )
    verdict = "as usual" if every else "which is not everywhere as usual"
    return [f"Of all intensities and quantiles {' and '.join(told)}, {verdict}; ASCE 7-16 asks for both."]
