"""kill -9 of the whole process at random moments: what is there is whole, and `--resume` makes the same store.

One kill is enough to notice that something is wrong; with ``--long`` ``DCFP_KILLS`` sets how often, also while it resumes, to believe that nothing is.
"""

import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from dcfp.study import read_study, run_study
from dcfp.study.results import open_store, share_done

KILLS = int(os.environ.get("DCFP_KILLS", "20"))
#: 24 blocks of one analysis, in steps so short that it takes as long as to write it.
TEXT = """
[factors]
record = ["NCC"]
pgv = { from = 0.1, to = 2.0, count = 4, unit = "m/s" }
mu = { from = 0.02, to = 0.12, count = 6 }
[analysis]
step = 0.0002
"""
#: A minute of work in 64 blocks: they are not done before the interruption comes, which waits for those at work alone.
LONG = """
[factors]
record = ["NCC", "KNA"]
pgv = { from = 0.1, to = 2.0, count = 64, unit = "m/s" }
mu = { from = 0.02, to = 0.12, count = 64 }
[analysis]
step = 0.0005
"""

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="kill -9 is of POSIX")


def start(file: Path, place: Path) -> subprocess.Popen[bytes]:
    words = [
        sys.executable,
        "-m",
        "dcfp.doors.cli.main",
        "study",
        str(file),
        "--out",
        str(place),
        "--resume",
        "--json",
    ]
    return subprocess.Popen(words, stdout=subprocess.DEVNULL)


def wait_for_blocks(process: subprocess.Popen[bytes], place: Path, blocks: int) -> None:
    """Wait until so many more blocks are written, or it ends."""
    folder = place / "status" / "c"
    before = len([one for one in folder.rglob("*") if one.is_file()])
    while process.poll() is None and len([o for o in folder.rglob("*") if o.is_file()]) < before + blocks:
        time.sleep(0.01)


@pytest.mark.slow
@pytest.mark.parametrize("wanted", [1, pytest.param(KILLS, marks=pytest.mark.long)])
def test_killed_again_and_again(tmp_path: Path, content, wanted: int) -> None:
    file = tmp_path / "study.toml"
    file.write_text(TEXT, encoding="utf-8")
    run_study(read_study(file), tmp_path / "whole.zarr")
    whole = content(tmp_path / "whole.zarr")
    chance = random.Random(4)
    kills = 0
    for attempt in range(20 * wanted):
        place = tmp_path / f"{attempt}.zarr"
        for _ in range(min(wanted, 4)):
            process = start(file, place)
            wait_for_blocks(process, place, chance.randrange(1, 9))
            time.sleep(chance.uniform(0.0, 0.05))
            if process.poll() is None:
                process.send_signal(signal.SIGKILL)
                kills += 1
            process.wait()
            if place.exists():
                assert 0.0 <= share_done(open_store(place)) <= 1.0  # readable at any moment
        run_study(read_study(file), place, resume=True)
        assert content(place) == whole
        if kills >= wanted:
            break
    assert kills >= wanted


@pytest.mark.slow
def test_ctrl_c_ends_with_a_sentence_and_the_status_of_an_interruption(tmp_path: Path, content) -> None:
    file = tmp_path / "study.toml"
    file.write_text(LONG, encoding="utf-8")
    place = tmp_path / "s.zarr"
    words = [sys.executable, "-m", "dcfp.doors.cli.main", "study", str(file), "--out", str(place)]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    wait_for_blocks(process, place, 1)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate()
    assert process.returncode == 130
    assert out == ""
    assert err == f"dcfp: stopped; {place} keeps what is done, and --resume goes on from it.\n"
    done = share_done(open_store(place))
    assert 0.0 < done < 1.0
