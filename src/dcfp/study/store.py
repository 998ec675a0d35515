"""The store of a study: Zarr, one chunk of each quantity for each block, readable at any moment.

A block is written quantity by quantity and its status last, each file under another name first. A block whose
status is there is whole; any other counts as not run, and is run again.
"""

import hashlib
import json
import os
import shutil
from collections.abc import Generator
from contextlib import contextmanager, suppress
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import filelock
import numpy as np
import xarray
import zarr
from zarr.storage import MemoryStore

from dcfp.analysis.response import NOT_RUN
from dcfp.errors import InputError
from dcfp.inference.earthquake import event_of
from dcfp.kernels._jit import source_digest
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station
from dcfp.schema.citations import citations_of
from dcfp.schema.identity import identity_of
from dcfp.schema.quantities import Quantity, quantity
from dcfp.schema.units import MM_PER_S, SECOND
from dcfp.study.factors import factor
from dcfp.study.results import (
    DIGEST,
    DIRECTIONS,
    MEANINGS,
    STATUS,
    exists,
    kept_peaks,
    open_store,
    results_in,
    share_done,
)
from dcfp.study.study import RECORD, SAMPLE, Block, Plan
from dcfp.study.work import Results
from dcfp.system import friction_law
from dcfp.version import version

if TYPE_CHECKING:
    from zarr.abc.store import Store


#: Form of the store, so that a later version knows what it has before it.
FORM = 1
#: End of the name under which Zarr writes a file before it is whole.
_PARTIAL = "*.partial"


