"""Results as files: NetCDF with a group for each of several, and lines of text, with units."""

import csv
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Protocol

import numpy as np

from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import MEASURES
from dcfp.motion.station import Station
from dcfp.motion.station_measures import STATION_MEASURES
from dcfp.schema.quantities import Quantities, Quantity
from dcfp.schema.table import Table, csv_head_of, csv_text
from dcfp.version import version

if TYPE_CHECKING:
    import xarray

    from dcfp.analysis.rig.virtual_test import VirtualTest

REMARKS = Quantity("remarks", "what a reader must know", get="remarks", printed=False)


class Tabulated(Protocol):
    """What has histories."""

    def to_dataset(self) -> "xarray.Dataset":
        """Return them over time."""
        ...


class OfMotion(Tabulated, Protocol):
    """An analysis under a ground motion, of a structure of whatever kind."""

    quantities: ClassVar[Quantities]

    @property
    def motion(self) -> GroundMotion | Station:
        """Return the ground motion."""
        ...


def write_responses(
    path: Path, responses: Sequence[OfMotion], kind: str, *, alone: bool | None = None
) -> None:
    """Write analyses as ``".nc"`` or ``".csv"``: the histories of one, or the peaks of several and in NetCDF a group for each.

    One that is not `alone` is what is left of several.
    """
    table = Table(
        (*responses[0].quantities.values(), REMARKS),
        responses,
        "Peaks of several response history analyses; the histories are in a group for each",
    )
    _write(path, kind, responses, group_names(responses), table, "analysis", alone=alone)


def write_tests(path: Path, loops: "Sequence[VirtualTest]", kind: str) -> None:
    """Write virtual tests as ``".nc"`` or ``".csv"``: the histories of one, or the measures of every cycle or lap of several and in NetCDF a group for each."""
    from dcfp.analysis.rig.virtual_test import rounds_of

    table = Table(
        tuple(loops[0].rounds_told),
        rounds_of(loops),
        f"Measures of every {loops[0].round_name} of several virtual tests; the histories are in a group for each",
    )
    names = _different(
        [[one.test.name, f"{one.test.name}_{one.friction_law.name}_{one.heating.name}"] for one in loops]
    )
    _write(path, kind, loops, names, table, "row", named=False)


def write_motions(path: Path, motions: Sequence[GroundMotion | Station], kind: str) -> None:
    """Write ground motions or stations as ``".nc"`` or ``".csv"``: the histories of one, or the measures of several and in NetCDF a group for each."""
    columns = STATION_MEASURES if isinstance(motions[0], Station) else MEASURES
    table = Table(
        tuple(columns), motions, "Measures of several ground motions; the histories are in a group for each"
    )
    given = [motion.name for motion in motions]
    names = _different(
        [
            [
                f"{one.name}_{one.origin.component}"
                if one.origin.component and given.count(one.name) > 1
                else one.name
            ]
            for one in motions
        ]
    )
    measured = {
        key: value
        for key, value in table.objects()[0].items()
        if value is not None and not isinstance(value, list)
    }
    remarks = {"remarks": " ".join(table.objects()[0]["remarks"])}
    _write(path, kind, motions, names, table, "motion", attributes=measured | remarks)


def write_study(path: Path, dataset: "xarray.Dataset", kind: str) -> None:
    """Write the results of a study as ``".nc"`` with everything, or as ``".csv"`` with a line for each analysis; the latter leaves out histories."""
    if kind == ".csv":
        _study_csv(path, dataset)
        return
    whole = dataset.load().copy()
    for name in (*whole.coords, *whole.data_vars):
        whole[name].encoding = {}
        if whole[name].dtype.kind == "T":  # NetCDF knows strings as objects
            whole[name] = whole[name].astype(object)
    compressed(whole).to_netcdf(path, engine="h5netcdf")


