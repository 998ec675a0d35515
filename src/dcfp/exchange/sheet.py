"""A worksheet that is filled from above: headings, tables, remarks."""

import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from operator import attrgetter
from typing import Any

#: Longest text that a cell holds; longer ones are cut.
_LONGEST_TEXT = 32_767
#: Longest header or footer.
_LONGEST_HEADER = 200

#: How numbers are shown, by the unit of their column; the cell holds every digit.
NUMBER_FORMATS = {
    "mm": "0.0",
    "mm/s": "0.0",
    "m/s": "0.000",
    "mm/s2": "0.0",
    "m/s2": "0.000",
    "kN": "0.0",
    "N": "0",
    "N/mm": "0",
    "N/mm2": "0.00",
    "degC": "0.0",
    "°C": "0.0",
    "s": "0.000",
    "kN m": "0.00",
    "–": "0.0000",
}
#: Numbers that count rather than measure.
COUNT = "0"


@dataclass(frozen=True)
class Head:
    """Head of a column: its name, unit (empty for words), width [characters] and number format (empty for that of the unit).

    `get` returns its value from a result, or is the name of the attribute that is it.
    """

    text: str
    unit: str = ""
    width: int = 11
    number_format: str = ""
    get: Callable[[Any], object] | str = ""

    @property
    def label(self) -> str:
        """The name with the unit."""
        return f"{self.text} [{self.unit}]" if self.unit else self.text

    def of(self, result: object) -> object:
        """Return its value of a result."""
        return self.get(result) if callable(self.get) else attrgetter(self.get)(result)

    @property
    def shape(self) -> str:
        """How its numbers are shown."""
        return self.number_format or NUMBER_FORMATS.get(self.unit, "General")


#: Formats of words, by their names.
_FORMATS: dict[str, dict[str, object]] = {
    "title": {"bold": True, "font_size": 14},
    "head": {"bold": True, "text_wrap": True, "bottom": 1},
    "words": {"text_wrap": True},
    "line": {},
}


class Formats:
    """The formats of a workbook, each made once."""

    def __init__(self, book: Any) -> None:
        self._book = book
        self._made: dict[str, Any] = {}

    def __getitem__(self, name: str) -> Any:
        """Return the format of that name, or that of numbers in a shape; it is made when it is first asked for."""
        if name not in self._made:
            properties = _FORMATS.get(name, {"num_format": name})
            self._made[name] = self._book.add_format({"valign": "top", **properties})
        return self._made[name]


class Sheet:
    """A worksheet and the row that is to be written next."""

    def __init__(self, book: Any, formats: Formats, name: str, title: str) -> None:
        self.page = book.add_worksheet(name)
        self.formats = formats
        self.name = name
        self.row = 0
        self._frozen = False
        self.page.set_landscape()
        self.page.set_paper(9)  # A4
        self.page.fit_to_pages(1, 0)
        # an ampersand begins a code in a header
        self.page.set_header(f"&L{title.replace('&', '&&')[:_LONGEST_HEADER]}&R&A")
        self.page.set_footer("&RPage &P of &N")

    def heading(self, text: str) -> None:
        """Write a heading."""
        self.page.write_string(self.row, 0, cut(text), self.formats["title"])
        self.row += 1

    def note(self, text: str) -> None:
        """Write a sentence on a line of its own."""
        self.page.write_string(self.row, 0, cut(text), self.formats["line"])
        self.row += 1

    def skip(self) -> None:
        """Leave a line empty."""
        self.row += 1

    def remarks(self, sentences: Iterable[str]) -> None:
        """Write sentences below what is there, each once; nothing where there are none."""
        found = dict.fromkeys(sentences)
        if found:
            self.skip()
            self.heading("Remarks")
        for sentence in found:
            self.note(sentence)

    def table(self, heads: Sequence[Head], rows: Iterable[Sequence[object]], *, frozen: int = 0) -> None:
        """Write a table below what is there.

        Parameters
        ----------
        heads
            Of the columns, which take their widths.
        rows
            Cells in the order of the heads.
        frozen
            How many columns, and the rows down to the head, stay in sight; of the first table on a sheet that asks for it.
        """
        for column, head in enumerate(heads):
            self.page.set_column(column, column, head.width)
            self.page.write_string(self.row, column, head.label, self.formats["head"])
        self.row += 1
        if frozen and not self._frozen:
            self.page.freeze_panes(self.row, frozen)
            self.page.repeat_rows(self.row - 1)
            self._frozen = True
        for row in rows:
            for column, (head, cell) in enumerate(zip(heads, row, strict=True)):
                self.cell(self.row, column, cell, head)
            self.row += 1

    def cell(self, row: int, column: int, value: object, head: Head) -> None:
        """Write one value as what it is; words are never taken for a formula or a link."""
        if value is None or (isinstance(value, float) and math.isnan(value)):
            return
        if isinstance(value, bool):
            self.page.write_string(row, column, "yes" if value else "no", self.formats["words"])
        elif isinstance(value, (int, float)) and math.isfinite(value):
            self.page.write_number(row, column, value, self.formats[head.shape])
        else:
            self.page.write_string(row, column, cut(str(value)), self.formats["words"])


def cut(text: str) -> str:
    """Return text as long as a cell can hold."""
    return text if len(text) <= _LONGEST_TEXT else f"{text[: _LONGEST_TEXT - 3]}..."


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
