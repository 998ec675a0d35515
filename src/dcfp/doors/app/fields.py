"""Fields with a label above them, as every panel uses them, those of a bearing, its friction and its heat, and those of the records."""

import asyncio
import math
from collections.abc import Callable, Collection, Generator, Mapping, Sequence
from contextlib import contextmanager, nullcontext
from functools import partial
from typing import Any, cast

from nicegui import ui
from nicegui.events import UploadEventArguments

from dcfp.doors.app.elements import FileDrop, Slider, Text
from dcfp.doors.app.session import (
    LARGEST_FILE,
    MOST_FILES,
    BearingForm,
    Session,
    bearing_fields,
    capitalised,
    read_upload,
    too_large,
)
from dcfp.errors import InputError
from dcfp.motion.formats.registry import FORMATS
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import DEGREE, HERTZ, SECOND
from dcfp.system import FRICTION_LAWS, HEATINGS

#: Time in which no key is pressed before a number counts [ms].
_PAUSE = 120
#: The one field of the heat that is not folded up.
_AMBIENT = "ambient"
#: Most records that are analysed together.
_MOST_CHOSEN = 8
_PGVS = (0.05, 1.5)
_CORNER = Parameter("high-pass filter, corner", HERTZ, step=0.01, absent="none", optional=True)
_ROTATE = Parameter("angle to turn them by, from x towards y", DEGREE, -360.0, 360.0, step=15.0, absent="none", optional=True)  # fmt: skip
_TIME_STEP = Parameter("time step of one column", SECOND, step=0.005, absent="in the file", optional=True)
_UNITS = {"": "as the file says", **{unit: unit for unit in ("mm/s2", "cm/s2", "gal", "m/s2", "g")}}


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
    label, unit = capitalised(one.words), one.unit.name if one.unit.has_dimension else ""
    if one.kind is bool:
        return switch_field(label, bool(value), change)
    if one.choices:
        return choice_field(label, words or {name: name for name in one.choices}, value, change)
    look: dict[str, Any] = {"suffix": unit or None, "placeholder": one.absent or None}
    look["value"] = shown_value(one, value)
    with _labelled(label) as name:
        if one.counts:
            made: Any = ui.input(**look, on_change=lambda event: change((event.value or "").strip() or None))
        else:
            made = ui.number(**look, step=one.step, on_change=lambda event: change(_number(event.value)))
        made.props(f"outlined dense for={name} debounce={_PAUSE}")
        made.props["aria-label"] = f"{label} [{unit}]" if unit else label
    return made


def shown_value(one: Parameter, value: Any) -> Any:
    """Return a value as its field shows it: several numbers as text, and what a visitor has written of them as it is."""
    if not one.counts:
        return value
    if isinstance(value, list):
        return ", ".join(f"{number:g}" for number in cast("list[float]", value))
    return str(value or "")


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
    settings: dict[str, Any] = {"value": list(value) if several else value, "multiple": several}
    with _labelled(label) as name:
        made = ui.select(
            dict(options), with_input=search, on_change=lambda event: change(event.value), **settings
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
        with card("Bearing"):
            self._places["bearing"] = ui.element("div").classes("pair")
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
        self._choices[key] = choice_field(label, words, self._form.values[key], partial(self._put, key))
        self._places[key] = ui.element("div").classes("brought")

    def _fill(self, place: str, fields: Mapping[str, Parameter], first: str = "", folded: str = "") -> None:
        """Put fields into a place, all but the first folded up under a title where there is one."""
        self._fields[place] = {}
        self._places[place].clear()
        ahead, rest = ([key for key in fields if (key == first) is wanted] for wanted in (True, False))
        with self._places[place]:
            for keys, around in (
                (ahead, nullcontext()),
                (rest, more(folded) if folded and rest else nullcontext()),
            ):
                with around:
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


def upload_words() -> str:
    """Return what is said of the files that may be sent."""
    return f"or drop them here: {', '.join(FORMATS)}; up to {MOST_FILES} of {LARGEST_FILE / 1e6:.0f} MB"


class RecordsPanel:
    """The fields of the records that a session holds; `changed` is called when one of them has changed."""

    def __init__(self, session: Session, changed: Callable[[], None]) -> None:
        self._session, self._changed = session, changed
        self._read: dict[str, Any] = {"units": None, "time_step": None}
        put: Any = partial(partial, self._put)
        read_as: Any = partial(partial, self._read_as)
        with card("Ground motion"):
            self._records = choice_field(
                "Records", session.choices(), session.chosen, self._choose, several=True, search=True
            )
            drop = FileDrop(upload_words(), LARGEST_FILE, on_upload=self._take)
            refused = "{:.80}: the file could not be sent."
            drop.on("too_large", lambda event: self._alert.say(too_large(str(event.args))))
            drop.on("refused", lambda event: self._alert.say(refused.format(str(event.args))))
            self._alert = Alert()
            self._pgv = Slider("PGV of every record", "m/s", 2, session.pgv, _PGVS, 0.01, put("pgv"))
            switch_field("As recorded, not scaled", session.as_recorded, put("as_recorded"))
            action("Join the chosen components as a station", self._join)
            with ui.element("div").classes("brought") as self._of_stations:
                parameter_field(_ROTATE, session.rotate, put("rotate"))
                switch_field(
                    "Vertical force follows the vertical component", session.vertical, put("vertical")
                )
            self._of_stations.set_visibility(session.in_plane)
            with more("Treatment and plain files"):
                switch_field("Remove a linear baseline in velocity", session.baseline, put("baseline"))
                parameter_field(_CORNER, session.corner, put("corner"))
                with ui.element("div").classes("pair"):
                    choice_field("Unit of plain columns", _UNITS, "", read_as("units"))
                    parameter_field(_TIME_STEP, None, read_as("time_step"))
                Text("p", "K-NET, KiK-net and JMA files are raw: filter them at 0.05 Hz before trusting a PGV.").classes("note")  # fmt: skip

    def _choose(self, keys: Any) -> None:
        chosen = [str(key) for key in keys or ()]
        if len(chosen) > _MOST_CHOSEN:
            self._alert.say(f"The page analyses at most {_MOST_CHOSEN} records at a time; for more there are studies in Python and on the command line.")  # fmt: skip
            self._records.value = chosen[:_MOST_CHOSEN]
            return
        if chosen != self._session.chosen:
            self._alert.say("")
            self._session.choose(chosen)
            self._of_stations.set_visibility(self._session.in_plane)
            self._changed()

    def _join(self) -> None:
        try:
            key = self._session.join()
        except InputError as error:
            self._alert.say(str(error))
            return
        self._records.set_options(self._session.choices(), value=[key])

    async def _take(self, event: UploadEventArguments) -> None:
        session, file = self._session, event.file
        try:
            session.refuse_more_files()
            if file.size() > LARGEST_FILE:
                raise InputError(too_large(file.name))
            content = await file.read()
            uploads = await asyncio.to_thread(read_upload, content, file.name, **self._read)
            keys = session.take(uploads)
        except InputError as error:
            self._alert.say(str(error))
            return
        self._alert.say("")
        self._records.set_options(session.choices(), value=keys[:1])

    def _put(self, name: str, value: Any) -> None:
        setattr(self._session, name, value)
        if name == "as_recorded":
            self._pgv.set_off(value)
        if name != "pgv" or not self._session.as_recorded:
            self._changed()

    def _read_as(self, name: str, value: Any) -> None:
        """Say how plain files are read that are sent from now on."""
        self._read[name] = value or None
