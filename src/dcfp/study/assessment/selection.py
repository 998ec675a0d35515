"""Which analyses of a study an assessment is about, one value of each factor that it does not look at; and how factors and results are called and shown."""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import xarray

from dcfp.errors import InputError
from dcfp.schema.nomenclature import NOMENCLATURE
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import (
    DEGC,
    KN,
    M_PER_S,
    M_PER_S2,
    MM,
    MM_PER_S,
    MM_PER_S2,
    N_PER_MM,
    N_PER_MM2,
    NEWTON,
    NONE,
    SECOND,
    Unit,
)
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
            f" (at {example})."
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


# How the factors and the results of a study are called and shown.


#: Factors that the nomenclature knows under another name.
_OTHER_NAMES = {"pgv": "peak_ground_velocity"}
#: Symbols of those that it does not know.
_SYMBOLS = {"pga": r"\mathrm{PGA}", "mu": r"\mu", "lambda": r"\lambda", "ambient": "T_0", "radius": "R"}
#: Units as data sets name them, and those that are shown in another.
_UNITS = {
    one.udunits: one for one in (NONE, DEGC, MM, SECOND, MM_PER_S, MM_PER_S2, NEWTON, N_PER_MM, N_PER_MM2)
}
_SHOWN = {MM_PER_S: M_PER_S, MM_PER_S2: M_PER_S2, NEWTON: KN}
#: What is known of a record beside its name.
OF_RECORDS = ("event", "station", "record_sha256", "time_step", "unscaled_pgv")
#: Values of a factor that a sentence names.
_MOST_NAMED = 12


def described(variable: "xarray.DataArray") -> Quantity:
    """Return what is known of a factor or a result: from the nomenclature, or else from its own attributes."""
    name = str(variable.name)
    known = NOMENCLATURE.get(_OTHER_NAMES.get(name, name))
    if known is not None:
        return known
    text = str(variable.attrs.get("units", "1"))
    unit = _UNITS.get(text) or Unit(text, udunits=text)
    plain = r"\ ".join(name.split("_"))
    symbol = str(variable.attrs.get("symbol", _SYMBOLS.get(name, rf"\mathrm{{{plain}}}")))
    words = str(variable.attrs.get("long_name", name))
    return Quantity(name, words, unit, _SHOWN.get(unit, unit), symbol=symbol)


def is_number(variable: "xarray.DataArray") -> bool:
    """Whether the values of a factor are numbers, and not names."""
    return variable.dtype.kind in "fiu"


def shown_value(variable: "xarray.DataArray", value: object) -> str:
    """Return one value of a factor with its unit, as it is shown: ``4500 mm``."""
    if not is_number(variable):
        return str(value)
    entry = described(variable)
    number = f"{entry.display(float(np.asarray(value, dtype=np.float64))):.6g}"
    return f"{number} {entry.shown.name}" if entry.shown.has_dimension else number


def shown_values(variable: "xarray.DataArray") -> str:
    """Return the values of a factor for a sentence, the first of many."""
    values = variable.to_numpy().ravel().tolist()
    named = [shown_value(variable, value) for value in values[:_MOST_NAMED]]
    more = [f"and {len(values) - _MOST_NAMED} more"] if len(values) > _MOST_NAMED else []
    return ", ".join([*named, *more])


def names_of(variable: "xarray.DataArray") -> "np.ndarray[Any, np.dtype[np.str_]]":
    """Return the values of a factor as words; a store has strings of a kind that NumPy does not convert by itself."""
    return np.array([str(value) for value in variable.to_numpy().ravel().tolist()], dtype=np.str_)


def events_of(dataset: "xarray.Dataset") -> "np.ndarray[Any, np.dtype[np.str_]]":
    """Return the earthquake of each record; its own name where none is known."""
    return names_of(dataset["event" if "event" in dataset.coords else "record"])


def coordinates_of(data: "xarray.Dataset | xarray.DataArray") -> "dict[str, xarray.DataArray]":
    """Return the coordinates of a data set or of a variable by their names."""
    return {str(name): data.coords[name] for name in data.coords}


def fixed_values(dataset: "xarray.Dataset") -> str:
    """Return the factors that have one value, with it: ``radius 4500 mm, lambda 1``."""
    return ", ".join(
        f"{name} {shown_value(values, values.item())}"
        for name, values in coordinates_of(dataset).items()
        if values.ndim == 0 and name not in OF_RECORDS
    )
