"""Running a study: the right numbers, whatever interrupts it."""

import errno
import json
from pathlib import Path

import numpy as np
import pytest

import dcfp
from dcfp.comparison import compare
from dcfp.errors import InputError
from dcfp.response.status import FAILED, NOT_RUN
from dcfp.study import Plan, Sampling, Settings, Study, Uniform, run_study
from dcfp.study import run as engine
from dcfp.study import store as stores
from dcfp.study.place import alone
from dcfp.study.results import QUANTITIES, open_store, share_done

pytestmark = pytest.mark.filterwarnings("error")


def test_every_result_is_that_of_the_analysis_alone(study: Study, motions) -> None:
    dataset = run_study(study)
    assert dataset["peak_displacement"].dims == ("record", "pgv", "mu", "ambient")
    for motion in motions:
        for pgv in (100.0, 800.0):
            for mu in study.factors["mu"]:
                for ambient in study.factors["ambient"]:
                    alone = dcfp.respond(
                        motion.scaled(pgv / motion.peak_velocity),
                        friction=dcfp.Li2020(mu_0=mu),
                        heating=dcfp.SimplifiedHeating(ambient=ambient),
                    )
                    found = dataset.sel(record=motion.name, pgv=pgv, mu=mu, ambient=ambient)
                    for name in set(QUANTITIES) - {"force_ratio"}:
                        assert found[name].item() == getattr(alone, name), name


def test_coordinates_and_provenance(study: Study, motions) -> None:
    dataset = run_study(study)
    assert dataset["pgv"].attrs["units"] == "mm s-1"
    assert dataset["peak_displacement"].attrs["units"] == "mm"
    assert dataset["event"].values.tolist() == [f"Event of {motion.name}" for motion in motions]
    assert dataset["record_sha256"].values.tolist() == [motion.digest for motion in motions]
    assert dataset["status"].attrs["flag_meanings"].split()[FAILED] == "failed"
    assert dataset.attrs["source"] == f"dcfp {dcfp.version()}"
    assert [one["sha256"] for one in json.loads(dataset.attrs["records"])] == [m.digest for m in motions]
    assert "Energy-Based Prediction" in dataset.attrs["references"]
    assert dataset.attrs["displacement_capacity"] == 440.0


def test_threads_and_stores_do_not_change_a_bit(study: Study, tmp_path: Path, content) -> None:
    memory = run_study(study, threads=1)
    one = run_study(study, tmp_path / "one.zarr", threads=1)
    four = run_study(study, tmp_path / "four.zarr", threads=4)
    assert memory.identical(one)
    assert one.identical(four)
    assert content(tmp_path / "one.zarr") == content(tmp_path / "four.zarr")


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


@pytest.mark.parametrize("error", [KeyboardInterrupt(), StopError()])
@pytest.mark.parametrize("blocks", [1, 7, 20])
def test_what_was_interrupted_is_taken_up_again(
    study: Study, tmp_path: Path, content, monkeypatch, error: BaseException, blocks: int
) -> None:
    run_study(study, tmp_path / "whole.zarr")
    place = tmp_path / "part.zarr"
    with pytest.raises(type(error)):
        run_study(study, place, report=stop_after(blocks, error))
    done = share_done(open_store(place))
    assert 0.0 < done < 1.0
    worked: list[int] = []
    work_off = engine.work_off
    monkeypatch.setattr(
        engine, "work_off", lambda plan, block: worked.append(block.size) or work_off(plan, block)
    )
    reported: list[int] = []
    run_study(study, place, resume=True, report=lambda analyses, cost: reported.append(analyses))
    assert content(place) == content(tmp_path / "whole.zarr")
    assert sum(worked) == pytest.approx((1.0 - done) * 144)  # nothing finished is run twice
    assert sum(reported) == 144
    assert sorted(path.name for path in tmp_path.iterdir()) == ["part.zarr", "whole.zarr"]


def test_resume_begins_where_there_is_nothing(study: Study, tmp_path: Path) -> None:
    assert run_study(study, tmp_path / "new.zarr", resume=True).identical(run_study(study))


def test_resuming_what_is_done_runs_nothing(study: Study, tmp_path: Path, monkeypatch) -> None:
    run_study(study, tmp_path / "s.zarr")
    monkeypatch.setattr(engine, "work_off", None)
    run_study(study, tmp_path / "s.zarr", resume=True)


