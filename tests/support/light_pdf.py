"""PDFs that are made and read quickly."""

import shutil
import subprocess
from io import BytesIO

import pytest


def leave_out_layout(patch: pytest.MonkeyPatch) -> None:
    """Embed fonts in figures without the tables by which other programs set text: half of the time goes into making them smaller."""
    from fontTools.subset import Options

    layout = ["GSUB", "GPOS", "GDEF"]
    patch.setattr(Options, "_drop_tables_default", [*Options._drop_tables_default, *layout])


def leave_out_figures(patch: pytest.MonkeyPatch) -> None:
    """Have empty figures in a report; for what is in its words."""
    from matplotlib.figure import Figure

    from dcfp.present.report import forms

    def empty(drawing: object, kind: str) -> bytes:
        stream = BytesIO()
        Figure(figsize=(1.0, 1.0)).savefig(stream, format=kind)
        return stream.getvalue()

    patch.setattr(forms, "_drawn", empty)


def page_texts(content: bytes) -> list[str]:
    """Return the words of every page."""
    if shutil.which("pdftotext") is None:
        from pypdf import PdfReader  # late: it needs seconds

        return [page.extract_text() for page in PdfReader(BytesIO(content)).pages]
    done = subprocess.run(["pdftotext", "-raw", "-", "-"], input=content, capture_output=True, check=True)
    return done.stdout.decode().split("\f")[:-1]
