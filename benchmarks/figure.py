"""One line of the table: a figure, its goal, and whether it is met."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Figure:
    """A measured figure.

    Parameters
    ----------
    what
        What was measured.
    value
        None where it could not be measured.
    unit
        Empty for a ratio.
    at_most, at_least
        The goal; a figure without one is there for information.
    note
        A remark, or why there is no value.
    """

    what: str
    value: float | None
    unit: str = ""
    at_most: float | None = None
    at_least: float | None = None
    note: str = ""

    @property
    def goal(self) -> str:
        """The goal in words, or nothing."""
        if self.at_most is not None:
            return f"<= {self.at_most:g}"
        return "" if self.at_least is None else f">= {self.at_least:g}"

    @property
    def met(self) -> bool | None:
        """Whether the goal is met; None where there is no goal or no value."""
        if self.value is None or not self.goal:
            return None
        if self.at_most is not None:
            return self.value <= self.at_most
        return self.at_least is not None and self.value >= self.at_least

    def row(self) -> tuple[str, ...]:
        """Return the cells of the table's row."""
        value = "-" if self.value is None else f"{self.value:.4g}"
        verdict = {True: "yes", False: "NO", None: ""}[self.met]
        return (self.what, value, self.unit, self.goal, verdict, self.note)

    def to_json(self) -> dict[str, object]:
        """Return the row with names."""
        return {
            "what": self.what,
            "value": self.value,
            "unit": self.unit,
            "goal": self.goal,
            "met": self.met,
            "note": self.note,
        }


HEADING = ("figure", "value", "unit", "goal", "met", "note")


def table(figures: list[Figure]) -> str:
    """Return the figures as a Markdown table."""
    rows = [HEADING, *(figure.row() for figure in figures)]
    widths = [max(len(row[i]) for row in rows) for i in range(len(HEADING))]
    lines = ["| " + " | ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)) + " |" for row in rows]
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
    return "\n".join([lines[0], rule, *lines[1:]])
