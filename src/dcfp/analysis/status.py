"""How an analysis ended."""

from enum import Enum


class Status(Enum):
    """How an analysis ended; the value is what results and tables show."""

    OK = "ok"
    BEYOND_CAPACITY = "beyond capacity"
    STILL_MOVING = "still moving"


#: The same as numbers, for arrays.
NUMBERS = {Status.OK: 1, Status.BEYOND_CAPACITY: 2, Status.STILL_MOVING: 3}
#: Numbers for what has no `Status`: not analysed yet, and an analysis that could not be finished.
NOT_RUN, FAILED = 0, 4
