"""Response history analysis of a building: limits, balance, symmetry, steps, plates, heating."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dcfp import (
    LI_2020,
    Bearing,
    ConstantFriction,
    GroundMotion,
    Kumar2015,
    Li2020,
    Lomiento2013,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
    load_motion,
)
from dcfp.analysis import respond
from dcfp.analysis.building import (
    Rayleigh,
    ShearBuilding,
    StiffnessProportional,
    respond_building,
    uniform_building,
)

HEATINGS = [NoHeating(), SimplifiedHeating(), PreciseHeating(cells=24)]
DAMPINGS = [None, StiffnessProportional(0.02), Rayleigh((0.02, 0.05), (1, 3))]
SINGLE = Bearing((9000.0,), 400.0, 60.0, 1.9e6)
UNEQUAL = Bearing((3000.0, 6000.0), 400.0, 60.0, 1.9e6)


@pytest.fixture(scope="module")
def motion():
    return load_motion("NCC").scaled_to_pgv(500.0)


@pytest.mark.parametrize("name", ["NCC", "KNA", "LPG", "IVD"])
@pytest.mark.parametrize("pgv", [250.0, 1000.0])
def test_stiff_storeys_are_the_rigid_structure(name, pgv):
    motion = load_motion(name).scaled_to_pgv(pgv)
    rigid = respond(motion)
    stiff = respond_building(motion, uniform_building(3, 0.02))
    # at 0.02 s LPG at 0.25 m/s is 0.18 % off, and at 0.01 s 0.04 %: it is the storeys that still give
    assert stiff.peak_displacement == pytest.approx(rigid.peak_displacement, rel=2e-3)
    assert stiff.input_velocity == pytest.approx(rigid.input_velocity, rel=5e-3)
    assert stiff.peak_temperature == pytest.approx(rigid.peak_temperature, abs=0.2)


@pytest.mark.parametrize("bearing", [SINGLE, UNEQUAL], ids=["single", "unequal"])
@pytest.mark.parametrize("heating", HEATINGS, ids=lambda h: h.name)
def test_stiff_storeys_on_other_plates(motion, bearing, heating):
    rigid = respond(motion, bearing, Kumar2015(), heating)
    stiff = respond_building(motion, uniform_building(2, 0.01), bearing, Kumar2015(), heating)
    assert stiff.peak_displacement == pytest.approx(rigid.peak_displacement, rel=2e-3)
    assert stiff.peak_temperature == pytest.approx(rigid.peak_temperature, abs=0.2)
    assert stiff.temperature.shape == stiff.time.shape


def test_unequal_plates_heat_unequally(motion):
    building = uniform_building(5, 0.5)
    equal = respond_building(motion, building)
    unequal = respond_building(motion, building, UNEQUAL)
    assert unequal.peak_temperature > equal.peak_temperature + 5.0
    assert unequal.peak_displacement == pytest.approx(equal.peak_displacement, rel=0.05)


@pytest.mark.parametrize("damping", DAMPINGS, ids=["undamped", "stiffness", "rayleigh"])
@pytest.mark.parametrize("friction", [ConstantFriction(), Li2020(), Lomiento2013()], ids=lambda f: f.name)
def test_the_balance_closes_at_every_sample(motion, damping, friction):
    response = respond_building(motion, uniform_building(5, 0.8, damping=damping), LI_2020, friction)
    energy = response.energy
    assert energy.relative_residual < 1e-10
    assert np.diff(energy.damping).min() >= -1e-12 * energy.input.max()
    assert np.diff(energy.hysteretic).min() >= -1e-9 * energy.input.max()
    assert (energy.damping[-1] > 0.0) == (damping is not None)
    # the vibration of an undamped building goes on, and its bound says that it might slide once more
    assert response.rests == (damping is not None)


def test_damping_takes_a_small_part_of_the_energy(motion):
    energy = respond_building(motion, uniform_building(5, 0.5)).energy
    assert 0.0 < energy.damping[-1] < 0.1 * energy.input[-1]
    assert energy.hysteretic[-1] > 0.9 * energy.input[-1]


@pytest.mark.parametrize("heating", HEATINGS, ids=lambda h: h.name)
def test_a_mirrored_motion_gives_a_mirrored_response(motion, heating):
    building = uniform_building(4, 0.6)
    response = respond_building(motion, building, heating=heating)
    mirrored = respond_building(motion.scaled(-1.0), building, heating=heating)
    np.testing.assert_allclose(mirrored.floor_displacement, -response.floor_displacement, atol=1e-9)
    np.testing.assert_allclose(mirrored.floor_acceleration, -response.floor_acceleration, atol=1e-6)
    np.testing.assert_allclose(mirrored.temperature, response.temperature, atol=1e-9)
    np.testing.assert_allclose(mirrored.energy.input, response.energy.input, rtol=1e-9, atol=1e-3)


@pytest.mark.parametrize("heating", HEATINGS, ids=lambda h: h.name)
@pytest.mark.parametrize("damping", [None, StiffnessProportional(0.02)], ids=["undamped", "damped"])
def test_half_the_step_changes_little(motion, heating, damping):
    building = uniform_building(5, 0.5, damping=damping)
    coarse = respond_building(motion, building, heating=heating)
    fine = respond_building(motion, building, heating=heating, step=0.001)
    assert coarse.step == pytest.approx(0.002)
    assert fine.step == pytest.approx(0.001)
    assert coarse.peak_displacement == pytest.approx(fine.peak_displacement, rel=1e-3)
    assert coarse.input_velocity == pytest.approx(fine.input_velocity, rel=1e-3)
    assert coarse.peak_temperature == pytest.approx(fine.peak_temperature, abs=0.2)
    np.testing.assert_allclose(coarse.peak_drift, fine.peak_drift, rtol=1e-3)
    np.testing.assert_allclose(coarse.peak_acceleration, fine.peak_acceleration, rtol=3e-3)


def test_precise_and_simplified_heating_agree(motion):
    building = uniform_building(5, 0.5)
    simple = respond_building(motion, building)
    precise = respond_building(motion, building, heating=PreciseHeating())
    assert precise.peak_displacement == pytest.approx(simple.peak_displacement, rel=0.05)
    assert 0.5 < (precise.peak_temperature - 20.0) / (simple.peak_temperature - 20.0) < 1.0


def test_histories_fit_together(motion):
    response = respond_building(motion, uniform_building(3, 0.7))
    masses = np.array(response.building.masses)
    samples = response.time.size
    assert response.drift.shape == (samples, 3)
    assert response.floor_acceleration.shape == (samples, 4)
    np.testing.assert_array_equal(response.time[:50], motion.time[:50])
    # what all floors together are accelerated by is the bearing's force
    np.testing.assert_allclose(
        response.floor_acceleration @ masses,
        -response.force,
        rtol=0.0,
        atol=1e-9 * np.abs(response.force).max(),
    )
    assert np.abs(response.displacement).max() <= response.peak_displacement
    assert (np.abs(response.drift).max(axis=0) <= response.peak_drift).all()
    assert (np.abs(response.floor_acceleration).max(axis=0) <= response.peak_acceleration * (1 + 1e-12)).all()
    sliding = response.sliding != 0.0
    reach = LI_2020.vertical_force / LI_2020.elastic_stiffness
    np.testing.assert_allclose(
        np.abs(response.elongation[sliding]), response.friction[sliding] * reach, rtol=1e-9
    )
    assert str(response).startswith(f"3 storeys under {motion.name}\n  pgv ")


def test_masses_are_scaled_to_what_the_bearing_carries(motion):
    fractions = ShearBuilding((0.2, 0.5, 0.3), (40.0, 30.0))
    tonnes = ShearBuilding((20.0, 50.0, 30.0), (4000.0, 3000.0))
    a, b = respond_building(motion, fractions), respond_building(motion, tonnes)
    assert a.building.mass == pytest.approx(LI_2020.mass)
    np.testing.assert_allclose(a.displacement, b.displacement, atol=1e-8)


def test_a_long_way_needs_more_of_the_plate_than_there_was_at_first():
    motion = load_motion("IVD").scaled_to_pgv(1500.0)
    response = respond_building(motion, uniform_building(2, 0.5), heating=PreciseHeating(cells=16))
    assert response.peak_displacement > 700.0
    assert response.energy.relative_residual < 1e-10


def test_at_rest_it_stays_at_rest():
    response = respond_building(GroundMotion(np.zeros(5), 0.01), uniform_building(2, 0.5))
    assert response.rests
    assert response.peak_displacement == 0.0
    assert response.input_velocity == 0.0
    assert response.energy.relative_residual == 0.0


def test_a_tail_of_ones_own(motion):
    response = respond_building(motion, uniform_building(2, 0.5), tail=1.0)
    assert response.time[-1] == pytest.approx(motion.duration + 1.0)


@settings(max_examples=40)
@given(
    storeys=st.integers(1, 6),
    period=st.floats(0.05, 2.0),
    mass_ratio=st.floats(0.1, 5.0),
    pgv=st.floats(100.0, 1500.0),
    stiffness=st.floats(1e5, 1e7),
    friction=st.sampled_from([Li2020(), Kumar2015(), ConstantFriction(), Lomiento2013()]),
    heating=st.sampled_from(HEATINGS),
    damped=st.booleans(),
)
def test_whatever_the_building_the_balance_closes(
    motion, storeys, period, mass_ratio, pgv, stiffness, friction, heating, damped
):
    bearing = dataclasses.replace(UNEQUAL, elastic_stiffness=stiffness)
    damping = StiffnessProportional(0.02) if damped else None
    building = uniform_building(storeys, period, mass_ratio=mass_ratio, damping=damping)
    response = respond_building(motion.scaled_to_pgv(pgv), building, bearing, friction, heating, tail=2.0)
    energy = response.energy
    assert energy.relative_residual < 1e-9
    assert np.diff(energy.hysteretic).min() >= -1e-6 * energy.input.max()
