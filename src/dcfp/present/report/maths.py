"""Mathematics in a small part of Typst's syntax, written as MathML.

The PDF takes the source as it is, the page takes the MathML of the same source, so that a formula is written once. There are numbers, single letters, names of
symbols, words in quotes, operators, scripts (``k_"ra"``, ``T^2``), fractions (``a / b`` of the two things beside the stroke), ``sqrt`` and parentheses,
which a fraction or a script takes away.
"""

import re
from dataclasses import dataclass
from html import escape
from html.entities import html5

_GREEK = (
    "alpha", "beta", "gamma", "delta", "Delta", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu", "xi", "pi", "rho", "sigma",
    "tau", "phi", "psi", "omega",
)  # fmt: skip
SYMBOLS = {name: html5[f"{name};"] for name in _GREEK} | {"epsilon": "ϵ"}
#: Names that are operators, and signs that are shown as others.
OPERATORS = {
    "times": "×",
    "approx": "≈",
    "integral": "∫",
    "<=": "≤",
    ">=": "≥",
    "!=": "≠",
    "-": "−",
}
#: Names of functions, which stand upright.
FUNCTIONS = ("exp", "ln", "min", "max")
#: Widths of spaces [em].
SPACES = {"thin": "0.17", "quad": "1"}
_TOKEN = re.compile(r'\s*(?:(?P<mn>\d+(?:\.\d+)?)|"(?P<mtext>[^"]*)"|(?P<mi>[A-Za-z]+)|(?P<mo><=|>=|!=|.))')


def mathml(source: str) -> str:
    """Return the MathML of a source.

    Raises
    ------
    ValueError
        If it is no mathematics: sources are written in this package, so this is a mistake in it.
    """
    content = _Reader(source).items()
    return (
        f'<math xmlns="http://www.w3.org/1998/Math/MathML" displaystyle="true"><mrow>{content}</mrow></math>'
    )


@dataclass(frozen=True)
class _Piece:
    """MathML of a piece, which may stand in parentheses."""

    inside: str
    fenced: bool = False

    @property
    def whole(self) -> str:
        return f"<mrow><mo>(</mo>{self.inside}<mo>)</mo></mrow>" if self.fenced else self.inside

    @property
    def bare(self) -> str:
        """Without the parentheses."""
        return f"<mrow>{self.inside}</mrow>" if self.fenced else self.inside


class _Reader:
    """Reads tokens, each an element of MathML and its text, from the left."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.tokens = [
            (str(found.lastgroup), found[str(found.lastgroup)]) for found in _TOKEN.finditer(source.strip())
        ]
        self.place = 0

    def take(self, signs: str) -> str:
        """Return the sign that comes next and go on, if it is one of those; nothing otherwise."""
        element, text = self.tokens[self.place] if self.place < len(self.tokens) else ("", "")
        if element != "mo" or text not in signs:
            return ""
        self.place += 1
        return text

    def items(self, end: str = "") -> str:
        """Return all items up to the sign `end`, which is left out, or to the end of the source."""
        found = ""
        while not (end and self.take(end)):
            if self.place == len(self.tokens):
                if not end:
                    break
                msg = f"mathematics lacks a parenthesis: {self.source}"
                raise ValueError(msg)
            found += self.item().whole
        return found

    def item(self) -> _Piece:
        found = self.scripted()
        while self.take("/"):
            found = _Piece(f"<mfrac>{found.bare}{self.scripted().bare}</mfrac>")
        return found

    def scripted(self) -> _Piece:
        base = self.atom()
        scripts: dict[str, str] = {}
        while mark := self.take("_^"):
            scripts[mark] = self.atom().bare
        if not scripts:
            return base
        tag = {"_": "msub", "^": "msup"}[next(iter(scripts))] if len(scripts) == 1 else "msubsup"
        inside = "".join(scripts[mark] for mark in "_^" if mark in scripts)
        return _Piece(f"<{tag}>{base.whole}{inside}</{tag}>")

    def atom(self) -> _Piece:
        if self.place == len(self.tokens):
            msg = f"mathematics ends too early: {self.source}"
            raise ValueError(msg)
        element, text = self.tokens[self.place]
        self.place += 1
        if text == "(" and element == "mo":
            return _Piece(self.items(")"), fenced=True)
        if text == "sqrt" and element == "mi":
            return _Piece(f"<msqrt>{self.atom().bare}</msqrt>")
        if element == "mi" and text in SPACES:
            return _Piece(f'<mspace width="{SPACES[text]}em"/>')
        if element == "mi" and text in FUNCTIONS:
            element = "mtext"
        elif element in ("mi", "mo") and text in OPERATORS:
            element, text = "mo", OPERATORS[text]
        elif element == "mi" and len(text) > 1:
            if text not in SYMBOLS:
                msg = f"there is no symbol {text!r} in mathematics; words stand in quotes."
                raise ValueError(msg)
            text = SYMBOLS[text]
        return _Piece(f"<{element}>{escape(text)}</{element}>")
