"""Visitors at once, quick answers, and doors that stay shut."""

import asyncio
import http.client
import statistics
from urllib.parse import urlsplit

import pytest

import dcfp
from dcfp.motion.load import motions_of

from .conftest import BROWSER_OPTIONS, at2_text, browser_path, pulse_motion, sync_api

#: From a slider to a number on the page: what is wanted, and what a busy machine is allowed [s].
WANTED, ALLOWED = 0.3, 1.0
SECONDS = 2.0

#: Moves the slider and waits until the number changes, in the browser's own clock [ms].
MOVE = """
async (step) => {
    const slider = document.querySelector('input.slider');
    const tile = document.querySelector('[data-tile="peak_displacement"]');
    slider.value = Number(slider.value) + step;
    const began = performance.now();
    const changed = new Promise((resolve) => {
        const observer = new MutationObserver(() => { observer.disconnect(); resolve(performance.now() - began); });
        observer.observe(tile, { characterData: true, childList: true, subtree: true });
    });
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    return await changed;
}
"""


@pytest.mark.slow
def test_from_the_slider_to_the_number(open_page, capsys):
    page = open_page()
    page.wait_for_timeout(500)
    times = []
    for i in range(7):
        times.append(page.evaluate(MOVE, 0.01 if i % 4 < 2 else -0.01) / 1e3)
        page.wait_for_timeout(120)
    median = statistics.median(times)
    with capsys.disabled():
        print(
            f"\nslider to number: median {median * 1e3:.0f} ms, largest {max(times) * 1e3:.0f} ms (wanted {WANTED * 1e3:.0f})"
        )
    assert median < ALLOWED


async def _visit(
    browser, address: str, number: int, seconds: float, entrance: asyncio.Lock, together: asyncio.Barrier
) -> tuple[int, list[str]]:
    """Be a visitor with a record and a bearing of one's own, who always must see one's own number.

    Visitors come in one by one, for to draw ten new pages keeps a browser on two processors busy for half a minute; then all use theirs together.
    """
    wrong: list[str] = []
    loop = asyncio.get_running_loop()
    context = await browser.new_context(viewport={"width": 1000, "height": 700})
    page = await context.new_page()
    page.on("pageerror", lambda error: wrong.append(str(error)))
    page.on("console", lambda said: wrong.append(said.text) if said.type == "error" else None)
    async with entrance:
        await page.goto(address)
        await page.wait_for_function(
            "document.querySelector('[data-tile=\"peak_displacement\"]')?.textContent.match(/\\d/)",
            timeout=60_000,
        )
    await together.wait()
    text = at2_text(pulse_motion(size=1500.0 + 100.0 * number)).encode()
    own = {"name": f"own{number}.AT2", "mimeType": "text/plain", "buffer": text}
    await page.locator("input[type=file]").set_input_files([own])
    await page.locator("h2", has_text=f"own{number}, PGV").wait_for()
    motion = motions_of(text, f"own{number}.AT2")[0].scaled_to_pgv(500.0)
    turns, until = 0, loop.time() + seconds
    while loop.time() < until or turns == 0:
        slider = 300 + 10 * number + turns % 5
        await page.get_by_label("Diameter of the slider [mm]", exact=True).first.fill(str(slider))
        bearing = dcfp.Bearing((4500.0, 4500.0), float(slider), 60.0, 1.9e6, 440.0)
        wanted = f"{dcfp.respond(motion, bearing).peak_displacement:.1f}"
        force = f"{dcfp.respond(motion, bearing).peak_force / 1e3:.0f}"
        try:
            await page.wait_for_function(
                "([y, force]) => document.querySelector('[data-tile=\"peak_displacement\"]').textContent === y && document.querySelector('[data-tile=\"peak_force\"]').textContent === force",
                arg=[wanted, force],
                timeout=20_000,
            )
        except sync_api.TimeoutError:
            seen = await page.locator('[data-tile="peak_displacement"]').inner_text()
            wrong.append(f"visitor {number}: {seen} instead of {wanted}")
            break
        turns += 1
    await context.close()
    return turns, wrong


