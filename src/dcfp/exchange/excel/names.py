"""Names of worksheets, as Excel allows them."""

import re
from collections.abc import Iterable

#: Longest name of a worksheet, and characters that it must not have.
LONGEST = 31
_FORBIDDEN = re.compile(r"[\[\]:*?/\\\x00-\x1f]+")
#: What Excel keeps for itself, in lower case.
_RESERVED = ("history",)


def sheet_names(wanted: Iterable[str], taken: Iterable[str] = ()) -> list[str]:
    """Return a name for each worksheet that Excel allows, and that no other has in any case of letters.

    Parameters
    ----------
    wanted
        What each is to be called.
    taken
        Names of the worksheets that are there already.
    """
    seen = {name.lower() for name in (*taken, *_RESERVED)}
    names: list[str] = []
    for name in wanted:
        plain = _FORBIDDEN.sub("-", name).strip("' ")[:LONGEST].strip("' ") or "case"
        found, number = plain, 2
        while found.lower() in seen:
            ending = f"_{number}"
            found, number = plain[: LONGEST - len(ending)] + ending, number + 1
        seen.add(found.lower())
        names.append(found)
    return names
