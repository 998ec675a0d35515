"""The head of a report: who made it for whom."""

import unicodedata

from dcfp.present.report.document import Document, Table, named_values


def heading_rows(document: Document) -> Table:
    """Return what the scenario says of the report."""
    heading = document.heading
    return named_values(
        [
            ("Project", heading.project),
            ("Client", heading.client),
            ("Report number", heading.number),
            ("Date", heading.date),
            ("Notes", heading.notes),
            ("Calculated with", document.maker),
        ]
    )


def short_title(document: Document) -> str:
    """Return what stands at the top of every page."""
    heading = document.heading
    return "  |  ".join(_short(word) for word in (heading.number, heading.project, document.title) if word)


def signatories(document: Document) -> tuple[tuple[str, str, str], ...]:
    """Return role and name of those who sign, and a line for the date where the report has none."""
    heading = document.heading
    asked, date = ("signature, date", "") if heading.date else ("signature", "Date: ________")
    return (
        (f"Calculated by ({asked})", heading.author, date),
        (f"Checked by ({asked})", heading.checker, date),
    )


def _short(text: str, most: int = 45) -> str:
    plain = " ".join(text.split())
    return plain if len(plain) <= most else plain[: most - 1].rstrip() + "…"


def printable(text: str) -> str:
    """Return a text without the characters that steer a machine; line ends and tabs stay."""
    return "".join(c for c in text if c in "\n\t" or unicodedata.category(c) not in ("Cc", "Cs"))
