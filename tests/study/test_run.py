"""Running a study: the right numbers, whatever is asked for."""

import json
from pathlib import Path

import numpy as np
import pytest

import dcfp
from dcfp.analysis.integration import Integration
from dcfp.analysis.response import FAILED
from dcfp.errors import InputError
from dcfp.inference import compare
from dcfp.methods import METHODS
from dcfp.study import Plan, Sampling, Study, Uniform, run_study
from dcfp.study.results import kept_peaks

pytestmark = pytest.mark.filterwarnings("error")


def test_every_result_is_that_of_the_analysis_alone(study: Study, motions, results) -> None:
    dataset = results
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
                    for name in set(kept_peaks()) - {"force_ratio"}:
                        assert found[name].item() == getattr(alone, name), name


def test_coordinates_and_provenance(motions, results) -> None:
    dataset = results
    assert dataset["pgv"].attrs["units"] == "mm s-1"
    assert dataset["peak_displacement"].attrs["units"] == "mm"
    assert dataset["event"].values.tolist() == [f"Event of {motion.name}" for motion in motions]
    assert dataset["record_sha256"].values.tolist() == [motion.digest for motion in motions]
    assert dataset["status"].attrs["flag_meanings"].split()[FAILED] == "failed"
    assert dataset.attrs["source"] == f"dcfp {dcfp.version()}"
    assert [one["sha256"] for one in json.loads(dataset.attrs["records"])] == [m.digest for m in motions]
    assert "Energy-Based Prediction" in dataset.attrs["references"]
    assert dataset.attrs["displacement_capacity"] == 440.0


def test_threads_and_stores_do_not_change_a_bit(study: Study, tmp_path: Path, content, results) -> None:
    one = run_study(study, tmp_path / "one.zarr", threads=1)
    four = run_study(study, tmp_path / "four.zarr", threads=4)
    assert results.identical(one)
    assert one.identical(four)
    assert content(tmp_path / "one.zarr") == content(tmp_path / "four.zarr")


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
    said = {
        said_of.method: one
        for said_of, one in case.predicted.items()
        if said_of.information.name != "INFORMED"
    }
    found = dict(zip(names, dataset["peak_displacement"].values.tolist(), strict=True))
    assert found["analysis"] == case.analysed.whole.displacement
    for name in names[1:]:
        assert found[name] == said[METHODS[name].name].bound, name
    march = dataset.sel(procedure="march")
    assert march["input_velocity"].item() == said["pulse march"].total_velocity
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
    study = Study(motions=motions[:1], histories=("displacement",), settings=Integration(step=0.003))
    alone = dcfp.respond(motions[0], step=0.003)
    size = motions[0].acceleration.size
    assert np.array_equal(run_study(study)["history_displacement"].values[0], alone.displacement[::4][:size])


def failing(pressure: float, speed: float, temperature: float) -> float:
    return 0.05 if temperature < 30.0 else np.nan


@pytest.mark.slow
def test_an_analysis_that_fails_is_marked_and_the_others_are_not(motions) -> None:
    model = dcfp.system.System(friction=dcfp.UserFriction(failing))
    dataset = run_study(Study(motions=motions, factors={"pgv": [60.0, 900.0]}, model=model))
    status = dataset["status"].sel(record="long").values
    assert status.tolist() == [1, FAILED]
    assert np.isnan(dataset["peak_force"].sel(record="long").values).tolist() == [False, True]


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
