"""The same study on several processes: the same bits, whoever dies."""

import os
import signal
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import dcfp
from dcfp.analysis.integration import Integration
from dcfp.errors import InputError
from dcfp.study import Study, run_study
from dcfp.study.results import open_store, share_done
from dcfp.study.run import run_on_cluster

psutil = pytest.importorskip("psutil")
pytest.importorskip("distributed")

pytestmark = pytest.mark.filterwarnings("default")  # what Dask warns of is its own


@pytest.fixture(scope="module")
def large() -> Study:
    """Work in 32 blocks of one analysis, in steps so short that it takes as long as to write it."""
    factors = {"pgv": np.linspace(100.0, 2000.0, 8), "mu": np.linspace(0.02, 0.12, 4)}
    return Study([dcfp.load_motion("NCC")], factors, settings=Integration(step=0.0002))


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


@pytest.mark.slow
def test_two_processes_give_the_same_bits_and_a_dead_worker_costs_its_block_alone(
    large: Study, on_threads: Path, tmp_path: Path, content
) -> None:
    place = tmp_path / "processes.zarr"
    reported: list[int] = []
    times: dict[str, int] = {}

    def kill_once(analyses: int, cost: float) -> None:
        reported.append(analyses)
        if len(reported) == 4:
            times.update(
                {
                    str(one): one.stat().st_mtime_ns
                    for one in (place / "status" / "c").rglob("*")
                    if one.is_file()
                }
            )
            # stopped before it is killed it is sure to have blocks with which it dies
            one = workers()[0].pid
            os.kill(one, signal.SIGSTOP)
            threading.Timer(0.5, os.kill, (one, signal.SIGKILL)).start()

    dataset = run_on_cluster(large, place, processes=2, report=kill_once)
    assert len(times) == 4
    assert dataset.identical(open_store(on_threads))
    assert content(place) == content(on_threads)
    assert len(reported) == 32  # every block came in once
    assert all(Path(name).stat().st_mtime_ns == written for name, written in times.items())


def stop_after(blocks: int):
    """Return a report that is interrupted after so many blocks."""
    left = [blocks]

    def stop(analyses: int, cost: float) -> None:
        left[0] -= 1
        if left[0] == 0:
            raise KeyboardInterrupt

    return stop


@pytest.mark.slow
def test_a_store_begun_on_threads_goes_on_on_processes_and_back_and_an_interruption_leaves_none_behind(
    large: Study, on_threads: Path, tmp_path: Path, content
) -> None:
    place = tmp_path / "s.zarr"
    with pytest.raises(KeyboardInterrupt):
        run_study(large, place, threads=2, report=stop_after(6))
    begun = share_done(open_store(place))
    with pytest.raises(KeyboardInterrupt):
        run_on_cluster(large, place, processes=1, resume=True, report=stop_after(20))
    deadline = time.monotonic() + 10.0
    while workers() and time.monotonic() < deadline:
        threading.Event().wait(0.1)
    assert workers() == []
    assert 0.0 < begun < share_done(open_store(place)) < 1.0
    run_study(large, place, resume=True)
    assert content(place) == content(on_threads)


def test_a_scheduler_that_is_not_there(study: Study, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr("dcfp.study.run._PATIENCE", 1)
    with pytest.raises(InputError, match=r"tcp://127.0.0.1:9: there is no Dask scheduler; start one"):
        run_on_cluster(study, tmp_path / "s.zarr", address="tcp://127.0.0.1:9")
    with pytest.raises(InputError, match="there is no Dask scheduler"):
        run_on_cluster(study, tmp_path / "t.zarr", address="nonsense://x")
