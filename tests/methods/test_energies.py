"""Input energies after Uang and Bertero, and the formula of Fajfar, Vidic and Fischinger."""

import numpy as np
import pytest

from dcfp import ConstantFriction, NoHeating, respond
from dcfp.errors import InputError
from dcfp.methods.spectra import input_energy_spectrum
from dcfp.methods.spectra.of_record import PERIODS
from dcfp.methods.uang_bertero_1988 import largest_input
from dcfp.motion import GroundMotion
from dcfp.motion.measures import significant_duration
from dcfp.motion.synthetic import harmonic


def energies(motion, period, damping):
    """Return the relative and the absolute input energy of an elastic oscillator [mm2/s2]."""
    spectrum = input_energy_spectrum(motion, np.array([period]), damping)
    return float(spectrum.relative[0]), float(spectrum.absolute[0])


def test_stiff_takes_absolute_and_soft_takes_relative_energy(motions):
    # Uang and Bertero's limits: a stiff system moves with the ground (E_abs = v_g^2 / 2 at most, E_rel to 0), a soft one stays (the other way round)
    for motion in motions.values():
        stiff_relative, stiff_absolute = energies(motion, 0.02, 0.05)
        soft_relative, soft_absolute = energies(motion, 90.0, 0.05)
        ground = 0.5 * motion.peak_velocity**2
        assert stiff_absolute == pytest.approx(ground, rel=0.05)
        assert stiff_relative < 0.05 * ground
        assert soft_relative == pytest.approx(ground, rel=0.1)
        assert soft_absolute < 0.1 * ground


def test_of_the_sliding_structure(motions):
    response = respond(motions["NCC"], friction=ConstantFriction(0.043), heating=NoHeating())
    mass = response.bearing.mass
    # the work of the bearing's force on the ground, by trapezoids
    power = response.structure_acceleration * response.ground_velocity
    work = np.concatenate(([0.0], np.cumsum(0.5 * np.diff(response.time) * (power[1:] + power[:-1]))))
    assert response.energy.absolute_input.max() / mass == pytest.approx(work.max(), rel=0.02)
    # when the ground has come to rest both are the same
    assert response.energy.absolute_input[-1] / mass == pytest.approx(
        response.energy.input[-1] / mass
        + response.ground_velocity[-1] * (0.5 * response.ground_velocity[-1] + response.velocity[-1])
    )


def test_the_largest_over_periods(motions):
    for motion in motions.values():
        found = largest_input(motion)
        spectrum = input_energy_spectrum(motion)
        assert found.relative == pytest.approx(spectrum.relative.max())
        assert found.absolute == pytest.approx(spectrum.absolute.max())
        assert found.relative_period in PERIODS
        assert found.duration == significant_duration(motion)
        assert found.unconfirmed
        assert energies(motion, found.relative_period, 0.05)[0] == pytest.approx(found.relative)
    # each at its own period: of two extremes the stiff one takes more absolute and the soft one more relative energy
    ends = largest_input(motions["KNA"], periods=np.array([0.02, 90.0]))
    assert (ends.absolute_period, ends.relative_period) == (0.02, 90.0)
    with pytest.raises(InputError):
        largest_input(motions["KNA"], damping=1.0)


def test_the_formula_of_fajfar(motions):
    for motion in motions.values():
        found = largest_input(motion)
        metres = (
            2.2 * significant_duration(motion) ** 0.5 * motion.peak_acceleration * motion.peak_velocity * 1e-6
        )
        assert found.formula == pytest.approx(1e6 * metres)
        assert "2.2" in found.unconfirmed[-1]
        # on these records it exceeds the largest V_E of the spectrum, by less than four times
        assert found.relative < found.formula < 16.0 * found.relative


def test_its_powers():
    one = largest_input(harmonic(1000.0, 1.0, 10.0)).formula
    assert largest_input(harmonic(3000.0, 1.0, 10.0)).formula == pytest.approx(9.0 * one)
    longer = largest_input(harmonic(1000.0, 1.0, 40.0)).formula
    assert longer / one == pytest.approx(2.0, rel=0.03)
    assert largest_input(GroundMotion(np.zeros(10), 0.01)).formula == 0.0