@pytest.mark.parametrize("what", ["cut", "empty", "gone", "partial"])
def test_a_damaged_store_is_mended(study: Study, tmp_path: Path, content, what: str) -> None:
    place = tmp_path / "s.zarr"
    run_study(study, place)
    whole = content(place)
    chunk = next(path for path in (place / "status" / "c").rglob("*") if path.is_file())
    if what == "cut":
        chunk.write_bytes(chunk.read_bytes()[:-3])
    elif what == "empty":
        chunk.write_bytes(b"")
    elif what == "gone":
        chunk.unlink()
    else:
        chunk.with_suffix(".0123.partial").write_bytes(b"half")
    run_study(study, place, resume=True)
    assert content(place) == whole


def test_a_full_disk_gets_one_sentence_and_loses_nothing(
    study: Study, tmp_path: Path, content, monkeypatch
) -> None:
    run_study(study, tmp_path / "whole.zarr")
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
    assert content(place) == content(tmp_path / "whole.zarr")


def test_a_disk_that_is_full_from_the_start(study: Study, tmp_path: Path, monkeypatch) -> None:
    def full(store, plan) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(stores, "_create", full)
    with pytest.raises(InputError, match=r"the store cannot be written \(No space left on device\)"):
        run_study(study, tmp_path / "s.zarr")
    assert list(tmp_path.iterdir()) == []


def test_a_store_that_is_there_is_not_touched(study: Study, motions, tmp_path: Path, content) -> None:
    place = tmp_path / "s.zarr"
    run_study(study, place)
    before = content(place)
    other = Study(motions=motions, factors={"mu": [0.05]})
    with pytest.raises(InputError, match=r"the store exists, 100 % of it done; go on with --resume"):
        run_study(study, place)
    with pytest.raises(InputError, match=r"this store is of another study; choose another name"):
        run_study(other, place, resume=True)
    with pytest.raises(InputError, match="another process is writing into this store"), alone(place):
        run_study(study, place, resume=True)
    with pytest.raises(InputError, match="another process is writing into this store"), alone(place):
        run_study(study, place, overwrite=True)
    assert content(place) == before
    run_study(other, place, overwrite=True)
    assert open_store(place).attrs["study_sha256"] != run_study(study).attrs["study_sha256"]


def test_another_version_does_not_go_on(study: Study, tmp_path: Path, content, monkeypatch) -> None:
    place = tmp_path / "s.zarr"
    run_study(study, place)
    before = content(place)
    monkeypatch.setattr("dcfp.study.provenance.source_digest", lambda: "of other kernels")
    with pytest.raises(InputError, match=r"this store is made by another version \(dcfp "):
        run_study(study, place, resume=True)
    assert content(place) == before


def test_a_link_is_followed_and_stays(study: Study, tmp_path: Path) -> None:
    (tmp_path / "real.zarr").symlink_to(tmp_path / "there.zarr")
    run_study(study, tmp_path / "real.zarr")
    run_study(study, tmp_path / "real.zarr", overwrite=True)
    assert run_study(study, tmp_path / "real.zarr", resume=True).identical(run_study(study))
    assert (tmp_path / "real.zarr").is_symlink()


def test_what_a_killed_process_left_beside_is_not_in_the_way(study: Study, tmp_path: Path) -> None:
    for name in (".s.zarr.new", ".s.zarr.old", ".s.zarr.other.part"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "zarr.json").write_text("half", encoding="utf-8")
    (tmp_path / ".s.zarr.lock").touch()
    run_study(study, tmp_path / "s.zarr")
    assert sorted(path.name for path in tmp_path.iterdir()) == [".s.zarr.other.part", "s.zarr"]


def test_a_store_that_cannot_be_replaced_is_still_there(
    study: Study, tmp_path: Path, content, monkeypatch
) -> None:
    place = tmp_path / "s.zarr"
    run_study(study, place)
    before = content(place)

    def full(store, plan) -> None:
        store.mkdir()
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(stores, "_create", full)
    with pytest.raises(InputError, match="No space left on device"):
        run_study(study, place, overwrite=True)
    assert content(tmp_path) == {f"s.zarr/{name}": data for name, data in before.items()}


def test_only_one_of_several_starters_runs(study: Study, tmp_path: Path) -> None:
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
    assert run_study(study, place, resume=True).identical(run_study(study))


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