def _study_csv(path: Path, dataset: "xarray.Dataset") -> None:
    from dcfp.study.results import parts_of  # late: a layer below, which imports what stores are read with

    quantities = [str(name) for name in dataset.data_vars if not str(name).startswith("history_")]
    dimensions = [str(name) for name in dataset[quantities[0]].dims]
    beside = [
        str(name) for name in dataset.coords if name not in dimensions and dataset[name].dims == ("sample",)
    ]
    names = [*dimensions, *beside, *quantities]
    units = [str(dataset[name].attrs.get("units", "")) for name in names]
    with path.open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow([csv_head_of(*one) if one[1] else one[0] for one in zip(names, units, strict=True)])
        for part in parts_of(dataset):
            like = part[quantities[-1]].transpose(*dimensions)
            columns = [_words(part[name].broadcast_like(like).transpose(*dimensions)) for name in names]
            writer.writerows(zip(*columns, strict=True))


def _words(array: "xarray.DataArray") -> list[str]:
    values: np.ndarray[Any, Any] = array.to_numpy().ravel()
    if "flag_meanings" in array.attrs:
        meanings = str(array.attrs["flag_meanings"]).split()
        return [meanings[int(value)] for value in values.tolist()]
    if values.dtype.kind == "f":
        return ["" if np.isnan(value) else f"{value:.9g}" for value in values.tolist()]
    return [str(value) for value in values.tolist()]


def group_names(responses: Sequence[OfMotion]) -> list[str]:
    """Return a name for each analysis, such as ``NCC_0.50``: the record and the PGV [m/s]."""
    return _different(
        [
            [f"{one.motion.name}_{one.motion.peak_velocity / 1e3:{form}}" for form in (".2f", ".6g")]
            for one in responses
        ]
    )


def _different(choices: Sequence[Sequence[str]]) -> list[str]:
    """Return for each the first of its names that no other has, or its last with a number."""
    names: list[str] = []
    for own in choices:
        plain = [re.sub(r"[^\w.-]+", "-", one) for one in own]
        numbered = (f"{plain[0]}_{number}" for number in range(2, len(choices) + 2))
        names.append(next(one for one in (*plain, *numbered) if one not in names))
    return names


def _write(
    path: Path,
    kind: str,
    results: Sequence[Tabulated],
    names: Sequence[str],
    table: Table,
    dimension: str,
    *,
    named: bool = True,
    attributes: Mapping[str, Any] | None = None,
    alone: bool | None = None,
) -> None:
    alone = len(results) == 1 if alone is None else alone
    if kind == ".csv":
        text = histories_csv(results[0].to_dataset()) if alone else table.csv()
        path.write_text(text, encoding="utf-8", newline="\n")
        return
    import xarray  # late: it takes long to import

    datasets = [compressed(one.to_dataset()) for one in results]
    if alone:
        datasets[0].attrs.update(attributes or {})
        datasets[0].to_netcdf(path, engine="h5netcdf")
        return
    about = {"Conventions": "CF-1.11", "title": table.title, "source": f"dcfp {version()}"}
    root = table.dataset(dimension, names if named else None, about)
    groups = {f"/{name}": data for name, data in zip(names, datasets, strict=True)}
    xarray.DataTree.from_dict({"/": root, **groups}).to_netcdf(path, engine="h5netcdf")


def compressed(data: "xarray.Dataset") -> "xarray.Dataset":
    """Return a data set whose variables will be written compressed."""
    for variable in data.variables.values():
        variable.encoding.update(zlib=True, complevel=1, shuffle=True)
    return data


def histories_csv(data: "xarray.Dataset") -> str:
    """Return the variables of a data set over ``time`` alone as CSV, with units in the head."""
    names = ["time", *(str(name) for name, one in data.data_vars.items() if one.dims == ("time",))]
    columns = np.column_stack([data[name].to_numpy() for name in names])
    return csv_text([csv_head_of(name, str(data[name].attrs["units"])) for name in names], columns.tolist())
