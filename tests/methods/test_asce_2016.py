"""ASCE/SEI 7-16, section 17.5, against worked examples of others; ASCE's own pages were not read."""

import math

import pytest

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.methods.asce_2016 import (
    ASCE_2016,
    DAMPING_TABLE,
    Asce2016Spectrum,
    damping_factor,
    equivalent_lateral_force,
    structure_shear,
    total_displacement,
)
from dcfp.methods.code import Bounds, CodeInputs, Structure
from dcfp.methods.equivalent_linear import PendulumWithFriction, iterate
from dcfp.schema.check import Verdict

#: The examples have g = 386.4 in/s2; with an inch of that many mm the ratio of g to lengths is theirs.
INCH = STANDARD_GRAVITY / 386.4

#: mgrubisic/tfp-database (H. Pham, UC Berkeley), sessionOut/sessionSummary.csv: S1, Tm, zetaM, moatAmpli, moatGap [in], as printed.
PHAM = [
    (1.021104444, 3.330817955, 0.149402038, 0.631314739, 15.58791687),
    (1.029922353, 2.758190231, 0.111117955, 1.265556319, 28.52987435),
    (1.252042166, 2.542428793, 0.152960955, 1.464210694, 33.57118622),
    (1.216157586, 3.230350469, 0.18072257, 1.622712376, 43.26559269),
    (1.113695642, 3.487902305, 0.113394801, 0.718972702, 22.04115506),
]


@pytest.mark.parametrize(("one_second", "period", "damping", "amplification", "gap"), PHAM)
def test_displacement_of_pham(one_second, period, damping, amplification, gap):
    found = maximum_displacement(one_second, period, damping_factor(damping)) / INCH
    # inputs have nine or ten digits
    assert found == pytest.approx(gap / amplification, rel=1e-7)


# mjamiv/isolation (name inferred; a machine-written report, used as arithmetic): L_eff 152 in, mu_eff 13.36/152 printed as 0.0879, S_D1 0.60, S_M1 0.90
PRINTED = [10, 8.282, 7.591, 7.309, 7.200, 7.156, 7.139, 7.132, 7.129, 7.128, 7.128]
ISOLATOR = PendulumWithFriction(152.0 * INCH, 13.36 / 152.0)


def rounds(one_second, start=10.0):
    spectrum = Asce2016Spectrum(3.0 * one_second, one_second, 20.0)
    steps, _ = iterate(ISOLATOR, spectrum, lambda damping: 1.0 / damping_factor(damping), start=start * INCH)
    return steps


def maximum_displacement(one_second, period, factor):
    """Return D_M [mm] on the branch of constant velocity, Eq. (17.5-1): S_M1 [g], T_M [s], B_M [-]."""
    return STANDARD_GRAVITY * one_second * period / (4.0 * math.pi**2 * factor)


def test_a_printed_iteration():
    steps = rounds(0.60)
    assert [step.displacement / INCH for step in steps[: len(PRINTED)]] == pytest.approx(PRINTED, abs=6e-4)
    first = steps[0]
    stiffness = 450.0 * ISOLATOR.effective_stiffness(10.0 * INCH) * INCH
    assert stiffness == pytest.approx(6.916, abs=6e-4)
    assert first.period == pytest.approx(2.578, abs=6e-4)
    assert first.damping == pytest.approx(0.364, abs=6e-4)
    assert 1.0 / first.reduction == pytest.approx(1.828, abs=6e-4)


@pytest.mark.parametrize(
    ("one_second", "inches", "period", "stiffness", "damping", "factor"),
    # the last digit within one unit: the printed rounds stop before they have settled
    [(0.60, 7.128, 2.325, 8.509, 0.415, 1.915), (0.90, 14.745, 2.854, 5.643, 0.303, 1.705)],
)
def test_its_results(one_second, inches, period, stiffness, damping, factor):
    last = rounds(one_second)[-1]
    assert last.displacement / INCH == pytest.approx(inches, abs=1e-3)
    assert last.period == pytest.approx(period, abs=1e-3)
    assert 450.0 * ISOLATOR.effective_stiffness(last.displacement) * INCH == pytest.approx(
        stiffness, abs=1.5e-3
    )
    assert last.damping == pytest.approx(damping, abs=1e-3)
    assert 1.0 / last.reduction == pytest.approx(factor, abs=1e-3)


def test_the_whole_procedure_on_it():
    answer = equivalent_lateral_force(ISOLATOR, Asce2016Spectrum(1.8, 0.60, 20.0))
    assert answer.displacement / INCH == pytest.approx(7.1274, abs=1e-4)
    # V_b = 60.66 kip at the printed displacement
    assert 450.0 * answer.base_shear == pytest.approx(60.66, abs=0.02)
    assert answer.displacement == pytest.approx(
        maximum_displacement(0.60, answer.period, damping_factor(answer.damping)), rel=1e-8
    )


def test_the_peruvian_tests():
    # unit tests of a public port of NTE E.031, whose equations are those of chapter 17; decimals follow from them
    assert damping_factor(0.15) == pytest.approx(1.35)
    assert damping_factor(0.25) == pytest.approx(1.6)
    assert maximum_displacement(0.9, 3.0, 1.5) == pytest.approx(447.13, abs=0.01)  # 0.3 g at 3 s
    assert structure_shear(100.0, 0.8, 0.2) == pytest.approx(89.4427, abs=1e-4)
    assert total_displacement(300.0, 2e3, 15e3, 24e3, 30e3) == pytest.approx(373.1707, abs=1e-4)
    assert total_displacement(300.0, 0.0, 15e3, 24e3, 30e3) == pytest.approx(345.0)


