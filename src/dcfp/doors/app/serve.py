"""The page, a head with units and theme and three pages below it of which one is seen; and its server."""

import asyncio
import ipaddress
import socket
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import urlsplit

from nicegui import app, ui
from nicegui.events import ValueChangeEventArguments
from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import PlainTextResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from dcfp.analysis import Response
from dcfp.doors.app.analysis import Task, predict
from dcfp.doors.app.building_tab import BuildingTab
from dcfp.doors.app.design_tab import DesignTab, Surveys
from dcfp.doors.app.elements import CHOICES, Text, Units
from dcfp.doors.app.machine_tab import MachineTab
from dcfp.doors.app.response_tab import ResponseTab
from dcfp.doors.app.session import LARGEST_FILE, Session, named_choices
from dcfp.errors import InputError
from dcfp.schema.units import Unit

if TYPE_CHECKING:
    from dcfp.doors.app.tab import Tab

#: Time for which a page that has lost its connection is kept [s].
_PATIENCE = 20.0
_STYLE = Path(__file__).parent / "static" / "app.css"
_ICON = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32"><rect width="32" height="32" rx="6" fill="#0b5394"/><path d="M5 22q11 5 22 0v4H5zM5 10q11-5 22 0V6H5z" fill="#fff"/><path d="M11 13h10v6H11z" fill="#DDAA33"/></svg>'
#: Which station is analysed before the first visitor chooses one.
_STATION = "P695-FF-2"
#: Themes in the order of the button, with what NiceGUI calls them.
_THEMES = {"system": None, "light": False, "dark": True}
#: Names under which a browser reaches its own machine.
LOOPBACK = ("127.0.0.1", "localhost", "::1")
#: Schemes of sockets as those of the pages that open them, and the ports that a browser leaves out.
_SCHEMES, _PORTS = {"ws": "http", "wss": "https"}, {"http": 80, "https": 443}
#: Largest body of a request: a file, and what wraps it [bytes].
LARGEST_BODY = LARGEST_FILE + 100_000
#: Everything comes from the server itself; NiceGUI compiles its templates in the browser, hence "unsafe-eval".
_POLICY = (
    "default-src 'self'; script-src 'self' 'unsafe-inline' 'unsafe-eval'; style-src 'self' 'unsafe-inline';"
    " img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self' data: blob:; object-src 'none';"
    " base-uri 'self'; form-action 'self'; frame-ancestors 'none'"
)
_HEADERS = {
    "content-security-policy": _POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
}


