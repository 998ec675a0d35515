"""What all tests share: how they are spread over processes, coarse figures, and no deadlines."""

import gc
import os
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import Any

import pytest
from hypothesis import settings

gc.disable()  # what is imported and collected is there for good: see pytest_collection_finish
TESTS = Path(__file__).parent
# `pytest -n` has a process for every processor already: a library's own threads would only get in each other's way
for library in ("OMP", "OPENBLAS", "MKL"):
    os.environ.setdefault(f"{library}_NUM_THREADS", "1")

# the many processes that tests start would each compile the sources
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False

# the first call of a kernel compiles it, which takes longer than any deadline
settings.register_profile("dcfp", deadline=None)
settings.load_profile("dcfp")

#: Folders whose tests share what is dear (a server and a browser, OpenSees in a process), and stay in one process;
#: elsewhere the tests of a file do. What takes longest begins first.
TOGETHER = ("doors/app", "study", "verify", "frozen", "present/report", "docs")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Offer what takes long."""
    parser.addoption("--slow", action="store_true", help="run the tests that take seconds, too")
    words = "run a share of the tests that take seconds, too: with 2/3 those of every third file from the second on"
    parser.addoption("--slow-share", default="0/1", metavar="K/N", help=words)
    parser.addoption("--long", action="store_true", help="run all of these and the checks at full size, too")


def pytest_configure(config: pytest.Config) -> None:
    """Compile the kernels before the processes of `pytest -n` start, which would each do it."""
    if not getattr(config.option, "numprocesses", None) or hasattr(config, "workerinput"):
        return
    config.option.loadscopereorder = False  # the order of `pytest_collection_modifyitems` stands
    project = tomllib.loads((TESTS.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    words = [sys.executable, TESTS / "support" / "warm_kernels.py"]
    started = [subprocess.Popen([*words, str(part), project["scripts"]["dcfp"]]) for part in (0, 1)]
    for process in started:
        process.wait()


def _group_of(path: str) -> str:
    """Return the folder or the file whose tests stay in one process, of a path in the project."""
    path = path.removeprefix(f"{TESTS.name}/")
    return next((folder for folder in TOGETHER if path.startswith(f"{folder}/")), path)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Spread groups over the processes of `pytest -n`: marks of groups do not reach pytest-xdist 3.8 under pytest 9.2."""
    from xdist.scheduler import LoadScopeScheduling

    class Groups(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return _group_of(nodeid.partition("::")[0])

    return Groups(config, log)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """Have one process more than processors: tests of the page and of processes wait for others much of their time."""
    return (os.cpu_count() or 1) + 1


def pytest_collection_finish() -> None:
    """Let the collector of garbage leave alone what is there for good, and come less often."""
    gc.freeze()
    gc.enable()
    gc.set_threshold(50_000, 10, 10)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what takes long where it is not asked for, and put those first that take longest."""
    every = config.getoption("long")
    all_slow = every or config.getoption("slow")
    share, _, shares = ("1/1" if all_slow else config.getoption("slow_share")).partition("/")
    files = sorted({item.path for item in items if item.get_closest_marker("slow")})
    taken = set(files[int(share) - 1 :: int(shares)]) if int(share) else set[Path]()
    out = {
        item
        for item in items
        if (item.get_closest_marker("long") and not every)
        or (item.get_closest_marker("slow") and item.path not in taken)
    }
    config.hook.pytest_deselected(items=list(out))
    items[:] = [item for item in items if item not in out]
    places = {folder: place for place, folder in enumerate(TOGETHER)}
    items.sort(key=lambda item: places.get(_group_of(item.path.relative_to(TESTS).as_posix()), len(places)))


@pytest.fixture(scope="session", autouse=True)
def coarse_figures() -> Iterator[None]:
    """Draw figures with a quarter of their resolution: what is tested is what is in them; read each formula in them once; and lay out no fonts."""
    from light_pdf import leave_out_layout
    from matplotlib.mathtext import MathTextParser

    read = lru_cache(maxsize=None)(
        MathTextParser._parse_cached.__wrapped__
    )  # of matplotlib's own they are 50
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(MathTextParser, "_parse_cached", read)
        # every renderer has a reader of its own
        patch.setattr(MathTextParser, "__hash__", lambda self: hash(self._output_type))
        patch.setattr(
            MathTextParser,
            "__eq__",
            lambda self, other: self._output_type == other._output_type,
            raising=False,
        )
        patch.setattr("dcfp.present.figures.style.RESOLUTION", 60)
        leave_out_layout(patch)
        yield
