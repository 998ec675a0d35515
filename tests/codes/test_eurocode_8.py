"""Eurocode 8 against a hand calculation made here, step by step: no published example of an isolated building with a spectrum could be read."""

import math

import numpy as np
import pytest

from dcfp.codes.equivalent_linear import PendulumWithFriction
from dcfp.codes.eurocode_8 import (
    accumulation_factor,
    damping_correction,
    simplified_linear_analysis,
    torsion_factors,
)
from dcfp.codes.result import Verdict
from dcfp.codes.structure import Structure
from dcfp.spectrum.design import Eurocode8Spectrum


def test_by_hand():
    # R 3 m, mu 5 %, a_g 3 m/s2 on ground C of type 1: S 1.15, T_C 0.6 s, T_D 2 s; metres and seconds throughout
    g, radius, mu = 9.80665, 3.0, 0.05
    d = 0.2
    for _ in range(100):
        stiffness = 1.0 / radius + mu / d  # over the weight [1/m]
        period = 2.0 * math.pi / math.sqrt(g * stiffness)
        xi = 2.0 / math.pi * (mu / d) / stiffness
        eta = max(math.sqrt(10.0 / (5.0 + 100.0 * xi)), 0.55)
        shape = 0.6 / period if period <= 2.0 else 0.6 * 2.0 / period**2
        acceleration = 3.0 * 1.15 * eta * 2.5 * shape
        d = acceleration / (g * stiffness)  # M S_e / K_eff
    answer = simplified_linear_analysis(PendulumWithFriction(3000.0, 0.05), Eurocode8Spectrum(3000.0, "C"))
    assert answer.displacement == pytest.approx(1000.0 * d, rel=1e-9)
    assert answer.period == pytest.approx(period, rel=1e-9)
    assert answer.damping == pytest.approx(xi, rel=1e-9)
    # F = M S_e is the bearing's own force at d_dc
    assert answer.base_shear == pytest.approx(acceleration / g, rel=1e-9)


def test_in_closed_form_beyond_the_corner():
    # where T_eff exceeds T_D and the floor of 0.55 holds, d_dc is the constant displacement of the spectrum times 0.55
    answer = simplified_linear_analysis(PendulumWithFriction(9000.0, 0.06), Eurocode8Spectrum(6000.0, "D"))
    assert answer.period > 2.0
    assert answer.damping > 0.2806
    constant = 2.5 * 6000.0 * 1.35 * 0.8 * 2.0 / (2.0 * math.pi) ** 2
    assert answer.displacement == pytest.approx(0.55 * constant, rel=1e-9)


@pytest.mark.parametrize(("damping", "eta"), [(0.05, 1.0), (0.20, 0.6325), (0.30, 0.55), (0.6, 0.55)])
def test_damping_correction(damping, eta):
    # tests of StructAI (a public program): eta(20 %) = 0.6325, eta(30 %) = 0.55
    assert damping_correction(damping) == pytest.approx(eta, abs=5e-5)


def test_torsion():
    # tests of pyntc (NTC 2018, 7.10.4-5): two devices at (+-2, +-1) m of the same stiffness have r_x = sqrt(5) m
    places, stiffness = np.array([[2000.0, 1000.0], [-2000.0, -1000.0]]), np.full((2, 2), 500.0)
    along_x, along_y = torsion_factors(places, stiffness, (500.0, 250.0))
    assert along_y == pytest.approx([1.0 + 0.5 / 5.0 * 2.0, 1.0 - 0.5 / 5.0 * 2.0])
    assert along_x == pytest.approx([1.0 + 0.25 / 5.0, 1.0 - 0.25 / 5.0])
    # and delta = 1 + 0.5 / 2^2 * 2 = 1.25 for r = 2 m: four devices on the axes
    places = 2000.0 * np.array([[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]])
    assert torsion_factors(places, np.ones((4, 2)), (500.0, 0.0))[1][0] == pytest.approx(1.25)


def test_residual_displacements():
    assert accumulation_factor(100.0, 0.2, 100.0) == 1.0
    at = 1.0 + 1.35 * (1.0 - (0.2 / 40.0) ** 0.6) / (1.0 + 80.0 * 0.4**1.5)
    assert accumulation_factor(40.0, 0.2, 100.0) == pytest.approx(at)
    weak = simplified_linear_analysis(PendulumWithFriction(9000.0, 0.043), Eurocode8Spectrum(500.0, "A"))
    assert any("re-centre" in remark for remark in weak.remarks)
    assert any("add up" in word for word in weak.unconfirmed)


def test_conditions(pendulum):
    structure = Structure(0.5, plan=40e3, fault_distance=20e6)
    answer = simplified_linear_analysis(pendulum, Eurocode8Spectrum(6000.0, "D"), structure)
    verdicts = {one.name: one.verdict for one in answer.conditions}
    assert verdicts["larger dimension of the plan"] is Verdict.MET
    assert verdicts["distance to a fault of magnitude 6.5 or more"] is Verdict.MET
    ratio = (1.0 / 9000.0 + 0.043 / answer.displacement) / (1.0 / 9000.0 + 0.215 / answer.displacement)
    assert (verdicts["K_eff(d_dc) over K_eff(0.2 d_dc)"] is Verdict.MET) == (ratio >= 0.5)
    # none was read in the standard itself
    assert not any(one.confirmed for one in answer.conditions)
    assert simplified_linear_analysis(pendulum, Eurocode8Spectrum(6000.0, "D")).verdict.endswith(
        ("known", ")")
    )


def test_the_frictionless_limit():
    answer = simplified_linear_analysis(PendulumWithFriction(1500.0, 1e-7), Eurocode8Spectrum(1000.0, "A"))
    undamped = damping_correction(0.0)
    period = answer.period
    expected = (
        undamped * 2.5 * 1000.0 * 0.4 * 2.0 / max(period, 2.0) / period * (period / (2.0 * math.pi)) ** 2
    )
    assert answer.displacement == pytest.approx(expected, rel=1e-4)
