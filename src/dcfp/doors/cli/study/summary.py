"""What is in a store, in one table."""

from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks
from dcfp.inference.intervals import quantile
from dcfp.schema.nomenclature import quantity
from dcfp.study.results import INTENSITIES, MEANINGS, parts_of

if TYPE_CHECKING:
    import xarray

#: What the table shows of each intensity.
_SHOWN = ("peak_displacement", "force_ratio", "peak_temperature", "residual_displacement", "input_velocity")
_QUANTILES = (0.16, 0.5, 0.84)
#: Digits after the point, where it is not one.
_DIGITS = {"force_ratio": 3, "input_velocity": 2, "peak_temperature": 0}
#: Rows of the table at most.
_MOST_ROWS = 12


def counts(dataset: "xarray.Dataset") -> dict[str, int]:
    """Return how many analyses ended in which way."""
    found = np.zeros(len(MEANINGS), dtype=np.int64)
    for part in parts_of(dataset[["status"]]):
        found += np.bincount(part["status"].to_numpy().ravel(), minlength=len(MEANINGS))
    return dict(zip(MEANINGS, found.tolist(), strict=True))


def summary_object(dataset: "xarray.Dataset") -> dict[str, Any]:
    """Return what is in a store, ready for JSON."""
    return {
        "title": dataset.attrs["title"],
        "dimensions": {str(name): int(size) for name, size in dataset.sizes.items()},
        "analyses": counts(dataset),
        "by_intensity": rows(dataset),
        "version": dataset.attrs["version"],
        "study_sha256": dataset.attrs["study_sha256"],
    }


def rows(dataset: "xarray.Dataset") -> list[dict[str, Any]]:
    """Return quantiles over all that is done, for some intensities of the grid, or for all of them together."""
    name = next((one for one in INTENSITIES if one in dataset.dims), None)
    if name is None:
        return [_row(dataset, {})]
    places = np.unique(np.linspace(0, dataset.sizes[name] - 1, _MOST_ROWS).round().astype(int))
    values = dataset[name].values
    return [_row(dataset.isel({name: int(place)}), {name: float(values[place])}) for place in places]


def _row(part: "xarray.Dataset", head: dict[str, float]) -> dict[str, Any]:
    row: dict[str, Any] = dict(head)
    for name in _SHOWN:
        values = np.abs(part[name].values.ravel())
        known = values[np.isfinite(values)]
        found = [quantile(known, part) if known.size else None for part in _QUANTILES]
        row[name] = dict(zip(("q16", "median", "q84"), found, strict=True))
    return row


def print_summary(dataset: "xarray.Dataset", place: str, elapsed: float | None = None) -> None:
    """Print what is in a store."""
    found = counts(dataset)
    total = sum(found.values())
    sizes = " × ".join(f"{size} {name}" for name, size in dataset[_SHOWN[0]].sizes.items())
    done = total - found["not_run"]
    lines = [
        ("Study", str(dataset.attrs["title"])),
        ("Analyses", f"{total:,} = {sizes}" + (f", {done:,} of them done" if done < total else "")),
        ("Store", place + (f", {elapsed:.1f} s" if elapsed is not None else "")),
    ]
    with page() as out:
        print_labelled(out, lines)
        out.print()
        out.print(_table(dataset))
        print_remarks(out, _remarks(found))


def _table(dataset: "xarray.Dataset") -> Any:
    found = rows(dataset)
    intensity = next((one for one in INTENSITIES if one in found[0]), None)
    heads = [_head(name) for name in _SHOWN]
    table = new_table([], [*([_intensity_head(intensity)] if intensity else []), *heads])
    for row in found:
        cells = [_spread(row[name], name) for name in _SHOWN]
        first = [f"{row[intensity] * (1.0 if intensity == 'scale' else 1e-3):.4g}"] if intensity else []
        add_row(table, [*first, *cells])
    return table


def _intensity_head(name: str) -> str:
    return {"pgv": "PGV\n[m/s]", "pga": "PGA\n[m/s²]", "scale": "Scale\n[-]"}[name]


def _head(name: str) -> str:
    short = {
        "peak_displacement": "y_max",
        "force_ratio": "F/W",
        "peak_temperature": "T_max",
        "residual_displacement": "|residual|",
        "input_velocity": "V_E",
    }[name]
    unit = quantity(name).shown
    return f"{short}\n[{unit.name if unit.has_dimension else '-'}]"


def _spread(values: dict[str, float | None], name: str) -> str:
    entry = quantity(name)
    shown = [None if value is None else entry.display(value) for value in values.values()]
    digits = _DIGITS.get(name, 1)
    if None in shown:
        return "–"
    low, middle, high = (f"{value:.{digits}f}" for value in shown if value is not None)
    return f"{middle} ({low}–{high})"


def _remarks(found: dict[str, int]) -> list[str]:
    remarks = ["Each: median and, in brackets, 16 to 84 % of all that is done at the intensity."]
    if found["beyond_capacity"]:
        remarks.append(f"{found['beyond_capacity']:,} of the analyses go beyond the displacement capacity.")
    if found["still_moving"]:
        remarks.append(
            f"{found['still_moving']:,} of them still move at the end, so that their residual is not final."
        )
    if found["failed"]:
        remarks.append(f"{found['failed']:,} gave no result, and stand as not a number.")
    return remarks
