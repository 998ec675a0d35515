"""A report as PDF, by Typst."""

import tempfile
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from typing import Any

from dcfp.errors import AnalysisError, InputError
from dcfp.present.report.document import Document, Drawing
from dcfp.present.report.typst_source import typst_source

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
