"""COSMOS strong-motion format 1.20, volumes 1 and 2.

Each channel has text, integer and real headers, comments and one series; the widths of all fields are
written in the file. Integer header 54 is where the sensor points. Real header 62 is the time step of the
series [ms]. Real header 34 is that of the recorder [s]; it differs when the series was resampled, so it is
used only where 62 is not given.

Reference: Consortium of Organizations for Strong-Motion Observation Systems (2001), COSMOS Strong Motion Data
Format, version 1.20.
"""

import re
from collections.abc import Sequence
from contextlib import suppress

from dcfp.arrays import FloatArray
from dcfp.errors import InputError
from dcfp.motion.formats.directions import azimuth, direction
from dcfp.motion.formats.registry import RecordFormat, Series
from dcfp.motion.formats.source import (
    NUMBER,
    SourceText,
    announced_numbers,
    canonical_unit,
    fixed_numbers,
    moment,
    parse_layout,
    to_number,
)

_INTEGER_HEADER = re.compile(
    r"^\s*(\d{1,4})\s+Integer-header values follow on.*?Format\s*=\s*(.*)$", re.IGNORECASE
)
_REAL_HEADER = re.compile(r"^\s*(\d{1,4})\s+Real-header values follow on.*?Format\s*=\s*(.*)$", re.IGNORECASE)
_SERIES = re.compile(
    rf"^\s*(\d{{1,15}})\s+(\w+)\s+pts,\s*approx\s*({NUMBER})\s*secs?,\s*units\s*=\s*([^,(]+?)\s*(?:\((\d+)\))?\s*,"
    r"\s*Format\s*=\s*(.*)$",
    re.IGNORECASE,
)
_END = re.compile(r"^\s*(?:/&|End-of-data)", re.IGNORECASE)

_SERIES_STEP = 62 - 1
_RECORDER_STEP = 34 - 1

_SENSOR = 54 - 1
#: Codes of a vertical sensor in place of degrees from north.
_VERTICAL = {400: "Up", 401: "Down", 402: "Vertical"}
#: Series that a volume 2 file may hold beside the acceleration.
_LEFT_OUT = frozenset({"velocity", "displacement"})

#: Table 2 of the format: the codes of units of acceleration.
_UNIT_CODES = {2: "g", 4: "cm/s2"}


def _recognises(source: SourceText) -> bool:
    """Whether the first line names the format, or a line announces the real headers in its words."""
    return "(Format v" in source.lines[0] or any(
        "real-header values follow" in line.lower() for line in source.lines
    )


def _read(source: SourceText) -> list[Series]:
    """Return the acceleration of every channel; velocity and displacement are checked and left out."""
    announced = [(index, found) for index, line in enumerate(source.lines) if (found := _SERIES.match(line))]
    series: list[Series] = []
    after = 0
    for start, found in announced:
        first = after
        values, after = announced_numbers(source, start, int(found[1]), found[6])
        if after < len(source.lines) and _END.match(source.lines[after]):
            after += 1
        if found[2].lower() not in _LEFT_OUT:
            series.append(_series(source, first, start, found, values, len(series) + 1))
    if after < len(source.lines):
        source.fail(
            "the channel that begins here has no series ('acceleration pts, approx'); the file is truncated.",
            line=after + 1,
        )
    if not series:
        source.fail("the file holds no acceleration; give the file of corrected acceleration.")
    return series


def _series(
    source: SourceText, first: int, start: int, found: re.Match[str], values: FloatArray, number: int
) -> Series:
    header = source.lines[first:start]
    label, *names = _channel_names(header, number)
    if direction(label) is None and azimuth(label) is None and (sensor := _sensor(source, first, start)):
        label, names = sensor, [label, *names]
    station = next(filter(None, map(_STATION.match, header)), None)
    return Series(
        values,
        _unit(source, found, start),
        _time_step(source, _real_header(source, first, start), found, start),
        component=label,
        names=tuple(names),
        event=" ".join(header[1].split()).removeprefix("Record of ") if len(header) > 1 else "",
        station=" ".join(f"{station[1]} {station[2]}".split()) if station else "",
        start=next((moment(begun[1]) for one in header if (begun := _START.match(one))), ""),
        processing=_processing(header),
    )


