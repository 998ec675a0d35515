"""The store of a study: Zarr, one chunk of each quantity for each block, readable at any moment.

A block is written quantity by quantity and its status last, each file under another name first. A block whose status is
there is whole; any other counts as not run, and is run again.
"""

from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import xarray
import zarr
from zarr.storage import MemoryStore

from dcfp.analysis.response import NOT_RUN
from dcfp.errors import InputError
from dcfp.schema.nomenclature import quantity
from dcfp.study.coordinates import coordinates
from dcfp.study.place import alone, followed, put_whole
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
                f"{self.place}: the results cannot be written ({error.strerror or error}); what is there stays good,"
                " and --resume goes on from it."
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
            f"{place}: the store exists, {100.0 * share_done(found):.3g} % of it done; go on with --resume, replace it with --overwrite, or choose"
            " another name."
        )
        raise InputError(msg)
    if found.attrs[DIGEST] != digest(plan):
        ours = makers()
        same = all(found.attrs.get(name) == value for name, value in ours.items())
        what = "of another study" if same else f"made by another version ({found.attrs.get('source')})"
        msg = f"{place}: this store is {what}; choose another name for the store of this one."
        raise InputError(msg)
