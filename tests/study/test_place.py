"""Whose place a store is: nothing else is touched, and only one process writes."""

import errno
from pathlib import Path

import numpy as np
import pytest

from dcfp.errors import InputError
from dcfp.study import Study, run_study
from dcfp.study import store as stores
from dcfp.study.results import open_store
from dcfp.study.store import alone

pytestmark = pytest.mark.filterwarnings("error")


@pytest.fixture
def small(motions) -> Study:
    """Another study than the grid, of one analysis for each record."""
    return Study(motions=motions, factors={"mu": [0.05]})


@pytest.mark.slow
def test_a_store_that_is_there_is_not_touched(
    study: Study, small: Study, store: Path, content, whole
) -> None:
    with pytest.raises(InputError, match=r"the store exists, 100 % of it done; go on with it \(resume\)"):
        run_study(study, store)
    with pytest.raises(InputError, match=r"this store is of another study; choose another name"):
        run_study(small, store, resume=True)
    with pytest.raises(InputError, match="another process is writing into this store"), alone(store):
        run_study(study, store, resume=True)
    with pytest.raises(InputError, match="another process is writing into this store"), alone(store):
        run_study(study, store, overwrite=True)
    assert content(store) == whole
    run_study(small, store, overwrite=True)
    assert open_store(store).identical(run_study(small))


@pytest.mark.slow
def test_another_version_does_not_go_on(study: Study, store: Path, content, whole, monkeypatch) -> None:
    monkeypatch.setattr("dcfp.study.store.source_digest", lambda: "of other kernels")
    with pytest.raises(InputError, match=r"this store is made by another version \(dcfp "):
        run_study(study, store, resume=True)
    assert content(store) == whole


@pytest.mark.slow
def test_a_link_is_followed_and_stays(small: Study, tmp_path: Path) -> None:
    (tmp_path / "real.zarr").symlink_to(tmp_path / "there.zarr")
    run_study(small, tmp_path / "real.zarr")
    run_study(small, tmp_path / "real.zarr", overwrite=True)
    assert run_study(small, tmp_path / "real.zarr", resume=True).identical(run_study(small))
    assert (tmp_path / "real.zarr").is_symlink()


def test_what_a_killed_process_left_beside_is_not_in_the_way(small: Study, tmp_path: Path) -> None:
    for name in (".s.zarr.new", ".s.zarr.old", ".s.zarr.other.part"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "zarr.json").write_text("half", encoding="utf-8")
    (tmp_path / ".s.zarr.lock").touch()
    run_study(small, tmp_path / "s.zarr")
    assert sorted(path.name for path in tmp_path.iterdir()) == [".s.zarr.other.part", "s.zarr"]


def test_a_store_that_cannot_be_replaced_is_still_there(
    study: Study, store: Path, tmp_path: Path, content, whole, monkeypatch
) -> None:
    def full(store, plan) -> None:
        store.mkdir()
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(stores, "_create", full)
    with pytest.raises(InputError, match="No space left on device"):
        run_study(study, store, overwrite=True)
    assert content(tmp_path) == {f"s.zarr/{name}": data for name, data in whole.items()}


@pytest.mark.slow
def test_only_one_of_several_starters_runs(study: Study, tmp_path: Path, results) -> None:
    """Threads stand for processes here: the lock is on the file, not in the process."""
    from concurrent.futures import ThreadPoolExecutor

    place = tmp_path / "s.zarr"

    def start(number: int) -> str:
        try:
            run_study(study, place, threads=1, resume=True)
        except InputError as error:
            return str(error)
        return "done"

    with ThreadPoolExecutor(4) as pool:
        outcomes = list(pool.map(start, range(8)))
    assert "done" in outcomes
    assert all(one == "done" or "another process is writing" in one for one in outcomes)
    assert run_study(study, place, resume=True).identical(results)


@pytest.mark.parametrize("how", ["folder", "file", "zarr"])
def test_what_is_no_store_is_not_replaced(study: Study, tmp_path: Path, content, how: str) -> None:
    import xarray

    place = tmp_path / "mine"
    if how == "folder":
        place.mkdir()
        (place / "thesis.txt").write_text("years of work", encoding="utf-8")
    elif how == "file":
        place.write_text("years of work", encoding="utf-8")
    else:
        xarray.Dataset({"a": ("x", np.zeros(3))}).to_zarr(place, zarr_format=3, consolidated=False)
    before = content(tmp_path)
    for options in ({}, {"resume": True}, {"overwrite": True}):
        with pytest.raises(InputError, match="this is not the store of a study"):
            run_study(study, place, **options)
    assert content(tmp_path) == before


def test_a_folder_that_is_not_there(study: Study, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="the store cannot be written"):
        run_study(study, tmp_path / "nowhere" / "s.zarr")
