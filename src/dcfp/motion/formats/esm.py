"""ASCII files of the European Strong Motion database (ESM, ITACA): ``DYNA`` headers, one value a line."""

import re
from itertools import takewhile

from dcfp.motion.formats.registry import RecordFormat, Series
from dcfp.motion.formats.source import Header, SourceText, canonical_unit, free_numbers, moment

_ENTRY = re.compile(r"([A-Z][A-Z0-9_/^.]*):\s?(.*)")
_HEADER_LINES = 200


def _recognises(source: SourceText) -> bool:
    """Whether the header names a DYNA format, or has the entries that only such headers have."""
    text = "\n".join(source.lines[:_HEADER_LINES])
    return "HEADER_FORMAT: DYNA" in text or "SAMPLING_INTERVAL_S:" in text


def _read(source: SourceText) -> list[Series]:
    entries = list(takewhile(bool, map(_ENTRY.fullmatch, source.lines)))
    header = Header(source, ((entry[1], entry[2]) for entry in entries if entry))
    quantity = header.get("DATA_TYPE", "ACCELERATION").upper()
    unit = canonical_unit(header.text("UNITS"))
    if quantity != "ACCELERATION" or unit is None:
        source.fail(
            f"the values are {quantity.lower()} in {header['UNITS'][:20]}; acceleration was expected, as in "
            "an .ACC.ASC file."
        )
    stream = header.get("STREAM", "")
    return [
        Series(
            free_numbers(source, len(entries), int(header.number("NDATA"))),
            unit,
            header.number("SAMPLING_INTERVAL_S"),
            component=stream,
            names=(stream[-1:],),
            event=_event(header),
            station=header.get("STATION_CODE", ""),
            start=moment(header.get("DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS", "")),
            processing=_processing(header),
            citation=header.get("DATA_CITATION", ""),
        )
    ]


def _event(header: Header) -> str:
    magnitude = header.get("MAGNITUDE_W") or header.get("MAGNITUDE_L")
    parts = (
        header.get("EVENT_NAME"),
        header.get("EVENT_DATE_YYYYMMDD"),
        f"M {magnitude}" if magnitude else "",
    )
    return ", ".join(part for part in parts if part)


def _processing(header: Header) -> str:
    low, high = header.get("LOW_CUT_FREQUENCY_HZ"), header.get("HIGH_CUT_FREQUENCY_HZ")
    kind, order = header.get("FILTER_TYPE", "").capitalize(), header.get("FILTER_ORDER", "")
    baseline = header.get("BASELINE_CORRECTION", "").lower()
    band = f"band-pass {low}-{high} Hz ({kind}, order {order})" if low and high else "no filter stated"
    return f"{band}, {baseline or 'no baseline correction stated'} (header)"


ESM = RecordFormat(
    "ESM ASCII",
    "European Strong Motion database and ITACA: one component of acceleration",
    _recognises,
    _read,
    "Engineering Strong-Motion database (ESM).",
)
