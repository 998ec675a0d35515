"""A report as one page of HTML that needs no other file, no script and no connection."""

import base64
from collections.abc import Callable, Iterable
from html import escape as escape_html
from importlib.resources import files
from io import BytesIO

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
    signatories,
)
from dcfp.present.report.maths import mathml

_ALIGNED = {"l": "", "r": ' class="right"', "c": ' class="centre"'}
#: What a browser may load: only what is on the page.
_POLICY = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"


def page_of(document: Document, advance: Callable[[], None] | None = None) -> str:
    """Return a report as HTML; `advance` is called after each figure."""
    writer = _Writer(advance)
    head = [writer.block(heading_rows(document)), _signatures(document)]
    front = (*head, *map(writer.block, document.front), _contents(document))
    return _page(document.title, (*front, *writer.sections(document.sections)))


def page_with(title: str, front: Iterable[Block], sections: Iterable[Section]) -> str:
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

    def sections(self, sections: Iterable[Section]) -> list[str]:
        return [self.section(one, f"{place}") for place, one in enumerate(sections, 1)]

    def section(self, section: Section, number: str) -> str:
        level = number.count(".") + 2
        start = ' class="page"' if section.on_new_page else ""
        inside = [self.block(block) for block in section.blocks]
        inside += [self.section(part, f"{number}.{i}") for i, part in enumerate(section.parts, 1)]
        head = f'<h{level} id="s{number}"><span class="number">{number}</span> {escape(section.title)}</h{level}>'
        return "\n".join([f"<section{start}>", head, *inside, "</section>"])

    def block(self, block: Block) -> str:
        match block:
            case Paragraph(parts, Tone.PLAIN):
                return f"<p>{_words(parts)}</p>"
            case Paragraph(parts, tone):
                kind = "note" if tone is Tone.NOTE else f"box {BOXES[tone]}"
                return f'<p class="{kind}">{_words(parts)}</p>'
            case Bullets(items):
                return "<ul>" + "".join(f"<li>{_words(item)}</li>" for item in items) + "</ul>"
            case Table():
                return _table(block)
            case Formula():
                return _formula(block)
            case Equations(symbols, origin):
                lines = "".join(f"<div>{mathml(one)}</div>" for one in symbols)
                return f'<div class="formula"><div class="lines">{lines}</div><div class="origin">{escape(origin)}</div></div>'
            case Drawing():
                return self.drawing(block)
            case Listing(text):
                return f"<pre>{escape(text)}</pre>"

    def drawing(self, block: Drawing) -> str:
        from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import

        stream = BytesIO()
        figure = block.draw()
        save_figure(figure, stream, "png")
        data = base64.b64encode(stream.getvalue()).decode("ascii")
        if self.advance is not None:
            self.advance()
        caption = f"<figcaption>{escape(block.caption)}</figcaption>" if block.caption else ""
        return (
            f'<figure><img alt="{escape(block.words)}" src="data:image/png;base64,{data}">{caption}</figure>'
        )


def escape(text: str) -> str:
    """Return a text in which nothing has a meaning for a browser."""
    return escape_html(printable(text))


def _words(parts: Parts) -> str:
    pieces: list[str] = []
    for part in parts:
        match part:
            case Maths(source):
                pieces.append(mathml(source))
            case Code(text):
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


def _table(table: Table) -> str:
    head = ""
    if table.head:
        names = "".join(
            f"<th{_ALIGNED[letter]} scope='col'>{_words(parts)}</th>"
            for parts, letter in zip(table.head, table.aligned, strict=True)
        )
        head = f"<thead><tr>{names}</tr></thead>"
    caption = f"<caption>{escape(table.caption)}</caption>" if table.caption else ""
    kind = "" if table.head else ' class="values"'
    rows = "\n".join(_row(row, table.aligned) for row in table.rows)
    return f'<div class="scroll"><table{kind}>{caption}{head}<tbody>\n{rows}\n</tbody></table></div>'


def _row(row: tuple[Cell, ...], aligned: str) -> str:
    found: list[str] = []
    place = 0
    for cell in row:
        span = f' colspan="{cell.span}"' if cell.span > 1 else ""
        content = _words(cell.parts)
        if cell.verdict is not None:
            content = f'<span class="{COLOURS[cell.verdict]}">{content}</span>'
        if cell.strong:
            content = f"<strong>{content}</strong>"
        found.append(f"<td{_ALIGNED[aligned[place]]}{span}>{content}</td>")
        place += cell.span
    return f"<tr>{''.join(found)}</tr>"


def _formula(formula: Formula) -> str:
    lines = " ".join(f'<span class="line">{mathml(line)}</span>' for line in formula.lines)
    kind = "origin" if formula.confirmed else "origin open"
    return (
        f'<div class="formula"><div class="name">{escape(formula.name)}</div><div class="{kind}">{escape(formula.origin)}</div>'
        f'<div class="lines">{lines}</div></div>'
    )


def _signatures(document: Document) -> str:
    people = "".join(
        f'<div><span class="note">{escape(role)}</span><br>{escape(name)}{"<br>" if date else ""}{escape(date)}</div>'
        for role, name, date in signatories(document)
    )
    return f'<div class="signatures">{people}</div>'


def _contents(document: Document) -> str:
    if not document.with_contents:
        return ""
    items = "".join(_entry(one, f"{place}") for place, one in enumerate(document.sections, 1))
    return f"<nav><h2>Contents</h2><ol>{items}</ol></nav>"


def _entry(section: Section, number: str) -> str:
    """Return the entry of a section in the contents, with those of the sections within it."""
    within = (
        []
        if "." in number
        else [_entry(part, f"{number}.{place}") for place, part in enumerate(section.parts, 1)]
    )
    inside = f"<ol>{''.join(within)}</ol>" if within else ""
    return f'<li><a href="#s{number}">{escape(section.title)}</a>{inside}</li>'
