"""The text of a record file, and where in it an error was found."""

from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from dcfp.errors import InputError
from dcfp.schema.reading import read_bytes

#: Largest file that is read [bytes]; the longest public records stay far below it.
MAXIMUM_SIZE = 200_000_000


@dataclass(frozen=True)
class SourceText:
    """A record file as lines of text.

    Attributes
    ----------
    path
        Where the file is, as the user wrote it.
    lines
        Its lines, without the ends of line.
    units, time_step
        What the user says of its unit and its time step [s]; None where it is left to the file.
    """

    path: Path
    lines: tuple[str, ...]
    units: str | None = None
    time_step: float | None = None

    def fail(self, reason: str, *, line: int | None = None) -> NoReturn:
        """Raise an `InputError` that names the file and, counted from 1, the line."""
        place = f"{self.path}" if line is None else f"{self.path}, line {line}"
        msg = f"{place}: {reason}"
        raise InputError(msg)


def read_source(path: Path, *, units: str | None = None, time_step: float | None = None) -> SourceText:
    """Return a file as text.

    Raises
    ------
    InputError
        If there is no such file, or it is empty, too large, not readable or not text.
    """
    content = read_bytes(path, "check the path", most=MAXIMUM_SIZE + 1)
    if len(content) > MAXIMUM_SIZE:
        msg = f"{path}: the file is larger than {MAXIMUM_SIZE / 1e6:.0f} MB, so it is not one record."
        raise InputError(msg)
    return source_of(content, path, units=units, time_step=time_step)


def source_of(
    content: bytes, path: Path, *, units: str | None = None, time_step: float | None = None
) -> SourceText:
    """Return the content of a file as text; `path` is only its name, nothing is read from there.

    Raises
    ------
    InputError
        If it is empty or not text.
    """
    if not content.strip():
        msg = f"{path}: the file is empty; a record of ground acceleration was expected."
        raise InputError(msg)
    if b"\x00" in content:
        msg = f"{path}: this is a binary file; a text file in one of the known record formats was expected."
        raise InputError(msg)
    text = _decode(content).replace("\r\n", "\n").replace("\r", "\n")
    return SourceText(path, tuple(text.rstrip(" \t\n\x1a").split("\n")), units, time_step)


def _decode(content: bytes) -> str:
    """Decode by trying: UTF-8, then the Shift-JIS of Japanese files, then one byte a character."""
    for encoding in ("utf-8-sig", "cp932"):
        try:
            return content.decode(encoding)
        except UnicodeDecodeError:
            continue
    return content.decode("latin-1")
