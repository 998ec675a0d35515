"""Run code in a process that has imported numba and started its compiler: what a new process does, without the seconds that these take."""

import contextlib
import io
import multiprocessing
import os
import sys
import traceback
import warnings
from collections.abc import Callable
from multiprocessing import forkserver
from multiprocessing.connection import Connection
from pathlib import Path

import pytest

_CONTEXT = multiprocessing.get_context("forkserver")
_CONTEXT.set_forkserver_preload(
    ["numba", "numba.core.caching", "numba.core.typing.templates", "warm_compiler"]
)


def output(code: str, folder: Path, environment: dict[str, str]) -> str:
    """Return what the code prints, run in a folder from which it imports; fail with its traceback if it fails."""
    return started(code, folder, environment)()


def started(code: str, folder: Path, environment: dict[str, str]) -> Callable[[], str]:
    """Begin to run code as in `output`, which the function that is returned waits for."""
    with (
        pytest.MonkeyPatch.context() as patch
    ):  # where what starts the processes finds what it loads beforehand
        places = [str(Path(__file__).parent), *filter(None, [os.environ.get("PYTHONPATH")])]
        patch.setenv("PYTHONPATH", os.pathsep.join(places))
        forkserver.ensure_running()
    here, there = _CONTEXT.Pipe(duplex=False)
    process = _CONTEXT.Process(target=_run, args=(code, folder, environment, there))
    process.start()
    there.close()

    def wait() -> str:
        failed, text = here.recv()
        process.join(60.0)
        process.close()
        here.close()
        assert not failed, text
        return text

    return wait


def _run(code: str, folder: Path, environment: dict[str, str], pipe: Connection) -> None:
    from numba.core import config

    os.environ.clear()
    os.environ.update(environment)
    os.chdir(folder)
    sys.path.insert(0, str(folder))
    sys.dont_write_bytecode = True
    warnings.simplefilter("error")
    config.reload_config()
    printed = io.StringIO()
    try:
        with contextlib.redirect_stdout(printed):
            exec(compile(code, "<call>", "exec"), {"__name__": "__main__"})
    except BaseException:
        pipe.send((True, traceback.format_exc()))
    else:
        pipe.send((False, printed.getvalue()))
