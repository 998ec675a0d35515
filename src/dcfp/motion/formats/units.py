"""Units of acceleration in which records are written."""

import re

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError

#: Size of each unit [mm/s2], under the spelling that `canonical_unit` makes of it.
_SIZES = {"mm/s2": 1.0, "cm/s2": 10.0, "gal": 10.0, "m/s2": 1000.0, "g": STANDARD_GRAVITY}

_SPELLINGS = {"gals": "gal", "gal(cm/s/s)": "gal", "g's": "g", "gs": "g"}


def canonical_unit(text: str) -> str | None:
    """Return one of mm/s2, cm/s2, gal, m/s2, g for any usual spelling of it, or None."""
    word = re.sub(r"[\s^*.]+", "", text.lower())
    word = _SPELLINGS.get(word, word)
    word = re.sub(r"/(?:sec|s)/(?:sec|s)$", "/s2", word)
    word = re.sub(r"/sec2$", "/s2", word)
    word = word.replace("²", "2")
    return word if word in _SIZES else None


def unit_size(text: str) -> float:
    """Return the size of a unit of acceleration [mm/s2].

    Raises
    ------
    InputError
        If the unit is not known.
    """
    unit = canonical_unit(text)
    if unit is None:
        msg = f"the unit {text!r} is not known; use one of {', '.join(_SIZES)}."
        raise InputError(msg)
    return _SIZES[unit]
