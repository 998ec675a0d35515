"""The page for everyone: on a telephone, with the keyboard, in the dark."""

import pytest

from .page_reading import DISPLACEMENT, show, slide, tile

PAGES = ("Response", "Test machine", "Design chart")


#: Inputs that can be seen and have no name.
NAMELESS = """() => [...document.querySelectorAll('input, select, textarea, button, [role=slider], [role=switch], canvas[role=img]')]
    .filter((one) => one.offsetParent !== null)
    .filter((one) => !one.getAttribute('aria-label') && !one.labels?.length && !one.textContent.trim())
    .filter((one) => !one.closest('[role=switch], .q-chip'))
    .map((one) => one.outerHTML.slice(0, 120))"""


def test_nothing_sticks_out_at_the_side_and_every_input_has_a_name(shared_page):
    page = shared_page
    for name in PAGES:
        show(page, name)
        for width in (375, 860, 1280):
            page.set_viewport_size({"width": width, "height": 760})
            page.wait_for_timeout(400)
            assert page.evaluate("document.documentElement.scrollWidth") <= width, name
        assert page.evaluate(NAMELESS) == [], name


def test_a_slider_says_what_it_is_and_where_it_stands(shared_page):
    page = shared_page
    slider = page.get_by_role("slider", name="PGV of every record")
    assert (slider.get_attribute("min"), slider.get_attribute("max")) == ("0.05", "1.5")
    before = tile(page, DISPLACEMENT)
    slide(page, "PGV of every record", "ArrowRight")
    page.wait_for_function(
        "before => document.querySelector('[data-tile=\"peak_displacement\"]').textContent !== before",
        arg=before,
    )
    assert slider.get_attribute("aria-valuetext") == "0.51 m/s"


def focused_names(page, count: int) -> list[str]:
    names: list[str] = []
    for _ in range(count):
        page.keyboard.press("Tab")
        names.append(
            page.evaluate(
                """() => {
                    const one = document.activeElement;
                    const label = one.labels?.[0]?.textContent ?? '';
                    return (one.getAttribute('aria-label') ?? label ?? '') || one.textContent.trim();
                }"""
            )
        )
    return names


@pytest.mark.slow
def test_every_control_can_be_reached_in_order_and_seen_there(open_page):
    page = open_page()
    names = focused_names(page, 60)
    expected = [
        "Skip to the page",
        "Unit of lengths",
        "Theme: system",
        "Response",
        "Test machine",
        "Design chart",
        "Records",
        "PGV of every record",
        "As recorded, not scaled",
        "Effective radius of the lower plate [mm]",
        "Diameter of the slider [mm]",
        "Friction law",
        "Coefficient at 60 N/mm2, 400 mm/s and 17.5 degC",
        "Bearing of the paper",
        "Play",
        "Time in the record",
        "Scenario (TOML)",
        "Figure (PNG)",
    ]
    places = [next((i for i, name in enumerate(names) if name.startswith(one)), -1) for one in expected]
    missing = [one for one, place in zip(expected, places, strict=True) if place < 0]
    assert not missing, "; ".join(names)
    assert places == sorted(places), list(zip(expected, places, strict=True))
    page.get_by_text(names[0]).focus()
    for _ in range(5):
        page.keyboard.press("Tab")
    assert page.evaluate("getComputedStyle(document.activeElement).outlineStyle") == "solid"
    page.get_by_text(names[0]).focus()
    page.keyboard.press("Enter")
    assert page.evaluate("document.activeElement.tagName") == "MAIN"


def background(page) -> int:
    """How bright the page is, from 0 to 765."""
    return page.evaluate(
        "getComputedStyle(document.body).backgroundColor.match(/\\d+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0)"
    )


@pytest.mark.slow
def test_the_theme_follows_the_system_and_can_be_turned(shared_page):
    page = shared_page
    page.emulate_media(color_scheme="dark")
    page.wait_for_function("document.body.classList.contains('body--dark')")
    assert background(page) < 200
    page.emulate_media(color_scheme="light")
    page.wait_for_function("document.body.classList.contains('body--light')")
    assert background(page) > 600
    button = page.get_by_role("button", name="Theme:")
    button.click()
    page.get_by_role("button", name="Theme: light").click()
    page.get_by_role("button", name="Theme: dark").wait_for()
    page.wait_for_function("document.body.classList.contains('body--dark')")
    assert background(page) < 200
