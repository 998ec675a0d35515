"""The building itself: periods, damping, scaling, refusals."""

import math

import numpy as np
import pytest

from dcfp import LI_2020, GroundMotion, InputError
from dcfp.analysis.building import (
    Rayleigh,
    ShearBuilding,
    StiffnessProportional,
    respond_building,
    uniform_building,
)


@pytest.mark.parametrize("storeys", [1, 2, 5, 12])
def test_a_uniform_building_has_the_period_asked_for(storeys):
    building = uniform_building(storeys, 0.7)
    # Chopra, uniform shear beam of n lumped masses: T_j / T_1 = sin(pi/(4n+2)) / sin((2j-1) pi/(4n+2))
    place = (2 * np.arange(1, storeys + 1) - 1) * math.pi / (4 * storeys + 2)
    np.testing.assert_allclose(
        building.fixed_base_periods, 0.7 * np.sin(place[0]) / np.sin(place), rtol=1e-10
    )
    assert building.mass == pytest.approx(1.0)


def test_two_storeys_by_hand():
    # m = 2, 1 and k = 2, 1: omega^2 = 1/2 and 2
    building = ShearBuilding((3.0, 2.0, 1.0), (2.0, 1.0))
    np.testing.assert_allclose(building.fixed_base_periods, 2.0 * math.pi / np.sqrt([0.5, 2.0]))


def test_scaling_leaves_periods_and_damping_ratios():
    building = uniform_building(4, 0.9, mass_ratio=2.0)
    scaled = building.scaled_to(LI_2020.mass)
    assert scaled.mass == pytest.approx(LI_2020.mass)
    assert scaled.masses[0] == pytest.approx(2.0 * scaled.masses[1])
    np.testing.assert_allclose(scaled.fixed_base_periods, building.fixed_base_periods)
    factor = LI_2020.mass / building.mass
    np.testing.assert_allclose(scaled.damping_matrix, factor * building.damping_matrix, atol=1e-9)


@pytest.mark.parametrize(
    ("damping", "expected"),
    [
        (StiffnessProportional(0.03), {0: 0.03}),
        (Rayleigh((0.02, 0.05), (1, 3)), {0: 0.02, 2: 0.05}),
        (Rayleigh((0.02, 0.02), (1, 2)), {0: 0.02, 1: 0.02}),
    ],
)
def test_the_modes_have_the_damping_asked_for(damping, expected):
    building = uniform_building(4, 0.8, damping=damping)
    mass = np.diag(building.masses[1:])
    c, k = building.damping_matrix[1:, 1:], building.storey_stiffness[1:, 1:]
    values, shapes = np.linalg.eigh(np.linalg.solve(np.sqrt(mass), k) @ np.linalg.inv(np.sqrt(mass)))
    modes = np.linalg.inv(np.sqrt(mass)) @ shapes
    for mode, ratio in expected.items():
        phi = modes[:, mode]
        assert phi @ c @ phi / (2.0 * math.sqrt(values[mode])) == pytest.approx(ratio)


@pytest.mark.parametrize("damping", [StiffnessProportional(0.03), Rayleigh((0.02, 0.05), (1, 3))])
def test_a_rigid_motion_feels_neither_storeys_nor_dampers(damping):
    building = uniform_building(4, 0.8, damping=damping)
    for matrix in (building.storey_stiffness, building.damping_matrix):
        np.testing.assert_allclose(matrix @ np.ones(5), 0.0, atol=1e-12 * np.abs(matrix).max())
        np.testing.assert_allclose(matrix, matrix.T)


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda: ShearBuilding((1.0,), ()), "at least one storey"),
        (lambda: ShearBuilding((1.0, 1.0), (1.0, 1.0)), "needs 3 masses"),
        (lambda: ShearBuilding((1.0, -1.0), (1.0,)), "mass of a floor must be a number of t above 0"),
        (
            lambda: ShearBuilding((1.0, 1.0), (math.nan,)),
            "stiffness of a storey must be a number of N/mm above 0",
        ),
        (lambda: StiffnessProportional(0.0), "must be a number above 0 and up to 0.9999"),
        (lambda: Rayleigh((0.02, math.nan), (1, 2)), "must be 2 numbers above 0 and up to 0.9999"),
        (lambda: Rayleigh((0.02, 0.02), (2, 2)), "two different numbers"),
        (lambda: Rayleigh((0.02, 0.02), (0, 1)), "number of a mode"),
        (lambda: Rayleigh((0.02,), (1,)), "must be 2 numbers"),
        (
            lambda: uniform_building(2, 0.5, damping=Rayleigh((0.02, 0.02), (1, 3))),
            "at least as many storeys",
        ),
        (lambda: uniform_building(3, 0.5, damping=Rayleigh((0.01, 0.5), (1, 2))), "would be negative"),
        (lambda: uniform_building(0, 0.5), "number of storeys"),
        (lambda: uniform_building(True, 0.5), "number of storeys"),
        (lambda: uniform_building(3, 0.0), "first period"),
        (lambda: uniform_building(3, 0.5, mass_ratio=0.0), "ratio of the base's mass"),
        (lambda: uniform_building(3, 0.5).scaled_to(0.0), "mass must be a number of t above 0"),
    ],
)
def test_refusals(make, says):
    with pytest.raises(InputError, match=says):
        make()


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"step": 0.0}, r"\(step\) must be"),
        ({"step": math.nan}, r"\(step\) must be"),
        ({"tail": -1.0}, r"\(tail\) must be"),
        ({"tail": math.inf}, r"\(tail\) must be"),
    ],
)
def test_an_analysis_refuses(arguments, says):
    with pytest.raises(InputError, match=says):
        respond_building(GroundMotion(np.zeros(3), 0.01), uniform_building(2, 0.5), **arguments)
