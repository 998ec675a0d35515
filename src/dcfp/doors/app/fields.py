"""Fields with a label above them, as every panel uses them, and those of the bearing, its friction and its heat."""

import math
from collections.abc import Callable, Collection, Generator, Mapping, Sequence
from contextlib import contextmanager, nullcontext
from functools import partial
from typing import Any, cast

from nicegui import ui

from dcfp.doors.app.elements import Text
from dcfp.doors.app.forms import BearingForm, bearing_fields, label_of
from dcfp.schema.parameters import Parameter
from dcfp.system import FRICTION_LAWS, HEATINGS

#: Time in which no key is pressed before a number counts [ms].
_PAUSE = 120
#: The one field of the heat that is not folded up.
_AMBIENT = "ambient"


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


def parameter_field(
    one: Parameter, value: Any, change: Callable[[Any], None], words: Mapping[str, str] | None = None
) -> Any:
    """Add the field of a parameter, for a number, several of them, a switch or a choice, whose choices `words` may put into words."""
    label = label_of(one)
    if one.kind is bool:
        return switch_field(label, bool(value), change)
    if one.choices:
        return choice_field(label, words or {name: name for name in one.choices}, value, change)
    unit = one.unit.name if one.unit.has_dimension else ""
    with _labelled(label) as name:
        if one.counts:
            made: Any = ui.input(value=_listed(value), suffix=unit or None, placeholder=one.absent or None, on_change=lambda event: change((event.value or "").strip() or None))  # fmt: skip
        else:
            made = ui.number(value=value, step=one.step, suffix=unit or None, placeholder=one.absent or None, on_change=lambda event: change(_number(event.value)))  # fmt: skip
        made.props(f"outlined dense for={name} debounce={_PAUSE}")
        made.props["aria-label"] = f"{label} [{unit}]" if unit else label
    return made


def shown_value(one: Parameter, value: Any) -> Any:
    """Return a value as its field shows it."""
    return _listed(value) if one.counts else value


def _listed(value: Any) -> str:
    """Return several numbers as text; what a visitor has written, as it is."""
    return (
        ", ".join(f"{number:g}" for number in cast("list[float]", value))
        if isinstance(value, list)
        else str(value or "")
    )


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


class BearingPanel:
    """The fields of a bearing; every page of a visitor has them, and they always show the same one.

    `changed` is called when one of them has changed; a page that `varies` some itself does not have those, with ``"mu"`` for the reference
    coefficient of any law.
    """

    def __init__(self, form: BearingForm, changed: Callable[[], None], varies: Collection[str] = ()) -> None:
        self._form, self._changed, self._varies = form, changed, varies
        self._choices: dict[str, ui.select] = {}
        self._places: dict[str, ui.element] = {}
        self._fields: dict[str, dict[str, tuple[Parameter, Any]]] = {}
        self._shown: tuple[str, str] = ("", "")
        self._quiet = False
        with card("Bearing"), ui.element("div").classes("pair") as self._places["bearing"]:
            pass
        with card("Friction and heat"):
            self._choice("law", "Friction law", {name: law.words for name, law in FRICTION_LAWS.items()})
            words = {name: model.words for name, model in HEATINGS.items()}
            self._choice("heating", "Temperature of the contact from", words)
            action("Bearing of the paper", self._reset)
        self._fill("bearing", {key: one for key, one in bearing_fields().items() if key not in varies})
        self.refresh()

    def refresh(self) -> None:
        """Show what the form holds, which another page may have changed."""
        form = self._form
        self._quiet = True
        for key, element in self._choices.items():
            element.value = form.values[key]
        chosen = (form.values["law"], form.values["heating"])
        if chosen != self._shown:
            self._shown = chosen
            hidden = form.reference if "mu" in self._varies else ""
            law = {key: one for key, one in form.law_fields().items() if key != hidden}
            self._fill("law", law, form.reference, "Parameters of the law")
            self._fill("heating", form.heating_fields(), _AMBIENT, "Plates and their heat")
        for fields in self._fields.values():
            for key, (one, element) in fields.items():
                element.value = shown_value(one, form.values[key])
        self._quiet = False

    def _choice(self, key: str, label: str, words: Mapping[str, str]) -> None:
        """Add a choice and the place of the parameters that it brings."""
        self._choices[key] = choice_field(
            label, words, self._form.values[key], lambda name: self._put(key, name)
        )
        self._places[key] = ui.element("div").classes("brought")

    def _fill(self, place: str, fields: Mapping[str, Parameter], first: str = "", folded: str = "") -> None:
        """Put fields into a place, all but the first folded up under a title where there is one."""
        self._fields[place] = {}
        self._places[place].clear()
        with self._places[place]:
            rest = [key for key in fields if key != first]
            self._add(place, fields, [first] if first in fields else [])
            with more(folded) if folded and rest else nullcontext():
                self._add(place, fields, rest)

    def _add(self, place: str, fields: Mapping[str, Parameter], keys: list[str]) -> None:
        for key in keys:
            made = parameter_field(fields[key], self._form.values[key], partial(self._put, key))
            self._fields[place][key] = (fields[key], made)

    def _put(self, key: str, value: Any) -> None:
        if self._quiet or self._form.values[key] == value:
            return
        self._form.put(key, value)
        if key in ("law", "heating", self._form.reference):
            self.refresh()
        self._changed()

    def _reset(self) -> None:
        self._form.reset()
        self.refresh()
        self._changed()
