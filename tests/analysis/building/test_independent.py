"""A building against calculations that share nothing with it."""

import json
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import numba
import numpy as np
import pytest
from scipy import signal

from dcfp import LI_2020, ConstantFriction, Li2020, NoHeating, load_motion
from dcfp.analysis.building import Rayleigh, respond_building, uniform_building

#: A bearing so rough that it never slides at the accelerations here.
ROUGH = ConstantFriction(0.999)


def by_lsim(motion, building, base_stiffness, step):
    """Return displacements of base and floors, linear, from scipy: (n, floors)."""
    mass = np.array(building.masses)
    floors = mass.size
    stiffness = building.storey_stiffness.copy()
    stiffness[0, 0] += base_stiffness
    a = np.zeros((2 * floors, 2 * floors))
    a[:floors, floors:] = np.eye(floors)
    a[floors:, :floors] = -stiffness / mass[:, None]
    a[floors:, floors:] = -building.damping_matrix / mass[:, None]
    b = np.concatenate((np.zeros(floors), -np.ones(floors)))[:, None]
    c = np.eye(2 * floors)[:floors]
    time = np.arange(round(motion.duration / step) + 1) * step
    ground = np.interp(time, motion.time, motion.acceleration)
    return signal.lsim((a, b, c, np.zeros((floors, 1))), ground, time)[1]


@pytest.mark.parametrize("damping", [None, Rayleigh((0.02, 0.04), (1, 3))])
def test_a_base_that_never_slides_is_a_linear_building(damping):
    motion = load_motion("NCC").scaled_to_pgv(250.0)
    response = respond_building(
        motion, uniform_building(3, 0.4, damping=damping), LI_2020, ROUGH, NoHeating(), tail=0.0
    )
    assert not response.sliding.any()
    linear = by_lsim(
        motion,
        response.building,
        LI_2020.restoring_stiffness + LI_2020.elastic_stiffness,
        motion.time_step,
    )
    np.testing.assert_allclose(
        response.floor_displacement, linear, rtol=0.0, atol=1e-8 * np.abs(linear).max()
    )


def test_a_base_that_is_held_too_is_a_building_on_the_ground():
    motion = load_motion("NCC").scaled_to_pgv(250.0)
    held = LI_2020.unchecked(elastic_stiffness=1.9e10)
    response = respond_building(motion, uniform_building(3, 0.4), held, ROUGH, NoHeating(), tail=0.0)
    own = response.building
    mass = np.array(own.masses[1:])
    a = np.block(
        [
            [np.zeros((3, 3)), np.eye(3)],
            [-own.storey_stiffness[1:, 1:] / mass[:, None], -own.damping_matrix[1:, 1:] / mass[:, None]],
        ]
    )
    b = np.array([0.0, 0.0, 0.0, -1.0, -1.0, -1.0])[:, None]
    _, fixed, _ = signal.lsim((a, b, np.eye(6)[:3], np.zeros((3, 1))), motion.acceleration, motion.time)
    np.testing.assert_allclose(
        response.floor_displacement[:, 1:], fixed, rtol=0.0, atol=1e-3 * np.abs(fixed).max()
    )
    drifts = np.diff(fixed, axis=1, prepend=0.0)
    np.testing.assert_allclose(response.peak_drift, np.abs(drifts).max(axis=0), rtol=5e-3)


@numba.njit
def in_small_steps(ground, interval, parts, mass, stiffness, damping, restoring, elastic, weight, law):
    """One storey in tiny steps, velocities first; the force of spring (b) returns to mu N. Constants per their own mass."""
    u0 = v0 = u1 = v1 = x = 0.0
    input_ = 0.0
    peaks = np.zeros(2)
    step = interval / parts
    for i in range(ground.size - 1):
        for j in range(parts):
            ag = ground[i] + (ground[i + 1] - ground[i]) * (j + 0.5) / parts
            between = stiffness * (u1 - u0) + damping * (v1 - v0)
            v0 += step * (-ag + (between - restoring * u0 - elastic * x) / mass[0])
            v1 += step * (-ag - between / mass[1])
            u0 += step * v0
            u1 += step * v1
            input_ -= ag * step * (mass[0] * v0 + mass[1] * v1)
            most = law[0] * (1.0 - law[1] * np.exp(-law[2] * abs(v0))) * weight / elastic
            x = min(max(x + step * v0, -most), most)
            peaks[0] = max(peaks[0], abs(u0))
            peaks[1] = max(peaks[1], abs(u1 - u0))
    return peaks, input_


@pytest.mark.parametrize(("name", "pgv"), [("NCC", 500.0), ("KNA", 1000.0)])
def test_one_storey_with_friction_that_knows_speed_in_small_steps(name, pgv):
    motion = load_motion(name).scaled_to_pgv(pgv)
    response = respond_building(
        motion, uniform_building(1, 0.5, mass_ratio=0.5), LI_2020, Li2020(), NoHeating(), tail=0.0
    )
    own = response.building
    law = Li2020().at_pressure(LI_2020.pressure)
    warm = law.reference * (law.heat_scale * np.exp(-law.heat_rate * 20.0) + law.heat_floor)
    peaks, energy = in_small_steps(
        motion.acceleration,
        motion.time_step,
        round(motion.time_step / 5e-6),
        np.array(own.masses),
        own.stiffnesses[0],
        own.damping_matrix[1, 1],
        LI_2020.restoring_stiffness,
        LI_2020.elastic_stiffness,
        LI_2020.vertical_force,
        np.array([warm, law.speed_drop, law.speed_rate]),
    )
    assert response.peak_displacement == pytest.approx(peaks[0], rel=1e-3)
    assert response.peak_drift[0] == pytest.approx(peaks[1], rel=1e-3)
    assert response.energy.input[-1] == pytest.approx(energy, rel=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize(("storeys", "name", "pgv"), [(1, "NCC", 500.0), (5, "KNA", 750.0)])
def test_coulomb_friction_against_opensees(tmp_path, storeys, name, pgv):
    required = os.environ.get("DCFP_REQUIRE_OPENSEES") == "1"
    if find_spec("openseespy") is None and not required:
        pytest.skip("OpenSees is not installed")
    motion = load_motion(name).scaled_to_pgv(pgv)
    response = respond_building(
        motion, uniform_building(storeys, 0.6), LI_2020, ConstantFriction(), NoHeating(), tail=0.0
    )
    own = response.building
    beta = 2.0 * own.damping.ratio * own.fixed_base_periods[0] / (2.0 * np.pi)
    job = {
        "masses": own.masses,
        "stiffnesses": own.stiffnesses,
        "dampings": [beta * k for k in own.stiffnesses],
        "restoring": LI_2020.restoring_stiffness,
        "elastic": LI_2020.elastic_stiffness,
        "yield": ConstantFriction().mu * LI_2020.vertical_force,
        "acceleration": motion.acceleration.tolist(),
        "interval": motion.time_step,
        "step": 5e-4,
    }
    job_file, result_file = tmp_path / "job.json", tmp_path / "result.json"
    job_file.write_text(json.dumps(job))
    done = subprocess.run(
        [sys.executable, str(Path(__file__).with_name("opensees_job.py")), str(job_file), str(result_file)],
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    if not result_file.exists() and not required:
        pytest.skip(f"OpenSees cannot be run: {done.stderr.strip()[-200:]}")
    result = json.loads(result_file.read_text())
    assert result["failed_steps"] == 0
    np.testing.assert_allclose([response.peak_displacement, *response.peak_drift], result["peaks"], rtol=2e-3)
