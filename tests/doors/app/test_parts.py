"""The parts of the page that need no browser."""

import asyncio

import numpy as np
import pytest

pytest.importorskip("nicegui", reason="the web page needs nicegui")

import dcfp
from dcfp.doors.app.charts.look import kept
from dcfp.doors.app.forms import HEATINGS, LAWS, LIMITS, BearingForm
from dcfp.doors.app.serve import LARGEST_BODY, Guard
from dcfp.doors.app.session import MOST_COMPONENTS, MOST_FILES, Session, plain_name, read_upload
from dcfp.doors.app.units import Units
from dcfp.errors import InputError
from dcfp.system import FRICTION_LAWS, System
from dcfp.system import HEATINGS as HEATING_MODELS

from .conftest import at2_text, pulse_motion


def test_the_fields_begin_with_the_paper_s_bearing():
    assert BearingForm().model() == System()


def test_every_law_and_heating_can_be_chosen():
    assert {*LAWS, "fitted"} == set(FRICTION_LAWS)
    assert set(HEATINGS) == set(HEATING_MODELS)
    for law in LAWS:
        assert BearingForm(law=law, mu=0.06).model().friction.reference == pytest.approx(0.06)


@pytest.mark.parametrize("name", [name for name in LIMITS if name not in ("capacity", "thickness")])
def test_an_empty_field_and_one_out_of_range_are_said(name):
    with pytest.raises(InputError, match="is missing"):
        BearingForm(**{name: None}).model()
    with pytest.raises(InputError, match=r"must be from .* to .*, not 1000000000"):
        BearingForm(**{name: 1e9}).model()


def test_thinning_keeps_every_extreme():
    random = np.random.default_rng(1)
    for size in (10, 839, 841, 5000, 99_999):
        columns = [random.normal(size=size), random.normal(size=size).cumsum()]
        chosen = kept(columns)
        assert chosen[0] == 0
        assert chosen[-1] == size - 1
        assert (np.diff(chosen) > 0).all()
        assert chosen.size <= max(840, 420 * 4 + 2)
        for column in columns:
            assert column[chosen].max() == column.max()
            assert column[chosen].min() == column.min()


def test_units_are_factors():
    units = Units("in", "kip", "in/s", "°F")
    assert units.length.text(25.4) == "1.00"
    assert units.force.text(4448.2216) == "1.0"
    assert units.temperature.text(100.0) == "212"
    assert units.energy.text(4448.2216 * 304.8) == "1"
    assert Units().length.text(-0.01) == "0.0"


@pytest.mark.parametrize(
    ("given", "shown"),
    [
        ("a.AT2", "a.AT2"),
        ("../../etc/passwd", "passwd"),
        ("C:\\records\\b.txt", "b.txt"),
        ("", "record"),
        ("..", "record"),
        ("a\x00b\n.AT2", "ab.AT2"),
    ],
)
def test_of_a_name_only_the_last_part_is_left(given, shown):
    assert plain_name(given) == shown


def test_a_long_name_is_shortened():
    assert len(plain_name("x" * 500 + ".AT2")) == 80


def test_a_record_of_too_many_steps_is_refused():
    with pytest.raises(InputError, match="too long for the page"):
        read_upload(at2_text(pulse_motion(points=300), step=1e-4).encode(), "fine.AT2")


def test_a_session_takes_so_many_files():
    uploads = read_upload(at2_text(pulse_motion(points=300)).encode(), "one.AT2")
    session = Session()
    for _ in range(MOST_FILES):
        session.take(uploads)
    with pytest.raises(InputError, match="at most 12 of your files"):
        session.take(uploads)
    with pytest.raises(InputError, match="components"):
        Session().take(uploads * (MOST_COMPONENTS + 1))
    assert Session().sent == {}


def test_a_record_that_was_sent_is_read_as_from_a_file(tmp_path):
    text = at2_text(pulse_motion())
    path = tmp_path / "mine.AT2"
    path.write_text(text)
    (upload,) = read_upload(text.encode(), "mine.AT2")
    assert upload.motion.digest == dcfp.load_motion(path).digest
    assert upload.motion.name == "mine"


async def _through(guard: Guard, scope: dict, bodies: list[bytes]) -> int:
    sent: list[dict] = []
    left = list(bodies)

    async def receive() -> dict:
        return {"type": "http.request", "body": left.pop(0) if left else b"", "more_body": bool(left)}

    async def send(message) -> None:
        sent.append(message)

    await guard({"type": "http", "headers": [], **scope}, receive, send)
    return sent[0]["status"]


async def _reading(scope, receive, send) -> None:
    """An application that reads everything."""
    del scope
    while (await receive())["more_body"]:
        pass
    await send({"type": "http.response.start", "status": 200, "headers": []})
    await send({"type": "http.response.body", "body": b""})


@pytest.mark.parametrize(
    ("local", "headers", "status"),
    [
        (True, {b"host": b"127.0.0.1:8080"}, 200),
        (True, {b"host": b"localhost:8080"}, 200),
        (True, {b"host": b"[::1]:8080"}, 200),
        (True, {}, 403),
        (True, {b"host": b"10.0.0.1:8080"}, 403),
        (False, {b"host": b"10.0.0.1:8080"}, 200),
        (False, {b"host": b"10.0.0.1:8080", b"origin": b"http://10.0.0.1:8080"}, 200),
        (False, {b"host": b"10.0.0.1:8080", b"origin": b"http://evil.example"}, 403),
        (True, {b"host": b"localhost", b"content-length": str(LARGEST_BODY + 1).encode()}, 413),
    ],
)
def test_who_is_let_in(local, headers, status):
    guard = Guard(_reading, local=local)
    assert asyncio.run(_through(guard, {"headers": list(headers.items())}, [b"x"])) == status


def test_a_body_that_goes_on_is_stopped():
    guard = Guard(_reading, local=False)
    part = b"0" * (LARGEST_BODY // 4)
    assert asyncio.run(_through(guard, {}, [part] * 4)) == 200
    assert asyncio.run(_through(guard, {}, [part] * 5)) == 413
