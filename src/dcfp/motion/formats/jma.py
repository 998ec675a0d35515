"""Strong-motion CSV of the Japan Meteorological Agency: lines of header, then NS, EW, UD side by side.

The text is Shift-JIS. The header gives the sampling rate and the unit but no number of values.
"""

import re

from dcfp.motion.formats.registry import RecordFormat, Series
from dcfp.motion.formats.source import Header, SourceText, moment, table_numbers

_HEADER_LINES = 12


def _recognises(source: SourceText) -> bool:
    """Whether the first lines give the site code and the sampling rate in JMA's words."""
    text = "\n".join(source.lines[:_HEADER_LINES])
    return "SITE CODE" in text and "SAMPLING RATE" in text


def _read(source: SourceText) -> list[Series]:
    titles_line, titles = _titles(source)
    header = Header.of_lines(source, source.lines[:titles_line], "=")
    unit = header.unit("UNIT", "gal(cm/s/s)")
    rate = header.number("SAMPLING RATE")
    table = table_numbers(source, titles_line + 1, len(titles), ",")
    begun = header.get("INITIAL TIME", "")
    return [
        Series(
            table[:, column],
            unit,
            1.0 / rate,
            component=title,
            event=f"record of {begun}" if begun else "",
            station=re.split(r",|\s{2,}", header.get("SITE CODE", ""))[0].strip(),
            start=moment(begun, 9),
            processing="as recorded; offset not removed",
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


JMA = RecordFormat(
    "JMA CSV",
    "Japan Meteorological Agency: strong-motion CSV, NS, EW and UD as recorded",
    _recognises,
    _read,
    "Japan Meteorological Agency.",
)
