"""Choose one component of a file by its name, its channel number or its direction."""

import re
from collections.abc import Sequence
from pathlib import Path

from dcfp.errors import InputError
from dcfp.motion.formats.component import Component

_DIRECTIONS = {
    "NS": ("ns", "n", "north", "northsouth", "360", "360deg", "0", "0deg", "000"),
    "EW": ("ew", "e", "east", "eastwest", "90", "90deg", "090"),
    "UD": ("ud", "u", "up", "z", "v", "vertical", "updown"),
}


def direction(label: str) -> str | None:
    """Return NS, EW or UD for a label that plainly means it (``"N-S"``, ``"360 Deg"``, ``"Up"``), or None."""
    word = _plain(label)
    return next((name for name, words in _DIRECTIONS.items() if word in words), None)


def select_component(components: Sequence[Component], wanted: str | None, path: Path) -> Component:
    """Return the component that is asked for.

    Raises
    ------
    InputError
        If there are several and none is asked for, or none or several have that name.
    """
    if wanted is None:
        if len(components) == 1:
            return components[0]
        msg = f"{path}: the file holds {len(components)} components; choose one of {_choices(components)}."
        raise InputError(msg)
    found = _matches(components, wanted)
    if len(found) == 1:
        return found[0]
    how = "has no component" if not found else "has more than one component"
    msg = f"{path}: the file {how} {wanted!r}; choose one of {_choices(components)}."
    raise InputError(msg)


def _matches(components: Sequence[Component], wanted: str) -> list[Component]:
    word = _plain(wanted)
    by_name = [item for item in components if word in {_plain(name) for name in item.names if name}]
    if by_name or direction(wanted) is None:
        return by_name
    return [item for item in components if direction(wanted) in {direction(name) for name in item.names}]


def _plain(label: str) -> str:
    return re.sub(r"[\s._:-]+", "", label.casefold())


def _choices(components: Sequence[Component]) -> str:
    labels = [item.names[0] or f"channel {number}" for number, item in enumerate(components, 1)]
    return ", ".join(repr(label) for label in labels)
