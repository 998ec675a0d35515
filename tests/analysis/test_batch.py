"""The batch gives what `respond` gives, lane by lane and to the last bit."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import dcfp
from dcfp.analysis.batch import GroundSet, Lanes, respond_in_batch
from dcfp.analysis.integration import Integration
from dcfp.analysis.response import FAILED, NUMBERS, Status
from dcfp.errors import InputError
from dcfp.system import LI_2020, System
from dcfp.system.friction import KimConstantinou2023Third

SINGLE = replace(LI_2020, radii=(9000.0,))
UNEQUAL = replace(LI_2020, radii=(3000.0, 5000.0))


@pytest.fixture(scope="module")
def motions() -> list[dcfp.GroundMotion]:
    return [dcfp.load_motion(name) for name in ("NCC", "LPG")]


def batch(motions, scales, models, *, tail=None, step=None, tolerance=0.02) -> dict[str, np.ndarray]:
    grounds = GroundSet.of(motions, Integration(tail=tail, step=step, tolerance=tolerance))
    return respond_in_batch(grounds, Lanes.grid(len(motions), scales, models))


def assert_same(peaks: dict[str, np.ndarray], lane: int, response: dcfp.Response) -> None:
    for name, values in peaks.items():
        if name == "force_ratio":
            expected = response.peak_force / response.bearing.vertical_force
        elif name == "status":
            expected = NUMBERS[response.status]
        else:
            expected = getattr(response, name)
        assert values[lane] == expected, name


def law(pressure: float, speed: float, temperature: float) -> float:
    return 0.06 + 1e-5 * speed - 1e-5 * temperature


MODELS = {
    "paper": System(),
    "none": System(heating=dcfp.NoHeating()),
    "precise": System(heating=dcfp.PreciseHeating()),
    "warm": System(heating=dcfp.SimplifiedHeating(ambient=40.0)),
    "plates of 50 mm": System(heating=dcfp.SimplifiedHeating(thickness=50.0)),
    "constant": System(friction=dcfp.ConstantFriction(0.05)),
    "kumar, single": System(SINGLE, dcfp.Kumar2015()),
    "kim": System(friction=KimConstantinou2023Third()),
    "unequal": System(UNEQUAL),
    "unequal, precise": System(UNEQUAL, heating=dcfp.PreciseHeating(cells=32)),
    "cycling": System(friction=dcfp.Lomiento2013()),
    "another pressure": System(replace(LI_2020, pressure=30.0)),
    "low friction": System(friction=dcfp.Li2020(mu_0=0.03)),
}


def test_every_kind_of_model_in_one_batch_is_as_alone(motions: list[dcfp.GroundMotion]) -> None:
    scales = np.array([[0.5, 2.0], [0.7, 1.5]])
    names = list(MODELS)
    peaks = batch(motions, scales, [MODELS[name] for name in names])
    lane = 0
    for motion, row in zip(motions, scales, strict=True):
        for scale in row:
            for name in names:
                model = MODELS[name]
                alone = dcfp.respond(
                    motion.scaled(float(scale)), model.bearing, model.friction, model.heating
                )
                assert_same(peaks, lane, alone)
                lane += 1
    assert lane == len(peaks["status"])


def test_what_is_at_the_capacity_is_not_beyond_it(motions: list[dcfp.GroundMotion]) -> None:
    found = dcfp.respond(motions[0]).peak_displacement
    for capacity in (found, np.nextafter(found, 0.0)):
        model = System(replace(LI_2020, displacement_capacity=float(capacity)))
        alone = dcfp.respond(motions[0], model)
        assert (alone.status is Status.BEYOND_CAPACITY) == (capacity < found)
        assert_same(batch(motions[:1], np.array([[1.0]]), [model]), 0, alone)


def test_a_short_record_after_a_long_one_ends_where_it_ends() -> None:
    long, short = dcfp.load_motion("NCC"), dcfp.load_motion("KNA")
    if short.acceleration.size > long.acceleration.size:
        long, short = short, long
    short = dcfp.GroundMotion(short.acceleration[: long.acceleration.size // 3], long.time_step, "short")
    peaks = batch([long, short], np.array([[2.0], [2.0]]), [System()])
    for lane, motion in enumerate((long, short)):
        assert_same(peaks, lane, dcfp.respond(motion.scaled(2.0)))


@pytest.mark.slow
def test_a_law_that_a_user_wrote(motions: list[dcfp.GroundMotion]) -> None:
    friction = dcfp.UserFriction(law)
    peaks = batch(motions[:1], np.array([[1.0]]), [System(friction=friction)])
    assert_same(peaks, 0, dcfp.respond(motions[0], friction=friction))


@pytest.mark.parametrize(
    "options",
    [{"tail": 0.0}, {"tail": 5.0}, {"step": 0.002}, {"tail": 1.0, "step": 0.003}, {"tolerance": 0.2}],
)
def test_tail_step_and_tolerance(motions: list[dcfp.GroundMotion], options: dict[str, float]) -> None:
    peaks = batch(motions, np.array([[1.0], [1.0]]), [System()], **options)
    for lane, motion in enumerate(motions):
        assert_same(peaks, lane, dcfp.respond(motion, **options))


def test_a_slider_that_leaves_the_cells_is_given_wider_plates() -> None:
    motion = dcfp.load_motion("IVD").scaled_to_pgv(2000.0)
    model = System(friction=dcfp.Li2020(mu_0=0.03), heating=dcfp.PreciseHeating())
    peaks = batch([motion], np.array([[1.0]]), [model])
    alone = dcfp.respond(motion, friction=model.friction, heating=model.heating)
    assert alone.peak_displacement > 1500.0  # far beyond the cells that there are at first
    assert_same(peaks, 0, alone)


def test_a_lane_that_never_slides_has_the_friction_at_rest(motions: list[dcfp.GroundMotion]) -> None:
    weak = motions[0].scaled(1e-3)
    peaks = batch([weak], np.array([[1.0]]), [System()])
    assert_same(peaks, 0, dcfp.respond(weak))
    assert peaks["peak_temperature"][0] == 20.0


def bad_law(pressure: float, speed: float, temperature: float) -> float:
    return 0.05 if speed < 300.0 else np.nan


@pytest.mark.slow
def test_an_analysis_that_fails_leaves_the_others_alone(motions: list[dcfp.GroundMotion]) -> None:
    models = [System(friction=dcfp.UserFriction(bad_law)), System()]
    peaks = batch(motions[:1], np.array([[2.0]]), models)
    assert peaks["status"][0] == FAILED
    assert np.isnan(peaks["peak_displacement"][0])
    assert np.isnan(peaks["force_ratio"][0])
    assert_same(peaks, 1, dcfp.respond(motions[0].scaled(2.0)))


@settings(max_examples=15, deadline=None)
@given(st.permutations(range(6)))
def test_the_order_of_lanes_does_not_matter(order: list[int]) -> None:
    motions = [dcfp.load_motion("NCC"), dcfp.load_motion("KNA")]
    grounds = GroundSet.of(motions)
    record = np.array([0, 0, 1, 1, 0, 1], dtype=np.intp)
    scale = np.array([1.0, 2.0, 1.0, 0.5, 1.0, 1.0])
    model = np.array([0, 1, 0, 1, 1, 1], dtype=np.intp)
    models = [System(), System(friction=dcfp.Li2020(mu_0=0.04))]
    there = respond_in_batch(grounds, Lanes(record, scale, model, models))
    moved = respond_in_batch(grounds, Lanes(record[order], scale[order], model[order], models))
    for name, values in there.items():
        assert np.array_equal(values[order], moved[name]), name


@pytest.mark.parametrize("tolerance", [0.0, 1.0, float("nan")])
def test_a_tolerance_that_cannot_be(motions: list[dcfp.GroundMotion], tolerance: float) -> None:
    with pytest.raises(InputError, match=r"\(tolerance\) must be a number above 0"):
        batch(motions, np.array([[1.0], [1.0]]), [System()], tolerance=tolerance)


def test_a_step_that_cannot_be(motions: list[dcfp.GroundMotion]) -> None:
    with pytest.raises(InputError, match=r"\(step\) must be a number of s"):
        GroundSet.of(motions, Integration(step=-1.0))
