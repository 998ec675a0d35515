"""The store of a study: Zarr, one chunk of each quantity for each block, readable at any moment.

A block is written quantity by quantity and its status last, each file under another name first. A block whose status is
there is whole; any other counts as not run, and is run again.
"""

import os
import shutil
import tempfile
from collections.abc import Generator, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import filelock
import numpy as np
import xarray
import zarr
from zarr.storage import MemoryStore

from dcfp.errors import InputError
from dcfp.nomenclature import quantity
from dcfp.response.status import NOT_RUN
from dcfp.study.coordinates import coordinates
from dcfp.study.plan import Block, Plan
from dcfp.study.provenance import DIGEST, digest, provenance
from dcfp.study.work import QUANTITIES, STATUS, Results

if TYPE_CHECKING:
    from zarr.abc.store import Store

#: What the numbers of a status mean, in their order.
MEANINGS = ("not_run", "ok", "beyond_capacity", "still_moving", "failed")
#: End of the name under which Zarr writes a file before it is whole.
_PARTIAL = "*.partial"


class StudyStore:
    """A store that a study is being written into.

    Parameters
    ----------
    group
        The open group.
    plan
        What it is the store of.
    place
        Its folder; None in memory.
    """

    def __init__(self, group: zarr.Group, plan: Plan, place: Path | None) -> None:
        self.plan = plan
        self.place = place
        self._group = group
        self._arrays: dict[str, Any] = {name: group[name] for name in (*QUANTITIES, STATUS)}
        self._histories: dict[str, Any] = {name: group[f"history_{name}"] for name in plan.study.histories}

    def is_done(self, block: Block) -> bool:
        """Whether a block is whole."""
        try:
            status = np.asarray(self._arrays[STATUS][block.region])
        except Exception:  # a file cut short by a full disk or a crash of the machine can raise anything
            return False
        return bool((status != NOT_RUN).all())

    def write(self, block: Block, results: Results) -> None:
        """Write the results of a block.

        Raises
        ------
        InputError
            If they cannot be written.
        """
        try:
            for name in self.plan.study.histories:
                self._histories[name][block.region] = results[f"history_{name}"]
            for name in (*QUANTITIES, STATUS):
                self._arrays[name][block.region] = results[name]
        except OSError as error:
            msg = (
                f"{self.place}: the results cannot be written ({error.strerror or error}); what is there stays good,"
                " and --resume goes on from it."
            )
            raise InputError(msg) from error

    def dataset(self) -> xarray.Dataset:
        """Return the results so far."""
        return _dataset(self._group.store)


def store_in_memory(plan: Plan) -> StudyStore:
    """Return an empty store that vanishes with the process."""
    memory = MemoryStore()
    _create(memory, plan)
    return StudyStore(zarr.open_group(memory, mode="r+"), plan, None)


@contextmanager
def store_on_disk(plan: Plan, place: Path, *, resume: bool, overwrite: bool) -> Generator[StudyStore]:
    """Give the store of a study at a place, new or as it was left, for this process alone.

    Parameters
    ----------
    plan
        The plan of the study.
    place
        Folder of the store.
    resume
        Whether a store that is there is gone on with.
    overwrite
        Whether a store that is there is replaced.

    Raises
    ------
    InputError
        If a store is there and neither was asked for, it is that of another study, another process is writing into it, or
        nothing can be written there.
    """
    if _exists(place):
        _check_is_ours(place, plan, resume=resume, overwrite=overwrite)
    if not (resume and _exists(place)):
        _create_whole(plan, place, overwrite=overwrite)
    with _alone(place):
        for left in place.rglob(_PARTIAL):
            left.unlink(missing_ok=True)
        yield StudyStore(zarr.open_group(place, mode="r+"), plan, place)


def open_store(path: str | Path) -> xarray.Dataset:
    """Return the results of a study, from its store or from the NetCDF file that it was exported to; arrays are read when they are used.

    Raises
    ------
    InputError
        If there is no such store or file, or it is not that of a study.
    """
    place = Path(path)
    if not _exists(place):
        msg = f"{path}: there is no such store; dcfp study run STUDY.toml writes one."
        raise InputError(msg)
    try:
        found = xarray.open_dataset(place, engine="h5netcdf") if place.is_file() else _dataset(place)
    except Exception as error:  # whatever it is, xarray, h5py or Zarr have an exception of their own for it
        msg = f"{path}: this is not the store of a study."
        raise InputError(msg) from error
    if DIGEST not in found.attrs or STATUS not in found:
        msg = f"{path}: this is not the store of a study."
        raise InputError(msg)
    return found


