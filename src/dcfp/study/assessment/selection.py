"""Which analyses of a study an assessment is about, one value of each factor that it does not look at; and how factors and results are called and shown."""

import warnings
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.schema.citations import citations_of
from dcfp.schema.quantities import NOMENCLATURE, Quantity
from dcfp.schema.units import Unit
from dcfp.study.factors import ANALYSIS, catalogue
from dcfp.study.results import INTENSITIES, MEANINGS, OF_STATIONS, STATUS, is_in_plane, parts_of
from dcfp.study.store import OF_RECORDS, coordinates
from dcfp.study.study import Block, Plan
from dcfp.study.work import response_of

if TYPE_CHECKING:
    from dcfp.analysis import Response
    from dcfp.analysis.plane_response import PlaneResponse

#: How far a number may be off the value of a factor that it means, relative [-] and, at zero, absolute.
_SAME, _SAME_AT_ZERO = 1e-6, 1e-9


def select(
    dataset: xarray.Dataset, at: Mapping[str, float | str], keep: Sequence[str] = ()
) -> xarray.Dataset:
    """Return the analyses of a study at one value of each factor that is named, with no dimension of length one.

    Parameters
    ----------
    at
        Values by the names of the factors, in the units of the data set; a sample is named by its number from
        0.
    keep
        Factors that stay a dimension even if they have one value.

    Raises
    ------
    InputError
        If there is no such factor, or it has not that value.
    """
    if "status" in dataset:  # without the histories, which have dimensions of their own
        grid = set(dataset["status"].dims)
        dataset = dataset[[name for name, one in dataset.data_vars.items() if set(one.dims) <= grid]]
    for name, wanted in at.items():
        dataset = _at(dataset, name, wanted)
    lone = [name for name, size in dataset.sizes.items() if size == 1 and name not in keep]
    return dataset.squeeze(lone)


def intensity_of(dataset: xarray.Dataset) -> str:
    """Return the factor of a study that says how strong a motion is: ``"pgv"``, ``"pga"`` or ``"scale"``.

    Raises
    ------
    InputError
        If it has none of those, or if it is sampled.
    """
    found = [name for name in INTENSITIES if name in dataset.dims or _is_fixed(dataset, name)]
    if len(found) != 1:
        msg = f"An assessment over the intensity needs one of {', '.join(INTENSITIES)} in the grid of the study, which is over {_dimensions(dataset)}."
        raise InputError(msg)
    return found[0]


def only(dataset: xarray.Dataset, names: Sequence[str], what: str) -> xarray.Dataset:
    """Return a study over those factors, of one value or several, and no other.

    Parameters
    ----------
    dataset
        A study; factors with one value do not count.
    names
        The factors.
    what
        What needs them, as the begin of a sentence: ``"A design chart"``.

    Raises
    ------
    InputError
        If one of them is missing, or if another has several values.
    """
    dataset = select(dataset, {}, keep=names)
    for name in names:
        if _is_fixed(dataset, name):
            dataset = dataset.expand_dims(name)
            if name == "record" and _is_fixed(dataset, "event"):
                dataset = dataset.assign_coords(event=dataset["event"].expand_dims("record"))
    missing = [name for name in names if name not in dataset.dims]
    if missing:
        msg = f"{what} is over {_listed(names)}; {_listed(missing)} {_is(missing)} not in the grid of this study, which is over {_dimensions(dataset)}."
        raise InputError(msg)
    others = [str(name) for name in dataset.dims if name not in names]
    if others:
        told = _listed([f"{name} ({_values(dataset, name)})" for name in others])
        about = f"over {_listed(names)} only" if names else "of one case"
        example = " ".join(f"{name}=..." for name in others)
        msg = (
            f"{what} is {about}, and {told} {_is(others)} left over; choose one value of each first"
            f" (at {example})."
        )
        raise InputError(msg)
    return dataset.transpose(*names)


def over_intensity(
    dataset: xarray.Dataset, names: Sequence[str], what: str, results: Sequence[str], *, unfinished: bool
) -> tuple[xarray.Dataset, str]:
    """Return some results over those factors, the records and the intensity, increasing, and its name."""
    intensity = intensity_of(dataset)
    chosen = only(dataset, (*names, "record", intensity), what)
    values = chosen[intensity]
    if not is_number(values) or not (values.to_numpy() > 0.0).all():
        msg = f"The values of {intensity} must be positive numbers, not {shown_values(values)}."
        raise InputError(msg)
    return usable(chosen.sortby(intensity), results, unfinished=unfinished), intensity


def _is_fixed(dataset: xarray.Dataset, name: str) -> bool:
    return name in dataset.coords and dataset[name].ndim == 0


