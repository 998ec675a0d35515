"""The test machine in the plane against closed forms, its own symmetries, and the machine in one direction."""

import math
from dataclasses import replace

import numpy as np
import pytest

from dcfp import (
    LI_2020,
    ConstantFriction,
    InputError,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    run_program,
)
from dcfp.analysis.rig import (
    Circle,
    Cloverleaf,
    Ellipse,
    FigureOfEight,
    Program,
    RecordedPath,
    RigTest,
    Sine,
    VerticalLoad,
    run_in_the_plane,
)
from dcfp.schema.declared import declared

MU = 0.043


def run_one(wave, friction=None, heating="none", bearing=LI_2020, **of_test):
    (loops,) = run_in_the_plane(
        Program("own", (RigTest("own", wave, **of_test),)), bearing, friction, heating
    )
    return loops


@pytest.mark.parametrize(("radius", "speed"), [(20.0, 10.0), (200.0, 400.0), (400.0, 600.0)])
def test_the_loop_area_of_a_circle(radius: float, speed: float) -> None:
    """Steady laps take 2 pi sqrt(r2 - (Y/kf)2) Y, Y = mu N; spring (b) keeps them (Y/kf/r)2 / 2 below 2 pi r mu N."""
    loops = run_one(Circle(radius, speed, 3), ConstantFriction(MU))
    yielding = MU * LI_2020.vertical_force
    stretch = yielding / LI_2020.elastic_stiffness
    lap = loops.laps[-1]
    assert lap.energy == pytest.approx(2.0 * math.pi * math.sqrt(radius**2 - stretch**2) * yielding, rel=1e-9)
    assert lap.length == pytest.approx(2.0 * math.pi * radius, rel=1e-9)
    if radius > 100.0:
        assert lap.energy == pytest.approx(2.0 * math.pi * radius * yielding, rel=1e-6)
        assert lap.friction == pytest.approx(MU, rel=1e-6)
    # two directions each for itself would take 8 r mu N
    assert lap.energy < 0.8 * 8.0 * radius * yielding
    # the friction goes along the velocity, but for the angle whose sine is (Y/kf)/r
    pendulum, sine = LI_2020.restoring_stiffness * radius, stretch / radius
    assert loops.force_x[-1] == pytest.approx(pendulum + yielding * sine, rel=1e-7)
    assert loops.force_y[-1] == pytest.approx(yielding * math.sqrt(1.0 - sine**2), rel=1e-7)


@pytest.mark.parametrize("path", [Circle(150.0, 300.0, 1), FigureOfEight(150.0, 300.0, 1), Cloverleaf(150.0, 300.0, 1)])  # fmt: skip
def test_work_is_in_the_springs_and_in_the_friction(path) -> None:
    loops = run_one(path, heating="simplified")
    assert loops.relative_energy_residual < 1e-7
    assert np.all(np.diff(loops.hysteretic_energy) >= 0.0)
    assert loops.hysteretic_energy[-1] > 0.8 * loops.work[-1]


@declared
class Turned(Cloverleaf):
    """A path by 90 degrees further."""

    def shape(self, phase):
        position, slope = super().shape(phase)
        return 1j * position, 1j * slope


@declared
class Leaning(FigureOfEight):
    """A path turned by 30 degrees."""

    def shape(self, phase):
        position, slope = super().shape(phase)
        return np.exp(1j * math.pi / 6.0) * position, np.exp(1j * math.pi / 6.0) * slope


@pytest.mark.parametrize(
    ("heating", "slack"), [("none", 1e-10), ("simplified", 1e-8), (PreciseHeating(points=47), 1e-8)]
)
def test_a_path_turned_by_a_right_angle_turns_the_forces(heating, slack: float) -> None:
    """A grid of squares looks the same from all four sides, where no point of it is on the very rim of the disc in the middle."""
    one, other = (run_one(kind(150.0, 300.0, 1), heating=heating) for kind in (Cloverleaf, Turned))
    size = one.peak_force
    assert other.force_x == pytest.approx(-one.force_y, abs=slack * size)
    assert other.force_y == pytest.approx(one.force_x, abs=slack * size)
    assert other.temperature == pytest.approx(one.temperature, abs=1e-5)


def test_a_leaning_path_has_the_same_work() -> None:
    upright, leaning = (
        run_one(kind(150.0, 300.0, 1), heating="precise") for kind in (FigureOfEight, Leaning)
    )
    assert leaning.work[-1] == pytest.approx(upright.work[-1], rel=5e-4)
    assert leaning.peak_temperature == pytest.approx(upright.peak_temperature, abs=0.3)
    assert leaning.peak_point_temperature == pytest.approx(upright.peak_point_temperature, abs=0.5)


def test_both_halves_of_an_eight_and_all_leaves_take_the_same_work() -> None:
    """With friction that knows no heat, once the start is over."""
    for path, parts in ((FigureOfEight(150.0, 300.0, 3), 2), (Cloverleaf(150.0, 300.0, 2), 4)):
        loops = run_one(path)
        ends = loops.lap_times[-2] + np.arange(parts + 1) / parts * path.period
        works = np.diff(np.interp(ends, loops.time, loops.work))
        assert works == pytest.approx(np.full(parts, works[0]), rel=1e-7)


