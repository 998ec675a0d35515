"""The compiled kernels' cache: never a stale answer, and never a failure on its account.

Each test writes a miniature package around a copy of the decorator's module and calls it in processes that have not seen it, as users do.
"""

import os
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import pytest
from forked import output, started

import dcfp.kernels

pytestmark = pytest.mark.slow
DECORATOR = Path(dcfp.kernels.__file__).with_name("_jit.py")

LAW = """
from mini.kernels._jit import kernel

@kernel
def law(x):
    return {factor} * x
"""

# the same fields in another order: code compiled for one and run with the other answers wrongly, without an error
STEP = """
from typing import NamedTuple

from mini.kernels._jit import kernel
from mini.kernels.law import law

class Rising(NamedTuple):
    start: float
    end: float

class Falling(NamedTuple):
    end: float
    start: float

@kernel
def rise(course):
    return law(course.end - course.start)
"""

CALL = """
from mini.kernels.step import Falling, Rising, rise
print(rise({course}))
hits = getattr(rise, "stats", None) and sum(rise.stats.cache_hits.values())
print(hits)
"""

RISING = "Rising(start=1.0, end=4.0)"
FALLING = "Falling(start=4.0, end=1.0)"


@dataclass(frozen=True)
class Answer:
    """What a new process printed: the value, and how much code it took from the cache."""

    value: float
    hits: int | None


@dataclass(frozen=True)
class Mini:
    """A package `mini` with two kernels in two files, one calling the other."""

    root: Path

    @property
    def kernels(self) -> Path:
        return self.root / "mini" / "kernels"

    @property
    def cache(self) -> Path:
        return self.root / "cache"

    def folders(self) -> set[Path]:
        return set((self.cache / "kernels").glob("*"))

    def write_law(self, factor: float) -> None:
        (self.kernels / "law.py").write_text(LAW.format(factor=factor))

    def environment(self, **more: str) -> dict[str, str]:
        inherited = {name: value for name, value in os.environ.items() if not name.startswith("NUMBA_")}
        return {
            **inherited,
            "DCFP_CACHE_DIR": str(self.cache),
            "PYTHONPATH": str(self.root),
            # no bytecode: Python tells an edited source by its second and size, which a quick edit may keep
            "PYTHONDONTWRITEBYTECODE": "1",
            **more,
        }

    def output(self, code: str, **environment: str) -> list[str]:
        return output(code, self.root, self.environment(**environment)).splitlines()

    def call(self, course: str = RISING, **environment: str) -> Answer:
        value, hits = self.output(CALL.format(course=course), **environment)
        return Answer(float(value), None if hits == "None" else int(hits))


@pytest.fixture
def mini(tmp_path: Path) -> Mini:
    package = Mini(tmp_path)
    package.kernels.mkdir(parents=True)
    (tmp_path / "mini" / "__init__.py").touch()
    (package.kernels / "__init__.py").touch()
    shutil.copy(DECORATOR, package.kernels)
    (package.kernels / "step.py").write_text(STEP)
    package.write_law(factor=2.0)
    return package


def code_files(mini: Mini, kernel: str, extension: str) -> list[Path]:
    return sorted(mini.cache.rglob(f"*.{kernel}-*.{extension}"))


def test_the_cache_answers_until_a_callee_in_another_file_is_edited_and_again_when_that_is_undone(mini):
    assert mini.call() == Answer(6.0, hits=0)
    assert mini.call() == Answer(6.0, hits=1)
    assert not list((mini.root / "mini").rglob("*.nbi"))
    mini.write_law(factor=5.0)
    assert mini.call() == Answer(15.0, hits=0)
    mini.write_law(factor=2.0)
    assert mini.call() == Answer(6.0, hits=1)
    assert mini.call(NUMBA_BOUNDSCHECK="1") == Answer(6.0, hits=0)  # checked code is kept apart


def test_folder_changes_with_any_kernel_source(mini):
    names = ["__init__.py", "_jit.py", "law.py", "step.py", "new.py"]
    code = f"""
from pathlib import Path
from mini.kernels._jit import cache_folder
print(cache_folder())
for name in {names}:
    with (Path("mini/kernels") / name).open("a") as source:
        source.write("# a remark\\n")
    cache_folder.cache_clear()
    print(cache_folder())
for name, text in [("law.py", Path("mini/kernels/law.py").read_text().removesuffix("# a remark\\n")),
                   ("step.py", "# a remark\\n" + Path("mini/kernels/step.py").read_text())]:
    (Path("mini/kernels") / name).write_text(text)  # the same text, moved from one file's end to the next one's head
cache_folder.cache_clear()
print(cache_folder())
"""
    folders = mini.output(code)
    assert len(folders) == len(set(folders)) == len(names) + 2
    assert all(folders)