async def visit_together(address: str, visitors: int, seconds: float) -> list[tuple[int, list[str]]]:
    """Let visitors use the page for some seconds."""
    from playwright.async_api import async_playwright

    async with async_playwright() as playwright:
        browser = await playwright.chromium.launch(executable_path=browser_path(), args=BROWSER_OPTIONS)
        entrance, together = asyncio.Lock(), asyncio.Barrier(visitors)
        found = await asyncio.gather(
            *(_visit(browser, address, number, seconds, entrance, together) for number in range(visitors))
        )
        await browser.close()
    return found


@pytest.mark.slow
@pytest.mark.parametrize("visitors", [3, pytest.param(10, marks=pytest.mark.long)])
def test_visitors_see_each_their_own_numbers(server, browser, capsys, visitors):
    del browser  # it says whether there is one
    from concurrent.futures import ThreadPoolExecutor

    # in another thread: the other tests' browser has the loop of this one
    with ThreadPoolExecutor(1) as pool:
        found = pool.submit(lambda: asyncio.run(visit_together(server, visitors, SECONDS))).result()
    wrong = [words for _, sentences in found for words in sentences]
    turns = [turns for turns, _ in found]
    with capsys.disabled():
        print(f"\n{visitors} visitors: {sum(turns)} changes, at least {min(turns)} each, {len(wrong)} wrong")
    assert wrong == []
    assert min(turns) >= 1


# ----- doors -----


def ask(server: str, path: str = "/", **headers: str) -> tuple[int, http.client.HTTPMessage]:
    """Ask for a path; return status and head of the answer."""
    connection = http.client.HTTPConnection(urlsplit(server).netloc, timeout=20)
    try:
        connection.request("GET", path, headers=headers)
        reply = connection.getresponse()
        reply.read()
        return reply.status, reply.headers
    finally:
        connection.close()


def test_another_host_or_origin_is_refused(server):
    own = urlsplit(server).netloc
    assert ask(server)[0] == 200
    assert ask(server, Host="evil.example")[0] == 403
    assert ask(server, Origin="http://evil.example")[0] == 403
    assert ask(server, Origin=f"http://{own}")[0] == 200
    assert ask(server, Origin="null")[0] == 403
    # another program of this machine, whose page the same browser shows
    assert ask(server, Origin="http://127.0.0.1:9")[0] == 403
    assert ask(server, Origin="http://127.0.0.1")[0] == 403


def test_a_socket_of_another_page_is_refused(server):
    path = "/_nicegui_ws/socket.io/?EIO=4&transport=websocket"
    upgrade = {
        "Upgrade": "websocket",
        "Connection": "Upgrade",
        "Sec-WebSocket-Key": "dGhlIHNhbXBsZSBub25jZQ==",
        "Sec-WebSocket-Version": "13",
    }
    assert ask(server, path, **upgrade, Origin="http://evil.example")[0] == 403
    polling = path.replace("websocket", "polling")
    status, head = ask(server, polling, Origin="http://evil.example")
    assert status == 403
    assert head.get("Access-Control-Allow-Origin") is None


@pytest.mark.slow
def test_nothing_may_be_loaded_from_elsewhere(server):
    policy = ask(server)[1].get("Content-Security-Policy", "")
    assert "default-src 'self'" in policy
    assert "http" not in policy


@pytest.mark.slow
def test_a_file_too_large_is_refused_by_page_and_server(open_page, server, tmp_path):
    page = open_page(expected=("413", "ERR_CONNECTION"))
    large = tmp_path / "large.AT2"
    large.write_bytes(b"0" * 20_000_001)
    page.locator("input[type=file]").set_input_files(large)
    page.get_by_role("alert").filter(has_text="larger than 20 MB").wait_for()
    # who goes around the page meets the server
    small = {"name": "small.AT2", "mimeType": "text/plain", "buffer": b"no numbers"}
    with page.expect_request(lambda request: request.method == "POST") as waited:
        page.locator("input[type=file]").set_input_files([small])
    address = waited.value.url
    status = page.evaluate(
        """async ([address]) => {
            const form = new FormData();
            form.append('file', new Blob([new Uint8Array(21_000_000)]), 'large.AT2');
            try { return (await fetch(address, { method: 'POST', body: form })).status; } catch { return 413; }
        }""",
        [address],
    )
    assert status == 413
    status = page.evaluate(
        """async ([address]) => {
            const form = new FormData();
            form.append('file', new Blob(['no numbers']), 'small.AT2');
            return (await fetch(address, { method: 'POST', body: form })).status;
        }""",
        [address],
    )
    assert status == 200