def _unit(source: SourceText, found: re.Match[str], line: int) -> str:
    unit = canonical_unit(found[4])
    if unit is None or found[2].lower() != "acceleration":
        source.fail(
            f"the series is {found[2].lower()} in {found[4][:20]}; acceleration in cm/s2 or g was expected "
            "(volume 1 or 2).",
            line=line + 1,
        )
    coded = _UNIT_CODES.get(int(found[5])) if found[5] and len(found[5]) < 4 else None
    if found[5] and coded != unit.replace("gal", "cm/s2"):
        source.fail(f"the unit {found[4]} contradicts its code {found[5][:6]}.", line=line + 1)
    return unit


def _real_header(source: SourceText, first: int, last: int) -> FloatArray:
    found = [index for index in range(first, last) if _REAL_HEADER.match(source.lines[index])]
    if len(found) != 1:
        source.fail(
            f"the channel that begins here has {len(found)} real headers instead of one.", line=first + 1
        )
    announced = _REAL_HEADER.match(source.lines[found[0]])
    layout = parse_layout(announced[2]) if announced else None
    if announced is None or layout is None:
        source.fail("the real header needs a format such as '(6F13.6)'.", line=found[0] + 1)
    return fixed_numbers(source, found[0] + 1, int(announced[1]), layout)[0]


def _time_step(source: SourceText, real: FloatArray, found: re.Match[str], line: int) -> float:
    if real.size <= _SERIES_STEP:
        source.fail(f"the real header has {real.size} values; at least {_SERIES_STEP + 1} were expected.")
    series, recorder = float(real[_SERIES_STEP]), float(real[_RECORDER_STEP])
    # A number that is not known is written as -999, or as another negative number that the file names.
    step = series / 1000.0 if series > 0.0 else recorder
    duration = int(found[1]) * step
    stated = to_number(found[3])
    # The duration on this line is rounded, by some agencies down; it still tells 5 ms from 20 ms.
    if stated is None or not 0.9 * stated - 1.0 <= duration <= 1.1 * stated + 1.0:
        source.fail(
            f"{found[1]} values at the header's time step of {step:g} s do not last the {found[3]} s "
            "that this line states.",
            line=line + 1,
        )
    return step


def _sensor(source: SourceText, first: int, last: int) -> str:
    """Return where the sensor points by the integer header, empty where it does not tell."""
    for index in range(first, last):
        announced = _INTEGER_HEADER.match(source.lines[index])
        layout = parse_layout(announced[2]) if announced else None
        if announced is None or layout is None:
            continue
        with suppress(InputError):  # nothing else needs it
            values, _ = fixed_numbers(source, index + 1, int(announced[1]), layout)
            code = int(values[_SENSOR]) if values.size > _SENSOR else -1
            return _VERTICAL.get(code, f"{code} deg" if 0 < code <= 360 else "")
    return ""


_CHANNEL = re.compile(r"^Sta Chan?\s*:?\s*(\d+|\?)\s*:\s*(.*?)\s*\(Rcrdr", re.IGNORECASE)
_CODES = re.compile(r"<SCNL>\s*([^\s.]*)\.([^\s.]+)\.")
_STATION = re.compile(r"^Statn No:.*?Code:\s*(\S*)\s*(.*?)\s*$", re.IGNORECASE)
_START = re.compile(r"^Rcrd start time:\s*(.*?UTC)", re.IGNORECASE)
_FILTER = re.compile(r"^Record filtered below\s*([\d.]+)\s*Hz.*?above\s*([\d.]+)\s*Hz", re.IGNORECASE)


def _channel_names(header: Sequence[str], index: int) -> tuple[str, ...]:
    """Return the names of a channel, the plainest first: direction, SEED code, number."""
    number, direction, code = "", "", ""
    for line in header:
        if found := _CHANNEL.match(line):
            number, direction = found[1].strip("?"), found[2]
        if found := _CODES.search(line):
            code = found[2]
    if direction.casefold() in {"other", "unknown"}:
        direction = ""
    number = number or str(index)
    names = (direction, code, f"channel {number}", f"chan {number}", number)
    return tuple(name for name in names if name)


def _processing(header: Sequence[str]) -> str:
    """Return what filter and correction the header states."""
    found = next((found for line in header if (found := _FILTER.match(line))), None)
    band = f"band-pass {found[1]}-{found[2]} Hz" if found else "no filter stated"
    title = header[0].casefold()
    if "uncorrected" in title:
        return f"{band}, uncorrected (header)"
    return f"{band}, {'corrected' if 'corrected' in title else 'correction not stated'} (header)"


COSMOS = RecordFormat(
    "COSMOS",
    "Consortium of Organizations for Strong-Motion Observation Systems, volumes 1 and 2: acceleration, channel after channel",
    _recognises,
    _read,
    "COSMOS; Center for Engineering Strong Motion Data.",
)
