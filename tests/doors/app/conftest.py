"""A server of its own, a real browser, and record files to send."""

import os
import shutil
import socket
import subprocess
import sys
import time
import urllib.request
from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from .page_reading import show

pytest.importorskip("nicegui", reason="the web page needs nicegui")
sync_api = pytest.importorskip("playwright.sync_api", reason="the tests of the web page need playwright")

#: Where no browser is found, tests of the page fail instead of being skipped.
REQUIRED = "DCFP_REQUIRE_BROWSER"
#: Time until the server must answer, with the kernels not yet compiled [s].
START = 90.0
#: The browsers that will do: the first draws pages alone, and has no window to draw for each.
BROWSERS = ("chromium-headless-shell", "chromium", "google-chrome")
BROWSER_OPTIONS = ["--no-sandbox", "--disable-gpu"]


def browser_path() -> str | None:
    """Return where there is a browser."""
    return next((path for name in BROWSERS if (path := shutil.which(name))), None)


def pulse_motion(points: int = 2000, step: float = 0.01, size: float = 2000.0) -> np.ndarray:
    """A velocity pulse that ends at rest, acceleration [mm/s2]."""
    time = np.arange(points) * step
    envelope = np.exp(-(((time - 5.0) / 1.2) ** 2))
    acceleration = size * envelope * np.sin(2.0 * np.pi * (time - 5.0) / 1.6)
    return acceleration - acceleration.mean()


def at2_text(acceleration: np.ndarray, step: float = 0.01) -> str:
    """A file of PEER in g."""
    words = [f"{value / 9806.65:15.7E}" for value in acceleration]
    body = "".join("".join(words[i : i + 5]) + "\n" for i in range(0, len(words), 5))
    return (
        "PEER NGA STRONG MOTION DATABASE RECORD\nMade, 1/1/2000, Test Station, 0\n"
        f"ACCELERATION TIME SERIES IN UNITS OF G\nNPTS={acceleration.size:7d}, DT= {step:9.5f} SEC,\n{body}"
    )


def knet_text(acceleration: np.ndarray, step: float = 0.01) -> str:
    """A file of K-NET."""
    counts = np.round(acceleration / (7845 / 8223790 * 10.0))
    words = [f"{value:9.0f}" for value in counts]
    body = "".join("".join(words[i : i + 8]) + "\n" for i in range(0, len(words), 8))
    head = (
        "Origin Time       2018/01/24 19:51:00\nLat.              41.0\nLong.             142.5\n"
        "Depth. (km)       30\nMag.              6.2\nStation Code      AOM003\n"
        "Station Lat.      41.4053\nStation Long.     141.1691\nStation Height(m) 4\n"
        f"Record Time       2018/01/24 19:51:38\nSampling Freq(Hz) {1 / step:.0f}Hz\nDuration Time(s)  {acceleration.size * step:.0f}\n"
        "Dir.              N-S\nScale Factor      7845(gal)/8223790\n"
        "Max. Acc. (gal)   17.338\nLast Correction   2018/01/24 19:51:38\nMemo.             \n"
    )
    return head + body


@pytest.fixture(scope="package")
def server(tmp_path_factory: pytest.TempPathFactory) -> Generator[str]:
    """The address of a server that has nothing but these tests to do."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    folder = tmp_path_factory.mktemp("server")
    environment = {key: value for key, value in os.environ.items() if not key.startswith("PYTEST_")}
    process = subprocess.Popen(
        [sys.executable, "-W", "error::DeprecationWarning:dcfp", "-m", "dcfp.doors.cli.main", "app", "--port", str(port), "--no-browser"],
        cwd=folder, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )  # fmt: skip
    address = f"http://127.0.0.1:{port}"
    try:
        _wait_for(address, process)
        yield address
        assert process.poll() is None, "the server ended by itself"
    finally:
        process.terminate()
        said, _ = process.communicate(timeout=20)
    assert "Traceback" not in said, said
    left = [path.name for path in folder.rglob("*")]
    assert left == [], "the server left files behind"


def _wait_for(address: str, process: "subprocess.Popen[str]") -> None:
    until = time.monotonic() + START
    while time.monotonic() < until:
        if process.poll() is not None:
            pytest.fail(f"the server ended: {process.communicate()[0]}")
        try:
            urllib.request.urlopen(address, timeout=10).close()
        except OSError:
            time.sleep(0.2)
        else:
            return
    pytest.fail("the server does not answer")


@pytest.fixture(scope="module")  # its loop must end before tests that have one of their own
def browser() -> Generator[Any]:
    """Chromium without a window."""
    path = browser_path()
    if path is None:
        if os.environ.get(REQUIRED) == "1":
            pytest.fail("there is no chromium, and DCFP_REQUIRE_BROWSER=1")
        pytest.skip("there is no chromium")
    with sync_api.sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=path, args=BROWSER_OPTIONS)
        yield found
        found.close()


class Visitors:
    """Pages, each of a visitor of its own, and whatever goes wrong in their browser."""

    def __init__(self, server: str, browser: Any) -> None:
        self.server, self.browser = server, browser
        self.contexts: list[Any] = []
        self.wrong: list[str] = []

    def open(
        self, width: int = 1280, height: int = 900, expected: tuple[str, ...] = (), **options: Any
    ) -> Any:
        """Open a page and wait for its first number."""
        context = self.browser.new_context(viewport={"width": width, "height": height}, **options)
        self.contexts.append(context)
        page = context.new_page()
        wrong = self.wrong

        def heard(message: Any) -> None:
            if message.type == "error" and not any(words in message.text for words in expected):
                wrong.append(f"console: {message.text}")

        page.on("console", heard)
        page.on("pageerror", lambda error: wrong.append(f"error: {error}"))
        page.on("dialog", lambda dialog: (wrong.append(f"dialog: {dialog.message}"), dialog.dismiss()))
        page.on("request", lambda request: wrong.extend(_elsewhere(request.url, self.server)))
        page.goto(self.server)
        page.wait_for_function(
            "document.querySelector('[data-tile=\"peak_displacement\"]')?.textContent.match(/\\d/)"
        )
        return page

    def leave(self) -> None:
        """Close every page."""
        for context in self.contexts:
            context.close()


@pytest.fixture
def open_page(server: str, browser: Any) -> Generator[Callable[..., Any]]:
    """Open pages; whatever goes wrong in a browser makes the test fail."""
    visitors = Visitors(server, browser)
    yield visitors.open
    visitors.leave()
    assert not visitors.wrong, visitors.wrong


@pytest.fixture(scope="module")
def visitor(server: str, browser: Any) -> Generator[tuple[Any, list[str]]]:
    """One page for the tests of a file that need no new one, since to draw a page is what takes longest."""
    visitors = Visitors(server, browser)
    yield visitors.open(), visitors.wrong
    visitors.leave()


@pytest.fixture
def shared_page(visitor: tuple[Any, list[str]]) -> Generator[Any]:
    """The page of the visitor who stays, at the response; whatever goes wrong makes the test fail.

    It is left at the response, too: as long as the design chart is seen, survey after survey is made for it.
    """
    page, wrong = visitor
    yield page
    show(page, "Response")
    seen = wrong.copy()
    wrong.clear()
    assert not seen, seen


def _elsewhere(address: str, server: str) -> list[str]:
    own = (server, server.replace("http", "ws"), "data:", "blob:")
    return [] if address.startswith(own) else [f"request: {address}"]


@pytest.fixture
def record_file(tmp_path: Path) -> Callable[[str, str], Path]:
    """Write the text of a record file."""

    def write(name: str, text: str) -> Path:
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write
