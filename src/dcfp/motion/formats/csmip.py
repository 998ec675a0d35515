"""CSMIP/CESMD volume 2 files: corrected acceleration, velocity and displacement, channel after channel.

Each block is announced by a line such as ``12000 points of accel data equally spaced at .005 sec, in cm/sec2.
(8f10.6)``; its fields have a fixed width and run together. Only the acceleration is returned, but all blocks
are counted, so that a truncated file is noticed.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from dcfp.arrays import FloatArray
from dcfp.motion.formats.component import Component, build_component, canonical_unit
from dcfp.motion.formats.numbers import NUMBER, fixed_numbers, parse_layout, to_number
from dcfp.motion.formats.source import SourceText
from dcfp.motion.ground_motion import Origin

NAME = "CSMIP V2"

_BLOCK = re.compile(
    rf"^\s*(\d{{1,15}})\s+points of\s+(\w+) data equally spaced at\s*({NUMBER})\s*sec(.*)$", re.IGNORECASE
)
_CHANNEL = re.compile(r"^Chan\s+(\d+):\s*(.*?)\s*$", re.IGNORECASE)
_EVENT = re.compile(r"^(?:Record|Rcrd) of\s+(.*?)(?:\s{2,}|\(|$)", re.IGNORECASE)


@dataclass(frozen=True)
class _Block:
    quantity: str
    header: tuple[str, ...]
    line: int
    time_step: float
    values: FloatArray


def recognises(source: SourceText) -> bool:
    """Whether a line announces a block of acceleration in CSMIP's words."""
    return any("points of accel data" in line.lower() for line in source.lines)


def read(source: SourceText) -> list[Component]:
    """Return the acceleration of every channel.

    Raises
    ------
    InputError
        If a header is incomplete, or does not agree with its values.
    """
    blocks = [_acceleration(source, first, last) for first, last in _channels(source)]
    return [_component(source, block, several=len(blocks) > 1) for block in blocks]


def _channels(source: SourceText) -> Iterator[tuple[int, int]]:
    """Yield the first line of each channel and the line that ends it."""
    first = 0
    for index, line in enumerate(source.lines):
        if line.startswith("/&"):
            yield first, index
            first = index + 1
    if first < len(source.lines):
        source.fail("the channel that begins here has no end ('/&'); the file is truncated.", line=first + 1)


def _acceleration(source: SourceText, first: int, last: int) -> _Block:
    """Read all blocks of a channel, and return the one of acceleration."""
    found: list[_Block] = []
    line = first
    while line < last:
        announced = _BLOCK.match(source.lines[line])
        if announced:
            block, line = _block(source, announced, line, source.lines[first:line])
            found.append(block)
        else:
            line += 1
    accelerations = [block for block in found if block.quantity == "accel"]
    if len(accelerations) != 1:
        source.fail(
            f"the channel that begins here has {len(accelerations)} blocks of acceleration instead of one.",
            line=first + 1,
        )
    return accelerations[0]


def _block(
    source: SourceText, found: re.Match[str], line: int, header: tuple[str, ...]
) -> tuple[_Block, int]:
    layout = parse_layout(found[4])
    time_step = to_number(found[3])
    if layout is None or time_step is None:
        source.fail("the block needs a time step and a format such as '(8f10.6)'.", line=line + 1)
    values, after = fixed_numbers(source, line + 1, int(found[1]), layout)
    if after < len(source.lines) and not re.search("[A-Za-z]{2}|/&", source.lines[after]):
        source.fail(f"more values stand here than the {found[1]} that were promised.", line=after + 1)
    return _Block(found[2].lower(), header, line, time_step, values), after


def _component(source: SourceText, block: _Block, *, several: bool) -> Component:
    text = source.lines[block.line]
    named = re.search(r"(?:\bin\b|units?\s*:)\s*([a-z/0-9^]+)", text, re.IGNORECASE)
    unit = canonical_unit(named[1]) if named else None
    if unit is None:
        source.fail("the block names no known unit; 'in cm/sec2' was expected.", line=block.line + 1)
    channel, number, station = _channel(block.header)
    label = channel or f"channel {number}"
    origin = Origin(
        event=_first(_EVENT, block.header),
        station=station,
        component=label,
        source=source.path.name,
        file_format=NAME,
        processing=_processing(block.header),
        citation="California Strong Motion Instrumentation Program (CSMIP), Center for Engineering Strong "
        "Motion Data (CESMD).",
    )
    azimuth = re.sub(r"\s*deg$", "", label, flags=re.IGNORECASE)
    names = (number, f"chan {number}", f"channel {number}", azimuth)
    return build_component(
        source,
        block.values,
        unit=unit,
        time_step=block.time_step,
        origin=origin,
        names=names,
        several=several,
    )


def _channel(header: tuple[str, ...]) -> tuple[str, str, str]:
    """Return the channel's direction and number, and the station, named on the line before them."""
    for index, line in enumerate(header):
        found = _CHANNEL.match(line)
        if found:
            station = re.split(r"\s{2,}", header[index - 1].strip())[0] if index else ""
            return found[2], found[1], station
    return "", "?", ""


def _first(pattern: re.Pattern[str], lines: tuple[str, ...]) -> str:
    return next((found[1].strip() for line in lines if (found := pattern.match(line))), "")


def _processing(header: tuple[str, ...]) -> str:
    text = "\n".join(header)
    corners = re.search(r"3 dB pts at\s*([\d.]+)\s*and\s*([\d.]+)", text)
    band = f"band-pass {corners[1]}-{corners[2]} Hz" if corners else "filter corners not stated"
    corrected = "instrument- and baseline-corrected" in text
    return f"{band}, {'instrument and baseline corrected' if corrected else 'correction not stated'} (header)"
