"""K-NET and KiK-net files of NIED, Japan: seventeen lines of header, then counts.

The acceleration is the count times the scale factor, ``7845(gal)/8223790``, and keeps the offset of the
instrument. KiK-net numbers the directions: 1 to 3 are NS, EW and UD in the borehole, 4 to 6 at the surface.
"""

import re

from dcfp.motion.formats.component import Component, build_component
from dcfp.motion.formats.numbers import (
    NUMBER,
    check_count,
    free_numbers,
    promised_count,
    required_number,
    required_text,
    to_number,
)
from dcfp.motion.formats.source import SourceText
from dcfp.motion.ground_motion import Origin

NAME = "K-NET/KiK-net"

_NAMES = (
    "Origin Time", "Lat.", "Long.", "Depth. (km)", "Mag.", "Station Code", "Station Lat.", "Station Long.",
    "Station Height(m)", "Record Time", "Sampling Freq(Hz)", "Duration Time(s)", "Dir.", "Scale Factor",
    "Max. Acc. (gal)", "Last Correction", "Memo.",
)  # fmt: skip

#: Label of each KiK-net direction code, and its other names.
_DIRECTIONS = {
    "1": ("NS1", "NS borehole"),
    "2": ("EW1", "EW borehole"),
    "3": ("UD1", "UD borehole"),
    "4": ("NS2", "NS", "NS surface"),
    "5": ("EW2", "EW", "EW surface"),
    "6": ("UD2", "UD", "UD surface"),
}


def recognises(source: SourceText) -> bool:
    """Whether the file begins with the time of origin, as all files of NIED do."""
    return source.lines[0].startswith("Origin Time") or any(
        line.startswith("Scale Factor") for line in source.lines[: len(_NAMES)]
    )


def read(source: SourceText) -> list[Component]:
    """Return the one component of the file.

    Raises
    ------
    InputError
        If the header is incomplete, or does not agree with the values.
    """
    header = _header(source)
    rate = required_number(source, header, "Sampling Freq(Hz)")
    promised = promised_count(source, rate, required_number(source, header, "Duration Time(s)"))
    counts = free_numbers(source, len(_NAMES))
    check_count(source, counts.size, promised)
    label, names = _direction(source, required_text(source, header, "Dir."))
    origin = Origin(
        event=f"{header['Origin Time']}, M {header['Mag.']}".strip(" ,M"),
        station=header["Station Code"],
        component=label,
        source=source.path.name,
        file_format=NAME,
        processing="raw counts times the scale factor; offset not removed",
        citation="National Research Institute for Earth Science and Disaster Resilience (NIED), Japan.",
    )
    return [
        build_component(
            source,
            counts,
            unit="gal",
            scale=_scale(source, header),
            time_step=1.0 / rate,
            origin=origin,
            names=names,
            several=True,
        )
    ]


def _header(source: SourceText) -> dict[str, str]:
    header: dict[str, str] = {}
    for number, name in enumerate(_NAMES, 1):
        line = source.lines[number - 1] if number <= len(source.lines) else ""
        if not line.startswith(name):
            source.fail(f"the header entry {name!r} was expected; the file is damaged.", line=number)
        header[name] = line[len(name) :].strip()
    return header


def _scale(source: SourceText, header: dict[str, str]) -> float:
    text = header["Scale Factor"]
    found = re.fullmatch(rf"({NUMBER})\s*\(gal\)\s*/\s*({NUMBER})", text)
    top, bottom = (to_number(found[1]), to_number(found[2])) if found else (None, None)
    if not top or not bottom or not 1e-12 < abs(top / bottom) < 1e3:
        source.fail(f"the scale factor is {text[:40]!r}; one like '7845(gal)/8223790' was expected.", line=14)
    return top / bottom


def _direction(source: SourceText, text: str) -> tuple[str, tuple[str, ...]]:
    if text in _DIRECTIONS:
        label, *names = _DIRECTIONS[text]
        return label, (text, *names)
    if text not in {"N-S", "E-W", "U-D"}:
        source.fail(f"the direction is {text[:30]!r}; N-S, E-W, U-D or 1 to 6 was expected.", line=13)
    return text, ()
