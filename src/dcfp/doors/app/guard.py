"""Who may talk to the server, and how much at once."""

from collections.abc import Awaitable, Callable, MutableMapping
from typing import Any
from urllib.parse import urlsplit

from dcfp.doors.app.uploads import LARGEST_FILE

_Message = MutableMapping[str, Any]
_Receive = Callable[[], Awaitable[_Message]]
_Send = Callable[[_Message], Awaitable[None]]
_Application = Callable[[_Message, _Receive, _Send], Awaitable[None]]

#: Names under which a browser reaches its own machine.
LOOPBACK = ("127.0.0.1", "localhost", "::1")
#: Largest body of a request: a file, and what wraps it [bytes].
LARGEST_BODY = LARGEST_FILE + 100_000
#: Everything comes from the server itself; NiceGUI compiles its templates in the browser, hence "unsafe-eval".
_POLICY = (
    "default-src 'self'; script-src 'self' 'unsafe-inline' 'unsafe-eval'; style-src 'self' 'unsafe-inline';"
    " img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self' data: blob:; object-src 'none';"
    " base-uri 'self'; form-action 'self'; frame-ancestors 'none'"
)
_HEADERS = (
    (b"content-security-policy", _POLICY.encode()),
    (b"x-content-type-options", b"nosniff"),
    (b"referrer-policy", b"no-referrer"),
)


class _TooLargeError(Exception):
    """The body of a request goes on beyond the limit."""


class Guard:
    """Refuses requests of other pages in the same browser, and bodies that are too large.

    A page that listens on the loopback can still be reached by any page that the browser shows, through its address or through a name
    that was made to point there; the names of host and origin tell them apart.

    Parameters
    ----------
    application
        What is guarded.
    local
        Whether only this machine may be named as the host.
    """

    def __init__(self, application: _Application, *, local: bool) -> None:
        self._application = application
        self._local = local

    async def __call__(self, scope: _Message, receive: _Receive, send: _Send) -> None:
        """Pass a request on, or refuse it."""
        if scope["type"] not in ("http", "websocket"):
            await self._application(scope, receive, send)
            return
        headers = {name.lower(): value.decode("latin-1") for name, value in scope["headers"]}
        if not self._is_welcome(headers):
            await _refuse(scope, send, 403, "This page answers its own visitors only.")
        elif _length(headers) > LARGEST_BODY:
            await _refuse(scope, send, 413, "The file is too large.")
        else:
            await self._pass_on(scope, receive, send)

    def _is_welcome(self, headers: dict[bytes, str]) -> bool:
        host = headers.get(b"host", "")
        if self._local and _name(host) not in LOOPBACK:
            return False
        origin = headers.get(b"origin")
        return origin is None or urlsplit(origin).netloc.lower() == host.lower()

    async def _pass_on(self, scope: _Message, receive: _Receive, send: _Send) -> None:
        taken, started = 0, False

        async def counted() -> _Message:
            nonlocal taken
            message = await receive()
            taken += len(message.get("body", b"")) if message["type"] == "http.request" else 0
            if taken > LARGEST_BODY:
                raise _TooLargeError
            return message

        async def with_headers(message: _Message) -> None:
            nonlocal started
            if message["type"] == "http.response.start":
                started = True
                plain = [one for one in message["headers"] if not one[0].startswith(b"access-control-")]
                message["headers"] = [*plain, *_HEADERS]
            await send(message)

        try:
            await self._application(scope, counted, with_headers)
        except _TooLargeError:
            if not started:
                await _refuse(scope, send, 413, "The file is too large.")


def _name(host: str) -> str:
    """Return the name in a host without its port."""
    return (urlsplit(f"//{host}").hostname or "").lower()


def _length(headers: dict[bytes, str]) -> int:
    text = headers.get(b"content-length", "0")
    return int(text) if text.isdecimal() else 0


async def _refuse(scope: _Message, send: _Send, status: int, words: str) -> None:
    if scope["type"] == "websocket":
        await send({"type": "websocket.close", "code": 1008})
        return
    body = words.encode()
    head = [(b"content-type", b"text/plain; charset=utf-8"), (b"content-length", str(len(body)).encode())]
    await send({"type": "http.response.start", "status": status, "headers": [*head, *_HEADERS]})
    await send({"type": "http.response.body", "body": body})
