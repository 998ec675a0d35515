"""Strong-motion CSV of the Japan Meteorological Agency: lines of header, then NS, EW, UD side by side.

The text is Shift-JIS. The header gives the sampling rate and the unit but no number of values.
"""

import re

from dcfp.motion.formats.component import Component, build_component, canonical_unit
from dcfp.motion.formats.numbers import required_number, required_text, table_numbers
from dcfp.motion.formats.source import SourceText
from dcfp.motion.ground_motion import Origin

NAME = "JMA CSV"

_HEADER_LINES = 12


def recognises(source: SourceText) -> bool:
    """Whether the first lines give the site code and the sampling rate in JMA's words."""
    text = "\n".join(source.lines[:_HEADER_LINES])
    return "SITE CODE" in text and "SAMPLING RATE" in text


def read(source: SourceText) -> list[Component]:
    """Return the components of the file, one for each column.

    Raises
    ------
    InputError
        If the header is incomplete, or a row is.
    """
    titles_line, titles = _titles(source)
    header = _header(source.lines[:titles_line])
    unit = canonical_unit(required_text(source, header, "UNIT"))
    if unit is None:
        source.fail(f"the unit is {header['UNIT'][:30]!r}; 'gal(cm/s/s)' was expected.")
    rate = required_number(source, header, "SAMPLING RATE")
    table = table_numbers(source, titles_line + 1, len(titles), ",")
    begun = header.get("INITIAL TIME", "")
    event = f"record of {begun}" if begun else ""
    station = re.split(r",|\s{2,}", header.get("SITE CODE", ""))[0].strip()
    return [
        build_component(
            source,
            table[:, column],
            unit=unit,
            time_step=1.0 / rate,
            origin=Origin(
                event=event,
                station=station,
                component=title,
                source=source.path.name,
                file_format=NAME,
                processing="as recorded; offset not removed",
                citation="Japan Meteorological Agency.",
            ),
            several=len(titles) > 1,
        )
        for column, title in enumerate(titles)
    ]


def _titles(source: SourceText) -> tuple[int, list[str]]:
    for index, line in enumerate(source.lines[:_HEADER_LINES]):
        words = [word.strip() for word in line.split(",")]
        if words and set(words) <= {"NS", "EW", "UD"}:
            if len(set(words)) < len(words):
                source.fail("a column stands twice; NS,EW,UD was expected.", line=index + 1)
            return index, words
    return source.fail("no line names the columns; 'NS,EW,UD' was expected.")


def _header(lines: tuple[str, ...]) -> dict[str, str]:
    parts = (line.split("=", 1) for line in lines if "=" in line)
    return {name.strip(): text.strip() for name, text in parts}
