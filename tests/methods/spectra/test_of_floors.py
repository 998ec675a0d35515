"""Broadening of floor spectra."""

import numpy as np
import pytest

import dcfp
from dcfp import InputError
from dcfp.analysis.plan import respond_plan
from dcfp.methods.spectra.of_floors import broadened, floor_spectra
from dcfp.system.plan import Plan, grid


def test_a_peak_becomes_a_plateau_of_the_frequencies_beside_it() -> None:
    periods = np.geomspace(0.05, 10.0, 400)
    values = np.exp(-0.5 * (np.log(periods) / 0.01) ** 2)  # a peak at one second
    wide = broadened(periods, values, 0.15)
    frequencies = 1.0 / periods
    # one hertz lies between (1 - 0.15) f and (1 + 0.15) f
    inside = (0.85 * frequencies < 0.999) & (1.15 * frequencies > 1.001)
    outside = (0.85 * frequencies > 1.05) | (1.15 * frequencies < 0.95)
    assert (wide[inside] > 0.9 * values.max()).all()
    assert (wide[outside] < 0.01).all()
    np.testing.assert_array_equal(broadened(periods, values, 0.0), values)


def test_the_slab_of_a_rigid_structure() -> None:
    motion = dcfp.load_station("P695-FF-2")
    assert motion is not None
    plan = Plan(grid([0.0, 6000.0], [0.0, 6000.0]), height=0.0)
    response = respond_plan(plan, motion.scaled_to_pgv(500.0), tail=0.0)
    spectra = floor_spectra(response, np.array([0.01, 1.0]), broadening=0.1)
    assert spectra.acceleration.shape == (1, 2, 2)
    # an oscillator of 100 Hz goes with the slab
    assert spectra.acceleration[0, 0, 0] == pytest.approx(np.abs(response.floor_acceleration[:, 0, 0]).max(), rel=0.1)  # fmt: skip
    with pytest.raises(InputError, match="broadening"):
        floor_spectra(response, broadening=0.9)
