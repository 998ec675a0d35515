"""Systems that no door takes, for the limits of the mathematics: endlessly stiff, endlessly flat, without friction."""

import copy
from typing import Any, TypeVar

T = TypeVar("T")


def unchecked(thing: T, **changes: Any) -> T:
    """Return a copy of a declared object with values that it would refuse."""
    made = copy.copy(thing)
    for name, value in changes.items():
        object.__setattr__(made, name, value)
    return made
