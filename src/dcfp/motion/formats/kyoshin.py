"""K-NET and KiK-net files of NIED, Japan: seventeen lines of header, then counts.

The acceleration is the count times the scale factor, ``7845(gal)/8223790``, and keeps the offset of the
instrument. KiK-net numbers the directions: 1 to 3 are NS, EW and UD in the borehole, 4 to 6 at the surface.
The time of the record is 15 s later than its first value.
"""

import re

from dcfp.motion.formats.registry import RecordFormat, Series
from dcfp.motion.formats.source import NUMBER, Header, SourceText, free_numbers, moment, to_number

_NAMES = (
    "Origin Time", "Lat.", "Long.", "Depth. (km)", "Mag.", "Station Code", "Station Lat.", "Station Long.",
    "Station Height(m)", "Record Time", "Sampling Freq(Hz)", "Duration Time(s)", "Dir.", "Scale Factor",
    "Max. Acc. (gal)", "Last Correction", "Memo.",
)  # fmt: skip

#: How much later the time of the record is than its first value [s], and Japan's time than UTC [h].
_DELAY, _JAPAN = 15.0, 9
#: Label of each direction, by its code in the header, and its other names.
_DIRECTIONS = {
    "N-S": ("N-S",),
    "E-W": ("E-W",),
    "U-D": ("U-D",),
    "1": ("NS1", "NS borehole", "1"),
    "2": ("EW1", "EW borehole", "2"),
    "3": ("UD1", "UD borehole", "3"),
    "4": ("NS2", "NS", "NS surface", "4"),
    "5": ("EW2", "EW", "EW surface", "5"),
    "6": ("UD2", "UD", "UD surface", "6"),
}


def _recognises(source: SourceText) -> bool:
    """Whether the file begins with the time of origin, as all files of NIED do."""
    return source.lines[0].startswith("Origin Time") or any(
        line.startswith("Scale Factor") for line in source.lines[: len(_NAMES)]
    )


def _read(source: SourceText) -> list[Series]:
    for number, (name, line) in enumerate(zip(_NAMES, [*source.lines, *_NAMES], strict=False), 1):
        if number > len(source.lines) or not line.startswith(name):
            source.fail(f"the header entry {name!r} was expected; the file is damaged.", line=number)
    header = Header(
        source,
        ((name, line.removeprefix(name)) for name, line in zip(_NAMES, source.lines, strict=False)),
    )
    rate = header.number("Sampling Freq(Hz)")
    promised = header.count("Sampling Freq(Hz)", "Duration Time(s)")
    counts = free_numbers(source, len(_NAMES), promised)
    direction = header.text("Dir.")
    if direction not in _DIRECTIONS:
        source.fail(f"the direction is {direction[:30]!r}; N-S, E-W, U-D or 1 to 6 was expected.", line=13)
    component, *names = _DIRECTIONS[direction]
    return [
        Series(
            counts,
            unit="gal",
            scale=_scale(source, header["Scale Factor"]),
            time_step=1.0 / rate,
            component=component,
            names=tuple(names),
            event=f"{header['Origin Time']}, M {header['Mag.']}".strip(" ,M"),
            station=header["Station Code"],
            start=moment(header["Record Time"], _JAPAN, -_DELAY),
            processing="raw counts times the scale factor; offset not removed",
        )
    ]


def _scale(source: SourceText, text: str) -> float:
    found = re.fullmatch(rf"({NUMBER})\s*\(gal\)\s*/\s*({NUMBER})", text)
    top, bottom = (to_number(found[1]), to_number(found[2])) if found else (None, None)
    if not top or not bottom or not 1e-12 < abs(top / bottom) < 1e3:
        source.fail(f"the scale factor is {text[:40]!r}; one like '7845(gal)/8223790' was expected.", line=14)
    return top / bottom


NIED = RecordFormat(
    "K-NET/KiK-net",
    "NIED, Japan: raw counts of one component, the directions of KiK-net numbered",
    _recognises,
    _read,
    "National Research Institute for Earth Science and Disaster Resilience (NIED), Japan.",
    one_of_several=True,
)
