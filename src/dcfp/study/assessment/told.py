"""What is told of the results of a study and of what follows from them: each a table of its quantities."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.inference.statistics import quantile
from dcfp.schema.nomenclature import quantity
from dcfp.schema.quantities import NOTHING, Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import M_PER_S, NONE
from dcfp.study.assessment.completeness import remarks_of
from dcfp.study.assessment.fragility_fit import lognormal_probability
from dcfp.study.assessment.selection import (
    OF_RECORDS,
    coordinates_of,
    described,
    fixed_values,
    is_number,
    shown_value,
)
from dcfp.study.results import INTENSITIES, MEANINGS, parts_of

if TYPE_CHECKING:
    import xarray

Row = dict[str, Any]

# ----- factors and results as columns -----


def column(variable: "xarray.DataArray") -> Quantity:
    """Return a factor or a result as a column of rows that hold its values, in the units of the data set, by its name; a PGV is told in m/s."""
    name, entry = str(variable.name), described(variable)
    head = {"pgv": "PGV", "pga": "PGA"}.get(name, name.replace("_", " "))
    if not is_number(variable):
        return Quantity(name, entry.words, head=head, get=lambda row: row[name])
    unit = M_PER_S if name == "pgv" else entry.unit
    key = f"{name}{_ending(unit.udunits)}"
    return Quantity(
        key,
        entry.words,
        unit,
        entry.shown,
        digits=4,
        precision=9,
        name=name,
        head=head,
        get=lambda row: row[name],
    )


def _entry(key: str) -> Callable[[Row], Any]:
    return lambda row: row[key]


def _ending(unit: str) -> str:
    """Return what ends a key whose values have a unit."""
    return "" if unit == "1" else f"_{unit.replace(' ', '_').replace('-1', '').replace('-', '')}"


def told(variable: "xarray.DataArray", value: Any) -> Any:
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


def lines_of(found: "xarray.Dataset") -> list[tuple[str, str]]:
    """Return of which study something is, and at which values of its factors."""
    fixed = fixed_values(found)
    return [("Study", str(found.attrs.get("title", "")) or NOTHING), *([("At", fixed)] if fixed else [])]


def document(found: "xarray.Dataset", rows: Sequence[Mapping[str, Any]], **more: Any) -> Row:
    """Return what JSON holds of something that follows from a study."""
    fixed = {
        column(one).key: told(one, one)
        for name, one in coordinates_of(found).items()
        if one.ndim == 0 and name not in OF_RECORDS
    }
    return {
        "study": str(found.attrs.get("study_name", "")),
        "at": fixed,
        **more,
        "results": list(rows),
        "remarks": remarks_of(found),
        "references": str(found.attrs.get("references", "")).splitlines(),
    }


def _intensity(found: "xarray.Dataset") -> "xarray.DataArray":
    return found[str(found.attrs["intensity"])]


def _unit(variable: "xarray.DataArray") -> str:
    shown = described(variable).shown
    return f"[{shown.name if shown.has_dimension else '-'}]"


# ----- incremental dynamic analysis -----


def ida_table(found: "xarray.Dataset", name: str) -> Table:
    """Return for every intensity the quantiles over the records, how many are beyond the capacity, and every record."""
    values = found[name]
    intensity = found[str(values.dims[1])]
    parts = [f"{part:g}" for part in found["quantile"].to_numpy().tolist()]
    records = [str(one) for one in found["record"].to_numpy().tolist()]
    count = len(records)

    def of(kind: str, one: str, title: str, head: str = "") -> Quantity:
        key = f"{kind} {one}"
        return replace(column(values), key=key, name=title, head=head, get=_entry(key), printed=bool(head))

    columns = [
        column(intensity),
        *(of("quantiles", part, f"{name} {part}", f"{100.0 * float(part):g} %") for part in parts),
        Quantity("beyond_capacity", "records beyond the capacity", NONE, printed=False),
        Quantity("beyond", "records beyond the capacity", NONE, head="beyond\ncapacity", get=lambda row: f"{row['beyond_capacity']} of {count}", stored=False),
        *(of("records", record, record) for record in records),
    ]  # fmt: skip
    quantiles = found[f"{name}_quantile"].to_numpy().T.tolist()
    beyond = found["beyond_capacity"].sum("record").to_numpy().tolist()
    rows = [
        {
            str(intensity.name): at,
            "beyond_capacity": int(beyond[i]),
            **{f"quantiles {part}": one for part, one in zip(parts, quantiles[i], strict=True)},
            **{f"records {record}": one for record, one in zip(records, single, strict=True)},
        }
        for i, (at, single) in enumerate(
            zip(intensity.to_numpy().tolist(), values.to_numpy().T.tolist(), strict=True)
        )
    ]
    return Table(tuple(columns), rows)


# ----- fragility -----


def fragility_table(found: "xarray.Dataset") -> Table:
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
    rows: list[Row] = []
    for i, value in enumerate(capacity.to_numpy().tolist()):
        one = found.isel(capacity=i)
        observed = zip(intensity.to_numpy().tolist(), one["fraction"].to_numpy().tolist(), strict=True)
        rows.append(
            {
                "capacity": value,
                "observed": [{str(intensity.name): at, "fraction": part} for at, part in observed],
                **{name: float(one[name]) for name in ("median", "dispersion", "total_dispersion")},
                **{name: one[name].to_numpy().tolist() for name in ("median_bound", "dispersion_bound")},
            }
        )
    return Table(columns, rows)


def fragility_curves(found: "xarray.Dataset") -> Table:
    """Return for every capacity the points of its curve."""
    intensity, capacity = _intensity(found), _capacity(found)
    name = str(intensity.name)
    rows: list[Row] = []
    for i, value in enumerate(capacity.to_numpy().tolist()):
        one = found.isel(capacity=i)
        lines = (one["probability"], *one["probability_bound"])
        points = zip(
            found[f"{name}_of_curve"].to_numpy().tolist(),
            *(line.to_numpy().tolist() for line in lines),
            strict=True,
        )
        rows += [
            dict(zip(("capacity", name, "probability", "low", "high"), (value, *point), strict=True))
            for point in points
        ]
    parts = (Quantity(one, one, NONE) for one in ("probability", "low", "high"))
    return Table((Quantity("capacity", "capacity", column(capacity).unit), column(intensity), *parts), rows)


def fragility_observed(found: "xarray.Dataset") -> Table:
    """Return for every intensity the fractions that are observed, and the probabilities that are fitted."""
    intensity, capacity = _intensity(found), _capacity(found)
    points = intensity.to_numpy()
    columns, values = [column(intensity)], [points.tolist()]
    for i in range(capacity.size):
        one = found.isel(capacity=i)
        fitted = lognormal_probability(points, float(one["median"]), float(one["total_dispersion"]))
        shown = shown_value(capacity, one["capacity"].item())
        for head, part in ((f"{shown}:\nobserved", one["fraction"].to_numpy()), ("\nfitted", fitted)):
            place = len(values)
            columns.append(
                Quantity(
                    f"{place}",
                    "probability",
                    NONE,
                    decimals=3,
                    head=head,
                    get=lambda row, place=place: row[place],
                )
            )
            values.append(part.tolist())
    rows = [{str(intensity.name): row[0], **dict(enumerate(row))} for row in zip(*values, strict=True)]
    return Table(tuple(columns), rows)


def _capacity(found: "xarray.Dataset") -> "xarray.DataArray":
    """Return the capacities under the name of the quantity, whose unit they have."""
    return found["capacity"].rename(str(found.attrs["quantity"]))


# ----- bounds, sensitivity -----

_SIDES = ("least", "nominal", "largest")


def bounds_table(found: "xarray.Dataset") -> Table:
    """Return for every result, quantile and intensity the least, nominal and largest value, and where they are."""
    intensity = _intensity(found)

    def of(row: Row) -> "xarray.DataArray":
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
    rows: list[Row] = []
    names = str(found.attrs["quantities"]).split(", ")
    parts: list[float] = found["quantile"].to_numpy().tolist()
    points: list[float] = intensity.to_numpy().tolist()
    for name, (i, part), (j, at) in product(names, enumerate(parts), enumerate(points)):
        one = found.isel({"quantile": i, str(intensity.name): j})
        rows.append(
            {
                "quantity": name,
                "quantile": part,
                str(intensity.name): at,
                **{side: float(one[f"{name}_{side}"]) for side in _SIDES},
                "largest_over_nominal": float(one[f"{name}_ratio"]),
                **{f"{side}_at": one[f"{name}_{side}_at"].item() for side in ("least", "largest")},
            }
        )
    return Table(columns, rows)


def sensitivity_table(found: "xarray.Dataset") -> Table:
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
    rows: list[Row] = []
    for places in product(*(range(one.size) for one in left)):
        at = {str(one.name): place for one, place in zip(left, places, strict=True)}
        where = {str(one.name): one.to_numpy()[place].item() for one, place in zip(left, places, strict=True)}
        for i, name in enumerate(found["factor"].to_numpy().tolist()):
            one = found.isel({**at, "factor": i})
            rows.append({**where, "factor": name, **{index: float(one[index]) for index in indices}})
    return Table(columns, rows)


# ----- a store -----

#: What is shown of each intensity of a store.
SUMMARY = {
    "peak_displacement": quantity("peak_displacement"),
    "force_ratio": quantity("force_ratio"),
    "peak_temperature": quantity("peak_temperature"),
    "residual_displacement": quantity("residual_displacement"),
    "input_velocity": quantity("input_velocity"),
}
_HEADS = {"peak_displacement": "y_max", "force_ratio": "F/W", "peak_temperature": "T_max", "residual_displacement": "|residual|", "input_velocity": "V_E"}  # fmt: skip
_DECIMALS = {"force_ratio": 3, "input_velocity": 2, "peak_temperature": 0}
_QUANTILES = {"q16": 0.16, "median": 0.5, "q84": 0.84}
#: Rows of the summary at most.
_MOST_ROWS = 12


def counts(dataset: "xarray.Dataset") -> dict[str, int]:
    """Return how many analyses ended in which way."""
    found = np.zeros(len(MEANINGS), dtype=np.int64)
    for part in parts_of(dataset[["status"]]):
        found += np.bincount(part["status"].to_numpy().ravel(), minlength=len(MEANINGS))
    return dict(zip(MEANINGS, found.tolist(), strict=True))


def summary_table(dataset: "xarray.Dataset") -> Table:
    """Return quantiles over all that is done, for some intensities of the grid, or for all of them together."""
    name = next((one for one in INTENSITIES if one in dataset.dims), None)

    def spread(one: str) -> Quantity:
        entry = SUMMARY[one]

        def text(row: Row) -> str:
            shown = [entry.written(value, decimals=_DECIMALS.get(one, 1)) for value in row[one].values()]
            return NOTHING if None in row[one].values() else f"{shown[1]} ({shown[0]}–{shown[2]})"

        bracket = entry.shown.name if entry.shown.has_dimension else "-"
        return Quantity(
            f"{one} ", entry.words, entry.unit, head=f"{_HEADS[one]}\n[{bracket}]", get=text, stored=False
        )

    first: list[Quantity] = []
    rows = [_spread_of(dataset)]
    if name is not None:
        places = np.unique(np.linspace(0, dataset.sizes[name] - 1, _MOST_ROWS).round().astype(int)).tolist()
        values = dataset[name].to_numpy().tolist()
        rows = [{name: float(values[place]), **_spread_of(dataset.isel({name: place}))} for place in places]
        shown = column(dataset[name])
        first = [
            Quantity(name, shown.words, described(dataset[name]).unit, printed=False),
            Quantity(f"{name} ", shown.words, shown.unit, shown.shown, digits=4, head=shown.head, get=lambda row: row[name], stored=False),
        ]  # fmt: skip
    return Table(
        (
            *first,
            *map(spread, SUMMARY),
            *(Quantity(one, entry.words, printed=False) for one, entry in SUMMARY.items()),
        ),
        rows,
    )


def _spread_of(part: "xarray.Dataset") -> Row:
    row: Row = {}
    for name in SUMMARY:
        values = np.abs(part[name].to_numpy().ravel())
        known = values[np.isfinite(values)]
        row[name] = {key: quantile(known, one) if known.size else None for key, one in _QUANTILES.items()}
    return row


def store_object(dataset: "xarray.Dataset") -> Row:
    """Return what JSON holds of a store."""
    return {
        "title": dataset.attrs["title"],
        "dimensions": {str(name): int(size) for name, size in dataset.sizes.items()},
        "analyses": counts(dataset),
        "by_intensity": summary_table(dataset).objects(),
        "version": dataset.attrs["version"],
        "study_sha256": dataset.attrs["study_sha256"],
    }
