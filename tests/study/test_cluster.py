"""The same study on several processes: the same bits, whoever dies."""

import os
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import dcfp
from dcfp.errors import InputError
from dcfp.study import Study, run_study
from dcfp.study.results import open_store
from dcfp.study.run import run_on_cluster

psutil = pytest.importorskip("psutil")
pytest.importorskip("distributed")

pytestmark = pytest.mark.filterwarnings("default")  # what Dask warns of is its own


@pytest.fixture(scope="module")
def large() -> Study:
    """Work in 64 blocks."""
    motions = [dcfp.load_motion(name) for name in ("NCC", "KNA")]
    factors = {"pgv": np.linspace(100.0, 2000.0, 16), "mu": np.linspace(0.02, 0.12, 16)}
    return Study(motions=motions, factors=factors)


@pytest.fixture(scope="module")
def on_threads(large: Study, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Its store, by the threads of this process."""
    place = tmp_path_factory.mktemp("large") / "threads.zarr"
    run_study(large, place)
    return place


def workers() -> list[psutil.Process]:
    """Return the worker processes that this one has."""
    found = psutil.Process().children(recursive=True)
    return [one for one in found if one.is_running() and "spawn_main" in " ".join(one.cmdline())]


def test_two_processes_give_the_same_bits_and_a_dead_worker_costs_its_block_alone(
    large: Study, on_threads: Path, tmp_path: Path, content
) -> None:
    place = tmp_path / "processes.zarr"
    reported: list[int] = []
    times: dict[str, int] = {}

    def kill_once(analyses: int, cost: float) -> None:
        reported.append(analyses)
        if len(reported) == 8:
            times.update(
                {
                    str(one): one.stat().st_mtime_ns
                    for one in (place / "status" / "c").rglob("*")
                    if one.is_file()
                }
            )
            os.kill(workers()[0].pid, signal.SIGKILL)

    dataset = run_on_cluster(large, place, processes=2, report=kill_once)
    assert len(times) == 8
    assert dataset.identical(open_store(on_threads))
    assert content(place) == content(on_threads)
    assert len(reported) == 64  # every block came in once
    assert all(Path(name).stat().st_mtime_ns == written for name, written in times.items())


def test_a_store_begun_on_threads_is_finished_on_processes(
    large: Study, on_threads: Path, tmp_path: Path, content
) -> None:
    place = tmp_path / "s.zarr"
    left = [20]

    def stop(analyses: int, cost: float) -> None:
        left[0] -= 1
        if left[0] == 0:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_study(large, place, report=stop)
    run_on_cluster(large, place, processes=1, resume=True)
    assert content(place) == content(on_threads)


def test_a_scheduler_that_is_not_there(study: Study, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("dcfp.study.run._PATIENCE", 1)
    with pytest.raises(InputError, match=r"tcp://127.0.0.1:9: there is no Dask scheduler; start one"):
        run_on_cluster(study, tmp_path / "s.zarr", address="tcp://127.0.0.1:9")
    with pytest.raises(InputError, match="there is no Dask scheduler"):
        run_on_cluster(study, tmp_path / "t.zarr", address="nonsense://x")


def test_an_interruption_leaves_no_process_behind(large: Study, tmp_path: Path) -> None:
    def stop(analyses: int, cost: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_on_cluster(large, tmp_path / "s.zarr", processes=1, report=stop)
    deadline = time.monotonic() + 10.0
    while workers() and time.monotonic() < deadline:
        threading.Event().wait(0.1)
    assert workers() == []
