"""PEER ``AT2`` files: the PEER ground motion databases, from the 1990s to NGA-West2.

Three or four lines of text, of which one says ``NPTS= 5372, DT= .0100 SEC`` or, in the oldest files,
``4000  0.0050  NPTS, DT``; then the values, row by row, in g.
"""

import re

from dcfp.motion.formats.registry import RecordFormat, Series
from dcfp.motion.formats.source import NUMBER, SourceText, canonical_unit, free_numbers

_HEADER_LINES = 8
_NAMED = re.compile(rf"NPTS\s*=\s*(\d{{1,15}})\s*[,;]?\s*DT\s*=\s*({NUMBER})", re.IGNORECASE)
_OLDEST = re.compile(rf"^\s*(\d{{1,15}})\s*,?\s*({NUMBER})\s*,?\s*NPTS\s*,?\s*DT", re.IGNORECASE)
_UNIT = re.compile(r"IN UNITS? OF\s+([A-Z/0-9^*]+)", re.IGNORECASE)


def _recognises(source: SourceText) -> bool:
    """Whether one of the first lines holds both NPTS and DT."""
    return _size_line(source) is not None


def _read(source: SourceText) -> list[Series]:
    line = _size_line(source) or 0
    size = _NAMED.search(source.lines[line]) or _OLDEST.search(source.lines[line])
    if size is None:
        source.fail("NPTS and DT must be given as 'NPTS= 5372, DT= .0100 SEC'.", line=line + 1)
    header = " ".join(source.lines[: line + 1])
    # The line of names stands before the line of units, whatever comes ahead of it.
    titles = [line.strip() for line in source.lines[:line] if not _UNIT.search(line)]
    parts = [part.strip() for part in titles[-1].split(",")] if titles else []
    component = parts.pop() if len(parts) > 2 else ""
    station = parts.pop() if len(parts) > 1 else ""
    return [
        Series(
            unit=_unit(source, header),
            values=free_numbers(source, line + 1, int(size[1])),
            time_step=float(size[2].upper().replace("D", "E")),
            component=component,
            event=", ".join(parts),
            station=station,
            processing=_processing(header),
        )
    ]


def _size_line(source: SourceText) -> int | None:
    for index, line in enumerate(source.lines[:_HEADER_LINES]):
        words = line.upper()
        if "NPTS" in words and re.search(r"\bDT\b", words):
            return index
    return None


def _unit(source: SourceText, header: str) -> str:
    if not re.search(r"\bACCEL", header, re.IGNORECASE):
        source.fail("the header does not say that the values are acceleration; give an acceleration file.")
    found = _UNIT.search(header)
    unit = canonical_unit(found[1]) if found else None
    if unit is None:
        source.fail("the header names no known unit; 'IN UNITS OF G' was expected.")
    return unit


def _processing(header: str) -> str:
    corners = re.search(r"HP\s*=\s*([\d.]+)\s*Hz\s*,?\s*LP\s*=\s*([\d.]+)\s*Hz", header, re.IGNORECASE)
    if corners:
        return f"PEER processed: band-pass {corners[1]}-{corners[2]} Hz (header), baseline corrected"
    return "PEER processed: filtered and baseline corrected; the corners are not in the header"


PEER = RecordFormat(
    "PEER AT2",
    "Pacific Earthquake Engineering Research Center, old and NGA headers: one component of acceleration",
    _recognises,
    _read,
    "PEER Ground Motion Database, Pacific Earthquake Engineering Research Center.",
)
