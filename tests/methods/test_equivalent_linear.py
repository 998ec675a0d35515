"""The equivalent system against its own loop, and the iteration against roots that are known."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import optimize

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import AnalysisError, InputError
from dcfp.methods.asce_2016 import Asce2016Spectrum
from dcfp.methods.code import CodeResult
from dcfp.methods.equivalent_linear import PendulumWithFriction, iterate
from dcfp.methods.spectra import TabulatedSpectrum
from dcfp.methods.spectra.elastic import displacement
from dcfp.schema.check import Check, Verdict, at_least, at_most

radii, frictions, displacements = st.floats(500.0, 2e4), st.floats(0.005, 0.2), st.floats(5.0, 2e3)


@given(radius=radii, friction=frictions, at=displacements)
def test_the_loop(radius, friction, at):
    pendulum = PendulumWithFriction(radius, friction)
    # the rigid-plastic loop: 4 mu W D, against 2 pi k D^2 of its secant
    loop = 4.0 * friction * at
    secant = pendulum.force(at) / at
    assert pendulum.effective_stiffness(at) == pytest.approx(secant)
    assert pendulum.effective_damping(at) == pytest.approx(loop / (2.0 * math.pi * secant * at**2))
    assert pendulum.effective_period(at) == pytest.approx(
        2.0 * math.pi / math.sqrt(secant * STANDARD_GRAVITY)
    )
    assert pendulum.effective_period(at) < pendulum.free_period
    assert pendulum.force(at) - pendulum.force(0.0) == pytest.approx(at / radius)
    assert pendulum.rest == pytest.approx(friction * radius)


def test_limits(pendulum):
    far, near = 1e9, 1e-9
    assert pendulum.effective_period(far) == pytest.approx(pendulum.free_period)
    assert pendulum.effective_damping(far) == pytest.approx(0.0, abs=1e-6)
    assert pendulum.effective_damping(near) == pytest.approx(2.0 / math.pi)


@pytest.mark.parametrize(
    ("radius", "friction"), [(0.0, 0.04), (-1.0, 0.04), (9000.0, 0.0), (9000.0, 1.0), (math.nan, 0.04)]
)
def test_refusals(radius, friction):
    with pytest.raises(InputError):
        PendulumWithFriction(radius, friction)


@given(one_second=st.floats(0.2, 1.5), friction=st.floats(0.02, 0.1))
def test_the_iteration_finds_the_root(one_second, friction):
    pendulum = PendulumWithFriction(9000.0, friction)
    spectrum = Asce2016Spectrum(4.0 * one_second, one_second, 20.0)

    def reduction(damping):
        return 1.0 / (1.0 + 4.0 * damping)

    def surplus(at):
        return (
            float(displacement(spectrum, pendulum.effective_period(at)))
            * reduction(pendulum.effective_damping(at))
            - at
        )

    last = iterate(pendulum, spectrum, reduction)[0][-1]
    root = optimize.brentq(surplus, 1e-2, 1e5, xtol=1e-10, rtol=1e-13)
    assert last.displacement == pytest.approx(root, rel=1e-8)
    assert last.period == pytest.approx(pendulum.effective_period(root), rel=1e-8)
    assert last.reduction == pytest.approx(reduction(last.damping))


def test_rounds_that_do_not_settle_are_halved():
    # no reduction, and an acceleration that falls so steeply that each round overshoots the one before
    periods = np.geomspace(0.1, 10.0, 100)
    spectrum = TabulatedSpectrum(periods, 3000.0 * periods**-7.0)
    pendulum = PendulumWithFriction(9000.0, 0.043)
    steps, _ = iterate(pendulum, spectrum, lambda _: 1.0)
    assert len(steps) == 1
    found = steps[0].displacement
    assert float(displacement(spectrum, pendulum.effective_period(found))) == pytest.approx(found, rel=1e-6)


def test_no_solution():
    # without reduction and with accelerations of 1000 g there is none below 100 m
    spectrum = TabulatedSpectrum(np.array([0.01, 1000.0]), np.array([1e7, 1e7]))
    with pytest.raises(AnalysisError, match="at no displacement"):
        iterate(PendulumWithFriction(9000.0, 0.043), spectrum, lambda _: 1.0)


def test_verdicts():
    assert at_most(1.0, 1.0) is at_least(1.0, 1.0) is Verdict.MET
    assert at_most(1.1, 1.0) is at_least(0.9, 1.0) is Verdict.NOT_MET
    conditions = [Check("", verdict, "", "", "") for verdict in Verdict]
    answers = {
        1: CodeResult("", 1.0, 0.1, conditions=(conditions[0],)),
        2: CodeResult("", 1.0, 0.1, conditions=tuple(conditions)),
        3: CodeResult("", 1.0, 0.1, conditions=(conditions[0], conditions[2])),
    }
    assert [answers[key].valid for key in answers] == [True, False, None]
    assert answers[1].verdict == "within its limits"
    assert answers[2].verdict == "outside its limits (1)"
    assert answers[3].verdict == "within its limits, 1 not known"
