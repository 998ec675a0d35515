"""What the pages have in common: fields at the side, results beside them, files to take away, and work of which only the latest matters."""

import asyncio
from abc import ABC, abstractmethod
from collections.abc import Awaitable, Callable, Collection, Iterable
from typing import Any, ClassVar

from nicegui import background_tasks, ui

from dcfp.doors.app.elements import Text
from dcfp.doors.app.fields import Alert, BearingPanel, action, card
from dcfp.doors.app.session import Session
from dcfp.errors import DcfpError


class Latest:
    """Does a piece of work again whenever it is asked to, one at a time; what is asked meanwhile is done once, with the latest values.

    The work looks up what is wanted, calculates in another thread, and shows it.
    """

    def __init__(self, work: Callable[[], Awaitable[None]]) -> None:
        self._work, self._name = work, f"latest work of {id(self)}"

    @property
    def outdated(self) -> bool:
        """Whether something newer is wanted than what is being done."""
        return self._name in background_tasks.lazy_coroutines_waiting

    def ask(self) -> None:
        """Do the work, now or after the present one."""
        background_tasks.create_lazy(self._work(), name=self._name)


class Tab(ABC):
    """One of the pages: `asks` says what its fields are, `title` is of the results before there are any, and it `varies` some fields of the bearing itself, if it is of one bearing."""

    of_one_bearing: ClassVar[bool] = True

    def __init__(self, session: Session, asks: str, title: str, varies: Collection[str] = ()) -> None:
        self.session, self._client, self.is_seen = session, ui.context.client, False
        self.latest = Latest(lambda: self.safely(self.work))
        with ui.element("div").classes("body"):
            with ui.element("aside").classes("side").props(f'aria-label="{asks}"'):
                self.add_fields()
                self._bearing = (
                    BearingPanel(session.bearing, self.ask, varies) if self.of_one_bearing else None
                )
            with ui.element("div").classes("results"):
                self._alert = Alert()
                with ui.element("div").classes("head-row"):
                    with ui.element("div").classes("title-row"):
                        self.title = Text("h2", title)
                        self.status = Text("span", "").classes("status")
                        self.status.set_visibility(False)
                    self.busy = Text("span", "").classes("busy").props("role=status")
                self.add_results()

    @abstractmethod
    def add_fields(self) -> None:
        """Add the fields above those of the bearing."""

    @abstractmethod
    def add_results(self) -> None:
        """Add the places of the results."""

    @abstractmethod
    async def work(self) -> None:
        """Calculate what the fields ask for, and show it."""

    @abstractmethod
    def show_again(self) -> None:
        """Show the same in other units."""

    def open(self) -> None:
        """Show the fields as another page may have left them, and calculate."""
        self.is_seen = True
        self.refresh_bearing()
        self.ask()

    def refresh_bearing(self) -> None:
        """Show the fields of the bearing as they are."""
        if self._bearing is not None:
            self._bearing.refresh()

    def close(self) -> None:
        """Be seen no longer."""
        self.is_seen = False

    def ask(self) -> None:
        """Calculate what the fields hold."""
        self.latest.ask()

    @property
    def is_gone(self) -> bool:
        """Whether the visitor has left."""
        return self._client.is_deleted

    async def safely(self, work: Callable[[], Awaitable[None]]) -> None:
        """Do a piece of work; what is wrong with it is said."""
        try:
            await work()
        except DcfpError as error:
            self.complain(str(error))

    def complain(self, sentence: str) -> None:
        """Say what is wrong; an empty sentence takes it away."""
        if not self.is_gone:
            self._alert.say(sentence)

    def add_files(self, *files: tuple[str, str, Callable[[], bytes | None]]) -> None:
        """Add files to take away: what each is, its name, and what makes it, or nothing as long as there are no results."""

        def giver(name: str, make: Callable[[], bytes | None]) -> Callable[[], Awaitable[None]]:
            async def give() -> None:
                content = await asyncio.to_thread(make)
                if content is not None and not self.is_gone:
                    ui.download(content, name)

            return lambda: self.safely(give)

        with card("Take it away", "h3"), ui.element("div").classes("actions"):
            for label, name, make in files:
                action(label, giver(name, make))


def write_list(place: ui.element, sentences: Iterable[Any]) -> None:
    """Write sentences into a list, which is not there without any."""
    place.clear()
    with place:
        for sentence in sentences:
            Text("li", str(sentence))
    place.set_visibility(bool(place.default_slot.children))
