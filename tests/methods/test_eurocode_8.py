"""Eurocode 8 against a hand calculation made here, step by step: no published example of an isolated building with a spectrum could be read."""

import math

import numpy as np
import pytest

from dcfp.methods.code import CodeInputs, Structure
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.eurocode_8 import (
    EUROCODE_8,
    Eurocode8Spectrum,
    accumulation_factor,
    damping_correction,
    simplified_linear_analysis,
    torsion_factors,
)
from dcfp.schema.check import Verdict


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
    # stiffer along y than along x: r_x^2 over the sum of K_y, r_y^2 over that of K_x
    places, stiffness = (
        np.array([[3.0, 1.0], [-3.0, 1.0], [0.0, -2.0]]),
        np.array([[1.0, 4.0], [1.0, 4.0], [2.0, 1.0]]),
    )
    turning = 9.0 * 4.0 * 2.0 + 1.0 * 1.0 * 2.0 + 4.0 * 2.0
    along_x, along_y = torsion_factors(places, stiffness, (0.2, 0.3))
    assert along_x == pytest.approx(1.0 + 0.3 * np.array([1.0, 1.0, -2.0]) / (turning / 4.0))
    assert along_y == pytest.approx(1.0 + 0.2 * np.array([3.0, -3.0, 0.0]) / (turning / 9.0))


def test_residual_displacements():
    assert accumulation_factor(100.0, 0.2, 100.0) == 1.0
    at = 1.0 + 1.35 * (1.0 - (0.2 / 40.0) ** 0.6) / (1.0 + 80.0 * 0.4**1.5)
    assert accumulation_factor(40.0, 0.2, 100.0) == pytest.approx(at)
    weak = EUROCODE_8.result(CodeInputs(Eurocode8Spectrum(500.0, "A"), PendulumWithFriction(9000.0, 0.043)))
    assert any("re-centre" in remark for remark in weak.remarks)
    assert any("add up" in word for word in weak.unconfirmed)


def test_conditions(pendulum):
    structure = Structure(0.5, plan=40e3, fault_distance=20e6)
    answer = simplified_linear_analysis(pendulum, Eurocode8Spectrum(6000.0, "D"), structure)
    verdicts = {one.name: one.verdict for one in answer.conditions}
    assert verdicts["larger dimension of the plan"] is Verdict.MET
    assert verdicts["distance to a fault of magnitude 6.5 or more"] is Verdict.MET
    d = answer.displacement
    ratio = (1.0 / 9000.0 + 0.043 / d) / (1.0 / 9000.0 + 0.215 / d)
    shown = {one.name: one.found for one in answer.conditions}
    assert shown["K_eff(d_dc) over K_eff(0.2 d_dc)"] == f"{ratio:.2f}"
    assert shown["rise of the force from d_dc/2 to d_dc over the weight"] == f"{0.5 * d / 9000.0:.3f}"
    assert shown["re-centring, d_dc over mu R"] == f"{d / (0.043 * 9000.0):.2f}"
    # none was read in the standard itself
    assert not any(one.confirmed for one in answer.conditions)
    assert simplified_linear_analysis(pendulum, Eurocode8Spectrum(6000.0, "D")).verdict.endswith(
        ("known", ")")
    )


@pytest.mark.parametrize(
    ("name", "mu", "level", "structure", "verdict"),
    # displacements of mu R and of 0.05 R part the conditions of this bearing: F rises by D / 2 R
    [
        ("K_eff(d_dc) over K_eff(0.2 d_dc)", 0.005, 4000.0, None, Verdict.MET),
        ("K_eff(d_dc) over K_eff(0.2 d_dc)", 0.08, 2000.0, None, Verdict.NOT_MET),
        ("effective damping", 0.005, 4000.0, None, Verdict.MET),
        ("effective damping", 0.08, 2000.0, None, Verdict.NOT_MET),
        ("larger dimension of the plan", 0.04, 3000.0, Structure(plan=51e3), Verdict.NOT_MET),
        (
            "distance to a fault of magnitude 6.5 or more",
            0.04,
            3000.0,
            Structure(fault_distance=14e6),
            Verdict.NOT_MET,
        ),
        ("effective period over that of the fixed base", 0.04, 3000.0, Structure(3.0), Verdict.NOT_MET),
        ("effective period over that of the fixed base", 0.04, 3000.0, Structure(0.3), Verdict.MET),
        ("effective period", 0.005, 4000.0, None, Verdict.NOT_MET),
        ("effective period", 0.08, 2000.0, None, Verdict.MET),
    ],
)
def test_both_sides_of_a_limit(name, mu, level, structure, verdict):
    answer = simplified_linear_analysis(
        PendulumWithFriction(4500.0, mu), Eurocode8Spectrum(level, "C"), structure
    )
    assert next(one.verdict for one in answer.conditions if one.name == name) is verdict


@pytest.mark.parametrize(("factor", "verdict"), [(0.9, Verdict.NOT_MET), (1.1, Verdict.MET)])
def test_the_rise_of_the_force_has_its_limit_at_a_twentieth_of_the_radius(factor, verdict):
    # where the floor of 0.55 holds beyond T_D, d_dc is 0.55 of the constant displacement, so a_g for d_dc = 0.05 R is known
    level = 0.05 * 9000.0 * (2.0 * math.pi) ** 2 / (0.55 * 2.5 * 1.35 * 0.8 * 2.0)
    answer = simplified_linear_analysis(
        PendulumWithFriction(9000.0, 0.05), Eurocode8Spectrum(factor * level, "D")
    )
    assert answer.displacement == pytest.approx(factor * 0.05 * 9000.0, rel=1e-9)
    name = "rise of the force from d_dc/2 to d_dc over the weight"
    assert next(one.verdict for one in answer.conditions if one.name == name) is verdict


def test_the_frictionless_limit():
    answer = simplified_linear_analysis(PendulumWithFriction(1500.0, 1e-7), Eurocode8Spectrum(1000.0, "A"))
    undamped = damping_correction(0.0)
    period = answer.period
    expected = (
        undamped * 2.5 * 1000.0 * 0.4 * 2.0 / max(period, 2.0) / period * (period / (2.0 * math.pi)) ** 2
    )
    assert answer.displacement == pytest.approx(expected, rel=1e-4)
