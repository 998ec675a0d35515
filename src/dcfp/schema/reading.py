"""Text and TOML from files, with one sentence for whatever may be wrong with them."""

import tomllib
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from dcfp.errors import InputError
from dcfp.schema.toml_places import Way, lines_of


def read_bytes(path: str | Path, what: str, *, most: int = -1) -> bytes:
    """Return the content of a file.

    Parameters
    ----------
    path
        Its name.
    what
        What it should be, as the end of a sentence on a file that is not there.
    most
        How many bytes are read; by default all.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    try:
        with Path(path).open("rb") as file:
            return file.read(most)
    except FileNotFoundError as error:
        msg = f"{path}: there is no such file; {what}."
        raise InputError(msg) from error
    except IsADirectoryError as error:
        msg = f"{path}: this is a folder; give the path of one file in it."
        raise InputError(msg) from error
    except (OSError, ValueError) as error:  # ValueError: a name that no file can have
        msg = f"{str(path)[:200]!r}: the file cannot be read ({getattr(error, 'strerror', None) or error})."
        raise InputError(msg) from error


def read_toml(path: str | Path, what: str) -> dict[str, Any]:
    """Return the content of a TOML file; arguments and errors as for `read_bytes`."""
    return parse_toml(read_bytes(path, what), path)[0]


def parse_toml(content: bytes, path: str | Path) -> tuple[dict[str, Any], dict[Way, int]]:
    """Return what a TOML file holds, and the line of each of its values.

    Raises
    ------
    InputError
        If it is not TOML.
    """
    try:
        text = content.decode("utf-8-sig")  # some editors put a mark of the byte order first
        return tomllib.loads(text), lines_of(text)
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        msg = f"{path}: this is not TOML ({error})."
        raise InputError(msg) from error
    except RecursionError:
        msg = f"{path}: lists and tables stand in each other too deep to be read."
        raise InputError(msg) from None


@contextmanager
def complaints_name(path: str | Path) -> Generator[None]:
    """Let every complaint within begin with the name of a file."""
    try:
        yield
    except InputError as error:
        if str(error).startswith(str(path)):
            raise
        msg = f"{path}: {error}"
        raise InputError(msg) from error