def test_processes_that_compile_at_once_all_answer_rightly(mini):
    courses = [RISING, FALLING] * 2
    waiting = [started(CALL.format(course=course), mini.root, mini.environment()) for course in courses]
    values = [float(wait().splitlines()[0]) for wait in waiting]
    assert values == [6.0, -6.0] * 2
    assert mini.call(RISING).value == 6.0
    assert mini.call(FALLING).value == -6.0


def test_code_of_other_types_under_a_name_is_not_used(mini):
    # so two processes leave it that save code for different types at the same moment
    mini.call(RISING)
    mini.call(FALLING)
    first, second = code_files(mini, "rise", "nbc")
    shutil.copy(first, second)
    answers = [mini.call(RISING), mini.call(FALLING)]
    assert [one.value for one in answers] == [6.0, -6.0]
    assert sorted(one.hits for one in answers) == [0, 1]


def test_a_file_cut_short_is_replaced(mini):
    mini.call()
    for extension, kept in (("nbi", 0), ("nbi", 20), ("nbc", 20)):
        for kernel in ("law", "rise"):
            (path,) = code_files(mini, kernel, extension)
            path.write_bytes(path.read_bytes()[:kept])
        assert mini.call() == Answer(6.0, hits=0)
    assert mini.call() == Answer(6.0, hits=1)


def test_a_process_of_its_own_answers_as_a_forked_one_and_finds_its_code(mini):
    mini.call()
    command = [sys.executable, "-W", "error", "-c", CALL.format(course=RISING)]
    done = subprocess.run(command, cwd=mini.root, env=mini.environment(), capture_output=True, text=True)
    assert (done.stdout.split(), done.stderr) == (["6.0", "1"], "")


def test_unwritable_place_compiles_in_memory(mini):
    mini.cache.write_text("a file where the folder should be")
    assert mini.call() == Answer(6.0, hits=0)
    assert not list(mini.root.rglob("*.nbi"))


def test_numba_chooses_no_place_of_its_own(mini):
    # numba would keep the code beside the source, where an edited callee is not noticed
    mini.call()
    (folder,) = mini.folders()
    (place,) = folder.iterdir()
    shutil.rmtree(place)
    place.write_text("a file where the folder should be")
    assert mini.call() == Answer(6.0, hits=0)
    assert not list((mini.root / "mini").rglob("*.nbi"))


def test_folder_that_goes_away_before_the_first_call_does_no_harm(mini):
    blocked = """
import os, pathlib, shutil
import mini.kernels.step
place = pathlib.Path(os.environ["DCFP_CACHE_DIR"])
shutil.rmtree(place)
place.write_text("a file where the folder should be")
"""
    assert mini.output(blocked + CALL.format(course=RISING)) == ["6.0", "0"]


def test_without_compilation_no_folder_is_made(mini):
    assert mini.call(NUMBA_DISABLE_JIT="1") == Answer(6.0, hits=None)
    assert not mini.cache.exists()


def test_numba_settings_of_the_user_are_left_alone(mini):
    code = """
from numba.core import config
before = config.CACHE_DIR
import mini.kernels.step
assert config.CACHE_DIR == before, config.CACHE_DIR
print(before)
"""
    assert mini.output(code + CALL.format(course=RISING), NUMBA_CACHE_DIR="own") == ["own", "6.0", "0"]
    assert not (mini.root / "own").exists()
    assert mini.folders()


def test_folders_long_out_of_use_are_deleted_when_a_new_one_is_opened(mini):
    mini.call()
    (first,) = mini.folders()
    foreign = first.with_name("notes")
    foreign.mkdir()
    long_ago = time.time() - 61 * 24 * 3600
    for folder in (first, foreign):
        os.utime(folder, (long_ago, long_ago))

    assert mini.call().hits == 1  # use renews it
    mini.write_law(factor=3.0)
    mini.call()
    assert first.exists()

    os.utime(first, (long_ago, long_ago))
    mini.write_law(factor=4.0)
    mini.call()
    assert not first.exists()
    assert foreign.exists()


def test_real_kernels_point_into_the_cache_folder():
    from dcfp.kernels._jit import cache_folder
    from dcfp.kernels.oscillator import advance_oscillator

    if not hasattr(advance_oscillator, "stats"):
        pytest.skip("compilation is switched off")
    assert advance_oscillator.stats.cache_path.startswith(cache_folder())
