"""Where the values of a TOML file stand, so that a complaint names the line."""

import re
from collections.abc import Mapping
from typing import TypeAlias

#: Keys and places in lists that lead to a value.
Way: TypeAlias = tuple[str | int, ...]

_SKIPPED = re.compile(r"(?:[ \t\r\n]|#[^\n]*)*")
_BLANKS = re.compile(r"[ \t]*")
_KEY = re.compile(r"\"(?P<quoted>(?:\\.|[^\"\\\n])*)\"|'(?P<literal>[^'\n]*)'|(?P<bare>[A-Za-z0-9_-]+)")
_STRING = re.compile(r'"""(?:\\.|[^\\])*?"{3,5}|\'\'\'.*?\'{3,5}|"(?:\\.|[^"\\\n])*"|\'[^\'\n]*\'', re.DOTALL)
_PLAIN = re.compile(r"[^,\]}\n#]+")


class Place(str):
    """What a complaint begins with: a file, the line, and the part of the file that it is about.

    Parameters
    ----------
    file
        Its name.
    lines
        Line of every value, by the way to it: `lines_of`.
    way
        To what this is about.
    label
        How that is shown.
    """

    __slots__ = ("file", "label", "lines", "way")

    file: str
    lines: Mapping[Way, int]
    way: Way
    label: str

    def __new__(cls, file: str, lines: Mapping[Way, int], way: Way = (), label: str = "") -> "Place":
        """Make the words."""
        line = lines.get(way)
        words = [file + (f", line {line}" if line else ""), *([label] if label else [])]
        made = super().__new__(cls, ": ".join(words))
        made.file, made.lines, made.way, made.label = file, lines, way, label
        return made

    @property
    def below(self) -> list[str | int]:
        """Keys of the table that this is about."""
        size = len(self.way)
        return [way[size] for way in self.lines if len(way) == size + 1 and way[:size] == self.way]

    def of(self, *way: str | int, label: str = "") -> "Place":
        """Return the place of what stands below this one; by default shown as this is."""
        whole = (*self.way, *way)
        known = whole if whole in self.lines else self.way
        return Place(self.file, self.lines, known, label or self.label)


def at_key(where: str, key: str) -> str:
    """Return where a key of a table stands, as far as that is known."""
    return where.of(key) if isinstance(where, Place) else where


def inside(where: str, key: str) -> str:
    """Return where a table stands that is a part of another one."""
    if isinstance(where, Place):
        head = where.label.removeprefix("[").removesuffix("]")
        return where.of(key, label=f"[{head}.{key}]" if head else f"[{key}]")
    return f"{where}: [{key}]" if where else f"[{key}]"


def lines_of(text: str) -> dict[Way, int]:
    """Return the line of every table and value of TOML that is known to be right, by keys and places in lists."""
    return _Scanner(text).found


class _Scanner:
    """Goes once through the text; a table that is one of a list has its number behind its keys."""

    def __init__(self, text: str) -> None:
        self.text, self.at = text, 0
        self.found: dict[Way, int] = {}
        self.lists: dict[Way, int] = {}
        table: Way = ()
        while self._skip(_SKIPPED) < len(text):
            if text[self.at] == "[":
                table = self._head()
            else:
                self._pair(table)

    def _skip(self, pattern: re.Pattern[str]) -> int:
        found = pattern.match(self.text, self.at)
        self.at = found.end() if found else self.at
        return self.at

    def _mark(self, way: Way, at: int | None = None) -> None:
        self.found.setdefault(way, self.text.count("\n", 0, self.at if at is None else at) + 1)

    def _keys(self) -> Way:
        keys: list[str | int] = []
        while True:
            self._skip(_BLANKS)
            one = _KEY.match(self.text, self.at)
            assert one is not None
            keys.append(next(part for part in one.groups() if part is not None))
            self.at = one.end()
            self._skip(_BLANKS)
            if self.text[self.at : self.at + 1] != ".":
                return tuple(keys)
            self.at += 1

    def _head(self) -> Way:
        begin, several = self.at, self.text.startswith("[[", self.at)
        self.at += 2 if several else 1
        keys = self._keys()
        self.at += 2 if several else 1
        way: Way = ()
        for place, key in enumerate(keys):
            way = (*way, key)
            if several and place == len(keys) - 1:
                self.lists[way] = self.lists.get(way, -1) + 1
            if way in self.lists:
                way = (*way, self.lists[way])
        self._mark(way, begin)
        return way

    def _pair(self, table: Way) -> None:
        begin = self.at
        way = (*table, *self._keys())
        for length in range(len(table) + 1, len(way) + 1):
            self._mark(way[:length], begin)
        self.at += 1  # the equals sign
        self._skip(_BLANKS)
        self._value(way)

    def _value(self, way: Way) -> None:
        self._mark(way)
        sign = self.text[self.at]
        if sign in "[{":
            self.at += 1
            count = 0
            while self.text[self._skip(_SKIPPED)] not in "]}":
                if sign == "[":
                    self._value((*way, count))
                else:
                    self._pair(way)
                count += 1
                self._skip(_SKIPPED)
                self.at += self.text[self.at] == ","
            self.at += 1
        else:
            self._skip(_STRING if sign in "\"'" else _PLAIN)
