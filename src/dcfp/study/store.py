"""The store of a study: Zarr, one chunk of each quantity for each block, readable at any moment.

A block is written quantity by quantity and its status last, each file under another name first. A block whose status is
there is whole; any other counts as not run, and is run again.
"""

import os
import shutil
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import filelock
import numpy as np
import xarray
import zarr
from zarr.storage import MemoryStore

from dcfp.analysis.response import NOT_RUN
from dcfp.errors import InputError
from dcfp.inference.case import event_of
from dcfp.schema.nomenclature import quantity
from dcfp.study.factors import factor
from dcfp.study.plan import Block, Plan
from dcfp.study.provenance import digest, makers, provenance
from dcfp.study.results import (
    DIGEST,
    MEANINGS,
    QUANTITIES,
    STATUS,
    exists,
    open_store,
    results_in,
    share_done,
)
from dcfp.study.study import RECORD, SAMPLE
from dcfp.study.work import Results

if TYPE_CHECKING:
    from zarr.abc.store import Store


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
                f"{self.place}: the results cannot be written ({error.strerror or error}); what is there stays good;"
                " go on from it (resume)."
            )
            raise InputError(msg) from error

    def dataset(self) -> xarray.Dataset:
        """Return the results so far."""
        return results_in(self._group.store)


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
    there = followed(place)
    with alone(there):
        known = exists(there)
        if known:
            _check_is_ours(there, plan, resume=resume, overwrite=overwrite)
        if not (known and resume):
            put_whole(there, lambda new: _create(new, plan))
        for left in there.rglob(_PARTIAL):
            left.unlink(missing_ok=True)
        yield StudyStore(zarr.open_group(there, mode="r+"), plan, there)


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


def _check_is_ours(place: Path, plan: Plan, *, resume: bool, overwrite: bool) -> None:
    """Check that a store may be gone on with, or replaced: nothing else is ever deleted."""
    found = open_store(place)
    if place.is_file():
        msg = f"{place}: this is a file; name the folder of a store."
        raise InputError(msg)
    if overwrite:
        return
    if not resume:
        msg = (
            f"{place}: the store exists, {100.0 * share_done(found):.3g} % of it done; go on with it (resume), replace it (overwrite), or choose"
            " another name."
        )
        raise InputError(msg)
    if found.attrs[DIGEST] != digest(plan):
        ours = makers()
        same = all(found.attrs.get(name) == value for name, value in ours.items())
        what = "of another study" if same else f"made by another version ({found.attrs.get('source')})"
        msg = f"{place}: this store is {what}; choose another name for the store of this one."
        raise InputError(msg)


# The folder of a store: taken by one process at a time, new or replaced whole or not at all.


@contextmanager
def alone(place: Path) -> Generator[None]:
    """Keep every other process from writing into a store, or making or replacing it.

    Raises
    ------
    InputError
        If another process does so, or nothing can be written beside the store.
    """
    # beside the store: within it Zarr would take it for a part that it does not know
    held = _beside(place, "lock")
    if not place.parent.is_dir():
        msg = f"{place}: the store cannot be written (there is no folder {str(place.parent)!r})."
        raise InputError(msg)
    lock = filelock.FileLock(held)
    try:
        lock.acquire(timeout=0)
    except filelock.Timeout as error:
        msg = f"{place}: another process is writing into this store; wait for it, or stop it."
        raise InputError(msg) from error
    except OSError as error:
        raise cannot_write(place, error) from error
    try:
        yield
    finally:
        with suppress(OSError):
            held.unlink(
                missing_ok=True
            )  # before the release: who takes a lock looks whether its file is still there
        lock.release()


def put_whole(place: Path, create: Callable[[Path], None]) -> None:
    """Let a new folder be filled under another name, and give it the place of what is there; only within `alone`.

    Raises
    ------
    InputError
        If it cannot be written; what was there then still is.
    """
    new, old = _beside(place, "new"), _beside(place, "old")
    try:
        for left in (new, old):  # of a process that was killed
            shutil.rmtree(left, ignore_errors=True)
        try:
            create(new)
            if place.exists():
                place.rename(old)
            new.rename(place)
        finally:
            shutil.rmtree(new, ignore_errors=True)
            shutil.rmtree(old, ignore_errors=True)
    except OSError as error:
        raise cannot_write(place, error) from error


def cannot_write(place: Path, error: OSError) -> InputError:
    """Return the sentence on a store that cannot be written."""
    return InputError(f"{place}: the store cannot be written ({error.strerror or error}).")


def followed(place: Path) -> Path:
    """Return where a link leads, and any other path as it is."""
    return Path(os.path.realpath(place)) if place.is_symlink() else place


def _beside(place: Path, what: str) -> Path:
    return place.parent / f".{place.name}.{what}"


# The coordinates of a study's results.


Coordinate = tuple[str, Any, dict[str, str]]


def coordinates(plan: Plan) -> dict[str, Coordinate]:
    """Return each coordinate as its dimension, values and attributes."""
    found: dict[str, Coordinate] = {}
    for name, values in plan.study.factors.items():
        found[name] = (name, _array(name, list(values)), _attributes(name))
    if plan.samples:
        numbers = np.arange(plan.sizes[SAMPLE])
        found[SAMPLE] = (SAMPLE, numbers, {"long_name": "number of the sample"})
        for name, values in plan.samples.items():
            found[name] = (SAMPLE, _array(name, values.tolist()), _attributes(name))
    along = RECORD if RECORD in plan.study.factors else SAMPLE
    return found | _of_records(plan, along)


def _of_records(plan: Plan, along: str) -> dict[str, Coordinate]:
    """Return what is known of the record at each place along a dimension."""
    motions = {motion.name: motion for motion in plan.study.motions}
    names = plan.study.factors.get(RECORD) or plan.samples[RECORD].tolist()
    chosen = [motions[str(name)] for name in names]
    words: dict[str, tuple[list[Any], dict[str, str]]] = {
        "event": ([event_of(one) for one in chosen], {"long_name": "earthquake"}),
        "station": ([one.origin.station for one in chosen], {"long_name": "station"}),
        "record_sha256": ([one.digest for one in chosen], {"long_name": "SHA-256 of the record"}),
    }
    found: dict[str, Coordinate] = {
        name: (along, np.array(values, dtype=object), attributes)
        for name, (values, attributes) in words.items()
    }
    found["time_step"] = (
        along,
        np.array([one.time_step for one in chosen]),
        {"long_name": "time step of the record", "units": "s"},
    )
    found["unscaled_pgv"] = (
        along,
        np.array([one.peak_velocity for one in chosen]),
        {"long_name": "peak ground velocity of the record as it is", "units": "mm s-1"},
    )
    return found


def _array(name: str, values: list[Any]) -> "np.ndarray[Any, Any]":
    return np.array(values, dtype=np.float64 if factor(name).is_number else object)


def _attributes(name: str) -> dict[str, str]:
    one = factor(name)
    attributes = {"long_name": one.words}
    return {**attributes, "units": one.unit.inner_unit.udunits} if one.is_number else attributes