def test_the_table_of_factors():
    assert [damping_factor(ratio) for ratio, _ in DAMPING_TABLE] == [0.8, 1.0, 1.2, 1.5, 1.7, 1.9, 2.0]
    assert damping_factor(0.0) == 0.8
    assert damping_factor(0.6) == 2.0


def test_shear_of_the_structure():
    assert structure_shear(0.2, 1.0, 0.3) == structure_shear(0.2, 1.0, 0.3, abrupt=True) == 0.2
    assert structure_shear(0.2, 0.8, 0.3, abrupt=True) == pytest.approx(0.2 * 0.8 ** (1.0 - 3.5 * 0.3))
    assert structure_shear(0.2, 0.8, 0.3, abrupt=True) > structure_shear(0.2, 0.8, 0.3)


def test_bounds_of_friction(pendulum):
    spectrum = Asce2016Spectrum(1.5, 0.9)
    nominal = equivalent_lateral_force(pendulum, spectrum)
    bounded = ASCE_2016.result(CodeInputs(spectrum, pendulum), Bounds(0.6, 1.8, "a test"))
    lower = equivalent_lateral_force(PendulumWithFriction(9000.0, 0.6 * 0.043), spectrum)
    upper = equivalent_lateral_force(PendulumWithFriction(9000.0, 1.8 * 0.043), spectrum)
    assert bounded.displacement == pytest.approx(lower.displacement)
    assert bounded.displacement > nominal.displacement > upper.displacement
    assert bounded.base_shear == pytest.approx(max(lower.base_shear, upper.base_shear))
    with pytest.raises(InputError, match="must not exceed"):
        Bounds(1.2, 0.8)


def test_conditions(pendulum):
    answer = equivalent_lateral_force(
        pendulum, Asce2016Spectrum(1.5, 0.9), Structure(0.5, height=15e3, site_class="D")
    )
    verdicts = {one.name: one.verdict for one in answer.conditions}
    assert verdicts["height of the structure above"] is verdicts["site class"] is Verdict.MET
    at = answer.displacement
    softening = (1.0 / 9000.0 + 0.043 / at) / (1.0 / 9000.0 + 0.215 / at)
    shown = {one.name: one.found for one in answer.conditions}
    assert shown["k_eff(D_M) over k_eff(0.2 D_M)"] == f"{softening:.2f}"
    assert shown["restoring force, F(D_M) - F(D_M/2) over W"] == f"{0.5 * at / 9000.0:.3f}"
    assert shown["effective period T_M"] == f"{answer.period:.2f} s"
    worse = equivalent_lateral_force(pendulum, Asce2016Spectrum(1.5, 0.9), Structure(2.0, 25e3, "E"))
    names = {one.name for one in worse.conditions if one.verdict is Verdict.NOT_MET}
    assert names >= {"height of the structure above", "site class", "T_M over the period of the fixed base"}
    # none was read in the standard itself
    assert not any(one.confirmed for one in answer.conditions)
    assert equivalent_lateral_force(pendulum, Asce2016Spectrum(1.5, 0.9)).valid is not True


@pytest.mark.parametrize(
    ("name", "mu", "one_second", "verdict"),
    [
        # the rise is 0.019 and 0.025, the damping 33 and 29 %, the softening 0.32 and 0.35, T_M 4.96 and 5.18 s
        ("restoring force, F(D_M) - F(D_M/2) over W", 0.043, 0.6, Verdict.NOT_MET),
        ("restoring force, F(D_M) - F(D_M/2) over W", 0.043, 0.7, Verdict.MET),
        ("effective damping", 0.043, 0.6, Verdict.NOT_MET),
        ("effective damping", 0.043, 0.7, Verdict.MET),
        ("k_eff(D_M) over k_eff(0.2 D_M)", 0.043, 0.6, Verdict.NOT_MET),
        ("k_eff(D_M) over k_eff(0.2 D_M)", 0.043, 0.7, Verdict.MET),
        ("effective period T_M", 0.043, 1.0, Verdict.MET),
        ("effective period T_M", 0.043, 1.2, Verdict.NOT_MET),
    ],
)
def test_both_sides_of_a_limit(name, mu, one_second, verdict):
    answer = equivalent_lateral_force(
        PendulumWithFriction(9000.0, mu), Asce2016Spectrum(2.0, one_second, 20.0)
    )
    assert next(one.verdict for one in answer.conditions if one.name == name) is verdict


def test_the_frictionless_limit():
    # mu to 0: the pendulum's own period, and 0.8 for no damping
    answer = equivalent_lateral_force(PendulumWithFriction(4000.0, 1e-7), Asce2016Spectrum(1.5, 0.6, 20.0))
    period = 2.0 * math.pi * math.sqrt(4000.0 / STANDARD_GRAVITY)
    assert answer.displacement == pytest.approx(maximum_displacement(0.6, period, 0.8), rel=1e-4)
