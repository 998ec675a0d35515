"""What the lines of text at the head of a COSMOS channel say, in words."""

import re
from collections.abc import Sequence

_CHANNEL = re.compile(r"^Sta Chan?\s*:?\s*(\d+|\?)\s*:\s*(.*?)\s*\(Rcrdr", re.IGNORECASE)
_CODES = re.compile(r"<SCNL>\s*([^\s.]*)\.([^\s.]+)\.")
_STATION = re.compile(r"^Statn No:.*?Code:\s*(\S*)\s*(.*?)\s*$", re.IGNORECASE)
_FILTER = re.compile(r"^Record filtered below\s*([\d.]+)\s*Hz.*?above\s*([\d.]+)\s*Hz", re.IGNORECASE)


def channel_names(header: Sequence[str], index: int) -> tuple[str, ...]:
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


def station(header: Sequence[str]) -> str:
    """Return the station's code and name."""
    found = next((found for line in header if (found := _STATION.match(line))), None)
    return " ".join(f"{found[1]} {found[2]}".split()) if found else ""


def event(header: Sequence[str]) -> str:
    """Return the line that names the event, the second of the header."""
    return " ".join(header[1].split()).removeprefix("Record of ") if len(header) > 1 else ""


def processing(header: Sequence[str]) -> str:
    """Return what filter and correction the header states."""
    found = next((found for line in header if (found := _FILTER.match(line))), None)
    band = f"band-pass {found[1]}-{found[2]} Hz" if found else "no filter stated"
    title = header[0].casefold()
    if "uncorrected" in title:
        return f"{band}, uncorrected (header)"
    return f"{band}, {'corrected' if 'corrected' in title else 'correction not stated'} (header)"
