"""Response spectra against closed forms, scipy's simulation, an independent program (eqsig), and laws of scale and sampling."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import signal

from dcfp.errors import InputError
from dcfp.methods.spectra import response_spectrum
from dcfp.methods.spectra.of_record import PERIODS, spectrum_of_set
from dcfp.motion import GroundMotion, named_motion
from dcfp.motion.synthetic import harmonic
from dcfp.motion.treatment import resample

SOME = np.array([0.2, 0.5, 1.0, 2.0, 4.0, 8.0])
#: 1 - cos(pi / 100): what a sine's largest exceeds its samples by, at the 100 in a period from which on nothing is looked for between them.
SAMPLED = 5e-4


@pytest.mark.parametrize("damping", [0.0, 0.05, 0.3])
def test_a_step_of_acceleration(damping):
    motion = GroundMotion(np.full(4001, 100.0), 0.005)
    overshoot = 1.0 + np.exp(-damping * np.pi / np.sqrt(1.0 - damping**2))
    expected = 100.0 * (SOME / (2.0 * np.pi)) ** 2 * overshoot
    # a parabola between the samples, and from 100 of them in a period on the samples alone
    assert response_spectrum(motion, SOME, damping).displacement == pytest.approx(expected, rel=SAMPLED)


def test_free_vibration_after_a_short_pulse():
    # a triangle of height A and base 2 b leaves an undamped oscillator with the amplitude A b sinc^2 / omega
    height, half = 500.0, 0.1
    rise = np.linspace(0.0, height, 51)
    values = np.concatenate((rise, rise[-2::-1], np.zeros(6000)))
    omega = 2.0 * np.pi / SOME[1:]
    expected = height * half * (np.sin(0.5 * omega * half) / (0.5 * omega * half)) ** 2 / omega
    found = response_spectrum(GroundMotion(values, half / 50), SOME[1:], 0.0)
    assert found.displacement == pytest.approx(expected, rel=SAMPLED)


@pytest.mark.parametrize("damping", [0.02, 0.05, 0.2])
def test_resonance(damping):
    # from rest u = A / (2 h omega^2) (1 - exp(-h omega t)) once the damping is small; after 60 cycles the steady state is there
    period, amplitude = 1.0, 200.0
    motion = harmonic(amplitude, period, 60.0, phase=np.pi / 2)
    steady = amplitude / (2.0 * damping * (2.0 * np.pi) ** 2)
    found = float(response_spectrum(motion, np.array([period]), damping).displacement[0])
    # the largest of 60 cycles, at 200 samples in each
    assert found == pytest.approx(steady * (1.0 - np.exp(-damping * 2.0 * np.pi * 60.0)), rel=3e-4)


@pytest.mark.slow
def test_against_scipy():
    motion = named_motion("IVD")
    fine = resample(motion, 16)
    periods, h = np.array([0.3, 1.0, 3.0]), 0.05
    # side by side in one system, whose steps are simulated in Python
    omega = np.diag(2.0 * np.pi / periods)
    nothing, one = np.zeros((3, 3)), np.eye(3)
    system = (
        np.block([[nothing, one], [-(omega**2), -2.0 * h * omega]]),
        np.concatenate((np.zeros(3), -np.ones(3)))[:, None],
        np.hstack((one, nothing)),
        np.zeros((3, 1)),
    )
    _, output, _ = signal.lsim(system, fine.acceleration, fine.time)
    found = response_spectrum(motion, periods, h).displacement
    assert found == pytest.approx(np.abs(output).max(axis=0), rel=SAMPLED)


@pytest.mark.parametrize("name", ["KNA", "NCC"])
def test_against_eqsig(name):
    # eqsig 1.2.17 (M. Millen; Nigam and Jennings 1968), which takes peaks at the samples only: given four in place of one;
    # it steps in Python, so the two short records
    sdof = pytest.importorskip("eqsig.sdof")
    record = named_motion(name)
    periods = np.geomspace(0.1, 10.0, 60)
    fine = resample(record, 4)
    expected, _, _ = sdof.pseudo_response_spectra(fine.acceleration, fine.time_step, periods, 0.05)
    found = response_spectrum(record, periods).displacement
    assert found == pytest.approx(expected, rel=0.005)


def test_resampling_changes_little(record):
    coarse, fine = (response_spectrum(motion).displacement for motion in (record, resample(record, 5)))
    # where the ground's acceleration changes from sample to sample more than the oscillator's, its turn between them is not quite a parabola
    assert coarse == pytest.approx(fine, rel=3e-3)
    assert np.median(np.abs(coarse / fine - 1.0)) < 1e-4
    long = 100.0 * record.time_step < PERIODS
    assert coarse[long] == pytest.approx(fine[long], rel=1e-3)


@given(factor=st.floats(0.1, 10.0), damping=st.floats(0.0, 0.5))
@settings(max_examples=20)
def test_scale_and_sign(factor, damping):
    motion = named_motion("KNA")
    one, other = (response_spectrum(m, SOME, damping) for m in (motion, motion.scaled(-factor)))
    assert other.displacement == pytest.approx(factor * one.displacement, rel=1e-9)


def test_limits_of_stiff_and_soft(record):
    stiff = response_spectrum(record, np.array([0.01]), 0.05)
    assert stiff.pseudo_acceleration[0] == pytest.approx(record.peak_acceleration, rel=0.05)
    soft = response_spectrum(record, np.array([100.0]), 0.0)
    assert soft.displacement[0] == pytest.approx(record.peak_displacement, rel=0.25)


def test_three_spectra_of_one(record):
    found = response_spectrum(record, SOME)
    omega = 2.0 * np.pi / SOME
    assert found.pseudo_acceleration == pytest.approx(omega**2 * found.displacement)
    assert found.acceleration(SOME) == pytest.approx(found.pseudo_acceleration)


def test_a_set():
    motion = named_motion("KNA")
    spectra = [response_spectrum(motion.scaled(factor), SOME) for factor in (1.0, 2.0, 4.0)]
    assert spectrum_of_set(spectra).displacement == pytest.approx(2.0 * spectra[0].displacement)
    assert spectrum_of_set(spectra, 0.5).displacement == pytest.approx(spectra[1].displacement)
    with pytest.raises(InputError, match="same periods"):
        spectrum_of_set([spectra[0], response_spectrum(motion, SOME[1:])])
    with pytest.raises(InputError, match="between 0 and 1"):
        spectrum_of_set(spectra, 1.0)
    with pytest.raises(InputError, match="at least one"):
        spectrum_of_set([])


@pytest.mark.parametrize(
    ("periods", "damping"),
    [([], 0.05), ([np.nan], 0.05), ([2.0, 1.0], 0.05), ([1.0, 1.0], 0.05), ([0.001, 1.0], 0.05), ([200.0], 0.05), ([1.0], 1.0), ([1.0], -0.1)],
)  # fmt: skip
def test_refusals(periods, damping):
    with pytest.raises(InputError):
        response_spectrum(named_motion("KNA"), np.array(periods), damping)