def _dataset(store: "Store | Path") -> xarray.Dataset:
    found = xarray.open_zarr(store, consolidated=False, chunks=None)
    # Zarr lists what it finds in the order of the file system
    order = [name for name in (*QUANTITIES, STATUS) if name in found]
    return found[[*order, *sorted(str(name) for name in found.data_vars if name not in order)]]


# ----- a new store -----


def _create(store: "Store | Path", plan: Plan) -> None:
    """Write everything but the results."""
    xarray.Dataset(coords=coordinates(plan), attrs=provenance(plan)).to_zarr(
        store, mode="w", zarr_format=3, consolidated=False
    )
    group = zarr.open_group(store, mode="r+")
    names = list(plan.sizes)
    common: dict[str, Any] = {"shape": plan.shape, "chunks": plan.chunks, "dimension_names": names}
    for name in QUANTITIES:
        group.create_array(
            name, dtype="float64", fill_value=np.nan, attributes=dict(quantity(name).attributes), **common
        )
    flags: dict[str, Any] = {
        "long_name": "how the analysis ended",
        "flag_values": list(range(len(MEANINGS))),
        "flag_meanings": " ".join(MEANINGS),
    }
    group.create_array(STATUS, dtype="uint8", fill_value=NOT_RUN, attributes=flags, **common)
    for name in plan.study.histories:
        group.create_array(
            f"history_{name}",
            shape=(*plan.shape, plan.longest_record),
            chunks=(*plan.chunks, plan.longest_record),
            dimension_names=[*names, "step"],
            dtype="float64",
            fill_value=np.nan,
            attributes=dict(quantity(name).attributes),
        )


def _create_whole(plan: Plan, place: Path, *, overwrite: bool) -> None:
    """Create a store under another name first, so that there is all of it or nothing."""
    try:
        for left in place.parent.glob(f".{place.name}.*.part"):
            shutil.rmtree(left, ignore_errors=True)
        part = Path(tempfile.mkdtemp(dir=place.parent, prefix=f".{place.name}.", suffix=".part"))
        try:
            _create(part, plan)
            part.chmod(0o777 & ~_umask())
            if overwrite and _exists(place):
                shutil.rmtree(place)
            part.rename(place)
        finally:
            shutil.rmtree(part, ignore_errors=True)
    except OSError as error:
        msg = f"{place}: the store cannot be written ({error.strerror or error})."
        raise InputError(msg) from error


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


# ----- a store that is there -----


def _exists(place: Path) -> bool:
    try:
        return place.exists()
    except (OSError, ValueError) as error:
        msg = f"{place}: this cannot be the name of a store ({error})."
        raise InputError(msg) from error


def _check_is_ours(place: Path, plan: Plan, *, resume: bool, overwrite: bool) -> None:
    """Check that a store may be gone on with, or replaced: nothing else is ever deleted."""
    found = open_store(place)
    if place.is_file():
        msg = f"{place}: this is a file; name the folder of a store."
        raise InputError(msg)
    if overwrite:
        with _alone(place):
            return
    if not resume:
        done = share_done(found)
        msg = (
            f"{place}: the store exists, {100.0 * done:.3g} % of it done; go on with --resume, replace it with --overwrite, or choose"
            " another name."
        )
        raise InputError(msg)
    if found.attrs[DIGEST] != digest(plan):
        made_by = found.attrs.get("version"), found.attrs.get("kernels_sha256")
        ours = provenance(plan)
        same = made_by == (ours["version"], ours["kernels_sha256"])
        what = "of another study" if same else f"made by another version ({found.attrs.get('source')})"
        msg = f"{place}: this store is {what}; choose another name for the store of this one."
        raise InputError(msg)


def share_done(dataset: xarray.Dataset) -> float:
    """Return which part of a study is done [-]."""
    status = dataset[STATUS]
    done = sum(int((part != NOT_RUN).sum()) for part in _parts(status))
    return done / max(status.size, 1)


def _parts(array: xarray.DataArray) -> "Iterator[np.ndarray[Any, Any]]":
    """Return an array bit by bit along its first dimension, so that little of it is in memory at a time."""
    first = array.dims[0]
    for place in range(array.sizes[first]):
        yield np.asarray(array.isel({first: place}))


@contextmanager
def _alone(place: Path) -> Generator[None]:
    """Keep every other process from writing into a store."""
    # beside the store: within it Zarr would take it for a part that it does not know
    held = place.parent / f".{place.name}.lock"
    lock = filelock.FileLock(held)
    try:
        lock.acquire(timeout=0)
    except filelock.Timeout as error:
        msg = f"{place}: another process is writing into this store; wait for it, or stop it."
        raise InputError(msg) from error
    except OSError as error:
        msg = f"{place}: the store cannot be written ({error.strerror or error})."
        raise InputError(msg) from error
    try:
        yield
    finally:
        lock.release()
        with suppress(OSError):
            held.unlink(missing_ok=True)
