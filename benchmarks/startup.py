"""What a user waits for at the command line: whole processes."""

import os
import shutil
import subprocess
import sys
from importlib.util import find_spec
from statistics import median
from tempfile import TemporaryDirectory

from figure import Figure
from stopwatch import once

REPETITIONS = 5
HELP = ("--help",)
RESPOND = ("respond", "NCC", "--pgv", "0.5")


def command() -> list[str] | None:
    """Return how to start the command line, or None while there is none."""
    if find_spec("dcfp.doors.cli") is None or find_spec("dcfp.doors.cli.main") is None:
        return None
    script = shutil.which("dcfp", path=os.path.dirname(sys.executable))
    if script is not None:
        return [script]
    return [sys.executable, "-c", "import sys; from dcfp.doors.cli.main import main; sys.exit(main())"]


def seconds(words: list[str], cache: str) -> float:
    """Return the time of one process with its compiled kernels in the folder `cache` [s]."""
    environment = {**os.environ, "DCFP_CACHE_DIR": cache}
    return once(lambda: subprocess.run(words, check=True, capture_output=True, env=environment))


def figures() -> list[Figure]:
    """Return the times of two commands, with kernels to be compiled and with compiled ones."""
    start = command()
    if start is None:
        return [Figure("dcfp --help", None, "s", at_most=0.3, note="there is no command line yet")]
    with TemporaryDirectory() as cache:
        try:
            first = seconds([*start, *RESPOND], cache)
            respond = [seconds([*start, *RESPOND], cache) for _ in range(REPETITIONS)]
            help_ = [seconds([*start, *HELP], cache) for _ in range(REPETITIONS)]
        except subprocess.CalledProcessError as error:
            note = f"it failed: {error.stderr.decode().strip()}"
            return [Figure("dcfp " + " ".join(RESPOND), None, "s", at_most=2.0, note=note)]
    name = "dcfp " + " ".join(RESPOND)
    return [
        Figure("dcfp --help", median(help_), "s", at_most=0.3),
        Figure(f"{name}, warm", median(respond), "s", at_most=2.0),
        Figure(f"{name}, first time", first, "s", note="with the compilation of the kernels"),
    ]
