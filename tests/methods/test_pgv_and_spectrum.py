"""The design method with a spectrum: what goes into it, what it keeps, and how it scatters."""

import math

import numpy as np
import pytest

from dcfp.inference.case import compare
from dcfp.inference.forecast import BY_SPECTRUM, calibration_set, cases_at, forecast
from dcfp.inference.statistics import ratios, scatter
from dcfp.methods import predict_with_spectrum
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.li_2020 import LI_2020, predict_from_pgv
from dcfp.methods.method import Information, Variant
from dcfp.methods.pgv_and_spectrum import FACTOR, NAME, POWER, spectral_change_ratio
from dcfp.methods.prediction import Ground, Methods
from dcfp.methods.pulses import CHANGE, DISPLACEMENT, TOTAL
from dcfp.methods.spectra.elastic import TabulatedSpectrum, velocity

RADIUS = 9000.0


def flat(pseudo_velocity: float) -> TabulatedSpectrum:
    """A spectrum of one pseudo-velocity [mm/s]."""
    periods = np.geomspace(0.05, 20.0, 400)
    return TabulatedSpectrum(periods, pseudo_velocity * 2.0 * np.pi / periods, "flat")


def test_with_one_pseudo_velocity_it_is_the_design_method_with_that_zeta() -> None:
    said = predict_with_spectrum(500.0, flat(600.0), RADIUS, LI_2020)
    assert said is not None
    zeta = FACTOR * (600.0 / 500.0) ** POWER
    base = predict_from_pgv(500.0, LI_2020).displacement_change
    assert said[0].displacement_change == pytest.approx(base * (zeta / LI_2020.change_ratio) ** 2, rel=1e-6)


def test_the_period_is_that_of_the_displacement_that_is_said() -> None:
    spectrum = TabulatedSpectrum(np.array([0.1, 1.0, 8.0]), np.array([9000.0, 6000.0, 300.0]), "falling")
    said = predict_with_spectrum(500.0, spectrum, RADIUS, LI_2020)
    assert said is not None
    prediction, period = said
    pendulum = PendulumWithFriction(RADIUS, LI_2020.nominal_friction)
    assert pendulum.effective_period(prediction.displacement_change) == pytest.approx(period, rel=1e-8)
    ratio = spectral_change_ratio(spectrum, 500.0, period)
    assert ratio == pytest.approx(FACTOR * (float(velocity(spectrum, period)) / 500.0) ** POWER)
    base = predict_from_pgv(500.0, LI_2020).displacement_change
    assert prediction.displacement_change == pytest.approx(
        base * (ratio / LI_2020.change_ratio) ** 2, rel=1e-6
    )


def test_a_stronger_spectrum_at_the_same_pgv_goes_further() -> None:
    found = [predict_with_spectrum(500.0, flat(one), RADIUS, LI_2020) for one in (300.0, 600.0, 1200.0)]
    changes = [one[0].displacement_change for one in found if one is not None]
    assert len(changes) == 3
    assert changes == sorted(changes)


def test_it_is_said_only_where_a_spectrum_is_known() -> None:
    variant = Variant(NAME, Information.SPECTRUM)
    assert variant not in forecast(Ground(500.0), Methods()).predicted
    assert variant in forecast(Ground(500.0, spectrum=flat(600.0)), Methods()).predicted
    assert variant not in compare("NCC").predicted
    assert variant in compare("NCC", codes=True).predicted


def test_a_pgv_with_a_spectrum_has_the_interval_that_knows_it() -> None:
    cases = cases_at(500.0, Methods())
    found = [forecast(Ground(500.0, spectrum=flat(one)), Methods(), cases) for one in (450.0, 700.0)]
    weak, strong = (one.intervals[BY_SPECTRUM] for one in found)
    assert set(weak) == set(found[0].intervals[None]) - {TOTAL}
    for quantity in (CHANGE, DISPLACEMENT):
        assert weak[quantity].median < strong[quantity].median
        ends = [math.log(one[quantity].high / one[quantity].low) for one in (weak, found[0].intervals[None])]
        assert ends[0] < ends[1]


@pytest.mark.slow
def test_it_scatters_less_than_the_pgv_alone() -> None:
    over: list[float] = []
    for pgv in (250.0, 500.0, 750.0, 1000.0):
        cases = [compare(motion.scaled_to_pgv(pgv), codes=True) for motion in calibration_set()]
        alone, knowing = (
            scatter(ratios(cases, Variant(*one), DISPLACEMENT)).dispersion
            for one in (("design", Information.PGV), (NAME, Information.SPECTRUM))
        )
        over.append(knowing / alone)
    assert np.mean(over) < 0.8
