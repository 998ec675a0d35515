"""What holds of every analysis in the plane: energy, rotation, one direction as a limit, a restart, cold and warm plates."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as some

import dcfp
from dcfp import (
    Bearing,
    ConstantFriction,
    GroundMotion,
    InputError,
    NoHeating,
    PreciseHeating,
    Station,
    respond,
)
from dcfp.analysis.plane_history import PlaneState
from dcfp.motion.station import joined

FINE = PreciseHeating(points=100)


def station(name: str, pgv: float) -> Station:
    found = dcfp.load_station(name)
    assert found is not None
    return found.scaled_to_pgv(pgv)


@pytest.fixture(scope="module")
def heated():
    return respond(station("P695-FF-2", 500.0))


def test_the_energy_closes_and_friction_takes_what_it_slides(heated) -> None:
    assert heated.energy.relative_residual < 1e-12
    assert heated.slip_work == pytest.approx(heated.energy.hysteretic[-1], rel=5e-4)
    assert heated.energy.input[-1] > 0.0
    assert np.all(np.diff(heated.energy.hysteretic) >= -1e-9 * heated.energy.hysteretic[-1])


@pytest.mark.parametrize("heating", ["none", "simplified"])
@pytest.mark.parametrize("angle", [30.0, 90.0, 137.0, 180.0])
def test_turned_ground_gives_the_turned_answer(heating: str, angle: float) -> None:
    motion = station("P695-NF-9", 500.0)
    one, other = (respond(each, heating=heating) for each in (motion, motion.rotated(angle)))
    for name in (
        "peak_displacement",
        "residual_displacement",
        "input_velocity",
        "peak_temperature",
        "peak_velocity",
    ):
        assert getattr(other, name) == pytest.approx(getattr(one, name), rel=1e-9), name
    turned = one.displacement_vectors @ np.array(
        [
            [np.cos(np.radians(angle)), np.sin(np.radians(angle))],
            [-np.sin(np.radians(angle)), np.cos(np.radians(angle))],
        ]
    )
    np.testing.assert_allclose(other.displacement_vectors, turned, atol=1e-7)


def test_the_grid_of_the_plate_turns_with_the_ground_but_for_its_spacing(heated) -> None:
    other = respond(station("P695-FF-2", 500.0).rotated(45.0))
    assert other.peak_displacement == pytest.approx(heated.peak_displacement, rel=5e-4)
    assert other.peak_temperature == pytest.approx(heated.peak_temperature, abs=0.3)
    assert other.peak_point_temperature == pytest.approx(heated.peak_point_temperature, abs=0.3)


@pytest.mark.parametrize(("heating", "friction"), [("none", ConstantFriction(0.043)), ("simplified", None)])
@pytest.mark.parametrize(("record", "pgv"), [("NCC", 250.0), ("KNA", 1000.0), ("IVD", 500.0)])
def test_one_component_alone_moves_as_in_one_direction(
    record: str, pgv: float, heating: str, friction
) -> None:
    motion = dcfp.load_motion(record).scaled_to_pgv(pgv)
    still = replace(motion, acceleration=np.zeros_like(motion.acceleration))
    line = respond(motion, friction=friction, heating=heating)
    for components in ((motion, still), (still, motion)):
        plane = respond(Station(*components), friction=friction, heating=heating)
        assert plane.peak_displacement == pytest.approx(line.peak_displacement, rel=1.2e-3)
        assert plane.peak_change == pytest.approx(line.peak_change, rel=2e-3)
        assert plane.peak_temperature == pytest.approx(line.peak_temperature, abs=0.3)
        assert plane.input_velocity == pytest.approx(line.input_velocity, rel=1e-3)
        assert min(plane.peak_displacement_x, plane.peak_displacement_y) == 0.0


def test_one_record_in_both_directions_is_that_record_along_the_diagonal() -> None:
    motion = dcfp.load_motion("NCC").scaled_to_pgv(500.0)
    half = motion.scaled(np.sqrt(0.5))
    one = respond(Station(motion, motion.scaled(0.0)), heating="none")
    both = respond(Station(half, half), heating="none")
    assert both.peak_displacement == pytest.approx(one.peak_displacement, rel=1e-9)
    assert both.peak_displacement_x == pytest.approx(one.peak_displacement_x * np.sqrt(0.5), rel=1e-9)


def test_the_second_direction_makes_it_move_further() -> None:
    """With constant friction the circle's radius is 188 mm where one direction alone moves by less than 40 (A = 1 m/s2, T = 3 s, mu = 0.08)."""
    time = np.arange(9000) * 0.01
    x, y = (GroundMotion(1000.0 * turned(2.0 * np.pi / 3.0 * time), 0.01) for turned in (np.cos, np.sin))
    options = {"friction": ConstantFriction(0.08), "heating": "none", "tail": 0.0}
    alone, together = respond(x, **options), respond(Station(x, y), **options)
    assert alone.peak_displacement < 40.0
    assert together.displacement[-600:].max() == pytest.approx(188.4, abs=0.3)


