"""The console script: help, exit statuses, interruptions, and how little it imports."""

import io
import subprocess
import sys
from types import SimpleNamespace

import pytest

import dcfp.doors.cli.respond
from dcfp.doors.cli.main import commands, main
from dcfp.errors import AnalysisError, InputError

HEAVY = ("numpy", "numba", "scipy", "matplotlib", "xarray", "pandas", "rich", "h5py")


def python(code: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=120
    )


@pytest.mark.parametrize(
    "words",
    [
        ["--help"],
        [],
        ["records", "--help"],
        ["spectrum", "--help"],
        ["verify", "--help"],
        ["study", "ida", "--help"],
    ],
)
def test_help_imports_nothing_heavy(words: list[str]) -> None:
    # the options of a bearing are those of its declared parts, whose laws know NumPy
    heavy = HEAVY[1:] if words[:1] == ["respond"] else HEAVY
    done = python(
        "import sys; from dcfp.doors.cli.main import main; "
        f"assert main({words!r}) == 0; heavy = sorted(set({heavy!r}) & set(sys.modules)); assert not heavy, heavy"
    )
    assert done.returncode == 0, done.stderr
    assert "usage: dcfp" in done.stdout
    assert done.stderr == ""


def test_help_names_every_command(run) -> None:
    status, out, _ = run("--help")
    assert status == 0
    assert all(f"  {name} " in out for name in ("records", "respond", "verify"))


def test_version(run) -> None:
    status, out, err = run("--version")
    assert (status, err) == (0, "")
    assert out.startswith("dcfp ")


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["respnd"], "dcfp: there is no command 'respnd'; did you mean 'respond'?\n"),
        (["xyz"], f"dcfp: there is no command 'xyz'; the commands are {', '.join(commands())}.\n"),
        (["respond"], "dcfp: name at least one RECORD, for example NCC or a file; dcfp records lists the named ones.\n"),
        (["respond", "NCC", "--frction", "x"], "dcfp: --frction is not an option of dcfp respond; did you mean --friction?\n"),
        (["respond", "NCC", "--zzz"], "dcfp: --zzz is not an option of dcfp respond; dcfp respond --help lists the options.\n"),
        (["respond", "NCC", "--load", "60"], "dcfp: --load is not an option of dcfp respond; dcfp respond --help lists the options.\n"),
        (["codes", "--weight", "0.8"], "dcfp: --weight is not an option of dcfp codes; did you mean --weight-above?\n"),
        (["respond", "NCC", "--step"], "dcfp: --step needs a value.\n"),
        (["respond", "NCC", "--pgv"], "dcfp: --pgv needs at least one value.\n"),
    ],
)  # fmt: skip
def test_slips_get_one_sentence(run, words: list[str], sentence: str) -> None:
    assert run(*words) == (2, "", sentence)


@pytest.mark.parametrize(
    ("error", "status", "words"),
    [
        (InputError("the number is wrong."), 2, "dcfp: the number is wrong.\n"),
        (AnalysisError("it makes\nno progress."), 1, "dcfp: it makes no progress.\n"),
        (KeyboardInterrupt(), 130, ""),
    ],
)
def test_errors_have_their_status(run, monkeypatch, error: BaseException, status: int, words: str) -> None:
    monkeypatch.setattr(dcfp.doors.cli.respond, "run", raising(error))
    assert run("respond", "NCC") == (status, "", words)


def test_an_unexpected_error_asks_to_be_reported(run, monkeypatch) -> None:
    monkeypatch.setattr(dcfp.doors.cli.respond, "run", raising(ZeroDivisionError("oops")))
    monkeypatch.delenv("DCFP_TRACEBACK", raising=False)
    status, out, err = run("respond", "NCC")
    assert (status, out, err.count("\n")) == (1, "", 1)
    assert "ZeroDivisionError" in err
    assert "report" in err
    assert "DCFP_TRACEBACK=1" in err
    monkeypatch.setenv("DCFP_TRACEBACK", "1")
    with pytest.raises(ZeroDivisionError):
        main(["respond", "NCC"])


@pytest.mark.slow
def test_a_closed_pipe_is_no_error() -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", "dcfp.doors.cli.main", "records", "--json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None
    assert process.stderr is not None
    process.stdout.close()
    words = process.stderr.read()
    process.stderr.close()
    assert (process.wait(timeout=60), words) == (0, "")


def test_the_exit_status_leaves_the_process() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "dcfp.doors.cli.main", "respond", "nowhere.AT2"],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)


def test_a_terminal_without_the_signs_gets_question_marks(monkeypatch) -> None:
    written = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(written, encoding="ascii"))
    assert main(["respond", "NCC"]) == 0
    assert b"from 20 ?C" in written.getvalue()


def test_a_progress_bar_appears_on_a_terminal_only(monkeypatch, capsys) -> None:
    from dcfp.doors.cli import console as progress

    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    with progress.progress("analyses", 2) as advance:
        advance()
    assert capsys.readouterr() == ("", "")
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    started = []
    monkeypatch.setattr("dcfp.doors.cli.console.Timer", lambda wait, act: fake_timer(started, act))
    with progress.progress("analyses", 2) as advance:
        advance()
    assert started == ["started", "cancelled"]


def fake_timer(events: list[str], act) -> SimpleNamespace:
    assert callable(act)
    return SimpleNamespace(
        daemon=False, start=lambda: events.append("started"), cancel=lambda: events.append("cancelled")
    )


def raising(error: BaseException):
    def fail(*_: object) -> int:
        raise error

    return fail
