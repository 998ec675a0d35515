"""Fields with a label above them, as every panel uses them."""

import math
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from nicegui import ui

from dcfp.doors.app.elements import Text
from dcfp.doors.app.forms import Limits

#: Time in which no key is pressed before a number counts [ms].
_PAUSE = 120


@contextmanager
def card(title: str, level: str = "h2", note: str = "") -> Generator[ui.element]:
    """Open a card with a title."""
    with ui.element("section").classes("card") as outer:
        if title:
            Text(level, title)
        if note:
            Text("p", note).classes("note")
        yield outer


@contextmanager
def more(title: str) -> Generator[None]:
    """Open a part that is folded up at first."""
    with ui.element("details").classes("more"):
        Text("summary", title)
        with ui.element("div"):
            yield


@contextmanager
def _labelled(label: str) -> Generator[str]:
    """Open a field with its label, and give the name by which the label knows the input."""
    with ui.element("div").classes("field") as outer:
        name = f"input-{outer.id}"
        Text("label", label).classes("field-label").props(f"for={name}")
        yield name


def number_field(
    label: str,
    unit: str,
    value: float | None,
    limits: Limits,
    change: Callable[[float | None], None],
    *,
    hint: str = "",
) -> ui.number:
    """Add a field for a number of `unit`; `hint` stands in it while it is empty."""
    with _labelled(label) as name:
        made = ui.number(
            value=value,
            step=limits.step,
            suffix=unit or None,
            placeholder=hint or None,
            on_change=lambda event: change(_number(event.value)),
        )
        made.props(f"outlined dense for={name} debounce={_PAUSE}")
        made.props["aria-label"] = f"{label} [{unit}]" if unit else label
    return made


def _number(value: object) -> float | None:
    if isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value):
        return float(value)
    return None


def choice_field(
    label: str,
    options: Mapping[str, str],
    value: str | Sequence[str],
    change: Callable[[Any], None],
    *,
    several: bool = False,
    search: bool = False,
) -> ui.select:
    """Add a field for one or several of some options."""
    with _labelled(label) as name:
        made = ui.select(
            dict(options),
            value=list(value) if several else value,
            multiple=several,
            with_input=search,
            on_change=lambda event: change(event.value),
        )
        made.props(f"outlined dense options-dense for={name} {'use-chips' if several else ''}")
        if search:  # then the input does not carry the name by which the label knows it
            made.props["aria-label"] = label
    return made


def switch_field(label: str, value: bool, change: Callable[[bool], None]) -> ui.switch:
    """Add a switch."""
    return ui.switch(label, value=value, on_change=lambda event: change(bool(event.value))).props("dense")


def action(label: str, do: Callable[[], Any]) -> ui.element:
    """Add a button."""
    made = Text("button", label).classes("action").props("type=button")
    made.on("click", do, args=[])
    return made


class Alert:
    """A place for the sentence that says what is wrong."""

    def __init__(self) -> None:
        self._text = Text("div").classes("alert").props("role=alert")
        self._text.set_visibility(False)

    def say(self, sentence: str) -> None:
        """Show a sentence; an empty one takes it away."""
        self._text.text = sentence
        self._text.set_visibility(bool(sentence))