def test_an_analysis_in_two_parts_is_the_same_analysis() -> None:
    whole = station("P695-FF-2", 500.0)
    cut = 700
    first, rest = (
        Station(*(replace(one, acceleration=one.acceleration[part]) for one in whole.components))
        for part in (slice(cut + 1), slice(cut, None))
    )
    for heating in ("simplified", "precise"):
        once = respond(whole, heating=heating, tail=0.0)
        began = respond(first, heating=heating, tail=0.0)
        kept = began.final_state
        went_on = respond(rest, heating=heating, tail=0.0, start=kept)
        np.testing.assert_allclose(went_on.displacement, once.displacement[cut:], rtol=1e-12, atol=1e-9)
        assert went_on.peak_displacement == pytest.approx(once.peak_displacement, rel=1e-12)
        assert went_on.peak_point_temperature == pytest.approx(once.peak_point_temperature, rel=1e-9)
        assert went_on.energy.hysteretic[-1] == pytest.approx(once.energy.hysteretic[-1], rel=1e-12)
        # what went on has not changed what it began from
        again = respond(rest, heating=heating, tail=0.0, start=kept)
        assert again.peak_displacement == went_on.peak_displacement
    afresh = respond(rest, tail=0.0, start=respond(first, tail=0.0).final_state.afresh())
    assert afresh.energy.hysteretic[0] == 0.0


def test_a_state_is_of_its_system() -> None:
    motion = station("P695-FF-2", 250.0)
    state = respond(motion, heating="none").final_state
    assert isinstance(state, PlaneState)
    with pytest.raises(InputError, match="another bearing, friction law or heating model"):
        respond(motion, heating="simplified", start=state)


def test_the_grid_grows_where_the_slider_leaves_it(monkeypatch) -> None:
    motion = station("P695-FF-5", 250.0)
    wide = respond(motion)
    monkeypatch.setattr("dcfp.system.fields.FIRST_REACH", 20.0)
    monkeypatch.setattr("dcfp.system.fields.cold_heat.__defaults__", (20.0,))
    narrow = respond(motion)
    assert narrow.final_state.heat.reach >= 40.0
    assert narrow.peak_displacement == wide.peak_displacement
    assert narrow.peak_temperature == pytest.approx(wide.peak_temperature, abs=1e-9)


def test_the_grid_is_fine_enough(heated) -> None:
    fine = respond(station("P695-FF-2", 500.0), heating=FINE)
    assert heated.peak_displacement == pytest.approx(fine.peak_displacement, rel=5e-4)
    assert heated.peak_temperature == pytest.approx(fine.peak_temperature, abs=0.3)
    assert heated.peak_point_temperature == pytest.approx(fine.peak_point_temperature, abs=0.5)


def test_unequal_plates_share_the_travel_and_heat_each_for_itself() -> None:
    motion = station("P695-FF-2", 500.0)
    equal, unequal = (respond(motion, Bearing(radii=radii)) for radii in ((4500.0, 4500.0), (6000.0, 3000.0)))
    assert unequal.plate_temperatures.shape[1] == 2
    warmer, cooler = unequal.plate_temperatures.max(axis=0)
    assert warmer > equal.peak_temperature > cooler


