"""The command that serves the page."""

import socket
import sys

import pytest

pytest.importorskip("nicegui", reason="the web page needs nicegui")

from dcfp.doors.cli.main import main


@pytest.fixture
def served(monkeypatch) -> list[tuple[str, int, bool]]:
    """What would have been served."""
    from dcfp.doors.app import serve

    found: list[tuple[str, int, bool]] = []
    monkeypatch.setattr(serve, "check_address", lambda host, port: None)
    monkeypatch.setattr(serve, "serve", lambda host, port, show: found.append((host, port, show)))
    return found


def test_only_this_machine_can_reach_it_by_default(served, capsys):
    assert main(["app"]) == 0
    assert served == [("127.0.0.1", 8080, True)]
    assert capsys.readouterr().err == "dcfp: http://127.0.0.1:8080 (Ctrl+C ends it)\n"


@pytest.mark.parametrize("host", ["0.0.0.0", "192.0.2.1", "::", "example.org"])
def test_more_than_this_machine_is_warned_of(served, capsys, host):
    assert main(["app", "--host", host, "--port", "9000", "--no-browser"]) == 0
    assert served == [(host, 9000, False)]
    first = capsys.readouterr().err.splitlines()[0]
    assert first == (
        "dcfp: anyone who can reach port 9000 of this machine can use the page; it asks for no password."
    )


@pytest.mark.parametrize("host", ["localhost", "127.0.0.2", "::1"])
def test_names_of_this_machine_are_not(served, capsys, host):
    assert main(["app", "--host", host]) == 0
    assert "anyone" not in capsys.readouterr().err
    assert served[0][0] == host


def test_without_nicegui_there_is_one_sentence(monkeypatch, capsys):
    for name in [name for name in sys.modules if name.startswith(("dcfp.doors.app", "nicegui"))]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "nicegui", None)
    assert main(["app"]) == 2
    said = capsys.readouterr().err
    assert (
        said
        == "dcfp: the web page needs the package nicegui, which is not installed: pip install 'dcfp[app]' brings it.\n"
    )


def test_a_port_that_is_taken(capsys):
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        assert main(["app", "--port", str(port), "--no-browser"]) == 2
    said = capsys.readouterr().err.splitlines()[-1]
    assert "choose another (--port)" in said


@pytest.mark.parametrize("port", ["0", "70000", "many"])
def test_a_port_that_cannot_be(capsys, port):
    assert main(["app", "--port", port]) == 2
    assert "must be a whole number from 1 to 65535" in capsys.readouterr().err
