"""A report in its two forms: as PDF, by Typst, and as one page of HTML that needs no other file, no script and no connection."""

import base64
import json
import re
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import fields as fields_of
from html import escape as escape_html
from importlib.resources import files
from io import BytesIO
from pathlib import Path
from typing import Any, cast

from dcfp.errors import AnalysisError, InputError
from dcfp.present.report import document as doc
from dcfp.present.report.maths import mathml
from dcfp.schema.check import Verdict

#: Last character up to which the fonts that come with Typst have all scripts of Europe.
_LAST_EUROPEAN = 0x052F
#: Blocks of signs that they have too: punctuation, arrows, mathematics.
_SIGNS = (0x1E00, 0x22FF)


def check_typst() -> Any:
    """Return the package Typst, with which a PDF can be made.

    Raises
    ------
    InputError
        If it is not installed.
    """
    try:
        import typst  # late: it is not needed for a page
    except ImportError as error:
        msg = "a report as PDF needs the Python package typst, which is not installed: pip install 'dcfp[report]'; a page (.html) needs nothing."
        raise InputError(msg) from error
    return typst


def pdf_of(document: doc.Document, advance: Callable[[], None] | None = None) -> bytes:
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
    typst = check_typst()
    data, drawings = data_of(document)
    with tempfile.TemporaryDirectory(prefix="dcfp-report-") as name:
        folder = Path(name)
        for place, drawing in enumerate(drawings):
            (folder / f"figure-{place}.pdf").write_bytes(_drawn(drawing, "pdf"))
            if advance is not None:
                advance()
        main = folder / "report.typ"
        main.write_bytes(files("dcfp.present.report").joinpath("template.typ").read_bytes())
        (folder / "report.json").write_text(data, encoding="utf-8")
        try:
            return typst.compile(main, root=folder, format="pdf", ignore_system_fonts=fonts_suffice(data))
        except typst.TypstError as error:
            msg = f"Typst cannot set the report ({error.message}); please report it with the scenario file."
            raise AnalysisError(msg) from error


def fonts_suffice(text: str) -> bool:
    """Return whether the fonts that come with Typst have every character of a text."""
    return all(ord(c) <= _LAST_EUROPEAN or _SIGNS[0] <= ord(c) <= _SIGNS[1] for c in text)


def _drawn(drawing: doc.Drawing, kind: str) -> bytes:
    from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import

    stream = BytesIO()
    save_figure(drawing.draw(), stream, kind)
    return stream.getvalue()


# ----- what the template reads -----

#: Words of so many characters may be broken: after signs, and every 15 characters. In a listing only those that no line can hold.
_LONGEST, _LONGEST_LISTED = 22, 100
_PIECE = re.compile(r"[^_\-./\\:,;|]{0,15}[_\-./\\:,;|]|\S{1,15}")
_BREAK = "\u200b"


def data_of(document: doc.Document) -> tuple[str, list[doc.Drawing]]:
    """Return a report as JSON, and its figures: number i is to lie beside it as ``figure-i.pdf``."""
    drawings: list[doc.Drawing] = []
    data = {
        "title": doc.printable(document.title),
        "author": doc.printable(document.heading.author),
        "maker": doc.printable(document.maker),
        "short": _plain(doc.short_title(document), drawings),
        "heading": _plain(document.title, drawings),
        "rows": _plain(doc.heading_rows(document), drawings),
        "signatories": _plain(doc.signatories(document), drawings),
        "front": _plain(document.front, drawings),
        "sections": _plain(document.sections, drawings),
    }
    return json.dumps(data, ensure_ascii=False), drawings