def _at(dataset: xarray.Dataset, name: str, wanted: float | str) -> xarray.Dataset:
    """Return a study at one value of a factor."""
    if name not in dataset.dims and name not in dataset.coords:
        known = _listed([str(one) for one in dataset.dims])
        msg = f"{name!r} is no factor of this study, which is over {known}."
        raise InputError(msg)
    factor = dataset[name]  # numbers from 0 where the dimension has no coordinate
    if name not in dataset.dims and factor.ndim > 0:
        along = str(factor.dims[0])
        msg = f"{name} cannot be chosen, because it goes with {along}; choose a {along}."
        raise InputError(msg)
    if not is_number(factor):
        same = names_of(factor) == str(wanted)
    elif isinstance(wanted, str):
        msg = f"{name} is chosen by a number, not by {wanted!r}; there is {shown_values(factor)}."
        raise InputError(msg)
    else:
        same = np.isclose(factor.to_numpy(), wanted, rtol=_SAME, atol=_SAME_AT_ZERO)
    found = np.flatnonzero(same)
    if found.size == 0:
        msg = f"There is no {name} of {shown_value(factor, wanted)} in this study; there is {_values(dataset, name)}."
        raise InputError(msg)
    return dataset.isel({name: int(found[0])}) if name in dataset.dims else dataset


def _values(dataset: xarray.Dataset, name: str) -> str:
    """Return the values of a dimension for a sentence."""
    return shown_values(dataset[name]) if name in dataset.coords else f"0 to {dataset.sizes[name] - 1}"


def _dimensions(dataset: xarray.Dataset) -> str:
    return _listed([str(name) for name in dataset.dims]) if dataset.dims else "none"


def _listed(names: Sequence[str]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def _is(names: Sequence[str]) -> str:
    return "is" if len(names) == 1 else "are"


#: Values of a factor that a sentence names.
_MOST_NAMED = 12


def described(variable: xarray.DataArray) -> Quantity:
    """Return what is known of a factor or a result: as it is declared, or else from its own attributes."""
    name = str(variable.name)
    if name in NOMENCLATURE:
        return NOMENCLATURE[name]
    known = catalogue().get(name)
    unit = Unit(text := str(variable.attrs.get("units", "1")), udunits=text)
    words, symbol = str(variable.attrs.get("long_name", name)), ""
    if known is not None:
        words, symbol = known.words, known.symbol
        unit = known.unit.inner_unit if known.is_number else unit
    plain = r"\ ".join(name.split("_"))
    shown = known.unit if known is not None and known.is_number else unit
    return Quantity(name, words, unit, shown, symbol=symbol or rf"\mathrm{{{plain}}}")


def is_number(variable: xarray.DataArray) -> bool:
    """Whether the values of a factor are numbers, and not names."""
    return variable.dtype.kind in "fiu"


def shown_value(variable: xarray.DataArray, value: object) -> str:
    """Return one value of a factor with its unit, as it is shown: ``4500 mm``."""
    if not is_number(variable):
        return str(value)
    entry = described(variable)
    number = f"{entry.display(float(np.asarray(value, dtype=np.float64))):.6g}"
    return f"{number} {entry.shown.name}" if entry.shown.has_dimension else number


def shown_values(variable: xarray.DataArray) -> str:
    """Return the values of a factor for a sentence, the first of many."""
    values = variable.to_numpy().ravel().tolist()
    named = [shown_value(variable, value) for value in values[:_MOST_NAMED]]
    more = [f"and {len(values) - _MOST_NAMED} more"] if len(values) > _MOST_NAMED else []
    return ", ".join([*named, *more])


def names_of(variable: xarray.DataArray) -> "np.ndarray[Any, np.dtype[np.str_]]":
    """Return the values of a factor as words; a store has strings of a kind that NumPy does not convert by itself."""
    return np.array([str(value) for value in variable.to_numpy().ravel().tolist()], dtype=np.str_)


def events_of(dataset: xarray.Dataset) -> "np.ndarray[Any, np.dtype[np.str_]]":
    """Return the earthquake of each record; its own name where none is known."""
    return names_of(dataset["event" if "event" in dataset.coords else "record"])


def coordinates_of(data: xarray.Dataset | xarray.DataArray) -> dict[str, xarray.DataArray]:
    """Return the coordinates of a data set or of a variable by their names."""
    return {str(name): data.coords[name] for name in data.coords}


def fixed_of(dataset: xarray.Dataset) -> dict[str, xarray.DataArray]:
    """Return the factors that have one value, by their names."""
    beside = [one.key for one in OF_RECORDS]
    return {
        name: values
        for name, values in coordinates_of(dataset).items()
        if values.ndim == 0 and name not in beside
    }


def fixed_values(dataset: xarray.Dataset) -> str:
    """Return the factors that have one value, with it: ``radius 4500 mm, lambda 1``."""
    return ", ".join(
        f"{name} {shown_value(values, values.item())}" for name, values in fixed_of(dataset).items()
    )


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
    number, whole = counts(found), found["status"].size
    missing, failed = number["not_run"], number["failed"]
    if missing and not unfinished:
        instead = "" if unfinished is None else ", or leave them out (unfinished)"
        msg = f"{missing} of the {whole} analyses have not been run; finish the study first{instead}."
        raise InputError(msg)
    if missing + failed == whole:
        msg = f"None of the {whole} analyses has a result."
        raise InputError(msg)
    remarks = [OF_STATIONS] if is_in_plane(found) else []
    if missing:
        remarks.append(f"{missing} of the {whole} analyses have not been run, and are left out.")
    if failed:
        remarks.append(f"{failed} of the {whole} analyses failed, and are left out.")
    if number["still_moving"] and _SIGNED.intersection(names):
        remarks.append(
            f"In {number['still_moving']} of the {whole} analyses it still moves at the end, so that the residual displacement is not final."
        )
    # in the plane it is a distance
    for name in () if is_in_plane(found) else _SIGNED.intersection(names):
        remarks.append(f"Of the {name.replace('_', ' ')} the size is taken, not the direction.")
        found[name] = (found[name].dims, np.abs(values_of(found, name)), found[name].attrs)
    return noted(found, remarks)


def counts(dataset: xarray.Dataset) -> dict[str, int]:
    """Return how many analyses ended in which way."""
    found = np.zeros(len(MEANINGS), dtype=np.int64)
    for part in parts_of(dataset[[STATUS]]):
        status = part[STATUS].to_numpy()  # of floats where xarray has made a gap
        found += [np.count_nonzero(status == code) for code in range(len(MEANINGS))]
    return dict(zip(MEANINGS, found.tolist(), strict=True))


def remarks_of(dataset: xarray.Dataset) -> list[str]:
    """Return the remarks in the attributes of a data set."""
    return [line for line in str(dataset.attrs.get("remarks", "")).splitlines() if line.strip()]


def noted(dataset: xarray.Dataset, remarks: Sequence[str], *references: str) -> xarray.Dataset:
    """Return a data set with further remarks and references, by their keys, in its attributes, one on each line."""
    known = str(dataset.attrs.get("references", "")).splitlines()
    return dataset.assign_attrs(
        remarks="\n".join(dict.fromkeys([*remarks_of(dataset), *remarks])),
        references="\n".join(dict.fromkeys([*known, *citations_of(*references)])),
    )


def values_of(dataset: xarray.Dataset, name: str) -> FloatArray:
    """Return a variable as numbers."""
    return np.asarray(dataset[name].to_numpy(), dtype=np.float64)


def check_part(part: float, what: str) -> None:
    """Refuse what is not above 0 and below 1.

    Raises
    ------
    InputError
        If it is not.
    """
    if not 0.0 < part < 1.0:
        msg = f"{what} must lie between 0 and 1, not {part:g}."
        raise InputError(msg)


def quantiles_over_records(values: xarray.DataArray, parts: Sequence[float]) -> xarray.DataArray:
    """Return quantiles over the records, along a new first dimension; see `dcfp.inference.statistics.quantile`.

    Records without a value do not count.

    Raises
    ------
    InputError
        If a part is not above 0 and below 1.
    """
    for part in parts:
        check_part(part, "A quantile")
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "All-NaN slice", RuntimeWarning)
        found = values.quantile(list(parts), "record", method="weibull", skipna=True, keep_attrs=True)
    return found.assign_coords(
        {name: one for name, one in coordinates_of(values).items() if "record" not in one.dims}
    )