@pytest.mark.parametrize(
    "change",
    [
        {"factors": {"mu": [0.05, 0.06]}},
        {"factors": {"mu": [0.05], "ambient": [20.0]}},
        {"settings": Settings(tolerance=0.03)},
        {"settings": Settings(tail=3.0)},
        {"model": dcfp.bearing.Model(heating=dcfp.NoHeating())},
        {"histories": ("displacement",)},
        {"sampling": Sampling({"radius": Uniform(2000.0, 4000.0)}, 4)},
    ],
)
def test_whatever_changes_a_number_makes_another_study(motions, change: dict) -> None:
    same = {"motions": motions, "factors": {"mu": [0.05]}}
    digests = {
        run_study(Study(**given)).attrs["study_sha256"]
        for given in (same, same | change, same | {"title": "Another"})
    }
    assert len(digests) == 2


def test_a_motion_that_differs_makes_another_study(motions) -> None:
    one = Study(motions=motions)
    other = Study(motions=[motions[0].scaled(1.0 + 1e-15), *motions[1:]])
    assert run_study(one).attrs["study_sha256"] != run_study(other).attrs["study_sha256"]


def test_samples_are_a_dimension_with_their_factors_along_it(motions) -> None:
    sampling = Sampling({"radius": Uniform(2000.0, 4000.0), "mu": Uniform(0.03, 0.1)}, 5)
    study = Study(motions=motions, factors={"pgv": [400.0, 600.0]}, sampling=sampling)
    dataset = run_study(study)
    assert dict(dataset["status"].sizes) == {"record": 3, "pgv": 2, "sample": 5}
    assert dataset["radius"].dims == ("sample",)
    case = dataset.isel(record=1, pgv=1, sample=3)
    bearing = dcfp.Bearing((case["radius"].item(),) * 2, 400.0, 60.0, 1.9e6)
    alone = dcfp.respond(
        motions[1].scaled(600.0 / motions[1].peak_velocity), bearing, dcfp.Li2020(mu_0=case["mu"].item())
    )
    assert case["peak_displacement"].item() == alone.peak_displacement
    assert json.loads(dataset.attrs["sampling_factors"])[1]["name"] == "mu"


def test_methods_say_what_they_say_alone() -> None:
    names = ["analysis", "pulse", "simplified", "design", "march", "asce7", "eurocode8", "aij1", "aij2", "aij-energy", "iwan"]  # fmt: skip
    motion = dcfp.load_motion("NCC")
    dataset = run_study(Study(motions=[motion], factors={"pgv": [500.0], "procedure": names})).squeeze()
    case = compare(motion.scaled(500.0 / motion.peak_velocity), codes=True)
    said = {view[0].name.lower(): one for view, one in case.predicted.items() if view[1].name != "INFORMED"}
    found = dict(zip(names, dataset["peak_displacement"].values.tolist(), strict=True))
    assert found["analysis"] == case.analysed.whole.displacement
    for name, key in (("pulse", "pulse"), ("simplified", "simplified"), ("design", "design"), ("march", "march"), ("asce7", "asce"), ("eurocode8", "eurocode"), ("aij1", "aij_1"), ("aij2", "aij_2"), ("aij-energy", "aij_energy"), ("iwan", "iwan")):  # fmt: skip
        assert found[name] == said[key].bound, name
    march = dataset.sel(procedure="march")
    assert march["input_velocity"].item() == said["march"].total_velocity
    assert np.isnan(dataset.sel(procedure="pulse")["peak_temperature"].item())


def test_histories_are_kept_over_the_length_of_each_record(motions) -> None:
    names = ("displacement", "force", "temperature")
    dataset = run_study(Study(motions=motions, factors={"mu": [0.05, 0.1]}, histories=names))
    alone = dcfp.respond(motions[1], friction=dcfp.Li2020(mu_0=0.1))
    size = motions[1].acceleration.size
    assert dataset["history_force"].dims == ("record", "mu", "step")
    for name in names:
        history = dataset[f"history_{name}"].sel(record="long", mu=0.1).values
        assert np.array_equal(history[:size], getattr(alone, name)[:size])
    short = dataset["history_force"].sel(record="short", mu=0.1).values
    assert np.isnan(short[motions[0].acceleration.size :]).all()


