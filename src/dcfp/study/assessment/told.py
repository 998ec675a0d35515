"""What is told of the results of a study and of what follows from them: each a table of its quantities."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from operator import itemgetter
from typing import Any

import numpy as np
import xarray

from dcfp.inference.statistics import quantile
from dcfp.schema.quantities import NOTHING, Quantity, quantity
from dcfp.schema.table import Table
from dcfp.schema.units import M_PER_S, NONE
from dcfp.study.assessment.fragility_fit import lognormal_probability
from dcfp.study.assessment.selection import (
    counts,
    described,
    fixed_of,
    fixed_values,
    is_number,
    remarks_of,
    shown_value,
)
from dcfp.study.results import INTENSITIES, added_peaks, is_in_plane, peaks_of

Row = dict[str, Any]


def column(variable: xarray.DataArray) -> Quantity:
    """Return a factor or a result as a column of rows that hold its values, in the units of the data set, by its name; a PGV is told in m/s."""
    name, entry = str(variable.name), described(variable)
    head, get = {"pgv": "PGV", "pga": "PGA"}.get(name, name.replace("_", " ")), itemgetter(name)
    if not is_number(variable):
        return Quantity(name, entry.words, head=head, get=get)
    unit = M_PER_S if name == "pgv" else entry.unit
    ending = unit.udunits.replace(" ", "_").replace("-1", "").replace("-", "")
    key = name if unit.udunits == "1" else f"{name}_{ending}"
    return Quantity(key, entry.words, unit, entry.shown, digits=4, precision=9, name=name, head=head, get=get)


def told(variable: xarray.DataArray, value: Any) -> Any:
    """Return a value as data hold it."""
    return column(variable).datum({str(variable.name): value.item() if hasattr(value, "item") else value})


def nested(objects: Sequence[Row]) -> list[Row]:
    """Return rows in which what has a key of two words stands in an object of the first."""
    found: list[Row] = []
    for row in objects:
        found.append({})
        for key, value in row.items():
            group, _, name = key.partition(" ")
            if name:
                found[-1].setdefault(group, {})[name] = value
            else:
                found[-1][key] = value
    return found


def lines_of(found: xarray.Dataset) -> list[tuple[str, str]]:
    """Return of which study something is, and at which values of its factors."""
    fixed = fixed_values(found)
    return [("Study", str(found.attrs.get("title", "")) or NOTHING), *([("At", fixed)] if fixed else [])]


def document(found: xarray.Dataset, rows: Sequence[Mapping[str, Any]], **more: Any) -> Row:
    """Return what JSON holds of something that follows from a study."""
    fixed = {column(one).key: told(one, one) for one in fixed_of(found).values()}
    return {
        "study": str(found.attrs.get("study_name", "")),
        "at": fixed,
        **more,
        "results": list(rows),
        "remarks": remarks_of(found),
        "references": str(found.attrs.get("references", "")).splitlines(),
    }


def _intensity(found: xarray.Dataset) -> xarray.DataArray:
    return found[str(found.attrs["intensity"])]


def _unit(variable: xarray.DataArray) -> str:
    shown = described(variable).shown
    return f"[{shown.name if shown.has_dimension else '-'}]"


def _rows(over: Sequence[str], **variables: xarray.DataArray) -> list[Row]:
    """Return a row for each point of some dimensions, the last varying fastest: where it is, and the values of variables there."""
    frame: Any = xarray.Dataset(variables).reset_coords(drop=True).to_dataframe(dim_order=list(over))
    return frame.reset_index().to_dict("records")


def ida_table(found: xarray.Dataset, name: str) -> Table:
    """Return for every intensity the quantiles over the records, how many are beyond the capacity, and every record."""
    values = found[name]
    intensity = found[str(values.dims[1])]
    parts = [f"{part:g}" for part in found["quantile"].to_numpy().tolist()]
    records = [str(one) for one in found["record"].to_numpy().tolist()]

    def of(group: str, one: str, title: str, head: str = "") -> Quantity:
        def get(row: Row) -> Any:
            return row[group][one]

        key = f"{group} {one}"
        return replace(column(values), key=key, name=title, head=head, get=get, printed=bool(head))

    columns = [
        column(intensity),
        *(of("quantiles", part, f"{name} {part}", f"{100.0 * float(part):g} %") for part in parts),
        Quantity("beyond_capacity", "records beyond the capacity", NONE, printed=False),
        Quantity("beyond", "records beyond the capacity", NONE, head="beyond\ncapacity", get=lambda row: f"{row['beyond_capacity']} of {len(records)}", stored=False),
        *(of("records", record, record) for record in records),
    ]  # fmt: skip
    lines = zip(
        intensity.to_numpy().tolist(),
        found["beyond_capacity"].sum("record").to_numpy().tolist(),
        found[f"{name}_quantile"].to_numpy().T.tolist(),
        values.to_numpy().T.tolist(),
        strict=True,
    )
    rows = [
        {
            str(intensity.name): at,
            "beyond_capacity": int(beyond),
            "quantiles": dict(zip(parts, quantiles, strict=True)),
            "records": dict(zip(records, single, strict=True)),
        }
        for at, beyond, quantiles, single in lines
    ]
    return Table(tuple(columns), rows)


def fragility_table(found: xarray.Dataset) -> Table:
    """Return for every capacity the median, the dispersions and their bounds, and the fractions that are observed."""
    intensity, capacity = _intensity(found), _capacity(found)
    at, of = column(intensity), column(capacity)
    ending = at.key.removeprefix(str(intensity.name))

    def between(one: Quantity, name: str) -> Any:
        def text(row: Row) -> str:
            low, high = (Quantity("", "", one.unit, one.shown, digits=3).written(end) for end in row[name])
            return NOTHING if low == NOTHING else f"{low} to {high}"

        return text

    beta = Quantity("", "", NONE)
    columns = (
        Quantity(f"capacity{of.key.removeprefix(str(capacity.name))}", "capacity", of.unit, of.shown, digits=4, head=f"capacity\n{_unit(capacity)}", get=lambda row: row["capacity"]),
        Quantity(f"median{ending}", "median", at.unit, at.shown, digits=4, precision=9, head=f"median\n{_unit(intensity)}", get=lambda row: row["median"]),
        Quantity("bounds", "bounds of the median", at.unit, head=f"bounds\n{_unit(intensity)}", get=between(at, "median_bound"), stored=False),
        Quantity(f"median_bounds{ending}", "bounds of the median", at.unit, precision=9, get=lambda row: row["median_bound"], flat=False, printed=False),
        Quantity("dispersion", "dispersion", NONE, digits=3, head="beta"),
        Quantity("beta", "bounds of the dispersion", NONE, head="bounds", get=between(beta, "dispersion_bound"), stored=False),
        Quantity("dispersion_bounds", "bounds of the dispersion", NONE, get=lambda row: row["dispersion_bound"], flat=False, printed=False),
        Quantity("total_dispersion", "total dispersion", NONE, digits=3, head="total beta"),
        Quantity("observed", "fractions that are observed", get=lambda row: Table((at, Quantity("fraction", "fraction", NONE)), row["observed"]).objects(), flat=False, printed=False),
    )  # fmt: skip
    single = {name: found[name] for name in ("median", "dispersion", "total_dispersion")}
    observed = _rows(("capacity", str(intensity.name)), fraction=found["fraction"])
    rows = [
        {
            **row,
            **{name: found[name][i].to_numpy().tolist() for name in ("median_bound", "dispersion_bound")},
            "observed": [one for one in observed if one["capacity"] == row["capacity"]],
        }
        for i, row in enumerate(_rows(("capacity",), **single))
    ]
    return Table(columns, rows)


def fragility_curves(found: xarray.Dataset) -> Table:
    """Return for every capacity the points of its curve."""
    intensity, capacity = _intensity(found), _capacity(found)
    name = str(intensity.name)
    points = {
        name: found[f"{name}_of_curve"],
        "probability": found["probability"],
        **{end: found["probability_bound"].sel(bound=end, drop=True) for end in ("low", "high")},
    }
    parts = (Quantity(one, one, NONE) for one in ("probability", "low", "high"))
    columns = (Quantity("capacity", "capacity", column(capacity).unit), column(intensity), *parts)
    return Table(columns, _rows(("capacity", "point"), **points))


def fragility_observed(found: xarray.Dataset) -> Table:
    """Return for every intensity the fractions that are observed, and the probabilities that are fitted."""
    intensity, capacity = _intensity(found), _capacity(found)
    points = intensity.to_numpy()
    columns = [column(intensity)]
    values = {str(intensity.name): points.tolist()}
    for i, value in enumerate(capacity.to_numpy().tolist()):
        one = found.isel(capacity=i)
        fitted = lognormal_probability(points, float(one["median"]), float(one["total_dispersion"]))
        head = f"{shown_value(capacity, value)}:\nobserved"
        for name, title, part in (
            ("observed", head, one["fraction"].to_numpy()),
            ("fitted", "\nfitted", fitted),
        ):
            columns.append(Quantity(f"{name} {i}", "probability", NONE, decimals=3, head=title))
            values[f"{name} {i}"] = part.tolist()
    rows = [dict(zip(values, row, strict=True)) for row in zip(*values.values(), strict=True)]
    return Table(tuple(columns), rows)


def _capacity(found: xarray.Dataset) -> xarray.DataArray:
    """Return the capacities under the name of the quantity, whose unit they have."""
    return found["capacity"].rename(str(found.attrs["quantity"]))


_SIDES = ("least", "nominal", "largest")


def bounds_table(found: xarray.Dataset) -> Table:
    """Return for every result, quantile and intensity the least, nominal and largest value, and where they are."""
    intensity = _intensity(found)

    def of(row: Row) -> xarray.DataArray:
        return found[str(row["quantity"])]

    def side(name: str) -> tuple[Quantity, Quantity]:
        def datum(row: Row) -> Any:
            return told(of(row), row[name])

        def text(row: Row) -> str:
            return column(of(row)).text({row["quantity"]: row[name]})

        return (
            Quantity(name, f"{name} value", get=datum, printed=False),
            Quantity(f"{name}\n", f"{name} value", NONE, get=text, stored=False),
        )

    def result(row: Row) -> str:
        return column(of(row)).heading().replace("\n", " ").replace(" [-]", "")

    columns = (
        Quantity("Result", "result", get=result, stored=False),
        Quantity("Records", "part of the records that do not exceed it", get=lambda row: f"{100.0 * row['quantile']:g} %", stored=False),
        Quantity("quantity", "result", printed=False),
        Quantity("unit", "its unit", get=lambda row: str(of(row).attrs.get("units", "1")), printed=False),
        Quantity("quantile", "part of the records that do not exceed it", NONE, printed=False),
        column(intensity),
        *(one for name in _SIDES for one in side(name)),
        Quantity("largest_over_nominal", "largest over nominal", NONE, digits=3, head="over\nnominal"),
        Quantity("least_at", "where it is least", printed=False),
        Quantity("largest_at", "where it is largest", head="largest at"),
    )  # fmt: skip
    over = ("quantile", str(intensity.name))
    entries = (*_SIDES, "least_at", "largest_at")
    rows = [
        {"quantity": name, **row}
        for name in str(found.attrs["quantities"]).split(", ")
        for row in _rows(
            over,
            largest_over_nominal=found[f"{name}_ratio"],
            **{entry: found[f"{name}_{entry}"] for entry in entries},
        )
    ]
    return Table(columns, rows)


def sensitivity_table(found: xarray.Dataset) -> Table:
    """Return for every factor, and every value of those that are left of the grid, its indices with their intervals."""
    left = [found[str(name)] for name in found["S1"].dims if name != "factor"]
    indices = ("S1", "S1_confidence", "ST", "ST_confidence")

    def with_interval(name: str) -> Any:
        def text(row: Row) -> str:
            value, half = row[name], row[f"{name}_confidence"]
            return NOTHING if math.isnan(value) or math.isnan(half) else f"{value:.3f} ± {half:.3f}"

        return text

    columns = (
        *map(column, left),
        Quantity("factor", "factor", head="Factor"),
        *(Quantity(name, "index", NONE, printed=False) for name in indices),
        *(Quantity(head, "index", NONE, get=with_interval(name), stored=False) for head, name in (("first order", "S1"), ("total", "ST"))),
    )  # fmt: skip
    over = (*(str(one.name) for one in left), "factor")
    return Table(columns, _rows(over, **{name: found[name] for name in indices}))


#: What is shown of each intensity of a store, with its head and its decimals there, besides what is added to the peaks.
_SHOWN = {
    "peak_displacement": ("y_max", 1),
    "force_ratio": ("F/W", 3),
    "peak_temperature": ("T_max", 0),
    "residual_displacement": ("|residual|", 1),
    "input_velocity": ("V_E", 2),
}
_QUANTILES = {"q16": 0.16, "median": 0.5, "q84": 0.84}
#: Rows of the summary at most.
_MOST_ROWS = 12


def summary_table(dataset: xarray.Dataset) -> Table:
    """Return quantiles over all that is done, for some intensities of the grid, or for all of them together."""
    name = next((one for one in INTENSITIES if one in dataset.dims), None)
    shown = [
        replace(quantity(one), head=head, decimals=decimals)
        for one, (head, decimals) in _SHOWN.items()
        if one in dataset
    ]
    in_plane = is_in_plane(dataset)
    known = peaks_of(in_plane=in_plane)
    shown += [replace(known[one], key=one) for one in added_peaks(in_plane=in_plane) if one in dataset]

    def spread(one: Quantity) -> Quantity:
        def text(row: Row) -> str:
            values = [one.written(value) for value in row[one.key].values()]
            return NOTHING if None in row[one.key].values() else f"{values[1]} ({values[0]}–{values[2]})"

        return Quantity(f"{one.key} ", one.words, one.unit, head=one.heading(), get=text, stored=False)

    first: list[Quantity] = []
    rows = [_spread_of(dataset, shown)]
    if name is not None:
        places = np.unique(np.linspace(0, dataset.sizes[name] - 1, _MOST_ROWS).round().astype(int)).tolist()
        values = dataset[name].to_numpy().tolist()
        rows = [
            {name: float(values[place]), **_spread_of(dataset.isel({name: place}), shown)} for place in places
        ]
        along = column(dataset[name])
        stored = Quantity(name, along.words, along.unit.inner_unit, printed=False)
        first = [stored, replace(along, key=f"{name} ", stored=False)]
    hidden = (Quantity(one.key, one.words, printed=False) for one in shown)
    return Table((*first, *map(spread, shown), *hidden), rows)


def _spread_of(part: xarray.Dataset, shown: Sequence[Quantity]) -> Row:
    row: Row = {}
    for one in shown:
        values = np.abs(part[one.key].to_numpy().ravel())
        known = values[np.isfinite(values)]
        row[one.key] = {key: quantile(known, at) if known.size else None for key, at in _QUANTILES.items()}
    return row


def store_object(dataset: xarray.Dataset) -> Row:
    """Return what JSON holds of a store."""
    return {
        "title": dataset.attrs["title"],
        "dimensions": {str(name): int(size) for name, size in dataset.sizes.items()},
        "analyses": counts(dataset),
        "by_intensity": summary_table(dataset).objects(),
        "version": dataset.attrs["version"],
        "study_sha256": dataset.attrs["study_sha256"],
    }
