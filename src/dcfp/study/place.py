"""The folder of a store: taken by one process at a time, new or replaced whole or not at all."""

import os
import shutil
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from pathlib import Path

import filelock

from dcfp.errors import InputError


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
