"""The results of a study as one file."""

import csv
from pathlib import Path
from typing import Any

import numpy as np
import xarray

from dcfp.present.tables.columns import compressed, head_of
from dcfp.study.results import parts_of


def write_study_netcdf(dataset: xarray.Dataset, path: Path) -> None:
    """Write everything that a store holds, as NetCDF."""
    whole = dataset.load().copy()
    for name in (*whole.coords, *whole.data_vars):
        whole[name].encoding = {}
        if whole[name].dtype.kind == "T":  # NetCDF knows strings as objects
            whole[name] = whole[name].astype(object)
    compressed(whole).to_netcdf(path, engine="h5netcdf")


def study_csv(dataset: xarray.Dataset, path: Path) -> None:
    """Write a line for each analysis, with units in the head; histories are left out."""
    quantities = [str(name) for name in dataset.data_vars if not str(name).startswith("history_")]
    dimensions = [str(name) for name in dataset[quantities[0]].dims]
    beside = [
        str(name) for name in dataset.coords if name not in dimensions and dataset[name].dims == ("sample",)
    ]
    names = [*dimensions, *beside, *quantities]
    with path.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        units = [str(dataset[name].attrs.get("units", "")) for name in names]
        writer.writerow([head_of(*one) if one[1] else one[0] for one in zip(names, units, strict=True)])
        for part in parts_of(dataset):
            writer.writerows(_lines(part, names, dimensions))


def _lines(part: xarray.Dataset, names: list[str], dimensions: list[str]) -> "zip[tuple[Any, ...]]":
    order = tuple(dimensions)
    like = part[names[-1]].transpose(*order)
    columns = [_words(part[name].broadcast_like(like).transpose(*order)) for name in names]
    return zip(*columns, strict=True)


def _words(array: xarray.DataArray) -> list[str]:
    values: np.ndarray[Any, Any] = array.to_numpy().ravel()
    if "flag_meanings" in array.attrs:
        meanings = str(array.attrs["flag_meanings"]).split()
        return [meanings[int(value)] for value in values.tolist()]
    if values.dtype.kind == "f":
        return ["" if np.isnan(value) else f"{value:.9g}" for value in values.tolist()]
    return [str(value) for value in values.tolist()]