@given(
    seed=some.integers(0, 10_000),
    pgv=some.floats(20.0, 1500.0),
    stiffness=some.floats(0.1, 30.0),
    radius=some.floats(500.0, 9000.0),
    step=some.sampled_from([0.002, 0.005, 0.01, 0.02]),
    heating=some.sampled_from(["none", "simplified", "precise"]),
)
@settings(max_examples=25)
def test_any_motion_of_any_bearing_closes(seed, pgv, stiffness, radius, step, heating) -> None:
    rng = np.random.default_rng(seed)
    x, y = (GroundMotion(np.cumsum(rng.normal(0.0, 200.0, 400)) * np.hanning(400), step) for _ in range(2))
    bearing = Bearing(radii=(radius, radius), elastic_stiffness=1.9e6 * stiffness)
    response = respond(joined([x, y], "noise").scaled_to_pgv(pgv), bearing, heating=heating)
    assert response.energy.relative_residual < 1e-11
    assert response.peak_displacement >= response.displacement.max() * (1.0 - 1e-12)
    assert (
        response.peak_displacement
        <= np.hypot(response.peak_displacement_x, response.peak_displacement_y) + 1.0
    )
    assert response.peak_point_temperature >= response.peak_temperature - 1e-9
    assert np.isfinite(response.lines).all()


def test_no_heat_is_the_ambient_temperature() -> None:
    response = respond(station("P695-FF-2", 250.0), heating=NoHeating(ambient=35.0))
    assert set(response.temperature) == {35.0}
    assert response.peak_point_temperature == 35.0


# ----- the vertical motion -----


def three(pgv: float, up: float, frequency: float = 8.0) -> Station:
    """Return a station whose vertical component has an amplitude [g] over the strong part of the motion."""
    pair = station("P695-FF-2", pgv)
    wave = up * 9806.65 * np.sin(2.0 * np.pi * frequency * pair.x.time) * np.hanning(pair.x.time.size)
    return replace(pair, vertical=replace(pair.x, acceleration=wave))


def test_a_vertical_component_of_nothing_changes_nothing() -> None:
    for heating in ("none", "precise"):
        one, other = (
            respond(three(500.0, 0.0), heating=heating, vertical=vertical) for vertical in (False, True)
        )
        assert other.peak_displacement == pytest.approx(one.peak_displacement, rel=1e-9)
        assert other.peak_temperature == pytest.approx(one.peak_temperature, abs=1e-6)
        assert set(other.load) == {one.bearing.vertical_force}


def test_a_constant_change_of_the_load_is_another_gravity() -> None:
    """Pendulum and friction carry the same part of the weight more, as with other radii and another coefficient."""
    pair = station("P695-FF-2", 500.0)
    lighter = replace(
        pair, vertical=replace(pair.x, acceleration=np.full(pair.x.acceleration.size, -0.2 * 9806.65))
    )
    one = respond(lighter, friction=ConstantFriction(0.05), heating="none", vertical=True, tail=0.0)
    # the same mass on a pendulum and a friction that are weaker by a fifth
    other = respond(pair, Bearing(radii=(4500.0 / 0.8,) * 2), ConstantFriction(0.04), "none", tail=0.0)
    assert one.peak_displacement == pytest.approx(other.peak_displacement, rel=1e-4)
    assert one.hysteretic_velocity == pytest.approx(other.hysteretic_velocity, rel=1e-4)


@pytest.mark.parametrize("up", [0.3, 1.3])
def test_the_energy_closes_under_a_changing_load(up: float) -> None:
    response = respond(three(500.0, up), vertical=True)
    assert response.energy.relative_residual < 1e-11
    assert response.slip_work == pytest.approx(response.energy.hysteretic[-1], rel=1e-3)
    assert response.uplift == (up > 1.0)
    assert response.least_load == pytest.approx(
        max(0.0, 1.0 - up) * response.bearing.vertical_force, rel=0.02, abs=1.0
    )
    assert 0.0 < abs(response.energy.lifting).max() < 0.05 * response.energy.input[-1]