def test_histories_have_the_samples_of_the_record_also_with_a_finer_step(motions) -> None:
    study = Study(motions=motions[:1], histories=("displacement",), settings=Settings(step=0.003))
    alone = dcfp.respond(motions[0], step=0.003)
    size = motions[0].acceleration.size
    assert np.array_equal(run_study(study)["history_displacement"].values[0], alone.displacement[::4][:size])


def failing(pressure: float, speed: float, temperature: float) -> float:
    return 0.05 if temperature < 30.0 else np.nan


def test_an_analysis_that_fails_is_marked_and_the_others_are_not(motions) -> None:
    model = dcfp.bearing.Model(friction=dcfp.UserFriction(failing))
    dataset = run_study(Study(motions=motions, factors={"pgv": [60.0, 900.0]}, model=model))
    status = dataset["status"].sel(record="long").values
    assert status.tolist() == [1, FAILED]
    assert np.isnan(dataset["peak_force"].sel(record="long").values).tolist() == [False, True]


FACTOR = 0.05


def of_global(pressure: float, speed: float, temperature: float) -> float:
    return FACTOR


def law_of(value: float, other=None):
    """Return a law that takes its coefficient from around it."""

    def mu(pressure: float, speed: float, temperature: float) -> float:
        return value

    return dcfp.UserFriction(mu)


def test_laws_of_a_user_are_told_apart_by_what_they_use(motions, monkeypatch) -> None:
    def digest(friction: dcfp.UserFriction) -> str:
        return run_study(Study(motions[:1], model=dcfp.bearing.Model(friction=friction))).attrs[
            "study_sha256"
        ]

    assert digest(law_of(0.05)) == digest(law_of(0.05))
    assert digest(law_of(0.05)) != digest(law_of(0.15))
    before = digest(dcfp.UserFriction(of_global))
    monkeypatch.setitem(globals(), "FACTOR", 0.06)
    assert digest(dcfp.UserFriction(of_global)) != before


def test_a_bearing_file_is_known_by_what_is_in_it(tmp_path: Path, record_file: Path) -> None:
    """From wherever and under whatever name the folder is looked at."""
    import shutil

    text = f'[factors]\nrecord = ["{record_file.name}"]\nbearing = ["b.toml"]\n[motion]\nunits = "m/s2"\n'
    folder = tmp_path / "one"
    folder.mkdir()
    (folder / "s.toml").write_text(text, encoding="utf-8")
    (folder / "b.toml").write_text("radius = 3000\n", encoding="utf-8")
    shutil.copy(record_file, folder)
    shutil.copytree(folder, tmp_path / "two")
    one = run_study(dcfp.read_study(folder / "s.toml"))
    two = run_study(dcfp.read_study(tmp_path / "two" / ".." / "two" / "s.toml"))
    assert one.attrs["study_sha256"] == two.attrs["study_sha256"]
    assert one["bearing"].values.tolist() == ["b.toml"]
    (folder / "b.toml").write_text("radius = 3500\n", encoding="utf-8")
    assert run_study(dcfp.read_study(folder / "s.toml")).attrs["study_sha256"] != one.attrs["study_sha256"]


def test_blocks_with_histories_are_small(motions) -> None:
    factors = {"pgv": np.linspace(10.0, 1000.0, 100), "mu": np.linspace(0.02, 0.1, 100)}
    plan = Plan(Study([dcfp.load_motion("IVD")], factors, histories=("displacement", "force", "friction")))
    sizes = {block.size for block in plan.blocks()}
    assert max(sizes) * 3 * plan.longest_record <= 8 * 2**20


@pytest.mark.parametrize("threads", [0, -2])
def test_a_number_of_threads_that_cannot_be(study: Study, threads: int) -> None:
    with pytest.raises(InputError, match="The number of threads must be a positive whole number"):
        run_study(study, threads=threads)


def test_a_plan_is_small_however_many_analyses_it_has(motions) -> None:
    factors = {"pgv": np.linspace(10.0, 1000.0, 1000), "mu": np.linspace(0.02, 0.1, 1000), "lambda": np.linspace(0.9, 1.1, 300)}  # fmt: skip
    plan = Plan(Study(motions=motions, factors=factors))
    assert plan.count == 900_000_000
    first = next(iter(plan.blocks()))
    assert first.size == len(plan.cases(first).lanes)
