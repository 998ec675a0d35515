"""Records of the Central Weather Bureau, Taiwan: ``#`` lines, then time, up, north and east."""

import re

from dcfp.motion.formats.registry import RecordFormat, Series, check_times
from dcfp.motion.formats.source import (
    Header,
    Layout,
    SourceText,
    check_count,
    fixed_numbers,
    moment,
    parse_layout,
)

_LAYOUT = Layout(per_line=4, width=10)


def _recognises(source: SourceText) -> bool:
    """Whether a comment line gives the sequence of the columns in CWB's words."""
    return any(line.lstrip().startswith("#DataSequence") for line in source.lines[:40])


def _read(source: SourceText) -> list[Series]:
    first = _first_row(source)
    lines = [re.sub(r"\(GMT.*?\)", "", line, count=1) for line in source.lines[:first]]
    header = Header.of_lines(source, lines, ":")
    directions = _directions(source, header.text("DataSequence"))
    unit = header.unit("AmplitudeUnit", "gal")
    rate = header.number("SampleRate(Hz)")
    rows = header.count("SampleRate(Hz)", "RecordLength(sec)")
    layout = parse_layout(header.get("Data", "")) or _LAYOUT
    if layout.per_line != len(directions) + 1:
        source.fail(f"the header names {len(directions) + 1} columns but its format has {layout.per_line}.")
    check_count(source, len(source.lines) - first, rows)
    values, _ = fixed_numbers(source, first, rows * layout.per_line, layout)
    table = values.reshape(rows, layout.per_line)
    check_times(source, table[:, 0], 1.0 / rate, resolution=0.001)
    magnitude = header.get("Magnitude(Ml)", "")
    event = header.get("Origin Time") or header.get("StartTime", "")
    note = "offset corrected (header)" if "(corr)" in header["AmplitudeUnit"] else "offset not removed"
    return [
        Series(
            table[:, column],
            unit,
            1.0 / rate,
            component=direction,
            event=f"{event}, ML {magnitude}" if magnitude else event,
            station=header.get("StationCode", ""),
            start=moment(header.get("StartTime", ""), 8),
            processing=f"{note}; no filter stated",
        )
        for column, direction in enumerate(directions, 1)
    ]


def _first_row(source: SourceText) -> int:
    for index, line in enumerate(source.lines):
        if line.strip() and not line.lstrip().startswith("#"):
            return index
    return len(source.lines)


def _directions(source: SourceText, text: str) -> list[str]:
    words = re.sub(r"\([+-]\)", "", text).replace(";", " ").split()
    directions = words[1:]
    known = set(directions) <= {"U", "N", "E"} and len(set(directions)) == len(directions) > 0
    if not known or words[0] != "Time":
        source.fail(f"the columns are {text[:40]!r}; 'Time U(+); N(+); E(+)' was expected.")
    return directions


CWB = RecordFormat(
    "CWB",
    "Central Weather Bureau, Taiwan: time, up, north and east",
    _recognises,
    _read,
    "Central Weather Bureau, Taiwan.",
    one_of_several=True,
)
