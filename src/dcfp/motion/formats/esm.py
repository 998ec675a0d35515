"""ASCII files of the European Strong Motion database (ESM, ITACA): ``DYNA`` headers, one value a line."""

import re

from dcfp.motion.formats.component import Component, build_component, canonical_unit
from dcfp.motion.formats.numbers import check_count, free_numbers, required_number, required_text
from dcfp.motion.formats.source import SourceText
from dcfp.motion.ground_motion import Origin

NAME = "ESM ASCII"

_ENTRY = re.compile(r"([A-Z][A-Z0-9_/^.]*):\s?(.*)")
_HEADER_LINES = 200


def recognises(source: SourceText) -> bool:
    """Whether the header names a DYNA format, or has the entries that only such headers have."""
    text = "\n".join(source.lines[:_HEADER_LINES])
    return "HEADER_FORMAT: DYNA" in text or "SAMPLING_INTERVAL_S:" in text


def read(source: SourceText) -> list[Component]:
    """Return the one component of the file.

    Raises
    ------
    InputError
        If the header is incomplete, does not agree with the values, or the values are not acceleration.
    """
    header, first = _header(source)
    quantity = header.get("DATA_TYPE", "ACCELERATION").strip().upper()
    unit = canonical_unit(required_text(source, header, "UNITS"))
    if quantity != "ACCELERATION" or unit is None:
        source.fail(
            f"the values are {quantity.lower()} in {header['UNITS'][:20]}; acceleration was expected, as in "
            "an .ACC.ASC file."
        )
    values = free_numbers(source, first)
    check_count(source, values.size, int(required_number(source, header, "NDATA")))
    stream = header.get("STREAM", "").strip()
    origin = Origin(
        event=_event(header),
        station=header.get("STATION_CODE", "").strip(),
        component=stream,
        source=source.path.name,
        file_format=NAME,
        processing=_processing(header),
        citation=header.get("DATA_CITATION", "").strip() or "Engineering Strong-Motion database (ESM).",
    )
    time_step = required_number(source, header, "SAMPLING_INTERVAL_S")
    return [
        build_component(source, values, unit=unit, time_step=time_step, origin=origin, names=(stream[-1:],))
    ]


def _header(source: SourceText) -> tuple[dict[str, str], int]:
    header: dict[str, str] = {}
    for index, line in enumerate(source.lines):
        entry = _ENTRY.fullmatch(line)
        if entry is None:
            return header, index
        header[entry[1]] = entry[2]
    return header, len(source.lines)


def _event(header: dict[str, str]) -> str:
    magnitude = header.get("MAGNITUDE_W", "").strip() or header.get("MAGNITUDE_L", "").strip()
    parts = (
        header.get("EVENT_NAME", "").strip(),
        header.get("EVENT_DATE_YYYYMMDD", "").strip(),
        f"M {magnitude}" if magnitude else "",
    )
    return ", ".join(part for part in parts if part)


def _processing(header: dict[str, str]) -> str:
    low = header.get("LOW_CUT_FREQUENCY_HZ", "").strip()
    high = header.get("HIGH_CUT_FREQUENCY_HZ", "").strip()
    kind = header.get("FILTER_TYPE", "").strip().capitalize()
    order = header.get("FILTER_ORDER", "").strip()
    baseline = header.get("BASELINE_CORRECTION", "").strip().lower()
    band = f"band-pass {low}-{high} Hz ({kind}, order {order})" if low and high else "no filter stated"
    return f"{band}, {baseline or 'no baseline correction stated'} (header)"
