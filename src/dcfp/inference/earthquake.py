"""Whether two records are of the same earthquake, as far as their sources say."""

import re

import numpy as np

from dcfp.motion.ground_motion import GroundMotion

#: Largest difference of the same sample in two files, over the peak [-].
_SAME_SAMPLES = 1e-3

_YEAR = re.compile(r"(?<!\d)(?:19|20)\d\d(?!\d)")
#: Words of a place that are in the names of many earthquakes.
_COMMON = frozenset(
    [
        "earthquake",
        "of",
        "the",
        "and",
        "japan",
        "taiwan",
        "turkey",
        "italy",
        "iran",
        "usa",
        "ussr",
        "canada",
        "california",
        "alaska",
        "mexico",
        "chile",
        "new",
        "zealand",
    ]
)


def event_of(motion: GroundMotion) -> str:
    """Return the earthquake of a motion, under one name where the sets of FEMA P-695 have two; the motion's own name where it is not known."""
    return re.sub(r"-\d\d(?=,? )", "", motion.origin.event) or motion.name


def is_known(motion: GroundMotion) -> bool:
    """Whether the source of a motion says enough of the earthquake to find others of it: a year at least."""
    return _YEAR.search(motion.origin.event) is not None


def is_same_record(motion: GroundMotion, other: GroundMotion) -> bool:
    """Whether two motions have the same samples but for their scale and the digits that a file leaves out."""
    if motion.acceleration.size != other.acceleration.size or 0.0 in (
        motion.peak_acceleration,
        other.peak_acceleration,
    ):
        return False
    one, two = motion.acceleration / motion.peak_acceleration, other.acceleration / other.peak_acceleration
    return bool(np.abs(np.abs(one) - np.abs(two)).max() < _SAME_SAMPLES)


def same_earthquake(event: str, other: str) -> bool:
    """Return whether two events may be the same earthquake: the same year, and a word of the name in common where both have one.

    Two earthquakes of one year are taken as the same where a source gives no more than a date, since to leave out one too many is
    the safer mistake.
    """
    if event == other:
        return True
    years = _YEAR.findall(event), _YEAR.findall(other)
    if not years[0] or not years[1] or years[0][0] != years[1][0]:
        return False
    names = _words(event), _words(other)
    return not names[0] or not names[1] or bool(names[0] & names[1])


def _words(event: str) -> set[str]:
    return {word for word in re.findall(r"[a-z]{3,}", event.lower()) if word not in _COMMON}
