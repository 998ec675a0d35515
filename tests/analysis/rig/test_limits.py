"""The virtual machine where closed forms or common sense say what comes out."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp.analysis.rig import Loops, Program, Recorded, RigTest, Sine, Triangle, VerticalLoad, run_program
from dcfp.analysis.rig.waveform import STARTS, Waveform
from dcfp.system import (
    LI_2020,
    Bearing,
    ConstantFriction,
    FrictionLaw,
    Heating,
    Kumar2015,
    Li2020,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
)

LOAD = VerticalLoad((60.0,))
COULOMB, COLD = ConstantFriction(0.043), NoHeating()
#: mu N / kf, by which spring (b) stretches before it slides [mm].
REACH = 0.043 * LI_2020.vertical_force / LI_2020.elastic_stiffness
STIFF = LI_2020.unchecked(elastic_stiffness=1e5 * LI_2020.elastic_stiffness)


def run_one(
    waveform: Waveform,
    friction: FrictionLaw = COULOMB,
    heating: Heating = COLD,
    bearing: Bearing = LI_2020,
    load: VerticalLoad = LOAD,
) -> Loops:
    return run_program(Program("program", (RigTest("test", waveform, load),)), bearing, friction, heating)[0]


def recorded(time: np.ndarray, displacement: np.ndarray) -> Recorded:
    return Recorded(np.asarray(time, dtype=float), np.asarray(displacement, dtype=float))


# ----- friction and springs -----


def test_without_friction_the_pendulum_is_left() -> None:
    loops = run_one(Sine(200.0, 400.0, 2), ConstantFriction(1e-9))
    pendulum = LI_2020.restoring_stiffness * loops.displacement
    assert np.abs(loops.force - pendulum).max() <= 1.0000001e-9 * LI_2020.vertical_force


def test_a_stiff_spring_leaves_a_coulomb_loop() -> None:
    loops = run_one(Sine(200.0, 400.0, 2), bearing=STIFF)
    slip = 0.043 * LI_2020.vertical_force
    assert np.abs(loops.friction_force)[1:] == pytest.approx(slip, rel=1e-9)
    assert loops.cycles[1].energy == pytest.approx(4.0 * slip * 200.0, rel=1e-7)


def test_a_soft_spring_never_slides() -> None:
    soft = LI_2020.unchecked(elastic_stiffness=1000.0)  # it would stretch by 324 mm
    loops = run_one(Sine(200.0, 400.0, 2), bearing=soft)
    stiffness = soft.restoring_stiffness + soft.elastic_stiffness
    assert not loops.sliding.any()
    assert loops.force == pytest.approx(stiffness * loops.displacement, rel=1e-12, abs=1e-6)
    assert not loops.hysteretic_energy.any()


def test_plates_that_conduct_perfectly_do_not_heat() -> None:
    cold = run_one(Sine(200.0, 400.0, 2), Li2020())
    for heating in (
        SimplifiedHeating().unchecked(conductivity=1e12),
        PreciseHeating().unchecked(conductivity=1e12),
    ):
        loops = run_one(Sine(200.0, 400.0, 2), Li2020(), heating)
        assert np.abs(loops.force - cold.force).max() < 1e-6 * np.abs(cold.force).max()


@pytest.mark.parametrize("radii", [(4500.0,), (4500.0, 4500.0), (6000.0, 3000.0)])
def test_the_centre_of_a_plate_heats_until_the_slider_has_left_it(radii: tuple[float, ...]) -> None:
    """Eq. (11) under a constant flux, while the part of the travel that is on this plate is within the contact: Eq. (12)."""
    bearing, heating = replace(LI_2020, radii=radii), SimplifiedHeating()
    shares = np.array(radii) / sum(radii)  # of the travel and of the heat
    edge = 0.25 * np.sqrt(np.pi) * bearing.slider_diameter / shares.max()
    loops = run_one(Triangle(1.2 * edge, 100.0, 1), heating=heating, bearing=bearing)
    flux = 0.043 * 60.0 * 100.0 * (shares @ shares)
    for part, is_heated in ((0.5, True), (0.97, True), (1.1, False)):
        at = int(np.argmax(loops.displacement >= part * edge))
        sliding = loops.time[at] - REACH / 100.0
        rise = 2.0 * flux / heating.conductivity * np.sqrt(heating.diffusivity * sliding / np.pi)
        assert (abs(loops.temperature[at] - 20.0 - rise) < 2e-3 * rise) == is_heated


def test_both_heating_models_agree_where_the_slider_hardly_moves() -> None:
    simplified = run_one(Sine(2.0, 20.0, 5), Li2020(), SimplifiedHeating(), STIFF)
    precise = run_one(Sine(2.0, 20.0, 5), Li2020(), PreciseHeating(), STIFF)
    rise = simplified.peak_temperature - 20.0
    travelled = 1.0 / LI_2020.contact_half_side
    assert rise > 4.0
    assert abs(precise.peak_temperature - simplified.peak_temperature) < travelled * rise


def test_slow_motion_has_the_slow_coefficient() -> None:
    loops = run_one(Sine(10.0, 1e-3, 1), Li2020(), SimplifiedHeating())
    slow = float(Li2020().coefficient(60.0, 0.0, 20.0))
    assert loops.cycles[0].friction == pytest.approx(slow, rel=1e-3)
    assert loops.peak_temperature < 20.1


def test_fast_motion_has_the_fast_coefficient() -> None:
    loops = run_one(Sine(200.0, 8000.0, 2), Li2020())
    fast = float(Li2020().coefficient(60.0, 8000.0, 20.0))
    assert loops.cycles[1].friction == pytest.approx(fast, rel=1e-9)


def test_fast_motion_with_heat_is_hot_and_smooth() -> None:
    loops = run_one(Sine(200.0, 8000.0, 2), Li2020(), PreciseHeating())
    assert 200.0 < loops.peak_temperature < 2000.0
    assert (np.diff(loops.hysteretic_energy) >= 0.0).all()


# ----- scale -----


def test_four_times_the_area_and_stiffness_is_four_times_the_force() -> None:
    large = replace(
        LI_2020,
        slider_diameter=2.0 * LI_2020.slider_diameter,
        elastic_stiffness=4.0 * LI_2020.elastic_stiffness,
    )
    here, there = (run_one(Sine(200.0, 400.0, 2), Li2020(), bearing=bearing) for bearing in (LI_2020, large))
    assert there.force == pytest.approx(4.0 * here.force, rel=1e-9, abs=1e-3)
    assert there.hysteretic_energy == pytest.approx(4.0 * here.hysteretic_energy, rel=1e-9)


def test_constant_friction_does_not_know_the_speed() -> None:
    slow, fast = (run_one(Sine(200.0, speed, 2)) for speed in (4.0, 4000.0))
    assert fast.force == pytest.approx(slow.force, rel=1e-9, abs=1e-3)


def test_a_single_plate_of_the_same_effective_radius_is_the_same_without_heat() -> None:
    single = replace(LI_2020, radii=(9000.0,))
    unequal = replace(LI_2020, radii=(3000.0, 6000.0))
    double = run_one(Sine(200.0, 400.0, 2), Li2020())
    for other in (single, unequal):
        assert run_one(Sine(200.0, 400.0, 2), Li2020(), bearing=other).force == pytest.approx(
            double.force, rel=1e-9, abs=1e-3
        )


def test_a_test_in_forces_is_the_same_test() -> None:
    force = VerticalLoad((LI_2020.vertical_force,), is_pressure=False)
    waveform = Sine(200.0, 400.0, 2)
    there = run_one(waveform, Li2020(), SimplifiedHeating(), load=force)
    assert there.force.tolist() == pytest.approx(
        run_one(waveform, Li2020(), SimplifiedHeating()).force.tolist()
    )


# ----- waveforms -----


def test_at_the_corner_of_a_triangle_it_sticks_until_the_spring_has_turned() -> None:
    loops = run_one(Triangle(1.0, 1.0, 2))  # 100 samples between zero and a corner, 2 mu N / kf is 0.34 mm
    corner = 100
    way = loops.displacement[corner] - loops.displacement[corner : corner + 100]
    friction = loops.friction_force[corner : corner + 100] / (0.043 * LI_2020.vertical_force)
    assert friction == pytest.approx(np.maximum(1.0 - way / REACH, -1.0), abs=1e-9)
    stuck = way < 2.0 * REACH
    assert (loops.sliding[corner + 1 : corner + 100][stuck[1:]] == 0.0).all()
    assert (loops.sliding[corner : corner + 100][~stuck] == -1.0).all()


@pytest.mark.parametrize("ramp", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("cycles", [1, 3])
def test_a_ramp_starts_and_ends_at_rest_and_its_cycles_do_not_count(ramp: float, cycles: int) -> None:
    waveform = Sine(200.0, 400.0, cycles, "ramp", ramp)
    loops = run_one(waveform, Li2020(), SimplifiedHeating())
    assert loops.displacement[[0, -1]] == pytest.approx([0.0, 0.0], abs=1e-9)
    assert loops.velocity[[0, -1]] == pytest.approx([0.0, 0.0], abs=1e-6)
    assert loops.time[-1] == pytest.approx((cycles + 2.0 * ramp) * waveform.period)
    assert len(loops.cycles) == cycles
    assert loops.cycle_times[0] == pytest.approx(ramp * waveform.period)
    for cycle in loops.cycles:
        assert cycle.largest == pytest.approx(200.0, rel=1e-9)
        assert cycle.least == pytest.approx(-200.0, rel=1e-9)
        assert len(cycle.crossings) == 2
    assert np.abs(loops.displacement).max() <= 200.0 * (1.0 + 1e-12)


def test_a_start_at_the_peak_is_from_rest_without_a_force_of_friction() -> None:
    loops = run_one(Sine(200.0, 400.0, 2, "peak"))
    assert loops.displacement[0] == 200.0
    assert loops.velocity[0] == 0.0
    assert loops.friction_force[0] == 0.0
    assert [len(cycle.crossings) for cycle in loops.cycles] == [2, 2]
    assert loops.cycles[1].energy == pytest.approx(4.0 * 0.043 * LI_2020.vertical_force * (200.0 - REACH))


@pytest.mark.parametrize("start", STARTS)
def test_friction_has_no_say_in_where_a_cycle_counts(start: str) -> None:
    loops = run_one(Sine(200.0, 400.0, 3, start))
    assert np.diff(loops.cycle_times) == pytest.approx(np.full(3, 2.0 * np.pi * 200.0 / 400.0))
    assert loops.cycles[2].friction == pytest.approx(0.043)


def test_a_recorded_sine_is_the_sine() -> None:
    time = np.linspace(0.0, 2.0 * np.pi, 2001)
    there = run_one(recorded(time, 200.0 * np.sin(2.0 * time)), Li2020(), SimplifiedHeating())
    sine = run_one(Sine(200.0, 400.0, 2), Li2020(), SimplifiedHeating())
    assert len(there.cycles) == 2
    for measured, exact in zip(there.cycles, sine.cycles, strict=True):
        assert measured.energy == pytest.approx(exact.energy, rel=1e-4)
        assert measured.friction == pytest.approx(exact.friction, rel=2e-3)
    assert there.peak_temperature == pytest.approx(sine.peak_temperature, abs=0.2)


@pytest.mark.parametrize("quarters", range(4, 8))
@pytest.mark.parametrize("kind", [Sine, Triangle])
def test_a_part_of_a_cycle_does_not_count_as_one(kind: type, quarters: int) -> None:
    loops = run_one(kind(200.0, 400.0, quarters / 4.0))
    assert loops.cycle_times.size - 1 == quarters // 4


def test_the_shortest_recorded_motion_runs() -> None:
    loops = run_one(recorded([0.0, 0.1, 0.2, 0.3], [0.0, 1.0, -1.0, 0.0]), Li2020(), PreciseHeating())
    assert np.isfinite(loops.lines).all()


# ----- loads that change -----


@pytest.mark.parametrize("law", [Li2020(), Kumar2015()])
def test_friction_follows_the_pressure(law: FrictionLaw) -> None:
    load = VerticalLoad((40.0, 80.0, 60.0), (0.0, 3.0, 6.0))
    loops = run_one(Sine(200.0, 400.0, 2), law, SimplifiedHeating(), load=load)
    pressure = np.interp(loops.time, load.times, load.values)
    assert loops.load == pytest.approx(pressure * LI_2020.slider_area)
    speed = np.abs(loops.velocity) * (0.5 if law.speed_is_of_surface else 1.0)
    expected = law.coefficient(pressure, speed, loops.temperature)
    slides = loops.sliding != 0.0
    # between samples gamma is taken as linear, and the temperature at the end of a step as it is expected
    assert loops.friction[slides] == pytest.approx(expected[slides], rel=5e-3)


def test_a_load_that_falls_at_rest_lets_the_spring_slip() -> None:
    time = np.linspace(0.0, 3.0, 301)
    displacement = np.minimum(time, 1.0) * 10.0
    load = VerticalLoad((60.0, 60.0, 30.0), (0.0, 1.5, 2.5))
    loops = run_one(recorded(time, displacement), load=load)
    at_rest = time > 1.05
    yield_force = 0.043 * loops.load
    assert loops.friction_force[at_rest] == pytest.approx(yield_force[at_rest], rel=1e-9)
    energy = loops.hysteretic_energy
    assert (np.diff(energy) >= 0.0).all()
    relieved = 0.5 * 0.043**2 * (loops.load[120] ** 2 - loops.load[-1] ** 2) / LI_2020.elastic_stiffness
    assert energy[-1] - energy[120] == pytest.approx(relieved, rel=1e-6)


def test_a_load_that_grows_at_rest_changes_nothing() -> None:
    time = np.linspace(0.0, 3.0, 301)
    displacement = np.minimum(time, 1.0) * 10.0
    loops = run_one(recorded(time, displacement), load=VerticalLoad((30.0, 30.0, 60.0), (0.0, 1.5, 2.5)))
    at_rest = loops.friction_force[time > 1.05]
    assert at_rest == pytest.approx(at_rest[0], rel=1e-12)
    assert loops.hysteretic_energy[-1] == loops.hysteretic_energy[120]


# ----- sequences -----


def sequence(pause: float, heating: Heating) -> tuple[Loops, ...]:
    tests = (
        RigTest("a", Sine(200.0, 400.0, 2), LOAD),
        RigTest("b", Sine(200.0, 400.0, 2), LOAD, pause=pause),
    )
    return run_program(Program("program", tests), LI_2020, Li2020(), heating)


@pytest.mark.parametrize("heating", [SimplifiedHeating(), PreciseHeating()])
def test_the_plates_cool_in_a_pause(heating: Heating) -> None:
    starts = [float(sequence(pause, heating)[1].temperature[0]) for pause in (0.0, 10.0, 100.0, 1000.0)]
    assert starts == sorted(starts, reverse=True)
    assert starts[0] > 80.0
    assert starts[-1] < 30.0
    # long after the first test the rise falls with the root of the time
    assert (starts[2] - 20.0) / (starts[3] - 20.0) == pytest.approx(10.0**0.5, rel=0.05)


@pytest.mark.parametrize("pause", [60.0, 600.0, 3600.0])
@pytest.mark.parametrize("heating", [SimplifiedHeating(), PreciseHeating()])
def test_a_pause_changes_nothing_before_it(heating: Heating, pause: float) -> None:
    there, alone = sequence(pause, heating)[0], run_one(Sine(200.0, 400.0, 2), Li2020(), heating)
    for one, other in zip(there.cycles, alone.cycles, strict=True):
        assert one.energy == pytest.approx(other.energy, rel=1e-4)
        assert one.friction == pytest.approx(other.friction, rel=1e-4)
    assert there.peak_temperature == pytest.approx(alone.peak_temperature, abs=0.02)


def test_a_test_without_a_pause_begins_cold() -> None:
    tests = tuple(RigTest(name, Sine(200.0, 400.0, 2), LOAD) for name in "ab")
    first, second = run_program(Program("program", tests), LI_2020, Li2020(), PreciseHeating())
    np.testing.assert_array_equal(first.lines, second.lines)
