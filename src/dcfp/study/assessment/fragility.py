"""Incremental dynamic analysis, Vamvatsikos and Cornell (2002), and fragility: how probable it is that a capacity is exceeded.

Every record is used at every intensity, so that its analyses are not independent trials: what is observed of
a record is one value, the intensity at which it first exceeds the capacity, known to lie between two
intensities of the study, or below the first, or above the last. A lognormal distribution is fitted to those
intervals by maximum likelihood: Baker (2015), with an interval in place of the exact intensity.
"""

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.study.assessment.fragility_fit import Draws, FirstExceedance, Fit, drawn_counts, first_exceedance
from dcfp.study.assessment.selection import (
    check_part,
    coordinates_of,
    events_of,
    few_records,
    noted,
    over_intensity,
    quantiles_over_records,
    shown_value,
    values_of,
)
from dcfp.study.results import MEANINGS, STATUS

#: Parts of the records that do not exceed [-]: the median and one standard deviation of a normal distribution on either side.
QUANTILES = (0.16, 0.5, 0.84)
#: Records that a distribution needs, and earthquakes that its confidence needs.
FEWEST = 4
#: Draws of earthquakes, and where their random numbers start.
DRAWS, SEED = 1000, 2015
#: What a fit says of every capacity: over what else, and in words.
_VARIABLES = {
    "median": ((), "median intensity"),
    "dispersion": ((), "dispersion between records"),
    "total_dispersion": ((), "total dispersion"),
    "median_bound": (("bound",), "bounds of the median intensity"),
    "dispersion_bound": (("bound",), "bounds of the dispersion between records"),
    "probability": (("point",), "probability that the capacity is exceeded"),
    "probability_bound": (("bound", "point"), "bounds of the probability"),
}
#: Points of a curve.
_POINTS = 201
#: Part of the draws without a fit from which on the others no longer say how sure it is [-].
_MANY_WITHOUT = 0.05


def ida(
    dataset: xarray.Dataset,
    quantity: str = "peak_displacement",
    quantiles: Sequence[float] = QUANTILES,
    *,
    unfinished: bool = False,
) -> xarray.Dataset:
    """Return the curves of an incremental dynamic analysis.

    Parameters
    ----------
    dataset
        A study of which at most the records and the intensity have several values; see
        `dcfp.study.assessment.select`.
    quantity, quantiles
        The result that is looked at, of a residual displacement the size, and parts of the records [-].
    unfinished
        Whether analyses that have not been run are left out rather than refused.

    Returns
    -------
    xarray.Dataset
        `quantity` over ``record`` and the intensity; ``<quantity>_quantile`` over ``quantile`` and the
        intensity; ``beyond_capacity``, whether an analysis is beyond the displacement capacity of the
        bearing.

    Raises
    ------
    InputError
        If another factor has several values, or the study is not finished.
    """
    what = "An incremental dynamic analysis"
    found, _ = over_intensity(dataset, (), what, [quantity], unfinished=unfinished)
    beyond = found[STATUS] == MEANINGS.index("beyond_capacity")
    curves = found[[quantity]].assign(
        {
            f"{quantity}_quantile": quantiles_over_records(found[quantity], quantiles),
            "beyond_capacity": beyond,
        }
    )
    remarks = few_records(quantiles, found.sizes["record"])
    if beyond.any():
        remarks.append(
            f"{int(beyond.sum())} of the {beyond.size} analyses are beyond the displacement capacity; they are those of plates without an end."
        )
    return noted(curves, remarks, "vamvatsikos_cornell_2002")


def fragility(
    dataset: xarray.Dataset,
    capacity: float | Sequence[float] | None = None,
    quantity: str = "peak_displacement",
    *,
    further_dispersions: Mapping[str, float] | None = None,
    confidence: float = 0.9,
    draws: int = DRAWS,
    seed: int = SEED,
    unfinished: bool = False,
) -> xarray.Dataset:
    """Fit the probability that a capacity is exceeded.

    Parameters
    ----------
    dataset, unfinished
        As for `ida`.
    capacity, quantity
        One or several, in the unit of the quantity, by default the displacement capacity of the study's
        bearing [mm]; and the result that is compared with it.
    further_dispersions
        By their names [-], for example of design and model: added to that between the records as the root of
        the sum of squares, after FEMA P-695; the median stays.
    confidence, draws, seed
        Part of the draws inside the bounds [-]; whole earthquakes are drawn, all components of one together.

    Returns
    -------
    xarray.Dataset
        Over ``capacity``: ``median`` (in the unit of the intensity), ``dispersion`` and ``total_dispersion``
        [-]; their ``median_bound`` and ``dispersion_bound``; ``fraction``, what part of the records is
        observed to exceed, over the intensity; and ``probability`` with its ``probability_bound`` over
        ``point``, whose intensities are ``<intensity>_of_curve``. Not a number where a capacity has no fit,
        of which a remark says why.

    Raises
    ------
    InputError
        If no capacity can be fitted, there are too few records, another factor has several values, or the
        study is not finished.
    """
    found, intensity = over_intensity(dataset, (), "A fragility", [quantity], unfinished=unfinished)
    capacities = _capacities(dataset, capacity, quantity)
    _check_options(confidence, draws, further_dispersions)
    grid, table = values_of(found, intensity), values_of(found, quantity)
    known = np.isfinite(table).any(axis=1)
    table, events = table[known], events_of(found)[known]
    if len(table) < FEWEST:
        msg = f"A fragility needs at least {FEWEST} records, and here are {len(table)}."
        raise InputError(msg)
    crossings = [first_exceedance(grid, table, one) for one in capacities]
    reasons = [one.reason(lambda value: shown_value(found[intensity], value)) for one in crossings]
    named = [shown_value(found[quantity], one) for one in capacities]
    if all(reasons):
        told = "; of ".join(f"{name} {why}" for name, why in zip(named, reasons, strict=True))
        msg = f"No fragility can be fitted: of {told}."
        raise InputError(msg)
    further = dict(further_dispersions or {})
    points = np.linspace(0.0, float(grid[-1]), _POINTS)
    drawn = Draws(drawn_counts(events, draws, seed), points, confidence)
    fits = [drawn.fit(one, math.hypot(*further.values())) for one in crossings]
    earthquakes = int(np.unique(events).size)
    result = _dataset(found, intensity, quantity, capacities, points, fits, earthquakes)
    result["fraction"] = (
        ("capacity", intensity),
        np.stack([_fractions(table, one) for one in capacities]),
        {"units": "1", "long_name": "part of the records that exceeds the capacity"},
    )
    told = [f"{name}: {why}." for name, why in zip(named, reasons, strict=True) if why]
    remarks = [*told, *_remarks(crossings, named, fits, earthquakes)]
    result = result.assign_attrs(
        confidence=confidence,
        draws=draws,
        seed=seed,
        records=len(table),
        earthquakes=earthquakes,
        further_dispersions=", ".join(f"{name} {value:g}" for name, value in further.items()) or "none",
    )
    return noted(result, remarks, "baker_2015", "fema_p695_2009")


