"""Nodes of a station and the march in the plane: what they depend on and what not, and how close it is to the analysis."""

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from dcfp.analysis import respond
from dcfp.errors import InputError
from dcfp.kernels.nodes import BLOCK, WAITING_SIZE
from dcfp.kernels.plane_march import _write_row
from dcfp.kernels.plane_nodes import _furthest, choose_plane_nodes
from dcfp.kernels.plane_step import COEFFICIENTS, oscillator_rows
from dcfp.methods import Nodes, find_nodes, march_in_plane
from dcfp.motion import treatment
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.load import load_station
from dcfp.motion.station import Station
from dcfp.system import ConstantFriction, NoHeating, SimplifiedHeating

#: Without heat, whose grid has directions of its own.
CONSTANT = (ConstantFriction(), NoHeating())


def station(name: str, velocity: float = 500.0) -> Station:
    """A station that begins and ends at rest."""
    found = load_station(name)
    assert found is not None
    padded = (replace(one, acceleration=np.pad(one.acceleration, 1)) for one in (found.x, found.y))
    return replace(found, **dict(zip("xy", padded, strict=True)), vertical=None, parts=()).scaled_to_pgv(
        velocity
    )


def changed(motion: Station, change: Callable[[GroundMotion], GroundMotion]) -> Station:
    return replace(motion, x=change(motion.x), y=change(motion.y), parts=())


@pytest.fixture(scope="module")
def near() -> Station:
    return station("P695-FF-2")


def same(one: Station, other: Station, rel: float, scale: float = 1.0) -> None:
    found, again = find_nodes(one), find_nodes(other)
    assert again.count == found.count
    np.testing.assert_allclose(np.diff(again.times), np.diff(found.times), rtol=0.0, atol=rel)
    amounts = [np.hypot(*nodes.velocities.T) for nodes in (found, again)]
    np.testing.assert_allclose(amounts[1], scale * amounts[0], atol=rel * scale * one.peak_velocity)
    marched = [
        march_in_plane(nodes, None, *CONSTANT).prediction for nodes in (found, again.scaled(1.0 / scale))
    ]
    assert marched[1].displacement == pytest.approx(marched[0].displacement, rel=10.0 * rel)
    assert marched[1].total_velocity == pytest.approx(marched[0].total_velocity, rel=10.0 * rel)


def test_where_x_and_y_point_changes_nothing(near: Station) -> None:
    for angle in (37.0, 90.0, 180.0):
        same(near, near.rotated(angle), 1e-7)


def test_quiet_before_and_after_and_other_samples_change_nothing(near: Station) -> None:
    same(near, changed(near, lambda one: replace(one, acceleration=np.pad(one.acceleration, 300))), 1e-9)
    same(near, changed(near, lambda one: treatment.resample(one, 3)), 1e-6)
    same(near, near.scaled(-2.0), 1e-9, 2.0)


def test_a_field_of_heat_turns_with_the_station_within_its_grid(near: Station) -> None:
    one, other = (march_in_plane(of).prediction for of in (near, near.rotated(37.0)))
    assert other.displacement == pytest.approx(one.displacement, rel=5e-3)
    assert other.total_velocity == pytest.approx(one.total_velocity, rel=1e-3)


def test_before_the_fit_no_leg_is_left_by_more_than_the_tolerance(near: Station) -> None:
    nodes = find_nodes(near, 0.1, fitted=False)
    time = near.x.time
    legs = np.stack([np.interp(time, nodes.times, one) for one in nodes.velocities.T])
    distance = np.hypot(*(legs - near.velocity.T)).max()
    assert 0.05 * near.peak_velocity < distance <= 0.1001 * near.peak_velocity
    fitted = find_nodes(near)
    assert fitted.count == nodes.count
    again = np.stack([np.interp(time, fitted.times, one) for one in fitted.velocities.T])
    assert np.sum((again - near.velocity.T) ** 2) < 0.7 * np.sum((legs - near.velocity.T) ** 2)


