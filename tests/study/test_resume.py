"""What interrupts a study, damages its store or fills its disk costs nothing that is done."""

import errno
from pathlib import Path

import numpy as np
import pytest
import zarr

from dcfp.analysis.response import NOT_RUN
from dcfp.errors import InputError
from dcfp.study import Study, run_study
from dcfp.study import run as engine
from dcfp.study import store as stores
from dcfp.study.results import open_store, share_done

pytestmark = pytest.mark.filterwarnings("error")


class StopError(Exception):
    """Something that goes wrong."""


def stop_after(blocks: int, error: BaseException):
    """Return a report that fails after so many blocks."""
    left = [blocks]

    def report(analyses: int, cost: float) -> None:
        left[0] -= 1
        if left[0] == 0:
            raise error

    return report


# an interruption writes what is at work, an error does not: of 12 blocks after the first and in the middle
@pytest.mark.slow
@pytest.mark.parametrize(
    ("blocks", "error"), [(1, KeyboardInterrupt()), (5, StopError()), (7, KeyboardInterrupt())]
)
def test_what_was_interrupted_is_taken_up_again(
    study: Study, tmp_path: Path, content, whole, monkeypatch, error: BaseException, blocks: int
) -> None:
    place = tmp_path / "part.zarr"
    with pytest.raises(type(error)):
        run_study(study, place, threads=2, report=stop_after(blocks, error))
    done = share_done(open_store(place))
    assert 0.0 < done < 1.0
    worked: list[int] = []
    work_off = engine.work_off
    monkeypatch.setattr(
        engine, "work_off", lambda plan, block: worked.append(block.size) or work_off(plan, block)
    )
    reported: list[int] = []
    run_study(study, place, resume=True, report=lambda analyses, cost: reported.append(analyses))
    assert content(place) == whole
    assert sum(worked) == pytest.approx((1.0 - done) * 144)  # nothing finished is run twice
    assert sum(reported) == 144
    assert sorted(path.name for path in tmp_path.iterdir()) == ["part.zarr"]


@pytest.mark.slow
def test_resume_begins_where_there_is_nothing(study: Study, tmp_path: Path, results) -> None:
    assert run_study(study, tmp_path / "new.zarr", resume=True).identical(results)


def test_resuming_what_is_done_runs_nothing(study: Study, store: Path, results, monkeypatch) -> None:
    monkeypatch.setattr(engine, "work_off", None)
    assert run_study(study, store, resume=True).identical(results)


@pytest.mark.parametrize("what", ["cut", "empty", "gone", "partial", "one not run"])
def test_a_damaged_store_is_mended(study: Study, store: Path, content, whole, what: str) -> None:
    chunk = next(path for path in (store / "status" / "c").rglob("*") if path.is_file())
    if what == "cut":
        chunk.write_bytes(chunk.read_bytes()[:-3])
    elif what == "empty":
        chunk.write_bytes(b"")
    elif what == "gone":
        chunk.unlink()
    elif what == "one not run":
        zarr.open_group(store, mode="r+")["status"][0, 0, 0, 0] = NOT_RUN
    else:
        chunk.with_suffix(".0123.partial").write_bytes(b"half")
    run_study(study, store, resume=True)
    assert content(store) == whole


@pytest.mark.slow
def test_a_full_disk_gets_one_sentence_and_loses_nothing(
    study: Study, tmp_path: Path, content, whole, monkeypatch
) -> None:
    place = tmp_path / "s.zarr"
    write, writes = stores.StudyStore.write, [0]

    def full(self, block, results) -> None:
        writes[0] += 1
        if writes[0] > 5:
            self._arrays["peak_force"] = Full()
        write(self, block, results)

    class Full:
        def __setitem__(self, region, values) -> None:
            raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(stores.StudyStore, "write", full)
        with pytest.raises(
            InputError, match=r"s.zarr: the results cannot be written \(No space left on device\)"
        ):
            run_study(study, place)
    status = open_store(place)["status"].values
    known = open_store(place)["peak_displacement"].values[status != NOT_RUN]
    assert known.size > 0
    assert np.isfinite(known).all()
    run_study(study, place, resume=True)
    assert content(place) == whole


def test_a_disk_that_is_full_from_the_start(study: Study, tmp_path: Path, monkeypatch) -> None:
    def full(store, plan) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(stores, "_create", full)
    with pytest.raises(InputError, match=r"the store cannot be written \(No space left on device\)"):
        run_study(study, tmp_path / "s.zarr")
    assert list(tmp_path.iterdir()) == []
