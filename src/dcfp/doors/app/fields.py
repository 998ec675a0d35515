"""Fields with a label above them, as every panel uses them, and those of the bearing, its friction and its heat."""

import math
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any

from nicegui import ui

from dcfp.doors.app.elements import Text
from dcfp.doors.app.forms import HEATINGS, LAWS, LIMITS, BearingForm, Limits, reference_of

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


# The fields of the bearing, its friction and its heat.


_NUMBERS = (
    ("lower_radius", "Radius, lower plate", "mm", ""),
    ("upper_radius", "Radius, upper plate", "mm", ""),
    ("slider", "Slider diameter", "mm", ""),
    ("pressure", "Pressure", "N/mm²", ""),
    ("stiffness", "Stiffness at rest", "kN/mm", ""),
    ("capacity", "Capacity", "mm", "not known"),
)


class BearingPanel:
    """The fields; every page of a visitor has them, and they always show the same bearing.

    Parameters
    ----------
    form
        What the fields hold.
    changed
        Called when one of them has changed.
    varies
        Names of fields that this page varies itself.
    """

    def __init__(self, form: BearingForm, changed: Callable[[], None], varies: tuple[str, ...] = ()) -> None:
        self._form, self._changed = form, changed
        self._fields: dict[str, Any] = {}
        self._quiet = False
        numbers = [one for one in _NUMBERS if one[0] not in varies]
        with card("Bearing"):
            for first, second in zip(numbers[::2], numbers[1::2], strict=False):
                with ui.element("div").classes("pair"):
                    self._number(*first)
                    self._number(*second)
            if len(numbers) % 2:
                self._number(*numbers[-1])
        with card("Friction and heat"):
            self._fields["law"] = choice_field("Friction law", LAWS, form.law, self._choose_law)
            with ui.element("div").classes("pair"):
                if "mu" not in varies:
                    self._number("mu", "Reference µ", "–", "")
                self._number("ambient", "Ambient", "°C", "")
            self._fields["heating"] = choice_field(
                "Temperature of the contact from", HEATINGS, form.heating, self._choose_heating
            )
            with more("Plates"):
                self._number("thickness", "Thickness of the plates", "mm", "endless")
            action("Bearing of the paper", self._reset)

    def refresh(self) -> None:
        """Show what the form holds, which another page may have changed."""
        self._quiet = True
        for name, element in self._fields.items():
            element.value = getattr(self._form, name)
        self._quiet = False

    def _number(self, name: str, label: str, unit: str, hint: str) -> None:
        def change(value: float | None) -> None:
            self._set(name, value)

        self._fields[name] = number_field(
            label, unit, getattr(self._form, name), LIMITS[name], change, hint=hint
        )

    def _choose_law(self, law: str) -> None:
        if law == self._form.law or self._quiet:
            return
        self._form.law = law
        self._form.mu = reference_of(law)
        self.refresh()
        self._changed()

    def _choose_heating(self, heating: str) -> None:
        self._set("heating", heating)

    def _set(self, name: str, value: object) -> None:
        if self._quiet or getattr(self._form, name) == value:
            return
        setattr(self._form, name, value)
        self._changed()

    def _reset(self) -> None:
        for name, value in vars(BearingForm()).items():
            setattr(self._form, name, value)
        self.refresh()
        self._changed()