@pytest.mark.parametrize("name", ["P695-FF-2", "P695-FF-7", "P695-NF-9"])
def test_a_leg_is_cut_where_the_velocity_is_furthest_from_it(name: str) -> None:
    """Of random legs, against the distances at fifty points of each interval."""
    motion, random = station(name), np.random.default_rng(0)
    vx, vy = motion.x.velocity, motion.y.velocity
    ax, ay = motion.x.acceleration * motion.time_step, motion.y.acceleration * motion.time_step
    bows = np.empty(vx.size // BLOCK + 1)
    choose_plane_nodes(ax, ay, vx, vy, 0, vx.size - 1, 1e9, bows, np.empty((9, WAITING_SIZE)), np.empty(9))
    share = np.arange(0.0, 1.0, 0.02)
    fine = [
        (v[:-1, None] + share * (a[:-1, None] + 0.5 * share * np.diff(a)[:, None])).ravel()
        for a, v in ((ax, vx), (ay, vy))
    ]
    places = (np.arange(vx.size - 1)[:, None] + share).ravel()
    for _ in range(200):
        start, end = np.sort(random.uniform(0.0, vx.size - 1.0, 2))
        start = max(start, end - random.choice([30.0, 300.0, 3000.0]))
        inside = (start < places) & (places < end)
        line = [np.interp(places[inside], (start, end), np.interp((start, end), places, one)) for one in fine]
        away = np.hypot(fine[0][inside] - line[0], fine[1][inside] - line[1])
        tolerance = 50.0
        found = _furthest(ax, ay, vx, vy, bows, start, end, tolerance)
        if math.isnan(found):
            assert away.max() < tolerance + 0.1
        else:
            assert np.interp(found, places[inside], away) > away.max() - 0.1


def test_along_a_line_it_is_the_analysis_of_straight_legs_in_one_direction(straight_legs) -> None:
    found = station("P695-FF-2")
    still = replace(found.y, acceleration=np.zeros_like(found.y.acceleration))
    line = replace(found, y=still, parts=()).rotated(30.0)
    nodes = find_nodes(found.x)
    legs = replace(find_nodes(line), misfit=0.0)  # the straight legs are all of the ground velocity
    for models in (CONSTANT, (None, SimplifiedHeating())):
        march, response = (
            march_in_plane(legs, None, *models),
            respond(straight_legs(nodes, 1e-3), None, *models),
        )
        assert march.nodes == nodes.count
        assert march.prediction.displacement == pytest.approx(response.peak_displacement, rel=0.01)
        assert march.prediction.displacement_change == pytest.approx(response.peak_change, rel=0.01)
        assert march.prediction.total_velocity == pytest.approx(response.input_velocity, rel=0.01)


@pytest.mark.parametrize("models", [CONSTANT, (None, None)], ids=["constant", "field"])
def test_the_march_is_close_to_the_analysis(models: tuple) -> None:
    """Eight stations of FEMA P-695; all fifty are in ``docs/prediction.md``."""
    ratios = []
    for number in range(1, 23, 3):
        motion = station(f"P695-FF-{number}")
        said, response = march_in_plane(motion, None, *models).prediction, respond(motion, None, *models)
        ratios.append(
            [
                said.displacement / response.peak_displacement,
                said.displacement_change / response.peak_change,
                said.total_velocity / response.input_velocity,
            ]
        )
    logarithms = np.log(ratios)
    assert (logarithms.std(axis=0, ddof=1) < 0.08).all()
    assert (np.abs(logarithms.mean(axis=0)) < (0.05, 0.05, 0.025)).all()


def test_fewer_steps_change_little(near: Station) -> None:
    nodes = find_nodes(near)
    usual, fine = (march_in_plane(nodes, longest=longest).prediction for longest in (0.05, 0.005))
    assert usual.displacement == pytest.approx(fine.displacement, rel=0.02)
    assert usual.total_velocity == pytest.approx(fine.total_velocity, rel=0.01)


@pytest.mark.parametrize("stiffness", [1.09, 2470.0])
@pytest.mark.parametrize("length", [1e-4, 0.01, 0.05, 0.3])
def test_the_coefficients_of_a_step_are_those_of_an_analysis(stiffness: float, length: float) -> None:
    table, lengths = np.empty((3, COEFFICIENTS)), length / np.array([1.0, 2.0, 4.0])
    for level in range(3):
        _write_row(stiffness, length, level, table)
    np.testing.assert_allclose(table, oscillator_rows(stiffness, lengths), rtol=1e-12)


def test_a_slide_beyond_the_first_grid_finds_more() -> None:
    march = march_in_plane(station("P695-FF-5", 1500.0))
    assert march.prediction.bound > 1200.0
    assert march.rests
    assert np.hypot(*march.displacement.T).max() <= march.prediction.bound * (1.0 + 1e-12)


def test_what_has_no_second_direction_or_no_motion() -> None:
    with pytest.raises(InputError, match="nodes of a station"):
        march_in_plane(Nodes(np.array([0.0, 1.0]), np.array([0.0, 1.0])))
    still = GroundMotion(np.zeros(100), 0.01)
    assert find_nodes(Station(still, still)).count == 0
    said = march_in_plane(Station(still, still)).prediction
    assert (said.displacement, said.displacement_change, said.total_velocity) == (0.0, 0.0, 0.0)
    assert math.isnan(said.input_velocity)
