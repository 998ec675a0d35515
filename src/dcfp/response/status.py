"""How an analysis ended."""

from enum import Enum


class Status(Enum):
    """How an analysis ended; the value is what results and tables show."""

    OK = "ok"
    BEYOND_CAPACITY = "beyond capacity"
    STILL_MOVING = "still moving"
