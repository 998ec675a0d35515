"""How the factors and the results of a study are called and shown."""

from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.schema.nomenclature import Quantity, nomenclature

if TYPE_CHECKING:
    import xarray

#: Factors that the nomenclature knows under another name.
_OTHER_NAMES = {"pgv": "peak_ground_velocity"}
#: Symbols of those that it does not know.
_SYMBOLS = {"pga": r"\mathrm{PGA}", "mu": r"\mu", "lambda": r"\lambda", "ambient": "T_0", "radius": "R"}
#: How units are shown, and shown value over value [-].
_SHOWN = {
    "1": ("–", 1.0),
    "degC": ("°C", 1.0),
    "mm s-1": ("m/s", 1e-3),
    "mm s-2": ("m/s²", 1e-3),
    "N": ("kN", 1e-3),
    "N mm-1": ("N/mm", 1.0),
    "N mm-2": ("N/mm²", 1.0),
}
#: What is known of a record beside its name.
OF_RECORDS = ("event", "station", "record_sha256", "time_step", "unscaled_pgv")
#: Values of a factor that a sentence names.
_MOST_NAMED = 12


def described(variable: "xarray.DataArray") -> Quantity:
    """Return what is known of a factor or a result: from the nomenclature, or else from its own attributes."""
    name = str(variable.name)
    known = nomenclature().get(_OTHER_NAMES.get(name, name))
    if known is not None:
        return known
    unit = str(variable.attrs.get("units", "1"))
    shown, factor = _SHOWN.get(unit, (unit, 1.0))
    plain = r"\ ".join(name.split("_"))
    symbol = str(variable.attrs.get("symbol", _SYMBOLS.get(name, rf"\mathrm{{{plain}}}")))
    return Quantity(name, symbol, unit, str(variable.attrs.get("long_name", name)), shown, factor)


def is_number(variable: "xarray.DataArray") -> bool:
    """Whether the values of a factor are numbers, and not names."""
    return variable.dtype.kind in "fiu"


def shown_value(variable: "xarray.DataArray", value: object) -> str:
    """Return one value of a factor with its unit, as it is shown: ``4500 mm``."""
    if not is_number(variable):
        return str(value)
    entry = described(variable)
    number = f"{float(np.asarray(value, dtype=np.float64)) * entry.factor:.6g}"
    return number if entry.shown == "–" else f"{number} {entry.shown}"


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
