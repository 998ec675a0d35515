"""Records of the Central Weather Bureau, Taiwan: ``#`` lines, then time, up, north and east."""

import re

from dcfp.motion.formats.component import Component, build_component, canonical_unit, check_times
from dcfp.motion.formats.numbers import (
    Layout,
    check_count,
    fixed_numbers,
    parse_layout,
    promised_count,
    required_number,
    required_text,
)
from dcfp.motion.formats.source import SourceText
from dcfp.motion.ground_motion import Origin

NAME = "CWB"

_LAYOUT = Layout(per_line=4, width=10)


def recognises(source: SourceText) -> bool:
    """Whether a comment line gives the sequence of the columns in CWB's words."""
    return any(line.lstrip().startswith("#DataSequence") for line in source.lines[:40])


def read(source: SourceText) -> list[Component]:
    """Return the components of the file, one for each column after the time.

    Raises
    ------
    InputError
        If the header is incomplete, or does not agree with the values.
    """
    first = _first_row(source)
    header = _header(source.lines[:first])
    directions = _directions(source, required_text(source, header, "DataSequence"))
    unit = canonical_unit(re.split(r"\.?\s", required_text(source, header, "AmplitudeUnit"))[0])
    if unit is None:
        source.fail(f"the unit is {header['AmplitudeUnit'][:30]!r}; 'gal' was expected.")
    rate = required_number(source, header, "SampleRate(Hz)")
    rows = promised_count(source, rate, required_number(source, header, "RecordLength(sec)"))
    layout = parse_layout(header.get("Data", "")) or _LAYOUT
    if layout.per_line != len(directions) + 1:
        source.fail(f"the header names {len(directions) + 1} columns but its format has {layout.per_line}.")
    check_count(source, len(source.lines) - first, rows)
    values, _ = fixed_numbers(source, first, rows * layout.per_line, layout)
    table = values.reshape(rows, layout.per_line)
    check_times(source, table[:, 0], 1.0 / rate, resolution=0.001)
    return [
        build_component(
            source,
            table[:, column],
            unit=unit,
            time_step=1.0 / rate,
            origin=_origin(source, header, direction),
            several=True,
        )
        for column, direction in enumerate(directions, 1)
    ]


def _first_row(source: SourceText) -> int:
    for index, line in enumerate(source.lines):
        if line.strip() and not line.lstrip().startswith("#"):
            return index
    return len(source.lines)


def _header(lines: tuple[str, ...]) -> dict[str, str]:
    parts = (line.strip().lstrip("#").split(":", 1) for line in lines if ":" in line)
    return {re.sub(r"\(GMT.*\)", "", name).strip(): text.strip() for name, text in parts}


def _directions(source: SourceText, text: str) -> list[str]:
    words = re.sub(r"\([+-]\)", "", text).replace(";", " ").split()
    directions = words[1:]
    known = set(directions) <= {"U", "N", "E"} and len(set(directions)) == len(directions) > 0
    if not known or words[0] != "Time":
        source.fail(f"the columns are {text[:40]!r}; 'Time U(+); N(+); E(+)' was expected.")
    return directions


def _origin(source: SourceText, header: dict[str, str], direction: str) -> Origin:
    magnitude = header.get("Magnitude(Ml)", "")
    event = header.get("Origin Time") or header.get("StartTime", "")
    note = "offset corrected (header)" if "(corr)" in header["AmplitudeUnit"] else "offset not removed"
    return Origin(
        event=f"{event}, ML {magnitude}" if magnitude else event,
        station=header.get("StationCode", ""),
        component=direction,
        source=source.path.name,
        file_format=NAME,
        processing=f"{note}; no filter stated",
        citation="Central Weather Bureau, Taiwan.",
    )
