"""Input energies after Uang and Bertero, and the formula of Fajfar, Vidic and Fischinger."""

import numpy as np
import pytest

from dcfp import ConstantFriction, NoHeating, respond
from dcfp.errors import InputError
from dcfp.methods import fajfar_1989, uang_bertero_1988
from dcfp.methods.spectra import input_energy_spectrum
from dcfp.methods.spectra.of_record import PERIODS
from dcfp.motion import GroundMotion
from dcfp.motion.measures import significant_duration
from dcfp.motion.synthetic import harmonic


def test_of_one_oscillator(motions):
    for motion in motions.values():
        found = uang_bertero_1988.elastic_input(motion, 2.0, 0.1)
        spectrum = input_energy_spectrum(motion, np.array([1.0, 2.0]), 0.1)
        assert found.relative == pytest.approx(float(spectrum.relative[1]))
        assert found.absolute == pytest.approx(float(spectrum.absolute[1]))
        assert found.relative_velocity == pytest.approx(np.sqrt(2.0 * found.relative))
        assert found.absolute_velocity == pytest.approx(np.sqrt(2.0 * found.absolute))


def test_stiff_takes_absolute_and_soft_takes_relative_energy(motions):
    # Uang and Bertero's limits: a stiff system moves with the ground (E_abs = v_g^2 / 2 at most, E_rel to 0), a soft one stays (the other way round)
    for motion in motions.values():
        stiff = uang_bertero_1988.elastic_input(motion, 0.02, 0.05)
        soft = uang_bertero_1988.elastic_input(motion, 90.0, 0.05)
        ground = 0.5 * motion.peak_velocity**2
        assert stiff.absolute == pytest.approx(ground, rel=0.05)
        assert stiff.relative < 0.05 * ground
        assert soft.relative == pytest.approx(ground, rel=0.1)
        assert soft.absolute < 0.1 * ground


def test_of_the_sliding_structure(motions):
    response = respond(motions["NCC"], friction=ConstantFriction(0.043), heating=NoHeating())
    found = uang_bertero_1988.sliding_input(response)
    mass = response.bearing.mass
    assert found.relative == pytest.approx(response.energy.input.max() / mass)
    # the work of the bearing's force on the ground, by trapezoids
    power = response.structure_acceleration * response.ground_velocity
    work = np.concatenate(([0.0], np.cumsum(0.5 * np.diff(response.time) * (power[1:] + power[:-1]))))
    assert found.absolute == pytest.approx(work.max(), rel=0.02)
    # when the ground has come to rest both are the same
    assert response.energy.absolute_input[-1] / mass == pytest.approx(
        response.energy.input[-1] / mass
        + response.ground_velocity[-1] * (0.5 * response.ground_velocity[-1] + response.velocity[-1])
    )


def test_the_largest_over_periods(motions):
    for motion in motions.values():
        found = uang_bertero_1988.maximum_input_energies(motion)
        spectrum = input_energy_spectrum(motion)
        assert found.energies.relative == pytest.approx(spectrum.relative.max())
        assert found.energies.absolute == pytest.approx(spectrum.absolute.max())
        assert found.relative_period in PERIODS
        assert found.duration == significant_duration(motion)
        assert found.unconfirmed
        one = uang_bertero_1988.elastic_input(motion, found.relative_period)
        assert one.relative == pytest.approx(found.energies.relative)
    # each at its own period: of two extremes the stiff one takes more absolute and the soft one more relative energy
    ends = uang_bertero_1988.maximum_input_energies(motions["KNA"], periods=np.array([0.02, 90.0]))
    assert (ends.absolute_period, ends.relative_period) == (0.02, 90.0)
    with pytest.raises(InputError):
        uang_bertero_1988.maximum_input_energies(motions["KNA"], damping=1.0)


def test_the_formula_of_fajfar(motions):
    for motion in motions.values():
        found = fajfar_1989.maximum_input_energy(motion)
        metres = (
            2.2 * significant_duration(motion) ** 0.5 * motion.peak_acceleration * motion.peak_velocity * 1e-6
        )
        assert found.energy == pytest.approx(1e6 * metres)
        assert found.equivalent_velocity == pytest.approx(1000.0 * np.sqrt(2.0 * metres))
        assert "2.2" in found.unconfirmed[0]
        # on these records it exceeds the largest V_E of the spectrum, by less than four times
        largest = uang_bertero_1988.maximum_input_energies(motion).energies.relative_velocity
        assert largest < found.equivalent_velocity < 4.0 * largest


def test_its_powers():
    one = fajfar_1989.maximum_input_energy(harmonic(1000.0, 1.0, 10.0))
    assert fajfar_1989.maximum_input_energy(harmonic(3000.0, 1.0, 10.0)).energy == pytest.approx(
        9.0 * one.energy
    )
    longer = fajfar_1989.maximum_input_energy(harmonic(1000.0, 1.0, 40.0))
    assert longer.energy / one.energy == pytest.approx(2.0, rel=0.03)
    assert fajfar_1989.maximum_input_energy(GroundMotion(np.zeros(10), 0.01)).energy == 0.0