def few_records(parts: Sequence[float], records: int) -> list[str]:
    """Return a sentence for each quantile that lies beyond the outermost of so many records."""
    return [
        f"{records} records are too few for a quantile of {part:g}; it is that of the outermost record."
        for part in parts
        if not 1.0 <= part * (records + 1) <= records
    ]


def numbered_cases(plan: Plan) -> xarray.Dataset:
    """Return the number of every case of a plan over its factors."""
    numbers = np.arange(plan.count).reshape(plan.shape)
    return xarray.Dataset({"number": (list(plan.sizes), numbers)}, coords=coordinates(plan))


def response_at(plan: Plan, at: Mapping[str, float | str]) -> "Response | PlaneResponse":
    """Return the response history analysis of one case, at a value of every factor that has several.

    Parameters
    ----------
    plan
        The plan of the study.
    at
        A value of every factor that has several, in the units of the results; a sample is named by its number.

    Raises
    ------
    InputError
        If there is no such case, or more than one, or it is one of another procedure.
    """
    chosen = only(select(numbered_cases(plan), at), (), "A response history analysis")
    places = np.unravel_index(int(chosen["number"].item()), plan.shape)
    cases = plan.cases(Block(0, tuple(slice(int(place), int(place) + 1) for place in places)))
    procedure = plan.procedures[int(cases.procedures[0])]
    if procedure != ANALYSIS:
        msg = f"The case is one of the procedure {procedure!r}, which has no histories; choose procedure={ANALYSIS}."
        raise InputError(msg)
    return response_of(plan, cases.lanes, 0)
