"""A report as PDF, by Typst."""

import re
import tempfile
from collections.abc import Callable
from importlib.resources import files
from io import BytesIO
from pathlib import Path
from typing import Any

from dcfp.errors import AnalysisError, InputError
from dcfp.present.report.document import (
    BOXES,
    COLOURS,
    Block,
    Bullets,
    Cell,
    Code,
    Document,
    Drawing,
    Equations,
    Formula,
    Listing,
    Maths,
    Paragraph,
    Parts,
    Section,
    Table,
    Tone,
    heading_rows,
    printable,
    short_title,
    signatories,
)

#: Last character up to which the fonts that come with Typst have all scripts of Europe.
_LAST_EUROPEAN = 0x052F
#: Blocks of signs that they have too: punctuation, arrows, mathematics.
_SIGNS = (0x1E00, 0x22FF)


def check_typst() -> None:
    """Check that PDF can be made.

    Raises
    ------
    InputError
        If Typst is not installed.
    """
    _typst()


def pdf_of(document: Document, advance: Callable[[], None] | None = None) -> bytes:
    """Return a report as a PDF: the same report always has the same bytes.

    Only the fonts in Typst are used, but for signs that they lack (such as Chinese ones), which are taken from the system's fonts if it has any with them.

    Parameters
    ----------
    document
        The report.
    advance
        Called after each figure.

    Raises
    ------
    InputError
        If Typst is not installed.
    AnalysisError
        If Typst cannot set the report.
    """
    typst = _typst()
    source, drawings = typst_source(document)
    with tempfile.TemporaryDirectory(prefix="dcfp-report-") as name:
        folder = Path(name)
        for place, drawing in enumerate(drawings):
            (folder / f"figure-{place}.pdf").write_bytes(_figure(drawing))
            if advance is not None:
                advance()
        main = folder / "report.typ"
        main.write_text(source, encoding="utf-8")
        try:
            return typst.compile(main, root=folder, format="pdf", ignore_system_fonts=fonts_suffice(source))
        except typst.TypstError as error:
            msg = f"Typst cannot set the report ({error.message}); please report it with the scenario file."
            raise AnalysisError(msg) from error


def fonts_suffice(text: str) -> bool:
    """Return whether the fonts that come with Typst have every character of a text."""
    return all(ord(c) <= _LAST_EUROPEAN or _SIGNS[0] <= ord(c) <= _SIGNS[1] for c in text)


def _typst() -> Any:
    try:
        import typst  # late: it is not needed for a page
    except ImportError as error:
        msg = "a report as PDF needs the Python package typst, which is not installed: pip install 'dcfp[report]'; a page (.html) needs nothing."
        raise InputError(msg) from error
    return typst


def _figure(drawing: Drawing) -> bytes:
    from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import

    stream = BytesIO()
    save_figure(drawing.draw(), stream, "pdf")
    return stream.getvalue()


# A report as the source of Typst.
#
# Whatever a user wrote becomes a string of Typst's code, in which a backslash and a quotation mark are
# escaped and nothing else has a meaning.


_ALIGNED = {"l": "left", "r": "right", "c": "center"}
#: Words of so many characters may be broken: after signs, and every 15 characters. In a listing only those that no line can hold.
_LONGEST, _LONGEST_LISTED = 22, 100
_PIECE = re.compile(r"[^_\-./\\:,;|]{0,15}[_\-./\\:,;|]|\S{1,15}")
_BREAK = "\u200b"
#: Rows of a table that stays on one page.
_TOGETHER = 12


def typst_source(document: Document) -> tuple[str, list[Drawing]]:
    """Return the source of a report, and its figures: number i is to lie beside it as ``figure-i.pdf``."""
    writer = _Writer()
    template = files("dcfp.present.report").joinpath("template.typ").read_text(encoding="utf-8")
    title, author = _string(document.title), _string(document.heading.author)
    head = [
        template,
        f"#set document(title: {title}, author: {author}, date: none)",
        f"#set page(..page-of({_string(document.maker)}, [{_words((short_title(document),))}]))",
        f"#title-of({_string(breakable(document.title))})",
        writer.block(heading_rows(document)),
        _signatures(document),
        *(writer.block(block) for block in document.front),
    ]
    if document.with_contents:
        head.append("#contents")
    body = [writer.section(section, 1) for section in document.sections]
    return "\n".join([*head, *body]) + "\n", writer.drawings


