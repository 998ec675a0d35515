"""Design spectra against the values of their tables and published points, and for jumps."""

import numpy as np
import pytest

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.methods.aij_2016 import Notification2000Spectrum
from dcfp.methods.asce_2016 import Asce2016Spectrum
from dcfp.methods.eurocode_8 import Eurocode8Spectrum
from dcfp.methods.spectra import TabulatedSpectrum
from dcfp.methods.spectra.elastic import displacement, velocity

KINDS = [(kind, ground) for kind in (1, 2) for ground in "ABCDE"]

#: S, T_B, T_C, T_D of EN 1998-1, Tables 3.2 and 3.3, as in rshalib (ROB-Seismology, refspec/en1998.py) and CFCSL/Response_Spectrum.
EN_1998 = {
    (1, "A"): (1.0, 0.15, 0.4, 2.0), (1, "B"): (1.2, 0.15, 0.5, 2.0), (1, "C"): (1.15, 0.2, 0.6, 2.0),
    (1, "D"): (1.35, 0.2, 0.8, 2.0), (1, "E"): (1.4, 0.15, 0.5, 2.0),
    (2, "A"): (1.0, 0.05, 0.25, 1.2), (2, "B"): (1.35, 0.05, 0.25, 1.2), (2, "C"): (1.5, 0.1, 0.25, 1.2),
    (2, "D"): (1.8, 0.1, 0.3, 1.2), (2, "E"): (1.6, 0.05, 0.25, 1.2),
}  # fmt: skip
#: Plateaus of type 1 over a_g: a public transcription of prEN 1998-1.
PLATEAUS = {"A": 2.5, "B": 3.0, "C": 2.875, "D": 3.375, "E": 3.5}


@pytest.mark.parametrize(("kind", "ground"), KINDS)
def test_corners_of_eurocode_8(kind, ground):
    soil, rising, constant, falling = EN_1998[kind, ground]
    spectrum = Eurocode8Spectrum(1000.0, ground, kind)
    plateau = 2.5 * soil * 1000.0
    at = spectrum.acceleration(
        np.array([0.0, 0.5 * rising, rising, constant, 2.0 * constant, falling, 2.0 * falling])
    )
    last = plateau * constant / falling
    expected = [
        soil * 1000.0,
        0.5 * (soil * 1000.0 + plateau),
        plateau,
        plateau,
        0.5 * plateau,
        last,
        0.25 * last,
    ]
    if 2.0 * constant > falling:
        at, expected = np.delete(at, 4), np.delete(expected, 4)
    assert at == pytest.approx(expected, rel=1e-6)


@pytest.mark.parametrize(("ground", "plateau"), PLATEAUS.items())
def test_plateaus_of_eurocode_8(ground, plateau):
    assert Eurocode8Spectrum(1000.0, ground).acceleration(0.3) == pytest.approx(plateau * 1000.0)


@pytest.mark.parametrize(
    ("spectrum", "corners"),
    [
        *((Eurocode8Spectrum(2000.0, ground, kind), EN_1998[kind, ground][1:]) for kind, ground in KINDS),
        (Asce2016Spectrum(1.5, 0.9, 6.0), (0.12, 0.6, 6.0)),
        (Notification2000Spectrum(1), (0.16, 0.576, 0.64)),
        (Notification2000Spectrum(2), (0.16, 0.64, 0.864)),
        (Notification2000Spectrum(3), (0.16, 0.64, 1.152)),
    ],
)
def test_no_jumps(spectrum, corners):
    for corner in corners:
        below, above = spectrum.acceleration(np.array([corner - 1e-7, corner + 1e-7]))
        assert below == pytest.approx(above, rel=1e-5)


def test_branches_of_asce():
    spectrum = Asce2016Spectrum(1.5, 0.9, 6.0)
    at = spectrum.acceleration(np.array([0.0, 0.06, 0.12, 0.4, 0.6, 1.0, 3.0, 6.0, 12.0])) / STANDARD_GRAVITY
    assert at == pytest.approx([0.6, 1.05, 1.5, 1.5, 1.5, 0.9, 0.3, 0.15, 0.0375])
    # constant displacement beyond T_L, constant velocity before
    assert displacement(spectrum, 12.0) == pytest.approx(displacement(spectrum, 6.0))
    assert velocity(spectrum, 1.0) == pytest.approx(velocity(spectrum, 5.0))


@pytest.mark.parametrize(
    ("period", "amplification", "tolerance"),
    # published points of class 1 (denmoku-db 2024), printed with four digits; the first is 0.864 / 0.636 = 1.3585
    [(0.636, 1.358, 5e-4), (0.916, 1.350, 1e-9), (0.559, 1.500, 1e-9)],
)
def test_published_amplification_of_soil_1(period, amplification, tolerance):
    found = Notification2000Spectrum(1).amplification(np.array(period))
    assert found == pytest.approx(amplification, rel=tolerance)


def test_published_point_of_soil_2():
    # NILIM Technical Note 1084: S_0 = 4.71 m/s2 at 1.09 s, whose last digit allows 0.5 %, and G_s = 2.025
    spectrum = Notification2000Spectrum(2)
    amplification = spectrum.amplification(np.array(1.09))
    assert amplification == pytest.approx(2.025)
    assert spectrum.acceleration(1.09) / amplification == pytest.approx(4710.0, rel=5e-3)


def test_the_notification_on_bedrock():
    spectrum = Notification2000Spectrum(1)
    periods = np.array([0.08, 0.16, 0.4, 0.64, 1.0, 4.0])
    bedrock = spectrum.acceleration(periods) / spectrum.amplification(periods)
    assert bedrock == pytest.approx([5600.0, 8000.0, 8000.0, 8000.0, 5120.0, 1280.0])
    rare = Notification2000Spectrum(1, level=0.2).acceleration(periods)
    assert rare == pytest.approx(0.2 * spectrum.acceleration(periods))
    assert Notification2000Spectrum(1).unconfirmed == ()
    # soft soil: 1.5 up to 0.64 s, then with the period up to 1.152 s
    soft = Notification2000Spectrum(3).amplification(np.array([0.5, 0.64, 0.9, 1.152, 5.0]))
    assert soft == pytest.approx([1.5, 1.5, 1.5 * 0.9 / 0.64, 2.7, 2.7])


def test_a_table():
    spectrum = TabulatedSpectrum(np.array([0.5, 1.0, 2.0]), np.array([1000.0, 500.0, 250.0]))
    # between the points a power law, before the first constant acceleration, after the last constant displacement
    at = spectrum.acceleration(np.array([0.1, 0.5, 0.8, 2.0, 4.0]))
    assert at == pytest.approx([1000.0, 1000.0, 625.0, 250.0, 62.5])
    for periods, values in (
        ([1.0], [1.0]),
        ([1.0, 1.0], [1.0, 1.0]),
        ([1.0, 2.0], [1.0, 0.0]),
        ([1.0, 2.0], [1.0]),
    ):
        with pytest.raises(InputError):
            TabulatedSpectrum(np.array(periods), np.array(values))


@pytest.mark.parametrize(
    "make",
    [
        lambda: Eurocode8Spectrum(0.0),
        lambda: Eurocode8Spectrum(1000.0, "F"),
        lambda: Eurocode8Spectrum(1000.0, "B", 3),
        lambda: Asce2016Spectrum(-1.0, 0.5),
        lambda: Notification2000Spectrum(4),
    ],
)
def test_refusals(make):
    with pytest.raises(InputError):
        make()
