"""CSMIP/CESMD volume 2 files: corrected acceleration, velocity and displacement, channel after channel.

Each block is announced by a line such as ``12000 points of accel data equally spaced at .005 sec, in cm/sec2.
(8f10.6)``; its fields have a fixed width and run together. Only the acceleration is returned, but all blocks
are counted, so that a truncated file is noticed.
"""

import re
from collections.abc import Iterator

from dcfp.arrays import FloatArray
from dcfp.motion.formats.registry import RecordFormat, Series
from dcfp.motion.formats.source import (
    NUMBER,
    SourceText,
    announced_numbers,
    canonical_unit,
    moment,
    to_number,
)

_BLOCK = re.compile(
    rf"^\s*(\d{{1,15}})\s+points of\s+(\w+) data equally spaced at\s*({NUMBER})\s*sec(.*)$", re.IGNORECASE
)
_CHANNEL = re.compile(r"^Chan\s+(\d+):\s*(.*?)\s*$", re.IGNORECASE)
_START = re.compile(r"Start time:\s*(.*?UTC)", re.IGNORECASE)
_EVENT = re.compile(r"^(?:Record|Rcrd) of\s+(.*?)(?:\s{2,}|\(|$)", re.IGNORECASE)


def _recognises(source: SourceText) -> bool:
    """Whether a line announces a block of acceleration in CSMIP's words."""
    return any("points of accel data" in line.lower() for line in source.lines)


def _read(source: SourceText) -> list[Series]:
    return [_acceleration(source, first, last) for first, last in _channels(source)]


def _channels(source: SourceText) -> Iterator[tuple[int, int]]:
    """Yield the first line of each channel and the line that ends it."""
    first = 0
    for index, line in enumerate(source.lines):
        if line.startswith("/&"):
            yield first, index
            first = index + 1
    if first < len(source.lines):
        source.fail("the channel that begins here has no end ('/&'); the file is truncated.", line=first + 1)


def _acceleration(source: SourceText, first: int, last: int) -> Series:
    """Read all blocks of a channel, and return the one of acceleration."""
    found: list[Series] = []
    line = first
    while line < last:
        announced = _BLOCK.match(source.lines[line])
        if announced is None:
            line += 1
            continue
        values, after = announced_numbers(source, line, int(announced[1]), announced[4])
        if announced[2].lower() == "accel":
            found.append(_series(source, source.lines[first:line], announced, line, values))
        line = after
    if len(found) != 1:
        source.fail(
            f"the channel that begins here has {len(found)} blocks of acceleration instead of one.",
            line=first + 1,
        )
    return found[0]


def _series(
    source: SourceText, header: tuple[str, ...], announced: re.Match[str], line: int, values: FloatArray
) -> Series:
    named = re.search(r"(?:\bin\b|units?\s*:)\s*([a-z/0-9^]+)", announced.string, re.IGNORECASE)
    unit = canonical_unit(named[1]) if named else None
    time_step = to_number(announced[3])
    if unit is None or time_step is None:
        source.fail(
            "the block names no time step or no known unit; 'in cm/sec2' was expected.", line=line + 1
        )
    channel, number, station = _channel(header)
    label = channel or f"channel {number}"
    azimuth = re.sub(r"\s*deg$", "", label, flags=re.IGNORECASE)
    return Series(
        values,
        unit,
        time_step,
        component=label,
        names=(number, f"chan {number}", f"channel {number}", azimuth),
        event=next((found[1].strip() for one in header if (found := _EVENT.match(one))), ""),
        station=station,
        start=next((moment(found[1]) for one in header if (found := _START.search(one))), ""),
        processing=_processing("\n".join(header)),
    )


def _channel(header: tuple[str, ...]) -> tuple[str, str, str]:
    """Return the channel's direction and number, and the station, named on the line before them."""
    for index, line in enumerate(header):
        found = _CHANNEL.match(line)
        if found:
            station = re.split(r"\s{2,}", header[index - 1].strip())[0] if index else ""
            return found[2], found[1], station
    return "", "?", ""


def _processing(text: str) -> str:
    corners = re.search(r"3 dB pts at\s*([\d.]+)\s*and\s*([\d.]+)", text)
    band = f"band-pass {corners[1]}-{corners[2]} Hz" if corners else "filter corners not stated"
    corrected = "instrument- and baseline-corrected" in text
    return f"{band}, {'instrument and baseline corrected' if corrected else 'correction not stated'} (header)"


CSMIP = RecordFormat(
    "CSMIP V2",
    "California Strong Motion Instrumentation Program and CESMD: corrected acceleration, channel after channel",
    _recognises,
    _read,
    "California Strong Motion Instrumentation Program (CSMIP), Center for Engineering Strong Motion Data (CESMD).",
)