@pytest.mark.parametrize("heating", [NoHeating(), SimplifiedHeating()])
@pytest.mark.parametrize("load", [None, VerticalLoad((40.0, 80.0), (0.0, 2.0))])
def test_a_straight_path_is_the_machine_in_one_direction(heating, load) -> None:
    straight = run_one(Ellipse(300.0, 500.0, 2, second_amplitude=0.0), heating=heating, load=load)
    wave = Sine(300.0, 500.0, 2, start="peak")
    (line,) = run_program(Program("line", (RigTest("line", wave, load),)), heating=heating)
    assert [lap.energy for lap in straight.laps] == pytest.approx([one.energy for one in line.cycles], rel=1e-3)  # fmt: skip
    there = np.interp(straight.time, line.time, line.force)
    assert straight.force_x == pytest.approx(there, abs=1e-3 * line.force.max())
    assert not straight.force_y.any()
    assert straight.temperature == pytest.approx(
        np.interp(straight.time, line.time, line.temperature), abs=0.1
    )
    # a test of one direction goes along x where another goes in two
    circle = RigTest("circle", Circle(10.0, 10.0, 1))
    both = Program("both", (circle, RigTest("line", wave, load)))
    _, along = run_in_the_plane(both, heating=heating)
    assert along.force_x == pytest.approx(straight.force_x, abs=1e-4 * line.force.max())
    with pytest.raises(InputError, match="run_in_the_plane"):
        run_program(both)


def test_a_disc_that_passes_over_points_heats_them_by_the_closed_form() -> None:
    """dT = 2 q sqrt(D/pi)/k [sqrt(t - ta) - sqrt(t - tb)] where the disc came at ta and left at tb: plane.md, section 5."""
    speed, length, lean = 200.0, 900.0, np.exp(0.3j)
    time = np.linspace(0.0, length / speed, 1801)
    path = RecordedPath(time, (speed * time - 0.5 * length) * lean)
    heating = PreciseHeating()
    loops = run_one(path, ConstantFriction(MU), heating, replace(LI_2020, displacement_capacity=None))
    fields = loops.fields
    assert fields is not None
    # two equal plates: half of the travel and of the flux on each
    share, radius, now = 0.5, 0.5 * LI_2020.slider_diameter, time[-1]
    flux = share * MU * LI_2020.pressure * speed
    x, y = np.meshgrid(fields.x, fields.y)
    point = (x + 1j * y) / lean
    offset = np.abs(point.imag)
    half = np.sqrt(np.maximum(radius**2 - offset**2, 0.0))
    came, left = (
        np.clip((point.real + side * half + 0.5 * share * length) / (share * speed), 0.0, now)
        for side in (-1.0, 1.0)
    )
    factor = 2.0 * flux * math.sqrt(heating.diffusivity / math.pi) / heating.conductivity
    expected = factor * (np.sqrt(now - came) - np.sqrt(now - left))
    found = fields.temperature[-1, 0] - heating.ambient
    # what the rim passes, it passes a fraction of a step early or late: there the rise is steep
    cell = fields.x[1] - fields.x[0]
    rim = np.abs(np.abs(point - 0.5 * share * length) - radius) < 2.0 * cell
    inside = (offset < 0.97 * radius) & (left > came)
    assert (inside & ~rim).sum() > 3500
    assert found[inside & ~rim] == pytest.approx(expected[inside & ~rim], abs=0.1)
    assert np.sqrt(np.mean((found - expected)[inside] ** 2)) < 0.03
    assert not found[offset > 1.01 * radius].any()
    assert fields.temperature[-1].max() == pytest.approx(heating.ambient + expected.max(), abs=0.05)
    covered = np.abs(point - 0.5 * share * length) < radius
    assert loops.temperature[-1] == pytest.approx(heating.ambient + expected[covered].mean(), abs=0.02)
    assert fields.temperature[fields.hottest].max() == pytest.approx(loops.peak_point_temperature, abs=0.1)


def test_a_slider_that_begins_far_away_heats_nothing_in_the_middle() -> None:
    small = replace(LI_2020, slider_diameter=100.0, displacement_capacity=None)
    time = np.linspace(0.0, 0.5, 51)
    loops = run_one(RecordedPath(time, 300j + 100.0 * time), heating="precise", bearing=small)
    x, y = np.meshgrid(loops.fields.x, loops.fields.y)
    near = np.abs(x + 1j * y - 150j) < 80.0
    warm = loops.fields.temperature[-1, 0] > loops.heating.ambient
    assert warm[near].sum() > 1900
    assert not warm[~near].any()


def test_heat_stays_through_a_pause_and_the_slider_comes_back() -> None:
    first = RigTest("first", Circle(200.0, 400.0, 1))
    at_once = RigTest("second", Circle(200.0, 400.0, 1), pause=0.0)
    later = RigTest("second", Circle(200.0, 400.0, 1), pause=600.0)
    for heating in ("precise", "simplified"):
        whole = run_one(Circle(200.0, 400.0, 2), heating=heating)
        _, soon = run_in_the_plane(Program("two", (first, at_once)), heating=heating)
        _, late = run_in_the_plane(Program("two", (first, later)), heating=heating)
        # where nothing rubs, what follows the flux at once is gone
        assert 0.0 < whole.laps[0].final_temperature - soon.temperature[0] < 1.5
        assert soon.laps[0].energy == pytest.approx(whole.laps[1].energy, rel=2e-3)
        assert late.begins == pytest.approx(first.waveform.period + 600.0)
        assert 20.0 < late.temperature[0] < 30.0
        assert soon.laps[0].energy < late.laps[0].energy < whole.laps[0].energy
