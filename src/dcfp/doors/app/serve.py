"""The server of the page."""

import asyncio
import ipaddress
import socket
from pathlib import Path

from nicegui import app, ui

from dcfp.doors.app.guard import LOOPBACK, Guard
from dcfp.doors.app.page import build_page
from dcfp.doors.app.session import named_choices
from dcfp.doors.app.surveys import Surveys
from dcfp.errors import InputError

#: Time for which a page that has lost its connection is kept [s].
_PATIENCE = 20.0
_STYLE = Path(__file__).parent / "static" / "app.css"
_ICON = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 32 32"><rect width="32" height="32" rx="6" fill="#0b5394"/><path d="M5 22q11 5 22 0v4H5zM5 10q11-5 22 0V6H5z" fill="#fff"/><path d="M11 13h10v6H11z" fill="#DDAA33"/></svg>'


def is_local(host: str) -> bool:
    """Return whether only this machine can reach a server at that host."""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host in LOOPBACK


def serve(host: str, port: int, *, show: bool) -> None:
    """Serve the page until the process is interrupted.

    Parameters
    ----------
    host, port
        Where.
    show
        Whether a browser is opened.
    """
    surveys = Surveys()

    @ui.page("/", title="dcfp", response_timeout=30.0)
    async def page() -> None:  # pyright: ignore[reportUnusedFunction]
        await build_page(surveys)

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
        msg = f"{host}, port {port}: the page cannot be served there ({reason}); choose another with --port."
        raise InputError(msg) from error


async def _prepare() -> None:
    """Have everything compiled and read before the first visitor waits for it."""
    await asyncio.to_thread(_warm_up)


def _warm_up() -> None:
    from dcfp.doors.app.analysis import Task, analyse, predict
    from dcfp.doors.app.session import Session

    named_choices()
    task = Task.of(Session())
    for response in analyse(task):
        predict(response, task.model)
