"""The pages: their number, their margins, the same bytes each time; and a page of HTML that needs nothing else."""

import os
import shutil
import subprocess
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from pypdf import PdfReader

from dcfp.present.report import Document, page_of, pdf_of
from dcfp.present.report.forms import data_of, fonts_suffice

pytestmark = pytest.mark.slow

#: Margins of a page that stay empty [cm]: of the text there are 2.2 at the sides.
_SIDES, _ENDS, _DOTS = 2.0, 0.9, 50.0


def pages_of(content: bytes, folder: Path) -> list[np.ndarray]:
    """Return the grey values of every page."""
    (folder / "report.pdf").write_bytes(content)
    command = ["pdftoppm", "-gray", "-r", f"{_DOTS:.0f}", "report.pdf", "page"]
    subprocess.run(command, cwd=folder, check=True)
    return [np.asarray(Image.open(path)) for path in sorted(folder.glob("page-*.pgm"))]


def margins_are_empty(page: np.ndarray) -> bool:
    side, end = (round(width / 2.54 * _DOTS) for width in (_SIDES, _ENDS))
    edges = (page[:, :side], page[:, -side:], page[:end], page[-end:])
    return all(int(edge.min()) > 240 for edge in edges)


needs_poppler = pytest.mark.skipif(
    shutil.which("pdftoppm") is None and os.environ.get("DCFP_REQUIRE_POPPLER") != "1",
    reason="needs pdftoppm of poppler",
)


@needs_poppler
def test_no_ink_is_in_the_margins(pdf: bytes, tmp_path: Path) -> None:
    pages = pages_of(pdf, tmp_path)
    assert [place for place, page in enumerate(pages, 1) if not margins_are_empty(page)] == []
    assert all(float((page < 200).mean()) > 0.001 for page in pages)  # none is empty


@needs_poppler
def test_names_of_any_length_stay_within_the_margins(nasty_pdf: bytes, tmp_path: Path) -> None:
    pages = pages_of(nasty_pdf, tmp_path)
    assert [place for place, page in enumerate(pages, 1) if not margins_are_empty(page)] == []


def test_every_page_has_its_number(pages: list[str]) -> None:
    assert 16 <= len(pages) <= 22
    for place, page in enumerate(pages, 1):
        assert f"{place} / {len(pages)}" in page


def test_each_case_has_one_page_with_both_figures(document: Document, pages: list[str]) -> None:
    for place, case in enumerate(document.numbers["cases"], 1):
        head = f"Case {place}: {case['record']}, {case['pgv_m_s']:.3f} m/s"
        (found,) = (page for page in pages[2:] if head in page)
        assert "Energy balance at the end" in found
        assert "governs by the pulse method" in found


def test_the_same_report_has_the_same_bytes(small: Document, small_pdf: bytes) -> None:
    assert pdf_of(small) == small_pdf
    assert page_of(small) == page_of(small)
    reader = PdfReader(BytesIO(small_pdf))
    assert reader.metadata is not None
    assert not {"/CreationDate", "/ModDate"} & set(reader.metadata)
    assert reader.metadata.title == "small"


def test_what_is_not_given_is_left_out(small_pdf: bytes, reading) -> None:
    text = reading.of_pdf(small_pdf)
    assert "Client" not in text
    assert "Calculated by (signature)" in text
    assert text.count("Date: ________") == 2


def test_the_page_needs_nothing_else(page: str, reading) -> None:
    text = reading.parsed(page)
    assert "script" not in text.tags
    assert text.tags.count("img") == 4
    others = [
        one
        for one in text.addresses
        if not one.startswith(("data:image/png;base64,", "#", "https://doi.org/"))
    ]
    assert others == []
    assert "default-src 'none'" in page
    assert "url(" not in page
    assert "@import" not in page
    targets = {f'id="{one[1:]}"' for one in text.addresses if one.startswith("#")}
    assert all(target in page for target in targets)
    assert "prefers-color-scheme: dark" in page
    assert "@media print" in page


def test_fonts_of_the_system_are_asked_only_for_what_typst_lacks(document: Document) -> None:
    assert fonts_suffice(data_of(document)[0])
    assert fonts_suffice("Zürich, Ő, µ ≤ √ – Ж")
    assert not fonts_suffice("東京")