class _Writer:
    def __init__(self) -> None:
        self.drawings: list[Drawing] = []

    def section(self, section: Section, level: int) -> str:
        lines = ["#pagebreak(weak: true)"] if section.on_new_page else []
        lines.append(f"#heading(level: {level}, {_string(breakable(section.title))})")
        lines += [self.block(block) for block in section.blocks]
        lines += [self.section(part, level + 1) for part in section.parts]
        return "\n".join(lines)

    def block(self, block: Block) -> str:
        match block:
            case Paragraph(parts, Tone.PLAIN):
                return f"#par[{_words(parts)}]"
            case Paragraph(parts, Tone.NOTE):
                return f"#par(note[{_words(parts)}])"
            case Paragraph(parts, tone):
                return f"#box-of({BOXES[tone]})[{_words(parts)}]"
            case Bullets(items):
                return "#list(" + ", ".join(f"[{_words(item)}]" for item in items) + ")"
            case Table():
                return _table(block)
            case Formula():
                return _formula(block)
            case Equations(symbols, origin):
                lines = ", ".join(f"$display({one})$" for one in symbols)
                return f"#equations-of({_string(origin)}, {lines})"
            case Drawing():
                return self.drawing(block)
            case Listing(text):
                return f"#listing-of({_string(breakable(text, _LONGEST_LISTED))})"

    def drawing(self, block: Drawing) -> str:
        self.drawings.append(block)
        caption = f"[{_words((block.caption,))}]" if block.caption else "none"
        file = f"figure-{len(self.drawings) - 1}.pdf"
        return f'#drawing-of("{file}", 100%, {_string(block.words)}, {caption})'


def breakable(text: str, longest: int = _LONGEST) -> str:
    """Return a text whose words of that many characters may be broken where a line ends."""
    return re.sub(rf"\S{{{longest},}}", lambda found: _BREAK.join(_PIECE.findall(found[0])), text)


def _string(text: str) -> str:
    """Return a text as a string of Typst's code."""
    escaped = printable(text).replace("\\", "\\\\").replace('"', '\\"')
    return '"' + escaped.replace("\n", "\\n").replace("\t", "\\t") + '"'


def _words(parts: Parts) -> str:
    pieces: list[str] = []
    for part in parts:
        match part:
            case Maths(source):
                pieces.append(f"${source}$")
            case Code(text):
                pieces.append(f"#raw({_string(text)})")
            case str():
                pieces.append("#" + _string(breakable(part)))
    return "".join(pieces)


def _table(table: Table) -> str:
    columns = ", ".join("auto" if width == 0.0 else f"{width:g}fr" for width in table.widths)
    align = ", ".join(_ALIGNED[letter] for letter in table.aligned)
    head = "".join(f"[{_words(parts)}], " for parts in table.head)
    caption = f"[{_words((table.caption,))}]" if table.caption else "none"
    together = "true" if len(table.rows) <= _TOGETHER else "false"
    rows = [", ".join(_cell(cell) for cell in row) + "," for row in table.rows]
    call = f"#table-of(({columns},), ({align},), ({head}), {caption}, {together}, ("
    return "\n".join([call, *(f"  {row}" for row in rows), "))"])


def _cell(cell: Cell) -> str:
    content = f"[{_words(cell.parts)}]"
    if cell.verdict is not None:
        content = f"verdict-of({COLOURS[cell.verdict]}, {content})"
    if cell.strong:
        content = f"strong({content})"
    return content if cell.span == 1 else f"table.cell(colspan: {cell.span}, {content})"


def _formula(formula: Formula) -> str:
    lines = ", ".join(f"$display({line})$" for line in formula.lines)
    confirmed = "true" if formula.confirmed else "false"
    return f"#formula-of({_string(formula.name)}, {_string(formula.origin)}, {confirmed}, {lines})"


def _signatures(document: Document) -> str:
    people = signatories(document)
    return (
        "#signatures("
        + ", ".join(
            f"({_string(role)}, {_string(breakable(name))}, {_string(date)})" for role, name, date in people
        )
        + ")"
    )
