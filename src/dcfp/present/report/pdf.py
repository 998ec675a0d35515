"""A report as PDF, by Typst."""

import json
import re
import tempfile
from collections.abc import Callable
from dataclasses import fields as fields_of
from importlib.resources import files
from io import BytesIO
from pathlib import Path
from typing import Any, cast

from dcfp.errors import AnalysisError, InputError
from dcfp.present.report.document import (
    BOXES,
    COLOURS,
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
    Section,
    Table,
    Tone,
    heading_rows,
    printable,
    short_title,
    signatories,
)  # fmt: skip
from dcfp.schema.check import Verdict

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
    data, drawings = data_of(document)
    with tempfile.TemporaryDirectory(prefix="dcfp-report-") as name:
        folder = Path(name)
        for place, drawing in enumerate(drawings):
            (folder / f"figure-{place}.pdf").write_bytes(_figure(drawing))
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


# ----- what the template reads -----

#: Words of so many characters may be broken: after signs, and every 15 characters. In a listing only those that no line can hold.
_LONGEST, _LONGEST_LISTED = 22, 100
_PIECE = re.compile(r"[^_\-./\\:,;|]{0,15}[_\-./\\:,;|]|\S{1,15}")
_BREAK = "\u200b"


def data_of(document: Document) -> tuple[str, list[Drawing]]:
    """Return a report as JSON, and its figures: number i is to lie beside it as ``figure-i.pdf``."""
    drawings: list[Drawing] = []
    data = {
        "title": printable(document.title),
        "author": printable(document.heading.author),
        "maker": printable(document.maker),
        "short": _plain(short_title(document), drawings),
        "heading": _plain(document.title, drawings),
        "rows": _plain(heading_rows(document), drawings),
        "signatories": _plain(signatories(document), drawings),
        "front": _plain(document.front, drawings),
        "with_contents": document.with_contents,
        "sections": _plain(document.sections, drawings),
    }
    return json.dumps(data, ensure_ascii=False), drawings


def _plain(value: Any, drawings: list[Drawing]) -> Any:
    """Return a part of a document as JSON holds it, and append its figures."""
    match value:
        case Tone():
            return BOXES.get(value, value.value)
        case Verdict():
            return COLOURS[value]
        case str():
            return breakable(printable(value))
        case Maths(source):
            return {"maths": source}
        case Code(text):
            return {"code": printable(text)}
        case Listing(text):
            return {"kind": "listing", "text": breakable(printable(text), _LONGEST_LISTED)}
        case Formula():
            texts = {"name": printable(value.name), "origin": printable(value.origin)}
            return {"kind": "formula", **texts, "confirmed": value.confirmed, "lines": value.lines}
        case Equations(symbols, origin):
            return {"kind": "equations", "symbols": symbols, "origin": printable(origin)}
        case Drawing(_, words, caption):
            drawings.append(value)
            file = f"figure-{len(drawings) - 1}.pdf"
            return {"kind": "drawing", "file": file, "words": words, "caption": _plain(caption, drawings)}
        case tuple():
            return [_plain(one, drawings) for one in cast("tuple[Any, ...]", value)]
        case Paragraph() | Bullets() | Table() | Cell() | Section():
            inside = {one.name: _plain(getattr(value, one.name), drawings) for one in fields_of(value)}
            return {"kind": type(value).__name__.lower(), **inside}
        case _:
            return value


def breakable(text: str, longest: int = _LONGEST) -> str:
    """Return a text whose words of that many characters may be broken where a line ends."""
    return re.sub(rf"\S{{{longest},}}", lambda found: _BREAK.join(_PIECE.findall(found[0])), text)
