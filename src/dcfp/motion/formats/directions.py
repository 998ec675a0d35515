"""Where a component points, from its label: north-south, east-west or up, and in degrees from north."""

import re

#: Labels of the directions, without blanks and marks; the figures of KiK-net are for the borehole and the surface.
_DIRECTIONS = {
    "NS": ("ns", "n", "north", "northsouth", "360", "360deg", "0", "0deg", "000", "ns1", "ns2"),
    "EW": ("ew", "e", "east", "eastwest", "90", "90deg", "090", "we", "westeast", "ew1", "ew2"),
    "UD": ("ud", "u", "up", "z", "v", "vertical", "updown", "ver", "vert", "vrt", "ud1", "ud2"),
}
#: Labels of a vertical component that is positive downwards.
_DOWN = ("down", "dwn", "dn", "du", "downup")
#: Channel of a seismometer or an accelerometer by the SEED manual, such as HNE.
_SEED = re.compile(r"[bcdefghlmsv][hlgn]([nez])")
_OF_SEED = {"n": "NS", "e": "EW", "z": "UD"}
#: Names of files of PEER end with the direction: ``NORTHR/LOS000``, ``IMPVALL/H-E06_233``, ``TABAS/TAB-UP``.
_OF_PEER = re.compile(r".*/.+?(\d{3}|-[a-z]{1,3})", re.IGNORECASE)
_QUADRANT = re.compile(r"([ns])(\d{1,2})([ew])")
_DEGREES = re.compile(r"(?:h[a-z]?\d?\s+)?(\d{1,3}(?:\.\d+)?)\s*(deg\w*|°)?", re.IGNORECASE)


def direction(label: str) -> str | None:
    """Return NS, EW or UD for a label that plainly means it (``"N-S"``, ``"360 Deg"``, ``"Up"``, ``"HNZ"``), or None."""
    word = plain(_bare(label))
    if word in _DOWN:
        return "UD"
    if found := _SEED.fullmatch(word):
        return _OF_SEED[found[1]]
    return next((name for name, words in _DIRECTIONS.items() if word in words), None)


def points_down(label: str) -> bool:
    """Whether a label plainly says that the component is positive downwards."""
    return plain(_bare(label)) in _DOWN


def azimuth(label: str) -> float | None:
    """Return where a horizontal component points, clockwise from north [degrees], where its label plainly says it, or None."""
    found = direction(label)
    if found is not None:
        return {"NS": 0.0, "EW": 90.0}.get(found)
    text = _bare(label)
    if found := _QUADRANT.fullmatch(plain(text)):
        north, east = found[1] == "n", found[3] == "e"
        turn = float(found[2]) if north == east else -float(found[2])
        return (turn if north else 180.0 + turn) % 360.0
    if (word := plain(text)) in ("s", "south", "w", "west"):
        return 180.0 if word.startswith("s") else 270.0
    if found := _DEGREES.fullmatch(text):
        whole, degrees = found[1], float(found[1])
        # one digit alone is rather the number of a channel
        return degrees % 360.0 if degrees <= 360.0 and (found[2] or len(whole) > 1) else None
    return None


def _bare(label: str) -> str:
    """Return what a label says of the direction: without a note in brackets, and of the name of a file of PEER its end."""
    text = re.sub(r"\(.*\)\s*$", "", label).strip()
    found = _OF_PEER.fullmatch(text)
    return found[1] if found else text


def plain(label: str) -> str:
    """Return a label in small letters without blanks and marks."""
    return re.sub(r"[\s._:-]+", "", label.casefold())
