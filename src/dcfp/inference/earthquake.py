"""Of which earthquake a motion is, by the name and the date that its source gives in whatever form."""

import re
from contextlib import suppress
from dataclasses import dataclass
from datetime import date
from functools import cache

import numpy as np

from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station

#: Largest difference of the same sample in two files, over the peak [-].
_SAME_SAMPLES = 1e-3
#: How far the same moment may be apart by date, for the time zones [d].
_SAME_DAY = 1
#: First year of the century that a year of two digits is of: no record is older.
_FIRST_YEAR = 1930

_MONTHS = ("jan", "feb", "mar", "apr", "may", "jun", "jul", "aug", "sep", "oct", "nov", "dec")
_YEAR = re.compile(r"(?<!\d)(?:19|20)\d\d(?!\d)")
#: Dates as sources write them: year first, in eight digits, month (or day) first, month in words.
_DATES = (
    re.compile(r"(?<!\d)(?P<year>\d{4})[-/.](?P<month>\d\d?)[-/.](?P<day>\d\d?)(?!\d)"),
    re.compile(r"(?<!\d)(?P<year>(?:19|20)\d\d)(?P<month>\d\d)(?P<day>\d\d)(?!\d)"),
    re.compile(r"(?<![\d/])(?P<month>\d\d?)/(?P<day>\d\d?)/(?P<year>\d{4}|\d\d)(?![\d/])"),
    re.compile(rf"\b(?P<word>{'|'.join(_MONTHS)})[a-z]*\.? (?P<day>\d\d?),? ?(?P<year>\d{{4}})\b"),
    re.compile(rf"\b(?P<day>\d\d?)[ -](?P<word>{'|'.join(_MONTHS)})[a-z]*\.?[ ,-]+(?P<year>\d{{4}})\b"),
)
#: Words that are in the names of many earthquakes, or that are no name.
_COMMON = re.compile(
    "earthquake|aftershock|record|rcrd|number|test|of|the|and|near|off|coast|sea|bay|lake|cape|san|santa|los|valley|hills?|mountains?|peak|city|island|region"
    "|north|south|east|west|central|northern|southern|eastern|western|utc|gmt|jst|p[ds]t|sun|mon|tue|wed|thu|fri|sat"
    "|japan|taiwan|turkey|italy|iran|usa|ussr|canada|california|alaska|mexico|chile|new|zealand|greece"
)
#: Other names of the earthquakes below.
_OTHER_NAMES = {
    "chichi": "chi", "jiji": "chi", "hyogo": "kobe", "hyogoken": "kobe", "hanshin": "kobe", "nanbu": "kobe", "nambu": "kobe",
    "izmit": "kocaeli", "marmara": "kocaeli", "rudbar": "manjil", "erzincan": "erzican",
}  # fmt: skip
#: The earthquakes of FEMA P-695, whose records have the year only, under one name where its sets have two, and their date (UTC).
_KNOWN = {
    "San Fernando 1971": date(1971, 2, 9),
    "Friuli, Italy 1976": date(1976, 5, 6),
    "Gazli, USSR 1976": date(1976, 5, 17),
    "Imperial Valley 1979": date(1979, 10, 15),
    "Irpinia, Italy 1980": date(1980, 11, 23),
    "Nahanni, Canada 1985": date(1985, 12, 23),
    "Superstition Hills 1987": date(1987, 11, 24),
    "Loma Prieta 1989": date(1989, 10, 18),
    "Manjil, Iran 1990": date(1990, 6, 20),
    "Erzican, Turkey 1992": date(1992, 3, 13),
    "Cape Mendocino 1992": date(1992, 4, 25),
    "Landers 1992": date(1992, 6, 28),
    "Northridge 1994": date(1994, 1, 17),
    "Kobe, Japan 1995": date(1995, 1, 16),
    "Kocaeli, Turkey 1999": date(1999, 8, 17),
    "Chi-Chi, Taiwan 1999": date(1999, 9, 20),
    "Hector Mine 1999": date(1999, 10, 16),
    "Duzce, Turkey 1999": date(1999, 11, 12),
    "Denali, Alaska 2002": date(2002, 11, 3),
}


