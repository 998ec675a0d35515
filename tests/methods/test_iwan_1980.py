"""Iwan's equivalent system against its own definition and its limits; that its constants are right could not be confirmed."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from dcfp import LI_2020
from dcfp.errors import AnalysisError, InputError
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.iwan_1980 import (
    MOST_DAMPING,
    Bilinear,
    added_damping,
    equivalent_linear,
    equivalent_oscillator,
    lengthening,
)
from dcfp.methods.spectra import response_spectrum
from dcfp.methods.spectra.of_record import LONGEST
from dcfp.motion import GroundMotion
from dcfp.motion.synthetic import harmonic
from dcfp.schema.check import Verdict

#: Second stiffness over the first [-].
HARDENING = LI_2020.restoring_stiffness / (LI_2020.restoring_stiffness + LI_2020.elastic_stiffness)


def secant(ductility, hardening=HARDENING):
    """Return the rule of the secant stiffness and the loop's area, which follows from the mechanics without a fit."""
    force = 1.0 + hardening * (max(ductility, 1.0) - 1.0)
    damping = 2.0 / np.pi * (1.0 - hardening) * (max(ductility, 1.0) - 1.0) / (max(ductility, 1.0) * force)
    return np.sqrt(max(ductility, 1.0) / force), damping


def iwan(ductility):
    return lengthening(ductility), added_damping(ductility)


def test_the_two_formulas():
    assert lengthening(1.0) == 1.0
    assert added_damping(1.0) == 0.0
    assert lengthening(2.0) == pytest.approx(1.121)
    assert added_damping(2.0) == pytest.approx(0.0587)
    assert lengthening(5.0) == pytest.approx(1.0 + 0.121 * 4.0**0.939)
    assert added_damping(5.0) == pytest.approx(0.0587 * 4.0**0.371)
    assert lengthening(0.3) == 1.0  # does not yield


def test_the_bilinear_system():
    system = Bilinear.of(LI_2020, 0.043)
    # springs of LI_2020: kra 838 N/mm, kf 1.9e6 N/mm; rf = mu N / kf
    assert pytest.approx(837.76 / (837.76 + 1.9e6), rel=1e-5) == HARDENING
    assert system.yield_displacement == pytest.approx(0.043 * LI_2020.vertical_force / 1.9e6)
    assert system.initial_period == pytest.approx(LI_2020.period * np.sqrt(HARDENING), rel=1e-9)
    for wrong in (0.0, 1.0):
        with pytest.raises(InputError):
            Bilinear.of(LI_2020, wrong)


@given(ductility=st.floats(2.0, 5e3))
def test_the_secant_of_a_stiff_bearing_is_the_rigid_plastic_one(ductility):
    system = Bilinear.of(LI_2020, 0.043)
    at = ductility * system.yield_displacement
    pendulum = PendulumWithFriction(LI_2020.effective_radius, 0.043)
    lengthened, damping = secant(ductility)
    # the elastic displacement before yielding is in one and not in the other
    assert system.initial_period * lengthened == pytest.approx(pendulum.effective_period(at), rel=1e-3)
    assert damping == pytest.approx(pendulum.effective_damping(at) * (1.0 - 1.0 / ductility), rel=1e-2)


@given(hardening=st.floats(0.0, 0.9), ductility=st.floats(1.01, 50.0))
def test_the_secant_of_a_polygon(hardening, ductility):
    # yields at 1 under 1, and is turned back at the ductility: corners of the loop, and its area by the shoelace formula
    force = 1.0 + hardening * (ductility - 1.0)
    corners = np.array([(ductility, force), (ductility - 2.0, force - 2.0)])
    x, y = np.concatenate((corners, -corners)).T
    area = 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
    lengthened, damping = secant(ductility, hardening)
    assert lengthened == pytest.approx(np.sqrt(ductility / force))
    assert damping == pytest.approx(area / (2.0 * np.pi * force * ductility), abs=1e-12)


