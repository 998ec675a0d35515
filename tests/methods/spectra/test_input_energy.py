"""Input energies against balances, a Fourier transform, quadrature on a fine grid, and an independent program."""

import numpy as np
import pytest
from scipy import signal

from dcfp.methods.spectra import input_energy_spectrum, response_spectrum
from dcfp.motion import GroundMotion, named_motion
from dcfp.motion.treatment import resample

SOME = np.array([0.3, 0.7, 1.5, 3.0, 6.0])


def oscillator(motion, period, damping):
    """Displacement and velocity at the samples, by a complex mode; exact for acceleration that is linear between them.

    z' = lambda z - a_g with lambda = - h omega + i omega_d gives u = Im(z) / omega_d and v = Im(lambda z) / omega_d.
    """
    omega, dt = 2.0 * np.pi / period, motion.time_step
    free = omega * np.sqrt(1.0 - damping**2)
    mode = complex(-damping * omega, free)
    over = np.exp(mode * dt)
    end = (over - 1.0 - mode * dt) / (mode**2 * dt)
    start = (over - 1.0) / mode - end
    a = motion.acceleration
    given = np.concatenate(([0.0], -start * a[:-1] - end * a[1:]))
    z = signal.lfilter([1.0], [1.0, -over], given)
    return z.imag / free, (mode * z).imag / free


def fourier_amplitude(motion, period):
    """Amplitude of the transform of the piecewise linear acceleration: that of the samples times sinc^2, with half triangles at the ends."""
    omega, dt = 2.0 * np.pi / period, motion.time_step
    a = motion.acceleration
    x = omega * dt
    whole = (np.sin(0.5 * x) / (0.5 * x)) ** 2
    start = (1.0 - 1j * x - np.exp(-1j * x)) / x**2  # of the half triangle that falls from 1 to 0
    weights = np.full(a.size, whole, dtype=complex)
    weights[0], weights[-1] = start, np.conj(start)
    return abs(dt * np.sum(weights * a * np.exp(-1j * omega * motion.time)))


def test_an_undamped_oscillator_keeps_what_it_is_given(record):
    # E at the end = v^2 / 2 + omega^2 u^2 / 2, and that is half the squared Fourier amplitude of the ground acceleration
    found = input_energy_spectrum(record, SOME, 0.0)
    for period, energy in zip(SOME, found.final, strict=True):
        u, v = oscillator(record, period, 0.0)
        stored = 0.5 * v[-1] ** 2 + 0.5 * (2.0 * np.pi / period * u[-1]) ** 2
        # both sum thousands of steps; they differ by rounding only
        assert energy == pytest.approx(stored, rel=1e-8)
        assert energy == pytest.approx(0.5 * fourier_amplitude(record, period) ** 2, rel=1e-8)


@pytest.mark.parametrize("damping", [0.05, 0.2])
def test_the_balance_with_damping(damping):
    motion = named_motion("NCC")
    fine = resample(motion, 40)
    found = input_energy_spectrum(motion, SOME, damping)
    for period, energy in zip(SOME, found.final, strict=True):
        omega = 2.0 * np.pi / period
        u, v = oscillator(fine, period, damping)
        dissipated = 2.0 * damping * omega * np.trapezoid(v**2, dx=fine.time_step)
        # trapezoids at 40 to a sample
        assert energy == pytest.approx(0.5 * v[-1] ** 2 + 0.5 * (omega * u[-1]) ** 2 + dissipated, rel=1e-6)


def test_both_energies_by_quadrature(record):
    # largest at the samples of the record, as the spectrum has it; trapezoids at eight to a sample
    fine = resample(record, 8)
    found = input_energy_spectrum(record, SOME, 0.1)
    for j, period in enumerate(SOME):
        u, v = oscillator(fine, period, 0.1)
        omega = 2.0 * np.pi / period
        relative = np.concatenate(([0.0], np.cumsum(_steps(-fine.acceleration * v, fine))))
        total = -2.0 * 0.1 * omega * v - omega**2 * u
        absolute = np.concatenate(([0.0], np.cumsum(_steps(total * fine.velocity, fine))))
        assert found.relative[j] == pytest.approx(relative[::8].max(), rel=1e-3)
        assert found.absolute[j] == pytest.approx(absolute[::8].max(), rel=1e-3)
        # E_abs - E = v_g (v_g / 2 + v), at every time
        excess = fine.velocity * (0.5 * fine.velocity + v)
        np.testing.assert_allclose(absolute - relative, excess, rtol=0.0, atol=1e-3 * absolute.max())


def _steps(values, motion):
    return 0.5 * motion.time_step * (values[1:] + values[:-1])


def test_the_absolute_energy_ends_as_the_relative_one_where_the_ground_rests():
    # v_g = 0 at the end, so the largest absolute energy is no less than the relative one there
    values = np.concatenate((np.sin(np.linspace(0.0, 2.0 * np.pi, 101)) * 300.0, np.zeros(2000)))
    found = input_energy_spectrum(GroundMotion(values, 0.01), SOME, 0.0)
    assert (found.absolute >= found.final * (1.0 - 1e-9)).all()


@pytest.mark.parametrize("name", ["KNA", "NCC"])
def test_against_eqsig(name):
    # eqsig sums - a v dt at the samples: a rectangle rule, within 1 % at 8 to a sample; it steps in Python, so the two short records
    sdof = pytest.importorskip("eqsig.sdof")
    record = named_motion(name)
    fine = resample(record, 8)
    _, v, _ = sdof.response_series(fine.acceleration, fine.time_step, SOME, 0.05)
    expected = np.sum(-fine.acceleration * v, axis=1) * fine.time_step
    assert input_energy_spectrum(record, SOME).final == pytest.approx(np.abs(expected), rel=0.01)


def test_the_same_displacements_as_the_response_spectrum(record):
    # which looks at the samples only, 100 of them and more in a period: 1 - cos(pi / 100) = 5e-4 of a sine
    energy, response = input_energy_spectrum(record, SOME), response_spectrum(record, SOME)
    assert energy.displacement == pytest.approx(response.displacement, rel=1e-3)


def test_peaks_at_the_samples(record):
    found = input_energy_spectrum(record, SOME, 0.05)
    for j, period in enumerate(SOME):
        u, v = oscillator(record, period, 0.05)
        omega = 2.0 * np.pi / period
        assert found.velocity[j] == pytest.approx(np.abs(v).max(), rel=1e-9)
        total = np.abs(2.0 * 0.05 * omega * v + omega**2 * u).max()
        assert found.total_acceleration[j] == pytest.approx(total, rel=1e-9)


def test_equivalent_velocity_and_scale(record):
    one, other = input_energy_spectrum(record, SOME), input_energy_spectrum(record.scaled(-3.0), SOME)
    assert one.equivalent_velocity == pytest.approx(np.sqrt(2.0 * one.relative))
    assert other.relative == pytest.approx(9.0 * one.relative, rel=1e-9)
    assert (one.relative >= one.final * (1.0 - 1e-12)).all()