def _plain(value: Any, drawings: list[doc.Drawing]) -> Any:
    """Return a part of a document as JSON holds it, and append its figures."""
    match value:
        case doc.Tone():
            return doc.BOXES.get(value, value.value)
        case Verdict():
            return doc.COLOURS[value]
        case str():
            return breakable(doc.printable(value))
        case doc.Maths(source):
            return {"maths": source}
        case doc.Code(text):
            return {"code": doc.printable(text)}
        case doc.Listing(text):
            return {"kind": "listing", "text": breakable(doc.printable(text), _LONGEST_LISTED)}
        case doc.Formula():
            texts = {"name": doc.printable(value.name), "origin": doc.printable(value.origin)}
            return {"kind": "formula", **texts, "confirmed": value.confirmed, "lines": value.lines}
        case doc.Equations(symbols, origin):
            return {"kind": "equations", "symbols": symbols, "origin": doc.printable(origin)}
        case doc.Drawing(_, words, caption):
            drawings.append(value)
            file = f"figure-{len(drawings) - 1}.pdf"
            return {"kind": "drawing", "file": file, "words": words, "caption": _plain(caption, drawings)}
        case tuple():
            return [_plain(one, drawings) for one in cast("tuple[Any, ...]", value)]
        case doc.Paragraph() | doc.Bullets() | doc.Table() | doc.Cell() | doc.Section():
            inside = {one.name: _plain(getattr(value, one.name), drawings) for one in fields_of(value)}
            return {"kind": type(value).__name__.lower(), **inside}
        case _:
            return value


def breakable(text: str, longest: int = _LONGEST) -> str:
    """Return a text whose words of that many characters may be broken where a line ends."""
    return re.sub(rf"\S{{{longest},}}", lambda found: _BREAK.join(_PIECE.findall(found[0])), text)


# ----- the page -----

_ALIGNED = {"l": "", "r": ' class="right"', "c": ' class="centre"'}
#: What a browser may load: only what is on the page.
_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"


def page_of(document: doc.Document, advance: Callable[[], None] | None = None) -> str:
    """Return a report as HTML; `advance` is called after each figure."""
    writer = _Writer(advance)
    head = [writer.block(doc.heading_rows(document)), _signatures(document)]
    front = (*head, *map(writer.block, document.front), _contents(document))
    return _page(document.title, (*front, *writer.sections(document.sections)))


def page_with(title: str, front: Iterable[doc.Block], sections: Iterable[doc.Section]) -> str:
    """Return a page of HTML that is no report of a calculation."""
    writer = _Writer(None)
    return _page(title, (*map(writer.block, front), *writer.sections(sections)))


def _page(title: str, parts: Iterable[str]) -> str:
    style = files("dcfp.present.report").joinpath("style.css").read_text(encoding="utf-8")
    inside = "\n".join(parts)
    return f"""<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{_POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{escape(title)}</title>
<style>
{style}</style>
</head>
<body>
<main>
<h1>{escape(title)}</h1>
{inside}
</main>
</body>
</html>
"""


class _Writer:
    def __init__(self, advance: Callable[[], None] | None) -> None:
        self.advance = advance

    def sections(self, sections: Iterable[doc.Section]) -> list[str]:
        return [self.section(one, f"{place}") for place, one in enumerate(sections, 1)]

    def section(self, section: doc.Section, number: str) -> str:
        level = number.count(".") + 2
        start = ' class="page"' if section.on_new_page else ""
        inside = [self.block(block) for block in section.blocks]
        inside += [self.section(part, f"{number}.{i}") for i, part in enumerate(section.parts, 1)]
        head = f'<h{level} id="s{number}"><span class="number">{number}</span> {escape(section.title)}</h{level}>'
        return "\n".join([f"<section{start}>", head, *inside, "</section>"])

    def block(self, block: doc.Block) -> str:
        match block:
            case doc.Paragraph(parts, doc.Tone.PLAIN):
                return f"<p>{_words(parts)}</p>"
            case doc.Paragraph(parts, tone):
                kind = "note" if tone is doc.Tone.NOTE else f"box {doc.BOXES[tone]}"
                return f'<p class="{kind}">{_words(parts)}</p>'
            case doc.Bullets(items):
                return "<ul>" + "".join(f"<li>{_words(item)}</li>" for item in items) + "</ul>"
            case doc.Table():
                return _table(block)
            case doc.Formula():
                return _formula(block)
            case doc.Equations(symbols, origin):
                lines = "".join(f"<div>{mathml(one)}</div>" for one in symbols)
                return f'<div class="formula"><div class="lines">{lines}</div><div class="origin">{escape(origin)}</div></div>'
            case doc.Drawing():
                return self.drawing(block)
            case doc.Listing(text):
                return f"<pre>{escape(text)}</pre>"

    def drawing(self, block: doc.Drawing) -> str:
        data = base64.b64encode(_drawn(block, "png")).decode("ascii")
        if self.advance is not None:
            self.advance()
        caption = f"<figcaption>{escape(block.caption)}</figcaption>" if block.caption else ""
        return (
            f'<figure><img alt="{escape(block.words)}" src="data:image/png;base64,{data}">{caption}</figure>'
        )


