"""The page: a head with units and theme, and three pages below it, of which one is seen."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING

from nicegui import ui
from nicegui.events import ValueChangeEventArguments

from dcfp.doors.app.design_tab import DesignTab, Surveys
from dcfp.doors.app.elements import Text
from dcfp.doors.app.machine_tab import MachineTab
from dcfp.doors.app.response_tab import ResponseTab
from dcfp.doors.app.session import Session
from dcfp.doors.app.units import CHOICES, Units
from dcfp.schema.units import Unit

if TYPE_CHECKING:
    from dcfp.doors.app.tab import Tab

#: Themes in the order of the button: that of the system, light, dark.
_THEMES = ((None, "system"), (False, "light"), (True, "dark"))


async def build_page(surveys: Surveys) -> None:
    """Build the page of one visitor."""
    session = Session()
    ui.colors(primary="#0b5394", dark="#1c2126", dark_page="#14181c")
    pages = _Pages(session, surveys)
    with ui.element("header").classes("top"):
        with ui.element("div").classes("name"):
            Text("h1", "dcfp")
            Text("p", "double concave friction pendulum bearings under recorded earthquakes")
        with ui.element("div").classes("units"):
            _add_units(session.units, pages.show_again)
        _add_theme()
        pages.add_buttons()
    with ui.element("main") as main:
        pages.add_places()
    ui.skip_link("Skip to the page", target=main)
    await ui.context.client.connected()
    pages.show(0)


class _Pages:
    """The three pages, each built when it is first seen."""

    def __init__(self, session: Session, surveys: Surveys) -> None:
        self._makers: Sequence[tuple[str, Callable[[], Tab]]] = (
            ("Response", lambda: ResponseTab(session)),
            ("Test machine", lambda: MachineTab(session)),
            ("Design chart", lambda: DesignTab(session, surveys)),
        )
        self._buttons: list[Text] = []
        self._places: list[ui.element] = []
        self._tabs: dict[int, Tab] = {}
        self._seen = -1

    def add_buttons(self) -> None:
        """Add the button of each page."""
        with ui.element("nav").classes("tabs").props('aria-label="Pages"'):
            for number, (name, _) in enumerate(self._makers):
                button = Text("button", name).classes("tab").props("type=button")
                button.on("click", partial(self.show, number), args=[])
                self._buttons.append(button)

    def add_places(self) -> None:
        """Add the place of each page."""
        for name, _ in self._makers:
            place = ui.element("section")
            place.props["aria-label"] = name
            self._places.append(place)

    def show(self, number: int) -> None:
        """Show one page."""
        if number == self._seen:
            return
        before = self._tabs.get(self._seen)
        if before is not None:
            before.close()
        self._seen = number
        for one, (button, place) in enumerate(zip(self._buttons, self._places, strict=True)):
            place.set_visibility(one == number)
            button.props["aria-current"] = "page" if one == number else "false"
        if number not in self._tabs:
            with self._places[number]:
                self._tabs[number] = self._makers[number][1]()
        self._tabs[number].open()

    def show_again(self) -> None:
        """Show every page in other units."""
        for tab in self._tabs.values():
            tab.show_again()


def _add_units(units: Units, changed: Callable[[], None]) -> None:
    def choose(own: Unit, event: ValueChangeEventArguments[str]) -> None:
        units.chosen[own] = next(one for one in CHOICES[own][1] if one.name == event.value)
        changed()

    for own, (words, few) in CHOICES.items():
        with ui.element("div") as place:
            Text("label", f"Unit of {words}").classes("unseen").props(f"for=unit-{place.id}")
            value = units.chosen[own].name
            made = ui.select([one.name for one in few], value=value, on_change=partial(choose, own))
            made.props(f"dense options-dense borderless for=unit-{place.id}").classes("unit-choice")


def _add_theme() -> None:
    dark = ui.dark_mode(None)
    button = Text("button", "Theme: system").classes("plain-button").props("type=button")

    def turn() -> None:
        place = [value for value, _ in _THEMES].index(dark.value)
        value, word = _THEMES[(place + 1) % len(_THEMES)]
        dark.set_value(value)
        button.text = f"Theme: {word}"

    button.on("click", turn, args=[])
