"""One calculation, its report and both forms of it, for all tests."""

import re
from collections.abc import Callable
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from light_pdf import page_texts

from dcfp.present.report import Document, build_report, page_of, pdf_of
from dcfp.present.report.document import Drawing, Section
from dcfp.study.scenario import Calculation, calculate, read_scenario

TOWER = Path(__file__).parents[3] / "docs" / "scenarios" / "tower.toml"


class Text(HTMLParser):
    """The words of a page, and every address in it."""

    def __init__(self, page: str) -> None:
        super().__init__(convert_charrefs=True)
        self.words: list[str] = []
        self.addresses: list[str] = []
        self.tags: list[str] = []
        self._silent = 0
        self.feed(page)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self._silent += tag == "style"
        self.addresses += [value or "" for name, value in attrs if name in ("src", "href")]

    def handle_endtag(self, tag: str) -> None:
        self._silent -= tag == "style"

    def handle_data(self, data: str) -> None:
        if not self._silent:
            self.words.append(data)


def plain(text: str) -> str:
    """Return a text with single spaces, and without the places at which it may be broken."""
    return re.sub(r"\s+", " ", text.replace("\u200b", ""))


def text_of_pdf(content: bytes) -> str:
    return plain(" ".join(page_texts(content)))


def text_of_page(page: str) -> str:
    return plain(" ".join(Text(page).words))


class Reading(NamedTuple):
    """How a report is read."""

    plain: Callable[[str], str] = plain
    of_pdf: Callable[[bytes], str] = text_of_pdf
    of_page: Callable[[str], str] = text_of_page
    parsed: Callable[[str], Text] = Text


@pytest.fixture(scope="session")
def reading() -> Reading:
    return Reading()


def with_the_lighter_figure(document: Document) -> Document:
    """Return a report without the figure of the response: each figure takes a second, and one is saved as the other."""

    def lean(section: Section) -> Section:
        blocks = tuple(one for one in section.blocks if not isinstance(one, Drawing) or "pulses" in one.words)
        return replace(section, blocks=blocks, parts=tuple(map(lean, section.parts)))

    return replace(document, sections=tuple(map(lean, document.sections)))


@pytest.fixture(scope="session")
def lighter() -> Callable[[Document], Document]:
    """What leaves the figure of the response out of a report."""
    return with_the_lighter_figure


def write_pulse(path: Path) -> Path:
    """Write a record of two seconds of a sine wave and two of rest [m/s2]."""
    time = np.arange(401) * 0.01
    wave = np.where(time <= 2.0, 3.0 * np.sin(2.0 * np.pi * time), 0.0)
    np.savetxt(path, np.column_stack((time, wave)), fmt="%.6f")
    return path


@pytest.fixture(scope="session")
def calculation(tmp_path_factory: pytest.TempPathFactory) -> Calculation:
    """The scenario of the guide at one of its two intensities."""
    path = tmp_path_factory.mktemp("tower") / "tower.toml"
    path.write_text(TOWER.read_text(encoding="utf-8").replace("[0.5, 0.75]", "[0.75]"), encoding="utf-8")
    return calculate(read_scenario(path))


@pytest.fixture(scope="session")
def document(calculation: Calculation) -> Document:
    return build_report(calculation)


@pytest.fixture(scope="session")
def pdf(document: Document) -> bytes:
    return pdf_of(document)


@pytest.fixture(scope="session")
def pages(pdf: bytes) -> list[str]:
    """The text of every page."""
    return page_texts(pdf)


@pytest.fixture(scope="session")
def nasty_pdf(nasty: Document) -> bytes:
    return pdf_of(nasty)


@pytest.fixture(scope="session")
def small_pdf(small: Document) -> bytes:
    return pdf_of(small)


@pytest.fixture(scope="session")
def page(document: Document) -> str:
    return page_of(document)


@pytest.fixture(scope="session")
def small(tmp_path_factory: pytest.TempPathFactory) -> Document:
    """A report of one short record with one figure, which is made quickly."""
    folder = tmp_path_factory.mktemp("small")
    write_pulse(folder / "pulse.txt")
    scenario = folder / "small.toml"
    scenario.write_text('[factors]\nrecord = ["pulse.txt"]\n[motion]\nunits = "m/s2"\n', encoding="utf-8")
    return with_the_lighter_figure(build_report(calculate(read_scenario(scenario))))


@pytest.fixture(scope="session")
def nasty(tmp_path_factory: pytest.TempPathFactory) -> Document:
    """A report in which every word of the user means something to Typst, to HTML or to TeX."""
    folder = tmp_path_factory.mktemp("nasty")
    name = "record_with_a_very_long_name_#panic()_$x^2$_<b>bold<_b>_0123456789_0123456789_0123456789_0123456789.txt"
    write_pulse(folder / name)
    text = f"""
title = 'A title with_a_word_that_nobody_can_break_because_it_has_no_spaces_in_it_0123456789 \\ # $x$ <script>alert(1)</script> #panic() *bold* `raw` @ref <label> // /* Zürich'
[factors]
record = ['{name}']
[motion]
units = "m/s2"
[bearing]
name = 'Bearing #panic("x") </td><script>alert(2)</script> \\begin{{x}} & % ~ </style>'
capacity = 50
capacity_note = ']#panic()[ \\ "quoted" $'
[report]
project = 'Project ]] #panic() [[ & <script> "double" ; )'
client = "Client_with_an_extremely_long_name_without_a_break_0123456789_0123456789_0123456789_0123456789_0123456789"
author = "O'Neill \\\\ #let x = 1 \\""
checker = "Éva Őry-Çelik"
number = "R-1/2 $5$"
notes = "two\\nlines, and a bell \\u0007"
"""
    scenario = folder / "nasty.toml"
    scenario.write_text(text, encoding="utf-8")
    return build_report(calculate(read_scenario(scenario)))
