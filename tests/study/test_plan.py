"""The plan: every analysis is in one block, and it is the right one."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import dcfp
from dcfp.errors import InputError
from dcfp.study import Choice, Plan, Sampling, Study, Uniform
from dcfp.study.study import LARGEST_BLOCK
from dcfp.study.work import project

NCC = dcfp.load_motion("NCC")


def plan_of(pgvs: int, mus: int, ambients: int) -> Plan:
    factors = {
        "pgv": np.linspace(100.0, 1000.0, pgvs),
        "mu": np.linspace(0.02, 0.1, mus),
        "ambient": np.linspace(0.0, 40.0, ambients),
    }
    return Plan(Study(motions=[NCC], factors=factors))


@pytest.mark.slow
@settings(max_examples=40)
@given(st.integers(1, 300), st.integers(1, 70), st.integers(1, 40))
def test_blocks_tile_the_grid(pgvs: int, mus: int, ambients: int) -> None:
    plan = plan_of(pgvs, mus, ambients)
    count = np.zeros(plan.shape, dtype=int)
    for number, block in enumerate(plan.blocks()):
        assert block.number == number
        assert block.shape == count[block.region].shape
        assert block.size <= LARGEST_BLOCK
        count[block.region] += 1
        # Zarr has chunks of one shape: a block is exactly one of them
        assert all(part.start % chunk == 0 for part, chunk in zip(block.region, plan.chunks, strict=True))
    assert (count == 1).all()
    assert plan.count == math.prod(plan.shape)


def test_a_large_study_has_blocks_worth_the_trouble() -> None:
    plan = plan_of(100, 100, 100)
    assert min(block.size for block in plan.blocks()) > LARGEST_BLOCK // 3


def test_what_an_analysis_is_of() -> None:
    plan = plan_of(3, 2, 2)
    lanes = [plan.cases(block).lanes for block in plan.blocks()]
    models = [one.models[int(number)] for one in lanes for number in one.model]
    scales = [float(scale) for one in lanes for scale in one.scale]
    expected = [
        (pgv / NCC.peak_velocity, mu, ambient)
        for pgv in plan.study.factors["pgv"]
        for mu in plan.study.factors["mu"]
        for ambient in plan.study.factors["ambient"]
    ]
    found = [(s, m.friction.reference, m.heating.ambient) for s, m in zip(scales, models, strict=True)]
    assert found == expected


def test_sampled_records_methods_and_intensities(motions) -> None:
    names = tuple(motion.name for motion in motions)
    sampling = Sampling(
        {
            "record": Choice(names),
            "procedure": Choice(("analysis", "march")),
            "pgv": Uniform(100.0, 900.0),
            "mu": Uniform(0.03, 0.1),
        },
        24,
    )
    plan = Plan(Study(motions=motions, sampling=sampling))
    assert plan.sizes == {"sample": 24}
    samples = plan.samples
    place = 0
    for block in plan.blocks():
        cases = plan.cases(block)
        for lane in range(block.size):
            motion = motions[int(cases.lanes.record[lane])]
            assert motion.name == samples["record"][place]
            assert plan.procedures[int(cases.procedures[lane])] == samples["procedure"][place]
            assert cases.lanes.scale[lane] * motion.peak_velocity == pytest.approx(samples["pgv"][place])
            assert cases.lanes.models[int(cases.lanes.model[lane])].friction.reference == samples["mu"][place]
            place += 1
    assert place == 24


def test_pga_and_scale(motions) -> None:
    for name, value, expected in (
        ("pga", 2000.0, 2000.0 / motions[0].peak_acceleration),
        ("scale", 1.5, 1.5),
    ):
        plan = Plan(Study(motions=motions[:1], factors={name: [value]}))
        (block,) = plan.blocks()
        assert plan.cases(block).lanes.scale.tolist() == [expected]


def test_a_model_that_cannot_be_is_found_beforehand(motions) -> None:
    factors = {"radius": [3000.0, 200.0], "slider": [300.0, 450.0]}
    with pytest.raises(InputError, match=r"radius = 200, slider = 450: the slider diameter"):
        Plan(Study(motions=motions, factors=factors))


def test_a_projection_counts_everything(study) -> None:
    found = project(Plan(study), 1)
    assert found.analyses == 3 * 8 * 3 * 2
    assert found.duration == pytest.approx(found.analyses / found.rate)
    assert 0 < found.tried <= found.analyses
