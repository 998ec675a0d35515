"""What a code wants of a test, and whether the test gave it."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Criterion:
    """One requirement on one test.

    Attributes
    ----------
    code, clause
        Where it stands.
    test
        Name of the test.
    statement
        What must hold, in words.
    value, limit
        What was found and what is allowed, in `unit`; the value must not exceed the limit, or where `at_least` not fall below it.
    unit
        Unit of both, or "-".
    at_least
        Whether the limit is a lower one.
    confirmed
        Whether the requirement was read in the code or in two independent sources; if not, it is from memory of the code.
    """

    code: str
    clause: str
    test: str
    statement: str
    value: float
    limit: float
    unit: str = "-"
    at_least: bool = False
    confirmed: bool = False

    @property
    def passed(self) -> bool:
        """Whether it holds; what is not a finite number never does."""
        return math.isfinite(self.value) and (
            self.value >= self.limit if self.at_least else self.value <= self.limit
        )
