"""The results of a study as they are read: from its store, or from the file that it was exported to."""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import xarray

from dcfp.analysis.response import HISTORIES, PEAKS
from dcfp.errors import InputError
from dcfp.schema.quantities import Quantities

if TYPE_CHECKING:
    from zarr.abc.store import Store

#: What a batch gives of each analysis: names in the nomenclature, in the order of the results.
OF_BATCH = (
    "peak_displacement",
    "peak_change",
    "peak_velocity",
    "peak_force",
    "force_ratio",
    "peak_temperature",
    "least_friction",
    "residual_displacement",
    "input_velocity",
    "hysteretic_velocity",
)
STATUS = "status"
#: What the numbers of a status mean, in their order.
MEANINGS = ("not_run", "ok", "beyond_capacity", "still_moving", "failed")
#: How strong the ground motion is: at most one of these in a study.
INTENSITIES = ("pgv", "pga", "scale")
#: Attribute by which a store knows its study.
DIGEST = "study_sha256"
#: Attribute that says in how many horizontal directions the ground moves.
DIRECTIONS = "directions"

#: What is said of the results of stations.
OF_STATIONS = "The records are stations: displacement, velocity, force and the intensity of the ground are those of the resultant of two directions."


def peaks_of(*, in_plane: bool) -> Quantities:
    """Return what is told of each analysis: of a single component, or of a station."""
    if not in_plane:
        return PEAKS
    from dcfp.analysis.plane_response import PLANE_PEAKS  # late: most studies are of one direction

    return PLANE_PEAKS


def _given(*, in_plane: bool) -> tuple[str, ...]:
    """Return what a batch gives itself that is a number, of single components or of stations."""
    if not in_plane:
        return OF_BATCH
    from dcfp.analysis.plane_batch import PEAKS as OF_PLANE

    known = peaks_of(in_plane=True)
    return tuple(name for name in OF_PLANE if known[name].is_number)


def histories_of(*, in_plane: bool) -> Quantities:
    """Return the histories of each analysis, as `peaks_of` its peaks."""
    if not in_plane:
        return HISTORIES
    from dcfp.analysis.plane_response import PLANE_HISTORIES

    return PLANE_HISTORIES


def added_peaks(*, in_plane: bool = False) -> tuple[str, ...]:
    """Return the names of the numbers that were added to what people read of an analysis, besides those that a batch gives itself."""
    given = _given(in_plane=in_plane)
    return tuple(
        name
        for name, one in peaks_of(in_plane=in_plane).items()
        if one.is_number and one.printed and name not in given and one.title not in INTENSITIES
    )


def kept_peaks(*, in_plane: bool = False) -> tuple[str, ...]:
    """Return the names of what is kept of each analysis besides its status, in the order of the results."""
    return (*_given(in_plane=in_plane), *added_peaks(in_plane=in_plane))


def is_in_plane(dataset: xarray.Dataset) -> bool:
    """Whether a study is of stations."""
    return dataset.attrs.get(DIRECTIONS) == 2


def open_store(path: str | Path) -> xarray.Dataset:
    """Return the results of a study, from its store or from the NetCDF file that it was exported to; arrays are read when they are used.

    Raises
    ------
    InputError
        If there is no such store or file, or it is not that of a study.
    """
    place = Path(path)
    if not exists(place):
        msg = f"{path}: there is no such store; dcfp study run STUDY.toml writes one."
        raise InputError(msg)
    try:
        found = xarray.open_dataset(place, engine="h5netcdf") if place.is_file() else results_in(place)
        ours = DIGEST in found.attrs and STATUS in found and "title" in found.attrs
    except Exception:  # whatever it is, xarray, h5py or Zarr have an exception of their own for it
        ours, found = False, xarray.Dataset()
    if not ours:
        msg = f"{path}: this is not the store of a study."
        raise InputError(msg)
    peaks_of(in_plane=is_in_plane(found))  # so that the nomenclature knows them
    return found


def results_in(store: "Store | Path") -> xarray.Dataset:
    """Return what stands in a store, in the order of the quantities: Zarr lists what it finds in the order of the file system."""
    found = xarray.open_zarr(store, consolidated=False, chunks=None)
    order = [name for name in (*kept_peaks(in_plane=is_in_plane(found)), STATUS) if name in found]
    return found[[*order, *sorted(str(name) for name in found.data_vars if name not in order)]]


def exists(place: Path) -> bool:
    """Whether anything is at a place.

    Raises
    ------
    InputError
        If nothing can be there.
    """
    try:
        return place.exists()
    except (OSError, ValueError) as error:
        msg = f"{place}: this cannot be the name of a store ({error})."
        raise InputError(msg) from error


def parts_of(dataset: xarray.Dataset) -> Iterator[xarray.Dataset]:
    """Return a study part by part along its first dimension, a chunk of the store at a time: little of it is in memory, and nothing is read twice."""
    status = dataset[STATUS]
    if not status.dims:
        yield dataset
        return
    first = status.dims[0]
    chunks: Any = status.encoding.get("chunks") or status.encoding.get("chunksizes") or (1,)
    length = max(1, int(chunks[0]))
    for begin in range(0, status.sizes[first], length):
        yield dataset.isel({first: slice(begin, begin + length)})


def share_done(dataset: xarray.Dataset) -> float:
    """Return which part of a study is done [-]."""
    done = sum(int((part[STATUS].to_numpy() != 0).sum()) for part in parts_of(dataset[[STATUS]]))
    return done / max(dataset[STATUS].size, 1)
