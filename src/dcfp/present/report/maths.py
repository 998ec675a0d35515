"""Mathematics in a small part of Typst's syntax: read into a tree, and written as MathML.

The PDF takes the source as it is, the page takes the MathML of the same source, so that a formula is written once. There are numbers, single letters, names of
symbols, words in quotes, operators, scripts (``k_"ra"``, ``T^2``), fractions (``a / b`` of the two things beside the stroke), ``sqrt`` and parentheses,
which a fraction or a script takes away.
"""

import re
from dataclasses import dataclass
from html import escape
from typing import TypeAlias

SYMBOLS = {
    "alpha": "α",
    "beta": "β",
    "gamma": "γ",
    "delta": "δ",
    "Delta": "Δ",
    "epsilon": "ϵ",
    "zeta": "ζ",
    "eta": "η",
    "lambda": "λ",
    "mu": "μ",
    "xi": "ξ",
    "pi": "π",
    "sigma": "σ",
    "tau": "τ",
    "phi": "φ",
    "omega": "ω",
}
#: Names that are operators, and how they are shown.
OPERATORS = {"times": "×", "approx": "≈", "integral": "∫"}
#: Names of functions, which stand upright.
FUNCTIONS = ("exp", "ln", "min", "max")
#: Widths of spaces [em].
SPACES = {"thin": "0.17", "quad": "1"}
_TOKEN = re.compile(r'\s*(?:(\d+(?:\.\d+)?)|"([^"]*)"|([A-Za-z]+)|(<=|>=|!=|.))')
_SHORT = {"<=": "≤", ">=": "≥", "!=": "≠", "-": "−"}


@dataclass(frozen=True)
class Number:
    """A number without a sign."""

    text: str


@dataclass(frozen=True)
class Name:
    """A letter or a symbol."""

    text: str


@dataclass(frozen=True)
class Word:
    """Words in quotes, or the name of a function."""

    text: str


@dataclass(frozen=True)
class Space:
    """A space."""

    width: str


@dataclass(frozen=True)
class Operator:
    """An operator or a relation."""

    text: str


@dataclass(frozen=True)
class Row:
    """Things beside each other; `fence` where they stand in parentheses."""

    items: tuple["Node", ...]
    fence: bool = False


@dataclass(frozen=True)
class Fraction:
    """One over the other."""

    above: "Node"
    below: "Node"


@dataclass(frozen=True)
class Root:
    """A square root."""

    inside: "Node"


@dataclass(frozen=True)
class Script:
    """A thing with what stands at its foot and at its head."""

    base: "Node"
    sub: "Node | None"
    sup: "Node | None"


Node: TypeAlias = Number | Name | Word | Space | Operator | Row | Fraction | Root | Script


def read_maths(source: str) -> Row:
    """Return the tree of a source.

    Raises
    ------
    ValueError
        If it is none: sources are written in this package, so this is a mistake in it.
    """
    reader = _Reader(source)
    row = reader.row("")
    if reader.place < len(reader.tokens):
        msg = f"mathematics cannot be read from {reader.tokens[reader.place]} on: {source}"
        raise ValueError(msg)
    return row


def mathml(source: str) -> str:
    """Return the MathML of a source."""
    content = _written(read_maths(source))
    return f'<math xmlns="http://www.w3.org/1998/Math/MathML" displaystyle="true">{content}</math>'


class _Reader:
    def __init__(self, source: str) -> None:
        self.tokens: list[tuple[str, str]] = []
        kinds = ("number", "word", "name", "sign")
        for found in _TOKEN.finditer(source.strip()):
            place = next(i for i in range(4) if found.group(i + 1) is not None)
            self.tokens.append((kinds[place], str(found.group(place + 1))))
        self.place = 0

    def sign(self) -> str:
        """Return the sign that comes next, or nothing."""
        if self.place < len(self.tokens) and self.tokens[self.place][0] == "sign":
            return self.tokens[self.place][1]
        return ""

    def row(self, end: str) -> Row:
        items: list[Node] = []
        while self.place < len(self.tokens) and not (end and self.sign() == end):
            items.append(self.item())
        return Row(tuple(items))

    def item(self) -> Node:
        found = self.scripted()
        while self.sign() == "/":
            self.place += 1
            found = Fraction(_bare(found), _bare(self.scripted()))
        return found

    def scripted(self) -> Node:
        base = self.atom()
        scripts: dict[str, Node] = {}
        while self.sign() in ("_", "^"):
            mark = self.sign()
            self.place += 1
            scripts[mark] = _bare(self.atom())
        return Script(base, scripts.get("_"), scripts.get("^")) if scripts else base

    def atom(self) -> Node:
        if self.place >= len(self.tokens):
            msg = f"mathematics ends too early: {self.tokens}"
            raise ValueError(msg)
        kind, text = self.tokens[self.place]
        self.place += 1
        if kind == "number":
            return Number(text)
        if kind == "word":
            return Word(text)
        if kind == "name":
            return self.named(text)
        if text == "(":
            return self.group()
        return Operator(_SHORT.get(text, text))

    def group(self) -> Row:
        inside = self.row(")")
        if self.sign() != ")":
            msg = f"mathematics lacks a parenthesis: {self.tokens}"
            raise ValueError(msg)
        self.place += 1
        return Row(inside.items, fence=True)

    def named(self, text: str) -> Node:
        if text == "sqrt":
            self.place += 1  # the parenthesis
            return Root(Row(self.group().items))
        if text in FUNCTIONS:
            return Word(text)
        if text in SPACES:
            return Space(SPACES[text])
        if text in OPERATORS:
            return Operator(OPERATORS[text])
        if len(text) > 1 and text not in SYMBOLS:
            msg = f"there is no symbol {text!r} in mathematics; words stand in quotes."
            raise ValueError(msg)
        return Name(SYMBOLS.get(text, text))


def _bare(node: Node) -> Node:
    return Row(node.items) if isinstance(node, Row) else node


def _written(node: Node) -> str:
    match node:
        case Number(text):
            return f"<mn>{text}</mn>"
        case Name(text):
            return f"<mi>{text}</mi>"
        case Word(text):
            return f"<mtext>{escape(text)}</mtext>"
        case Space(width):
            return f'<mspace width="{width}em"/>'
        case Operator(text):
            return f"<mo>{escape(text)}</mo>"
        case Row(items, fence):
            inside = "".join(_written(item) for item in items)
            return f"<mrow><mo>(</mo>{inside}<mo>)</mo></mrow>" if fence else f"<mrow>{inside}</mrow>"
        case Fraction(above, below):
            return f"<mfrac>{_written(above)}{_written(below)}</mfrac>"
        case Root(inside):
            return f"<msqrt>{_written(inside)}</msqrt>"
        case Script(base, sub, sup):
            return _scripts(_written(base), sub, sup)


def _scripts(base: str, sub: Node | None, sup: Node | None) -> str:
    if sub is not None and sup is not None:
        return f"<msubsup>{base}{_written(sub)}{_written(sup)}</msubsup>"
    if sub is not None:
        return f"<msub>{base}{_written(sub)}</msub>"
    return base if sup is None else f"<msup>{base}{_written(sup)}</msup>"
