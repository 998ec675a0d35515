"""Nodes of a ground velocity: what they depend on and what not, the fit, and how good the march along their legs is."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from dcfp.analysis import respond
from dcfp.errors import InputError
from dcfp.inference.forecast import calibration_set
from dcfp.methods import Nodes, find_nodes, march_through_pulses
from dcfp.motion import named_motion, treatment
from dcfp.motion.ground_motion import GroundMotion

QUANTITIES = ("displacement", "displacement_change", "total_velocity")


def velocity_of(nodes: Nodes, motion: GroundMotion) -> np.ndarray:
    """Ground velocity by the legs, at a hundred points of each interval of the samples [mm/s]."""
    return np.interp(fine_times(motion), nodes.times, nodes.velocities)


def fine_times(motion: GroundMotion) -> np.ndarray:
    return np.linspace(0.0, motion.duration, 20 * (motion.acceleration.size - 1) + 1)


def fine_velocity(motion: GroundMotion) -> np.ndarray:
    return treatment.resample(motion, 20).velocity


@pytest.mark.parametrize("tolerance", [0.05, 0.1, 0.3])
def test_before_the_fit_no_leg_is_left_by_more_than_the_tolerance(tolerance: float) -> None:
    motion = named_motion("NCC")
    nodes = find_nodes(motion, tolerance, fitted=False)
    distance = np.abs(velocity_of(nodes, motion) - fine_velocity(motion)).max()
    assert 0.5 * tolerance * motion.peak_velocity < distance <= 1.01 * tolerance * motion.peak_velocity
    # and each node is where the velocity was furthest: on it
    at = np.interp(nodes.times, fine_times(motion), fine_velocity(motion))
    np.testing.assert_allclose(nodes.velocities, at, atol=1e-3 * motion.peak_velocity)


@pytest.mark.parametrize("tolerance", [0.05, 0.1, 0.3])
@pytest.mark.parametrize("motion", [*calibration_set()[::16], named_motion("NCC")], ids=lambda one: one.name)
def test_blocks_leave_out_no_node(motion: GroundMotion, tolerance: float) -> None:
    """Against a search that looks at every interval for every leg."""
    a, v = motion.acceleration * motion.time_step, motion.velocity
    found = find_nodes(motion, tolerance, fitted=False)
    peak = np.abs(fine_velocity(motion)).max()

    def at(place: np.ndarray) -> np.ndarray:
        i = np.minimum(place.astype(int), v.size - 2)
        share = place - i
        return v[i] + share * (a[i] + 0.5 * share * (a[i + 1] - a[i]))

    def between(start: float, end: float) -> list[float]:
        slope = float(np.diff(at(np.array([start, end])))[0]) / (end - start)
        here, there = a[:-1] - slope, a[1:] - slope
        i = np.flatnonzero((here * there <= 0.0) & (here != there))
        places = i + here[i] / (here[i] - there[i])
        places = places[(start < places) & (places < end)]
        away = np.abs(at(places) - at(np.array([start])) - slope * (places - start))
        if not away.size or away.max() <= tolerance * peak:
            return []
        cut = float(places[away.argmax()])
        return [*between(start, cut), cut, *between(cut, end)]

    first, *_, last = found.times / motion.time_step
    expected = np.array([first, *between(first, last), last]) * motion.time_step
    np.testing.assert_allclose(found.times, expected, rtol=0.0, atol=1e-9)


def test_the_fit_is_that_of_least_squares() -> None:
    """Against the dense solution with hat functions at many points; and no change of a node makes it better."""
    motion = named_motion("KNA")
    nodes = find_nodes(motion, 0.2)
    time, velocity = fine_times(motion), fine_velocity(motion)
    inside = (time >= nodes.times[0]) & (time <= nodes.times[-1])
    hats = np.stack([np.interp(time[inside], nodes.times, unit) for unit in np.eye(nodes.count)], axis=1)
    found = np.linalg.lstsq(hats, velocity[inside])[0]
    np.testing.assert_allclose(nodes.velocities, found, atol=0.005 * motion.peak_velocity)
    squares = [
        np.sum((velocity_of(one, motion) - velocity) ** 2)
        for one in (nodes, find_nodes(motion, 0.2, fitted=False))
    ]
    assert squares[0] < 0.8 * squares[1]


@pytest.mark.parametrize(
    ("change", "exact"),
    [
        (lambda motion: motion.scaled(-3.0), True),
        (lambda motion: replace(motion, acceleration=np.pad(motion.acceleration, 500)), True),
        (lambda motion: treatment.resample(motion, 3), False),
    ],
    ids=["mirrored", "padded", "resampled"],
)
@pytest.mark.parametrize("name", ["KNA", "NCC", "LPG", "IVD"])
def test_nodes_are_those_of_the_motion_however_it_is_written_down(
    name: str, change: Callable[[GroundMotion], GroundMotion], exact: bool
) -> None:
    motion = named_motion(name)
    # a record that begins or ends with an acceleration changes where a zero is put beside it
    motion = replace(motion, acceleration=np.pad(motion.acceleration, 1))
    one, other = find_nodes(motion), find_nodes(change(motion))
    scale = change(motion).peak_acceleration / motion.peak_acceleration
    assert other.count == one.count
    rel = 1e-9 if exact else 1e-6
    np.testing.assert_allclose(np.diff(other.times), np.diff(one.times), rtol=0.0, atol=rel)
    np.testing.assert_allclose(
        np.abs(other.velocities), scale * np.abs(one.velocities), atol=rel * scale * motion.peak_velocity
    )
    said, again = (march_through_pulses(nodes).prediction for nodes in (one, other.scaled(1.0 / scale)))
    for quantity in QUANTITIES:
        assert getattr(again, quantity) == pytest.approx(getattr(said, quantity), rel=1e-5)


def trapezoid(ripple: float = 0.0) -> GroundMotion:
    """A velocity that rises to 500 mm/s, stays there for 2 s, falls by 1000 mm/s in 1 s and comes back; with a ripple of 3 Hz on the top."""
    step = 0.005
    time = np.arange(0.0, 8.0, step)
    corners = [1.0, 1.5, 3.5, 4.5, 5.0]
    velocity = np.interp(time, corners, [0.0, 500.0, 500.0, -500.0, 0.0])
    top = np.interp(time, [1.0, 1.5, 3.5, 3.55], [0.0, 1.0, 1.0, 0.0])
    velocity += 500.0 * ripple * top * np.sin(6.0 * np.pi * (time - 1.5))
    return GroundMotion(np.gradient(velocity, step), step, "trapezoid")


def test_a_plateau_is_a_leg_of_its_own() -> None:
    analysis, march = respond(trapezoid()), march_through_pulses(trapezoid())
    assert march.nodes <= 8
    assert march.prediction.displacement_change == pytest.approx(analysis.peak_change, rel=0.1)
    assert march.prediction.displacement == pytest.approx(analysis.peak_displacement, rel=0.1)


def test_a_ripple_of_a_twentieth_changes_little() -> None:
    plain, rippled = (march_through_pulses(trapezoid(ripple)).prediction for ripple in (0.0, 0.05))
    for name in ("displacement", "displacement_change"):
        assert getattr(rippled, name) == pytest.approx(getattr(plain, name), rel=0.05)


def test_the_misfit_is_what_the_legs_leave_of_the_ground_velocity() -> None:
    motion = named_motion("NCC")
    nodes = find_nodes(motion)
    within = (motion.time >= nodes.times[0]) & (motion.time <= nodes.times[-1])
    beside = motion.velocity - np.interp(motion.time, nodes.times, nodes.velocities)
    # by the sum over the samples in place of the integral
    expected = np.linalg.norm(beside[within]) / np.linalg.norm(motion.velocity[within])
    assert nodes.misfit == pytest.approx(expected, rel=1e-3)
    assert find_nodes(trapezoid()).misfit < 0.01
    assert find_nodes(motion, 0.03).misfit < 0.5 * nodes.misfit
    # what legs without a record leave out is nothing
    assert Nodes(nodes.times, nodes.velocities).misfit == 0.0


@pytest.mark.parametrize("velocity", [500.0, 1000.0])
def test_the_march_is_close_to_the_analysis_of_far_field_records(velocity: float) -> None:
    """A dozen components of FEMA P-695; all hundred are in ``studies/pulse_rules``."""
    motions = [motion.scaled_to_pgv(velocity) for motion in calibration_set()[:24:2]]
    found = [(march_through_pulses(one).prediction, respond(one)) for one in motions]
    for name, of_analysis, limit, bias in (
        ("displacement", "peak_displacement", 0.08, 0.1),
        ("displacement_change", "peak_change", 0.08, 0.1),
        ("total_velocity", "input_velocity", 0.08, 0.025),
    ):
        ratios = np.log([getattr(said, name) / getattr(response, of_analysis) for said, response in found])
        assert ratios.std(ddof=1) < limit
        assert abs(ratios.mean()) < bias


@pytest.mark.parametrize("tolerance", [0.0, 1.5, np.nan])
def test_a_tolerance_out_of_range_is_refused(tolerance: float) -> None:
    with pytest.raises(InputError, match="tolerance"):
        find_nodes("NCC", tolerance)


def test_a_motion_without_motion_has_no_nodes() -> None:
    assert find_nodes(GroundMotion(np.zeros(100), 0.01)).count == 0
    assert march_through_pulses(GroundMotion(np.zeros(100), 0.01)).prediction.displacement == 0.0


@pytest.mark.parametrize(
    ("times", "velocities"), [([0.0, 1.0], [0.0]), ([1.0, 1.0], [0.0, 1.0]), ([0.0, 1.0], [0.0, np.nan])]
)
def test_nodes_must_follow_each_other(times: list[float], velocities: list[float]) -> None:
    with pytest.raises(InputError, match="nodes"):
        Nodes(np.array(times), np.array(velocities))