@dataclass(frozen=True)
class Earthquake:
    """What a source says of an earthquake, as far as it does: words of its name, and year and day (UTC or local)."""

    names: frozenset[str] = frozenset()
    year: int | None = None
    day: date | None = None

    @property
    def is_known(self) -> bool:
        """Whether that suffices to find other records of it."""
        return bool(self.names) or self.year is not None

    def may_be(self, other: "Earthquake") -> bool:
        """Whether both may be the same; to say so of one too many is the safer mistake, so that aftershocks of a year are the same.

        With two names they have a word in common; and the year is the same, as far as both are known. Without the two names it is the day that is the same, or
        where one has the year only the year.
        """
        named = bool(self.names and other.names)
        if named and not self.names & other.names:
            return False
        if self.year is None or other.year is None:
            return named
        if not named and self.day is not None and other.day is not None:
            return abs((self.day - other.day).days) <= _SAME_DAY
        return self.year == other.year


@cache
def read_earthquake(event: str) -> Earthquake:
    """Return what the name of an event says: ``"CHI-CHI 09/20/99"``, ``"Kobe, Japan 1995"``, ``"2000/10/06 13:30:00, M 7.3"``."""
    text = event.lower()
    day: date | None = None
    for form in _DATES:
        if day is None and (found := form.search(text)) is not None:
            day = _day(found)
            text = text if day is None else text.replace(found.group(), " ")
    years = _YEAR.findall(text)
    words: list[str] = [word for word in re.findall(r"[a-z]{3,}", text) if not _COMMON.fullmatch(word)]
    names = frozenset(_OTHER_NAMES.get(word, word) for word in words)
    year = day.year if day is not None else int(years[0]) if years else None
    return Earthquake(names, year, _KNOWN.get(event, day))


def _day(found: re.Match[str]) -> date | None:
    """Return the day that was found, None where there is no such; day before month where the month would be above 12."""
    parts = found.groupdict()
    year, day = int(parts["year"]), int(parts["day"])
    month = _MONTHS.index(parts["word"]) + 1 if parts.get("word") else int(parts["month"])
    if year < 100:
        year += 1900 if 1900 + year >= _FIRST_YEAR else 2000
    for one, other in ((month, day), (day, month)):
        with suppress(ValueError):
            return date(year, one, other)
    return None


def earthquake_of(motion: GroundMotion | Station) -> Earthquake:
    """Return what the source of a motion says of its earthquake; the day of the record where it says no other."""
    said = read_earthquake(motion.origin.event)
    if said.day is None and motion.origin.start:
        day = date.fromisoformat(motion.origin.start[:10])
        if said.year in (None, day.year):
            return Earthquake(said.names, day.year, day)
    return said


def event_of(motion: GroundMotion | Station) -> str:
    """Return the earthquake of a motion, under the one name of those of FEMA P-695; the motion's own name where it is not known."""
    said = earthquake_of(motion)
    for name in _KNOWN:
        known = read_earthquake(name)
        if said.may_be(known) and (said.names & known.names or said.day is not None):
            return name
    return motion.origin.event or motion.name


def is_known(motion: GroundMotion) -> bool:
    """Whether the source of a motion says enough of the earthquake to find others of it: a name or a year at least."""
    return earthquake_of(motion).is_known


def same_earthquake(event: str, other: str) -> bool:
    """Return whether two events may be the same earthquake; see `Earthquake.may_be`."""
    return event == other or read_earthquake(event).may_be(read_earthquake(other))


def is_same_record(motion: GroundMotion, other: GroundMotion) -> bool:
    """Whether two motions have the same samples but for their scale and the digits that a file leaves out."""
    if motion.acceleration.size != other.acceleration.size or 0.0 in (
        motion.peak_acceleration,
        other.peak_acceleration,
    ):
        return False
    one, two = motion.acceleration / motion.peak_acceleration, other.acceleration / other.peak_acceleration
    return bool(np.abs(np.abs(one) - np.abs(two)).max() < _SAME_SAMPLES)
