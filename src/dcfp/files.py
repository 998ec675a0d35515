"""Results into files, whole or not at all.

A file is written under another name in the same folder and takes its own name when it is complete, so that a failure
or an interruption leaves what was there before.
"""

import os
import stat
from collections.abc import Generator, Iterable, Sequence
from contextlib import contextmanager
from pathlib import Path

from dcfp.errors import InputError

DATA_EXTENSIONS = (".nc", ".csv")
FIGURE_EXTENSIONS = (".png", ".pdf", ".svg")


def check_outputs(paths: Iterable[Path], *, overwrite: bool, inputs: Iterable[Path] = ()) -> None:
    """Check that every file can be written, before any work is done.

    Parameters
    ----------
    paths
        Files that will be written.
    overwrite
        Whether a file may be there already.
    inputs
        Files that are read, which must not be written over even then.

    Raises
    ------
    InputError
        If a file exists, is named twice or is an input, or its folder is missing or cannot be written to.
    """
    read = {_resolved(path) for path in inputs}
    seen: set[Path] = set()
    for path in paths:
        place = _resolved(path)
        if place in seen:
            msg = f"{path}: two outputs have the same name; give each its own."
            raise InputError(msg)
        seen.add(place)
        if place in read and place.exists():
            msg = f"{path}: this file is an input; give the output another name."
            raise InputError(msg)
        _check_place(path, place, overwrite)


def _resolved(path: Path) -> Path:
    try:
        return path.resolve()
    except (OSError, ValueError, RuntimeError) as error:
        msg = f"{path}: this cannot be the name of a file ({error})."
        raise InputError(msg) from error


def _check_place(path: Path, place: Path, overwrite: bool) -> None:
    try:
        mode = place.stat().st_mode
    except FileNotFoundError:
        mode = None
    except (OSError, ValueError) as error:
        raise InputError(_cannot_write(path, error)) from error
    if mode is not None and not stat.S_ISREG(mode):
        what = "a folder" if stat.S_ISDIR(mode) else "not a regular file"
        msg = f"{path}: this is {what}; name a file to write to."
        raise InputError(msg)
    if mode is not None and not overwrite:
        msg = f"{path}: the file exists; choose another name, or replace it (overwrite)."
        raise InputError(msg)
    if not place.parent.is_dir():
        msg = f"{path}: there is no folder {str(path.parent)!r}; make it first."
        raise InputError(msg)
    if not os.access(place.parent, os.W_OK | os.X_OK) or (mode is not None and not os.access(place, os.W_OK)):
        msg = f"{path}: the file cannot be written (no permission)."
        raise InputError(msg)


@contextmanager
def whole_files(paths: Sequence[Path], *, overwrite: bool) -> Generator[list[Path]]:
    """Give a temporary file for each path; they take the names of the paths when the block is left without an error.

    Raises
    ------
    InputError
        If a file cannot be written, or appeared in the meantime.
    """
    temporary: list[Path] = []
    try:
        for path in paths:
            temporary.append(_temporary_beside(_resolved(path)))
        yield list(temporary)
        check_outputs(paths, overwrite=overwrite)
        for path, part in zip(paths, temporary, strict=True):
            place = _resolved(path)
            part.chmod(_permissions(place))
            part.replace(place)
    except OSError as error:
        raise InputError(_cannot_write(paths[0] if paths else Path(), error)) from error
    finally:
        for part in temporary:
            part.unlink(missing_ok=True)


def _temporary_beside(place: Path) -> Path:
    import tempfile  # late: a help text needs no file

    handle, name = tempfile.mkstemp(dir=place.parent, prefix=f".{place.name[:100]}.", suffix=".part")
    os.close(handle)
    return Path(name)


def _permissions(place: Path) -> int:
    """Return the permissions of the file that is replaced, or those that a new file would get."""
    if place.exists():
        return stat.S_IMODE(place.stat().st_mode)
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


def _cannot_write(path: Path, error: Exception) -> str:
    reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
    return f"{path}: the file cannot be written ({reason})."


def known_extension(name: str, extensions: tuple[str, ...], what: str) -> Path:
    """Return the path `name` if it has one of `extensions`; `what` is for the sentence.

    Raises
    ------
    InputError
        If not.
    """
    path = Path(name)
    if path.suffix.lower() not in extensions:
        msg = f"{name}: {what} can be written as {', '.join(extensions)}; give the file one of these extensions."
        raise InputError(msg)
    return path
