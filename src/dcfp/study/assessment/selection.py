"""Which analyses of a study an assessment is about: one value of each factor that it does not look at."""

from collections.abc import Mapping, Sequence

import numpy as np
import xarray

from dcfp.errors import InputError
from dcfp.study.assessment.described import is_number, names_of, shown_value, shown_values
from dcfp.study.results import INTENSITIES

#: How far a number may be off the value of a factor that it means, relative [-] and, at zero, absolute.
_SAME, _SAME_AT_ZERO = 1e-6, 1e-9


def select(
    dataset: xarray.Dataset, at: Mapping[str, float | str], keep: Sequence[str] = ()
) -> xarray.Dataset:
    """Return the analyses at one value of each factor that is named, with no dimension of length one.

    Parameters
    ----------
    dataset
        A study.
    at
        Values by the names of the factors, in the units of the data set; a sample is named by its number from 0.
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
        if name in dataset.dims:
            dataset = dataset.isel({name: _place(dataset, name, wanted)})
        else:
            _check_fixed(dataset, name, wanted)
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
            f" (on the command line: --at {example})."
        )
        raise InputError(msg)
    return dataset.transpose(*names)


def sorted_over(dataset: xarray.Dataset, name: str) -> xarray.Dataset:
    """Return a study with the values of a factor increasing.

    Raises
    ------
    InputError
        If they are no numbers, or not positive ones.
    """
    values = dataset[name]
    if not is_number(values) or not (values.to_numpy() > 0.0).all():
        msg = f"The values of {name} must be positive numbers, not {shown_values(values)}."
        raise InputError(msg)
    return dataset.sortby(name)


def _is_fixed(dataset: xarray.Dataset, name: str) -> bool:
    return name in dataset.coords and dataset[name].ndim == 0


def _place(dataset: xarray.Dataset, name: str, wanted: float | str) -> int:
    factor = dataset[name]  # numbers from 0 where the dimension has no coordinate
    found = np.flatnonzero(_same(factor, name, wanted))
    if found.size == 0:
        msg = f"There is no {name} of {shown_value(factor, wanted)} in this study; there is {_values(dataset, name)}."
        raise InputError(msg)
    return int(found[0])


def _check_fixed(dataset: xarray.Dataset, name: str, wanted: float | str) -> None:
    if name not in dataset.coords:
        known = _listed([str(one) for one in dataset.dims])
        msg = f"{name!r} is no factor of this study, which is over {known}."
        raise InputError(msg)
    factor = dataset[name]
    if factor.ndim > 0:
        along = str(factor.dims[0])
        msg = f"{name} cannot be chosen, because it goes with {along}; choose a {along}."
        raise InputError(msg)
    if not _same(factor, name, wanted):
        msg = f"There is no {name} of {shown_value(factor, wanted)} in this study; there is {shown_values(factor)}."
        raise InputError(msg)


def _same(factor: xarray.DataArray, name: str, wanted: float | str) -> np.ndarray:
    if not is_number(factor):
        return names_of(factor) == str(wanted)
    if isinstance(wanted, str):
        msg = f"{name} is chosen by a number, not by {wanted!r}; there is {shown_values(factor)}."
        raise InputError(msg)
    return np.asarray(np.isclose(factor.to_numpy(), wanted, rtol=_SAME, atol=_SAME_AT_ZERO))


def _values(dataset: xarray.Dataset, name: str) -> str:
    """Return the values of a dimension for a sentence."""
    return shown_values(dataset[name]) if name in dataset.coords else f"0 to {dataset.sizes[name] - 1}"


def _dimensions(dataset: xarray.Dataset) -> str:
    return _listed([str(name) for name in dataset.dims]) if dataset.dims else "none"


def _listed(names: Sequence[str]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def _is(names: Sequence[str]) -> str:
    return "is" if len(names) == 1 else "are"
