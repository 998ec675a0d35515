"""Whatever a user wrote is words, in Typst and in HTML."""

import pytest

from dcfp.present.report import Document, page_of
from dcfp.present.report.forms import breakable, data_of


@pytest.mark.slow
def test_typst_shows_what_was_written(nasty: Document, nasty_pdf: bytes, reading) -> None:
    text = reading.of_pdf(nasty_pdf).replace(" ", "")
    heading = nasty.heading
    for word in (
        nasty.title,
        heading.project,
        heading.client,
        heading.author,
        heading.checker,
        heading.number,
    ):
        assert reading.plain(word).replace(" ", "") in text


@pytest.mark.slow
def test_html_shows_what_was_written(nasty: Document, reading) -> None:
    page = page_of(nasty)
    parsed = reading.parsed(page)
    assert not {"script", "b", "iframe"} & set(parsed.tags)
    assert parsed.tags.count("img") == 2
    text = reading.of_page(page)
    heading = nasty.heading
    for word in (nasty.title, heading.project, heading.client, heading.author, heading.number, "</style>"):
        assert reading.plain(word) in text


def test_a_word_is_a_string_and_nothing_more(nasty: Document) -> None:
    body, _ = data_of(nasty)
    # outside of strings no user's word is left
    outside, inside, escaped = [], False, False
    for character in body:
        if escaped:
            escaped = False
        elif inside and character == "\\":
            escaped = True
        elif character == '"':
            inside = not inside
        elif not inside:
            outside.append(character)
    assert not inside
    rest = "".join(outside)
    assert "panic" not in rest
    assert "script" not in rest


def test_long_words_can_be_broken_and_short_ones_cannot() -> None:
    assert breakable("short words stay as they are") == "short words stay as they are"
    long = "a_very_long_name_without_any_space_0123456789012345678901234567890123456789"
    broken = breakable(long)
    assert broken.replace("\u200b", "") == long
    assert max(map(len, broken.split("\u200b"))) <= 16