class StudyStore:
    """A store that a study is being written into: an open group, in a folder or (None) in memory."""

    def __init__(self, group: zarr.Group, plan: Plan, place: Path | None) -> None:
        self.plan = plan
        self.place = place
        self._group = group
        histories = (f"history_{name}" for name in plan.study.histories)
        kept = kept_peaks(in_plane=plan.study.in_plane)
        self._arrays: dict[str, Any] = {name: group[name] for name in (*histories, *kept, STATUS)}

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
            for name, array in self._arrays.items():  # the status last
                array[block.region] = results[name]
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
        If a store is there and neither `resume` nor `overwrite` says what to do, it is that of another study,
        another process is writing into it, or nothing can be written there.
    """
    there = Path(os.path.realpath(place)) if place.is_symlink() else place
    with alone(there):
        known = exists(there)
        if known:
            _check_is_ours(there, plan, resume=resume, overwrite=overwrite)
        if not (known and resume):
            _put_whole(there, plan)
        for left in there.rglob(_PARTIAL):
            left.unlink(missing_ok=True)
        yield StudyStore(zarr.open_group(there, mode="r+"), plan, there)


def _create(store: "Store | Path", plan: Plan) -> None:
    """Write everything but the results."""
    xarray.Dataset(coords=coordinates(plan), attrs=provenance(plan)).to_zarr(
        store, mode="w", zarr_format=3, consolidated=False
    )
    group = zarr.open_group(store, mode="r+")

    def create(name: str, attributes: dict[str, Any], kind: str, empty: float, **further: int) -> None:
        group.create_array(
            name,
            shape=(*plan.shape, *further.values()),
            chunks=(*plan.chunks, *further.values()),
            dimension_names=[*plan.sizes, *further],
            dtype=kind,
            fill_value=empty,
            attributes=attributes,
        )

    for name in kept_peaks(in_plane=plan.study.in_plane):
        create(name, dict(quantity(name).attributes), "float64", np.nan)
    flags: dict[str, Any] = {
        "long_name": "how the analysis ended",
        "flag_values": list(range(len(MEANINGS))),
        "flag_meanings": " ".join(MEANINGS),
    }
    create(STATUS, flags, "uint8", NOT_RUN)
    for name in plan.study.histories:
        attributes = dict(quantity(name).attributes)
        create(f"history_{name}", attributes, "float64", np.nan, step=plan.longest_record)


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
        raise _cannot_write(place, error) from error
    try:
        yield
    finally:
        with suppress(OSError):  # before the release: who takes a lock looks whether its file is still there
            held.unlink(missing_ok=True)
        lock.release()


def _put_whole(place: Path, plan: Plan) -> None:
    """Fill a new folder under another name, and give it the place of what is there, all or nothing; within `alone`."""
    new, old = _beside(place, "new"), _beside(place, "old")
    try:
        for left in (new, old):  # of a process that was killed
            shutil.rmtree(left, ignore_errors=True)
        try:
            _create(new, plan)
            if place.exists():
                place.rename(old)
            new.rename(place)
        finally:
            shutil.rmtree(new, ignore_errors=True)
            shutil.rmtree(old, ignore_errors=True)
    except OSError as error:
        raise _cannot_write(place, error) from error


def _cannot_write(place: Path, error: OSError) -> InputError:
    return InputError(f"{place}: the store cannot be written ({error.strerror or error}).")


def _beside(place: Path, what: str) -> Path:
    return place.parent / f".{place.name}.{what}"


Coordinate = tuple[str, Any, dict[str, str]]


#: What is known of a record besides its name.
OF_RECORDS = (
    Quantity("event", "earthquake", get=event_of),
    Quantity("station", "station", get="origin.station"),
    Quantity("record_sha256", "SHA-256 of the record", get="digest"),
    Quantity("time_step", "time step of the record", SECOND, get="time_step"),
    Quantity(
        "unscaled_pgv",
        "peak ground velocity of the record as it is, of a station of the resultant",
        MM_PER_S,
        get="peak_velocity",
    ),
)


def coordinates(plan: Plan) -> dict[str, Coordinate]:
    """Return each coordinate as its dimension, values and attributes."""
    found = {name: _coordinate(name, name, list(values)) for name, values in plan.study.factors.items()}
    if plan.samples:
        numbers = np.arange(plan.sizes[SAMPLE])
        found[SAMPLE] = (SAMPLE, numbers, {"long_name": "number of the sample"})
        found |= {name: _coordinate(name, SAMPLE, values.tolist()) for name, values in plan.samples.items()}
    motions = {motion.name: motion for motion in plan.study.motions}
    along = RECORD if RECORD in plan.study.factors else SAMPLE
    names: list[Any] = list(plan.study.factors.get(RECORD) or plan.samples[RECORD].tolist())
    for one in OF_RECORDS:
        values = [one.of(motions[str(name)]) for name in names]
        found[one.key] = (along, _array(values, is_number=one.is_number), one.attributes)
    return found


def _coordinate(name: str, along: str, values: list[Any]) -> Coordinate:
    one = factor(name)
    attributes = {"long_name": one.words}
    if one.is_number:
        attributes["units"] = one.unit.inner_unit.udunits
    return along, _array(values, is_number=one.is_number), attributes


def _array(values: list[Any], *, is_number: bool) -> "np.ndarray[Any, Any]":
    return np.array(values, dtype=np.float64 if is_number else object)


def provenance(plan: Plan) -> dict[str, Any]:
    """Return the attributes of the results of a study."""
    study = plan.study
    attributes: dict[str, Any] = {
        "Conventions": "CF-1.11",
        "title": study.title,
        "source": f"dcfp {version()}",
        **makers(),
        "store_form": FORM,
        DIGEST: digest(plan),
        DIRECTIONS: 2 if study.in_plane else 1,
        "study_name": study.name,
        "study": study.text,
        "references": "\n".join(citations_of(*_citations(plan), "li_2020")),
        "bearing": json.dumps(asdict(study.model.bearing)),
        "friction_law": repr(study.model.friction),
        "heating_model": repr(study.model.heating),
        "settings": json.dumps(asdict(study.settings)),
        "vertical": int(study.vertical),
        "records": json.dumps([_record(motion) for motion in study.motions]),
        "sampling_method": "grid" if study.sampling is None else study.sampling.method,
    }
    capacities = {model.bearing.displacement_capacity for model in plan.models_at_ends()}
    if len(capacities) == 1 and None not in capacities:  # [mm]
        attributes["displacement_capacity"] = capacities.pop()
    if study.sampling is not None:
        sampled = [{"name": name, "distribution": repr(one)} for name, one in study.sampling.factors.items()]
        attributes |= {"sampling_seed": study.sampling.seed, "sampling_factors": json.dumps(sampled)}
    return attributes


def makers() -> dict[str, str]:
    """Return which versions make the numbers."""
    return {"version": version(), "kernels_sha256": source_digest()}


def digest(plan: Plan) -> str:
    """Return what two studies share only if every analysis of them is the same, and every result to the last bit."""
    study = plan.study
    whole = {
        **makers(),
        "form": FORM,
        "grid": {name: _exactly(list(values)) for name, values in study.factors.items()},
        "samples": {name: _exactly(np.asarray(values).tolist()) for name, values in plan.samples.items()},
        "records": [(motion.name, motion.digest) for motion in study.motions],
        "model": identity_of(study.model),
        "bearings": {name: identity_of(model) for name, model in study.bearings.items()},
        "settings": identity_of(study.settings),
        "vertical": study.vertical,
        "kept": kept_peaks(in_plane=study.in_plane),
        "histories": study.histories,
        "chunks": plan.chunks,
    }
    return hashlib.sha256(json.dumps(whole).encode()).hexdigest()


def _exactly(values: list[Any]) -> list[Any]:
    """Return values as they can be written without loss."""
    return [value.hex() if isinstance(value, float) else value for value in values]


def _citations(plan: Plan) -> list[str]:
    laws = {plan.study.model.friction.citation}
    for name in plan.study.factors.get("law", plan.samples.get("law", [])):
        try:
            laws.add(friction_law(str(name)).citation)
        except InputError:  # a law that needs parameters is that of the study's own model
            continue
    return sorted(laws)


def _record(motion: GroundMotion | Station) -> dict[str, Any]:
    return {
        "name": motion.name,
        "sha256": motion.digest,
        "origin": asdict(motion.origin),
        "treatment": list(motion.treatment),
        "time_step_s": motion.time_step,
        "samples": len(motion.acceleration),
        "pgv_mm_s": motion.peak_velocity,
        "pga_mm_s2": motion.peak_acceleration,
    }
