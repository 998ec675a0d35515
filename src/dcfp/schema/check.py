"""A check: what was found beside what is allowed, and whether it holds; of analyses, tests, codes and the package itself."""

from dataclasses import dataclass
from enum import StrEnum

from dcfp.schema.notebook import fields_card
from dcfp.schema.quantities import Quantity

#: Relative difference up to which two numbers are the same but for rounding [-].
_ROUNDING = 1e-12


class Verdict(StrEnum):
    """Whether a check is met."""

    MET = "met"
    NOT_MET = "not met"
    NOT_KNOWN = "not known"

    @classmethod
    def of(cls, met: bool | None) -> "Verdict":
        """Return the verdict on what is met or not, or on what is not known where it is None."""
        return cls.NOT_KNOWN if met is None else cls.MET if met else cls.NOT_MET


@dataclass(frozen=True)
class Check:
    """What was found beside what is allowed.

    Attributes
    ----------
    name
        What is asked, in words.
    verdict
        Whether it is met; not known where what it would need is not given, or where it was skipped.
    found, limit
        A number in `unit` (or "-"), or words with their units; None where there is none. `at_least`: the limit is a lower one.
    source, confirmed
        Where it is asked, a clause or a paper; whether this could be confirmed there, else it stands as remembered.
    of, subject
        What asks it: a code, the analysis, a group of checks; what is looked at, where that is one of several tests.
    expected, difference
        For a number that ought to be another one, that number, and how far apart the two are, in words.
    ratio
        Size of the difference over the largest that is allowed [-]: zero where the number is better by any amount, None where this is not a finite number.
    remark
        What a reader should know.
    """

    name: str
    verdict: Verdict
    found: float | str | None
    limit: float | str | None
    source: str = ""
    confirmed: bool = True
    of: str = ""
    subject: str = ""
    unit: str = "-"
    at_least: bool = False
    expected: float | None = None
    difference: str = ""
    ratio: float | None = None
    remark: str = ""

    @property
    def passed(self) -> bool | None:
        """Whether it is met; None where that is not known."""
        return None if self.verdict is Verdict.NOT_KNOWN else self.verdict is Verdict.MET

    @property
    def found_words(self) -> str:
        """What was found, in words with its unit."""
        return self._in_words(self.found)

    @property
    def limit_words(self) -> str:
        """What is allowed, in words with its unit."""
        return self._in_words(self.limit)

    def _in_words(self, value: float | str | None) -> str:
        if value is None or isinstance(value, str):
            return value or ""
        return f"{value:.6g}" if self.unit == "-" else f"{value:.6g} {self.unit}"

    def _repr_html_(self) -> str:
        return fields_card(self, f"{self.of}: {self.name}" if self.of else "Check")


#: What is told of a check.
COLUMNS = [
    Quantity("name", "what is asked", head="Condition", get="name"),
    Quantity("verdict", "whether it is met", get="verdict", printed=False),
    Quantity("found", "what was found", head="Found", get="found"),
    Quantity("limit", "what is allowed", head="Limit", get="limit"),
    Quantity("source", "where it is asked", get="source", printed=False),
    Quantity("Where", "where it is asked", get=lambda one: one.source if one.confirmed else f"{one.source}, unconfirmed", stored=False),
    Quantity("Verdict", "whether it is met", get="verdict", stored=False),
    Quantity("confirmed", "whether this could be confirmed in its source", get="confirmed", printed=False),
]  # fmt: skip


def at_most(value: float, limit: float) -> Verdict:
    """Return whether a value is at most a limit, but for rounding; what is not a number never is."""
    return Verdict.of(value <= limit * (1.0 + _ROUNDING))


def at_least(value: float, limit: float) -> Verdict:
    """Return whether a value is at least a limit, but for rounding; what is not a number never is."""
    return Verdict.of(value >= limit * (1.0 - _ROUNDING))