def _capacities(
    dataset: xarray.Dataset, capacity: float | Sequence[float] | None, quantity: str
) -> list[float]:
    if capacity is None:
        known = dataset.attrs.get("displacement_capacity")
        if known is None or quantity != "peak_displacement":
            msg = f"A fragility of {quantity} needs a capacity, because the study has none for it."
            raise InputError(msg)
        capacity = float(known)
    listed = [float(one) for one in (capacity if isinstance(capacity, Sequence) else [capacity])]
    wrong = [one for one in listed if not (math.isfinite(one) and one > 0.0)]
    if wrong or not listed:
        msg = (
            f"A capacity must be a positive number, not {wrong[0]:g}."
            if wrong
            else "Give at least one capacity."
        )
        raise InputError(msg)
    return sorted(set(listed))


def _check_options(confidence: float, draws: int, further: Mapping[str, float] | None) -> None:
    check_part(confidence, "The confidence")
    if draws < 1:
        msg = f"The earthquakes must be drawn at least once, not {draws} times."
        raise InputError(msg)
    for name, value in (further or {}).items():
        if not (math.isfinite(value) and value >= 0.0):
            msg = f"The dispersion {name} must be zero or a positive number, not {value:g}."
            raise InputError(msg)


def _fractions(table: FloatArray, capacity: float) -> FloatArray:
    """Return what part of the records exceeds the capacity at each intensity."""
    known = np.isfinite(table).sum(axis=0)
    exceed = (np.nan_to_num(table, nan=-np.inf) > capacity).sum(axis=0)
    return np.where(known > 0, exceed / np.maximum(known, 1), np.nan)


def _dataset(
    found: xarray.Dataset,
    intensity: str,
    quantity: str,
    capacities: Sequence[float],
    points: FloatArray,
    fits: Sequence[Fit],
    earthquakes: int,
) -> xarray.Dataset:
    variables: dict[str, Any] = {}
    for name, (over, words) in _VARIABLES.items():
        values = np.array([getattr(one, name) for one in fits])
        if "bound" in over and earthquakes < FEWEST:  # too few to say how sure it is
            values = np.full_like(values, np.nan)
        units = str(found[intensity].attrs.get("units", "1")) if name.startswith("median") else "1"
        variables[name] = (("capacity", *over), values, {"units": units, "long_name": words})
    coordinates: dict[str, Any] = {
        "capacity": ("capacity", list(capacities), dict(found[quantity].attrs)),
        "bound": ["low", "high"],
        f"{intensity}_of_curve": ("point", points, dict(found[intensity].attrs)),
        intensity: found[intensity],
        **{name: one for name, one in coordinates_of(found).items() if one.ndim == 0},
    }
    return xarray.Dataset(
        variables, coordinates, {**found.attrs, "quantity": quantity, "intensity": intensity}
    )


def _remarks(
    crossings: Sequence[FirstExceedance], named: Sequence[str], fits: Sequence[Fit], earthquakes: int
) -> list[str]:
    remarks: list[str] = []
    for name, one, fit in zip(named, crossings, fits, strict=True):
        if one.returns:
            remarks.append(
                f"{name}: {one.returns} of the records exceed it and are within it again at a higher intensity; the first time counts."
            )
        if fit.without > _MANY_WITHOUT and math.isfinite(fit.median) and earthquakes >= FEWEST:
            remarks.append(
                f"{name}: {100.0 * fit.without:.0f} % of the draws of earthquakes have no fit, so that the bounds are too narrow;"
                " more intensities or records would help."
            )
    if earthquakes < FEWEST:
        remarks.append(
            f"How sure it is cannot be said from {earthquakes} earthquakes; {FEWEST} are the fewest."
        )
    remarks.append(
        "Fitted to the intervals of intensity in which each record first exceeds the capacity, because the same records are used at every intensity;"
        " no factor for the shape of the spectrum (FEMA P-695, SSF) is applied."
    )
    return remarks