@pytest.mark.parametrize("pgv", [250.0, 1000.0])
@pytest.mark.parametrize("rule", [iwan, secant])
def test_the_answer_is_that_of_its_own_oscillator(motions, pgv, rule):
    for motion in motions.values():
        motion = motion.scaled_to_pgv(pgv)
        last = equivalent_oscillator(motion, Bilinear.of(LI_2020, 0.043), rule)[-1]
        own = response_spectrum(motion, np.array([last.period]), last.damping)
        assert own.displacement[0] == pytest.approx(last.displacement, rel=1e-6)
        usual = response_spectrum(motion, np.array([last.period]), 0.05)
        assert last.reduction == pytest.approx(own.displacement[0] / usual.displacement[0])
        if rule is iwan:
            answer = equivalent_linear(motion, LI_2020, 0.043)
            assert answer.steps[-1] == last
            assert answer.base_shear == pytest.approx(0.043 + last.displacement / 9000.0)


def test_a_friction_bearing_is_outside_the_fit(motions):
    for motion in motions.values():
        answer = equivalent_linear(motion)
        ductility = answer.conditions[0]
        assert ductility.verdict is Verdict.NOT_MET
        assert not ductility.confirmed
        assert float(ductility.found) > 100.0
        assert answer.valid is False
        assert "0.121" in answer.unconfirmed[0]
        harmonic_one = answer.conditions[-1]
        assert harmonic_one.verdict is Verdict.MET
        assert not harmonic_one.confirmed


def test_damping_and_period_are_clipped_and_say_so(motions):
    answer = equivalent_linear(motions["IVD"].scaled_to_pgv(1000.0))
    assert answer.damping == MOST_DAMPING
    assert any("no oscillator has" in remark for remark in answer.remarks)
    # a period beyond the pendulum's is mechanically impossible, and is said too
    assert answer.conditions[1].verdict is Verdict.NOT_MET
    slippery = equivalent_linear(motions["IVD"].scaled_to_pgv(1000.0), LI_2020, 1e-4)
    assert slippery.period == LONGEST
    assert any("the longest" in remark for remark in slippery.remarks)


def test_what_does_not_yield_is_elastic(motions):
    motion = motions["KNA"].scaled(1e-4)
    answer = equivalent_linear(motion)
    system = Bilinear.of(LI_2020, 0.043)
    own = response_spectrum(motion, np.array([system.initial_period]), 0.0)
    assert answer.displacement == pytest.approx(own.displacement[0])
    assert answer.displacement < system.yield_displacement
    assert (answer.period, answer.damping) == (pytest.approx(system.initial_period), 0.0)
    stiffness = (LI_2020.restoring_stiffness + LI_2020.elastic_stiffness) / LI_2020.vertical_force
    assert answer.base_shear == pytest.approx(stiffness * answer.displacement)
    # a ductility below those of the fit: neither within nor outside
    assert answer.conditions[0].verdict is Verdict.NOT_KNOWN
    assert answer.valid is None


def test_rounds_that_do_not_settle_are_halved(motions):
    # a period that falls steeply where the displacement is 100 mm: each round ends on the other side
    def rule(ductility):
        return 0.25 + 2.0 / (1.0 + (min(ductility, 1e3) / 10.0) ** 12), 0.05

    steps = equivalent_oscillator(motions["LPG"], Bilinear(2.0, 10.0), rule)
    assert len(steps) == 1
    at = steps[0]
    own = response_spectrum(motions["LPG"], np.array([at.period]), at.damping)
    assert own.displacement[0] == pytest.approx(at.displacement, rel=1e-6)


def test_no_solution_within_reach(motions):
    with pytest.raises(AnalysisError, match="no equivalent oscillator"):
        equivalent_oscillator(motions["LPG"].scaled(1e7), Bilinear.of(LI_2020, 0.043), secant)


def test_no_motion():
    with pytest.raises(AnalysisError, match="does not move"):
        equivalent_linear(GroundMotion(np.zeros(100), 0.01))


def test_within_the_fit_it_may_be_used():
    soft = LI_2020.unchecked(elastic_stiffness=0.043 * LI_2020.vertical_force / 20.0)
    answer = equivalent_linear(harmonic(600.0, 1.0, 2.0), soft, 0.043)
    assert 2.0 < float(answer.conditions[0].found) < 8.0
    assert answer.conditions[0].verdict is Verdict.MET
    assert answer.conditions[1].verdict is Verdict.MET