def test_the_force_goes_with_the_load() -> None:
    response = respond(three(500.0, 0.5), friction=ConstantFriction(0.05), heating="none", vertical=True)
    sliding = response.sliding > 0.0
    pendulum = response.bearing.restoring_stiffness * (response.load / response.bearing.vertical_force)
    friction = response.force_vectors - pendulum[:, np.newaxis] * response.displacement_vectors
    np.testing.assert_allclose(
        np.linalg.norm(friction, axis=1)[sliding] / response.load[sliding], 0.05, rtol=1e-9
    )


def test_no_vertical_component_is_refused() -> None:
    with pytest.raises(InputError, match="the station has no vertical component"):
        respond(station("P695-FF-2", 250.0), vertical=True)
    with pytest.raises(InputError, match="a single component has no vertical one"):
        respond("NCC", vertical=True)


def test_the_hottest_point_is_found_between_the_points_of_the_grid() -> None:
    station = dcfp.load_station("P695-NF-2").scaled_to_pgv(1000.0)
    coarse, fine = (dcfp.respond(station, heating=dcfp.PreciseHeating(points=points)) for points in (50, 120))
    grid = coarse.line("point_temperature")[-1]
    assert fine.peak_point_temperature - grid > 0.9  # what the grid alone would miss
    assert coarse.peak_point_temperature == pytest.approx(fine.peak_point_temperature, abs=0.5)


def test_a_slider_that_goes_too_far_for_a_field_is_told() -> None:
    station = dcfp.load_station("P695-NF-2").scaled_to_pgv(2000.0)
    small = replace(dcfp.LI_2020, slider_diameter=30.0)
    with pytest.raises(dcfp.AnalysisError, match="too far for the field of heat on 200 points"):
        dcfp.respond(station, small, heating=dcfp.PreciseHeating(points=200))


def test_the_hottest_point_of_the_next_earthquake_is_its_own() -> None:
    station = dcfp.load_station("P695-FF-2").scaled_to_pgv(1000.0)
    first = dcfp.respond(station)
    second = dcfp.respond(station.scaled(0.2), start=first.final_state.afresh())
    assert second.peak_temperature <= second.peak_point_temperature < first.peak_point_temperature - 20.0
    still = second.line("point_temperature")[0]
    assert still == pytest.approx(
        first.final_state.heat.temperatures(0, first.system, first.time[-1]).max(), abs=0.01
    )


def test_no_point_of_the_plate_is_hotter_than_the_hottest_after_a_rest_either() -> None:
    once = dcfp.load_station("P695-NF-14").scaled_to_pgv(1000.0)
    rest = np.zeros(round(20.0 / once.time_step))
    x, y = (
        dcfp.GroundMotion(
            np.concatenate((one.acceleration, rest, 1.2 * one.acceleration)), once.time_step, name
        )
        for one, name in ((once.x, "x"), (once.y, "y"))
    )
    response = dcfp.respond(
        dcfp.Station(x, y),
        replace(dcfp.LI_2020, slider_diameter=200.0),
        heating=dcfp.PreciseHeating(points=16),
        tail=0.0,
        keep=dcfp.Keep(every=20),
    )
    fields, reached = response.fields, response.line("point_temperature")
    samples = np.round(fields.time / once.time_step).astype(int)
    hottest = fields.temperature.max(axis=(1, 2, 3))
    assert fields.time[hottest.argmax()] > 20.0 + once.duration
    assert (hottest <= reached[samples] + 0.2).all()


def test_without_a_field_the_hottest_point_is_the_contact() -> None:
    station = dcfp.load_station("P695-NF-2").scaled_to_pgv(1000.0)
    assert dcfp.respond(station, heating="none").peak_point_temperature == 20.0
    simplified = dcfp.respond(station, heating="simplified")
    assert simplified.peak_point_temperature == simplified.peak_temperature


def test_what_is_done_with_the_vertical_component_is_told() -> None:
    station = dcfp.load_station("P695-FF-2").scaled_to_pgv(250.0)
    whole = replace(station, vertical=station.x)
    for vertical, words in ((False, "is left out"), (True, "follows the vertical component, from 0.")):
        response = dcfp.respond(whole, heating="none", vertical=vertical)
        assert [words in one for one in response.remarks].count(True) == 1
    assert not any("vertical" in one for one in dcfp.respond(station, heating="none").remarks)