def escape(text: str) -> str:
    """Return a text in which nothing has a meaning for a browser."""
    return escape_html(doc.printable(text))


def _words(parts: doc.Parts) -> str:
    pieces: list[str] = []
    for part in parts:
        match part:
            case doc.Maths(source):
                pieces.append(mathml(source))
            case doc.Code(text):
                pieces.append(f"<code>{escape(text)}</code>")
            case str():
                pieces.append(_linked(part))
    return "".join(pieces)


def _linked(text: str) -> str:
    """Return a text in which a DOI is a link."""
    before, mark, doi = text.partition(" doi:")
    if not mark or not doi.startswith("10.") or any(c.isspace() for c in doi):
        return escape(text).replace("\n", "<br>")
    address = escape(f"https://doi.org/{doi}")
    return f'{escape(before)} <a href="{address}">doi:{escape(doi)}</a>'


def _table(table: doc.Table) -> str:
    head = ""
    if table.head:
        names = "".join(
            f"<th{_ALIGNED[letter]} scope='col'>{_words(cell.parts)}</th>"
            for cell, letter in zip(table.head, table.aligned, strict=True)
        )
        head = f"<thead><tr>{names}</tr></thead>"
    caption = f"<caption>{escape(table.caption)}</caption>" if table.caption else ""
    kind = "" if table.head else ' class="values"'
    rows = "\n".join(_row(row, table.aligned) for row in table.rows)
    return f'<div class="scroll"><table{kind}>{caption}{head}<tbody>\n{rows}\n</tbody></table></div>'


def _row(row: tuple[doc.Cell, ...], aligned: str) -> str:
    found: list[str] = []
    place = 0
    for cell in row:
        span = f' colspan="{cell.span}"' if cell.span > 1 else ""
        content = _words(cell.parts)
        if cell.verdict is not None:
            content = f'<span class="{doc.COLOURS[cell.verdict]}">{content}</span>'
        if cell.strong:
            content = f"<strong>{content}</strong>"
        found.append(f"<td{_ALIGNED[aligned[place]]}{span}>{content}</td>")
        place += cell.span
    return f"<tr>{''.join(found)}</tr>"


def _formula(formula: doc.Formula) -> str:
    lines = " ".join(f'<span class="line">{mathml(line)}</span>' for line in formula.lines)
    kind = "origin" if formula.confirmed else "origin open"
    return (
        f'<div class="formula"><div class="name">{escape(formula.name)}</div><div class="{kind}">{escape(formula.origin)}</div>'
        f'<div class="lines">{lines}</div></div>'
    )


def _signatures(document: doc.Document) -> str:
    people = "".join(
        f'<div><span class="note">{escape(role)}</span><br>{escape(name)}{"<br>" if date else ""}{escape(date)}</div>'
        for role, name, date in doc.signatories(document)
    )
    return f'<div class="signatures">{people}</div>'


def _contents(document: doc.Document) -> str:
    items = "".join(_entry(one, f"{place}") for place, one in enumerate(document.sections, 1))
    return f"<nav><h2>Contents</h2><ol>{items}</ol></nav>"


def _entry(section: doc.Section, number: str) -> str:
    """Return the entry of a section in the contents, with those of the sections within it."""
    within = (
        []
        if "." in number
        else [_entry(part, f"{number}.{place}") for place, part in enumerate(section.parts, 1)]
    )
    inside = f"<ol>{''.join(within)}</ol>" if within else ""
    return f'<li><a href="#s{number}">{escape(section.title)}</a>{inside}</li>'