def is_local(host: str) -> bool:
    """Return whether only this machine can reach a server at that host."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host in LOOPBACK


def serve(host: str, port: int, *, show: bool) -> None:
    """Serve the page until the process is interrupted; `show` opens a browser."""
    surveys = Surveys()

    @ui.page("/", title="dcfp", response_timeout=30.0)
    async def page() -> None:  # pyright: ignore[reportUnusedFunction]
        await _build_page(surveys)

    ui.add_css(_STYLE, shared=True)
    app.add_middleware(Guard, local=is_local(host))
    app.on_startup(_prepare)
    ui.run(
        host=host,
        port=port,
        title="dcfp",
        favicon=_ICON,
        language="en-GB",
        dark=None,
        tailwind=False,
        reload=False,
        show=show,
        show_welcome_message=False,
        reconnect_timeout=_PATIENCE,
    )


def check_address(host: str, port: int) -> None:
    """Find out in time whether the page can be served there.

    Raises
    ------
    InputError
        If not.
    """
    try:
        family, _, _, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        with socket.socket(family, socket.SOCK_STREAM) as test:
            test.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            test.bind(address)
    except (OSError, OverflowError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        msg = f"{host}, port {port}: the page cannot be served there ({reason}); choose another (port)."
        raise InputError(msg) from error


async def _prepare() -> None:
    """Have everything compiled and read before the first visitor waits for it."""
    await asyncio.to_thread(_warm_up)


def _warm_up() -> None:
    named_choices()
    session = Session()
    for record in (*session.chosen, _STATION):
        session.choose([record])  # a station with the heating model that is usual for it
        task = Task.of(session)
        for response in task.analysed():
            if isinstance(response, Response):
                predict(response, task.model)


async def _build_page(surveys: Surveys) -> None:
    session = Session()
    ui.colors(primary="#0b5394", dark="#1c2126", dark_page="#14181c")
    with ui.element("header").classes("top"):
        with ui.element("div").classes("name"):
            Text("h1", "dcfp")
            Text("p", "double concave friction pendulum bearings under recorded earthquakes")
        units = ui.element("div").classes("units")
        _add_theme()
        tabs = ui.element("nav").classes("tabs").props('aria-label="Pages"')
    with ui.element("main") as main:
        pages = _Pages(session, surveys, tabs)
    with units:
        _add_units(session.units, pages.show_again)
    ui.skip_link("Skip to the page", target=main)
    await ui.context.client.connected()
    pages.show("Response")


class _Pages:
    """The pages, each built when it is first seen, and their buttons."""

    def __init__(self, session: Session, surveys: Surveys, buttons: ui.element) -> None:
        self._makers: dict[str, Callable[[], Tab]] = {
            "Response": lambda: ResponseTab(session),
            "Test machine": lambda: MachineTab(session),
            "Design chart": lambda: DesignTab(session, surveys),
            "Building": lambda: BuildingTab(session),
        }
        self._tabs: dict[str, Tab] = {}
        self._seen = ""
        self._parts: dict[str, tuple[Text, ui.element]] = {}
        for name in self._makers:
            with buttons:
                button = Text("button", name).classes("tab").props("type=button")
                button.on("click", partial(self.show, name), args=[])
            place = ui.element("section")
            place.props["aria-label"] = name
            self._parts[name] = button, place

    def show(self, name: str) -> None:
        """Show one page."""
        if name == self._seen:
            return
        if self._seen in self._tabs:
            self._tabs[self._seen].close()
        self._seen = name
        for one, (button, place) in self._parts.items():
            place.set_visibility(one == name)
            button.props["aria-current"] = "page" if one == name else "false"
        if name not in self._tabs:
            with self._parts[name][1]:
                self._tabs[name] = self._makers[name]()
        self._tabs[name].open()

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
        words, values = list(_THEMES), list(_THEMES.values())
        place = (values.index(dark.value) + 1) % len(values)
        dark.set_value(values[place])
        button.text = f"Theme: {words[place]}"

    button.on("click", turn, args=[])


# Who may talk to the server, and how much at once.


class _TooLargeError(Exception):
    """The body of a request goes on beyond the limit."""


class Guard:
    """Refuses requests of other pages in the same browser, and bodies that are too large.

    A page that listens on the loopback can still be reached by any page that the browser shows, through its address or through a name
    that was made to point there; the names of host and origin tell them apart. Where it is `local`, only this machine may be named as the host.
    """

    def __init__(self, application: ASGIApp, *, local: bool) -> None:
        self._application = application
        self._local = local

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, or refuse it."""
        if scope["type"] not in ("http", "websocket"):
            await self._application(scope, receive, send)
            return
        headers = Headers(scope=scope)
        length = headers.get("content-length", "0")
        if not self._is_welcome(headers, scope.get("scheme", "http")):
            await _refuse(403, "This page answers its own visitors only.")(scope, receive, send)
        elif length.isdecimal() and int(length) > LARGEST_BODY:
            await _refuse(413, "The file is too large.")(scope, receive, send)
        else:
            await self._pass_on(scope, receive, send)

    def _is_welcome(self, headers: Headers, scheme: str) -> bool:
        host = headers.get("host", "")
        if self._local and _name(host) not in LOOPBACK:
            return False
        origin = headers.get("origin")
        if origin is None:
            return True
        own = _place(f"{_SCHEMES.get(scheme, scheme)}://{host}")
        return own is not None and _place(origin) == own

    async def _pass_on(self, scope: Scope, receive: Receive, send: Send) -> None:
        taken, started = 0, False

        async def counted() -> Message:
            nonlocal taken
            message = await receive()
            taken += len(message.get("body", b"")) if message["type"] == "http.request" else 0
            if taken > LARGEST_BODY:
                raise _TooLargeError
            return message

        async def with_headers(message: Message) -> None:
            nonlocal started
            if message["type"] == "http.response.start":
                started = True
                plain = [one for one in message["headers"] if not one[0].startswith(b"access-control-")]
                message["headers"] = plain
                MutableHeaders(scope=message).update(_HEADERS)
            await send(message)

        try:
            await self._application(scope, counted, with_headers)
        except _TooLargeError:
            if not started:
                await _refuse(413, "The file is too large.")(scope, receive, send)


def _place(origin: str) -> tuple[str, str, int] | None:
    """Return scheme, host and port of an origin; None where it has none of its own, such as ``null``."""
    try:
        parts = urlsplit(origin.lower())
        port = parts.port or _PORTS[parts.scheme]
    except (KeyError, ValueError):
        return None
    return parts.scheme, parts.hostname or "", port


def _name(host: str) -> str:
    """Return the name in a host without its port."""
    return (urlsplit(f"//{host}").hostname or "").lower()


def _refuse(status: int, words: str) -> ASGIApp:
    """Return what answers a request with a refusal, and closes a socket."""

    async def refuse(scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] == "websocket":
            await send({"type": "websocket.close", "code": 1008})
        else:
            await PlainTextResponse(words, status, _HEADERS)(scope, receive, send)

    return refuse
