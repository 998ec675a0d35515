"""What the tests read from a page, and do to it."""

from pathlib import Path
from typing import Any

#: Tiles of the page, by the names of their quantities.
DISPLACEMENT, SWING, RESIDUAL, INPUT = (
    "peak_displacement",
    "peak_change",
    "residual_displacement",
    "input_velocity",
)
FORCE, RATIO, TEMPERATURE, FRICTION = "peak_force", "force_ratio", "peak_temperature", "least_friction"


def tile(page: Any, name: str) -> str:
    """The number in a tile."""
    return page.locator(f'[data-tile="{name}"]').inner_text()


def wait_for_tile(page: Any, name: str, text: str) -> None:
    """Wait until a tile shows a text."""
    page.wait_for_function(
        "([name, text]) => document.querySelector(`[data-tile='${name}']`)?.textContent === text",
        arg=[name, text],
        timeout=15_000,
    )


def send(page: Any, *paths: Path) -> None:
    """Send files."""
    page.locator("input[type=file]").set_input_files([str(path) for path in paths])


def fill(page: Any, label: str, value: str) -> None:
    """Write into a field."""
    page.get_by_label(label, exact=True).first.fill(value)


def show(page: Any, name: str) -> None:
    """Go to one of the three pages, and wait until it is seen and the others are not: they have fields of the same names."""
    page.get_by_role("button", name=name, exact=True).click()
    page.wait_for_function(
        """(name) => {
            const seen = [...document.querySelectorAll('main > section')].filter((one) => one.offsetParent !== null);
            return seen.length === 1 && seen[0].getAttribute('aria-label') === name;
        }""",
        arg=name,
    )


def slide(page: Any, label: str, key: str, times: int = 1) -> None:
    """Move a slider with the keyboard."""
    slider = page.get_by_role("slider", name=label)
    slider.focus()
    for _ in range(times):
        page.keyboard.press(key)
