"""How harmonic a motion is, and that this is what an equivalent system fitted to earthquakes fails at."""

import numpy as np
import pytest

from dcfp import LI_2020, ConstantFriction, NoHeating, respond
from dcfp.errors import AnalysisError
from dcfp.methods.iwan_1980 import Bilinear, equivalent_linear, harmonic_condition, harmonic_share
from dcfp.motion import GroundMotion
from dcfp.motion.synthetic import harmonic, ricker
from dcfp.motion.treatment import resample
from dcfp.schema.check import Verdict

MU = 0.043
#: A bearing so soft before it slides, r_f = 20 mm, that its ductility is within Iwan's fit, and what fails is not that.
SOFT = LI_2020.unchecked(elastic_stiffness=MU * LI_2020.vertical_force / 20.0)


@pytest.mark.parametrize(("cycles", "least"), [(3, 0.5), (10, 0.9), (40, 0.97)])
def test_harmonic_motions_are_harmonic(cycles, least):
    share, period = harmonic_share(harmonic(1000.0, 2.0, cycles))
    assert least < share < 1.0
    assert period == pytest.approx(2.0, rel=0.02)
    assert harmonic_condition(harmonic(1000.0, 2.0, cycles)).verdict is Verdict.NOT_MET


def test_recorded_motions_are_not(motions):
    for motion in motions.values():
        condition = harmonic_condition(motion)
        assert condition.verdict is Verdict.MET
        assert not condition.confirmed
    assert harmonic_share(ricker(500.0, 0.5))[0] < 0.4


def test_the_share_knows_no_scale_and_no_sampling(motions):
    for motion in motions.values():
        share, period = harmonic_share(motion)
        assert harmonic_share(motion.scaled(-3.0)) == pytest.approx((share, period))
        # lines between the samples take away what the sampling had mirrored
        assert harmonic_share(resample(motion, 4)) == pytest.approx((share, period), rel=0.06)


def test_white_noise_has_the_share_of_the_band():
    # constant power up to 50 Hz: the widest band within it has 0.2 of its middle frequency, at most 10 Hz of 50
    noise = np.random.default_rng(1).standard_normal(20_000)
    share, _ = harmonic_share(GroundMotion(noise, 0.01))
    assert share == pytest.approx(0.2, abs=0.03)


def test_no_motion():
    with pytest.raises(AnalysisError, match="does not move"):
        harmonic_share(GroundMotion(np.zeros(10), 0.01))


def ratio(motion):
    """Return the ductility, and the displacement by response history analysis over the estimate; what comes after the motion does not count, as in a spectrum."""
    answer = equivalent_linear(motion, SOFT, MU)
    found = respond(motion, SOFT, ConstantFriction(MU), NoHeating(), tail=0.0)
    return float(answer.conditions[0].found), found.peak_displacement / answer.displacement


def test_iwan_fails_under_harmonic_motion(motions):
    recorded = [ratio(motion.scaled_to_pgv(250.0)) for motion in motions.values()]
    initial = Bilinear.of(SOFT, MU).initial_period
    cases = [(200.0, 1.3), (400.0, 1.3), (400.0, 2.0), (600.0, 2.5)]  # amplitude [mm/s2], period over T_0
    steady = [ratio(harmonic(amplitude, initial * part, 20.0, ramp=3.0)) for amplitude, part in cases]
    # every ductility is within the fit, and none of the recorded motions is harmonic
    assert all(1.0 < ductility < 8.0 for ductility, _ in recorded + steady)
    ratios_recorded, ratios_steady = (np.array([r for _, r in some]) for some in (recorded, steady))
    # within 40 % under records; from 0.4 to 5 times the estimate under a sine
    assert np.abs(np.log(ratios_recorded)).max() < np.log(1.45)
    assert ratios_steady.min() < 0.5
    assert ratios_steady.max() > 3.0
