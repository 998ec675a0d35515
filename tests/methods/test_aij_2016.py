"""The methods of the AIJ against each other, against numerical roots, and in their limits."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import optimize

from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import InputError
from dcfp.methods import aij_2016
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.methods.spectra import TabulatedSpectrum

PERIODS = np.geomspace(0.01, 100.0, 50)


def constant_velocity(level):
    """A spectrum of constant pseudo-velocity [mm/s]; a straight line between logarithms, so exact."""
    return TabulatedSpectrum(PERIODS, 2.0 * np.pi * level / PERIODS)


@given(
    radius=st.floats(1000.0, 2e4),
    friction=st.floats(1e-3, 0.2),
    velocity=st.floats(50.0, 5e3),
    loops=st.floats(0.5, 5.0),
)
def test_the_energy_balance_is_the_root(radius, friction, velocity, loops):
    pendulum = PendulumWithFriction(radius, friction)

    def surplus(at):  # per unit mass
        spring = 0.5 * STANDARD_GRAVITY / radius * at**2
        return spring + 4.0 * loops * friction * STANDARD_GRAVITY * at - 0.5 * velocity**2

    root = optimize.brentq(surplus, 0.0, 1e6, xtol=1e-13, rtol=1e-14)
    answer = aij_2016.energy_balance(pendulum, velocity, loops)
    assert answer.displacement == pytest.approx(root, rel=1e-12)
    assert answer.base_shear == pytest.approx(friction + root / radius, rel=1e-12)


def test_the_energy_balance_as_the_paper_has_it(pendulum):
    # D omega_f / V_E = -8 a + sqrt(64 a^2 + 1) for two loops
    omega = math.sqrt(STANDARD_GRAVITY / 9000.0)
    a = 0.043 * STANDARD_GRAVITY / (omega * 1500.0)
    expected = 1500.0 / omega * (math.sqrt(64.0 * a**2 + 1.0) - 8.0 * a)
    assert aij_2016.energy_balance(pendulum, 1500.0).displacement == pytest.approx(expected, rel=1e-12)
    frictions = np.array([0.02, 0.043, 0.08])
    found = [aij_2016.energy_balance(PendulumWithFriction(9000.0, mu), 1500.0) for mu in frictions.tolist()]
    displacements, shears = (
        np.array([one.displacement for one in found]),
        np.array([one.base_shear for one in found]),
    )
    assert displacements[1] == pytest.approx(expected, rel=1e-12)
    assert (np.diff(displacements) < 0.0).all()
    assert shears == pytest.approx(frictions + displacements / 9000.0)


@pytest.mark.parametrize("friction", [0.005, 0.02, 0.043, 0.1])
@pytest.mark.parametrize("level", [200.0, 1000.0, 3000.0])
def test_two_methods_agree_on_a_constant_velocity(friction, level):
    pendulum = PendulumWithFriction(9000.0, friction)
    first = aij_2016.method_1(pendulum, constant_velocity(level))
    second = aij_2016.method_2(pendulum, level)
    assert second.displacement == pytest.approx(first.displacement, rel=1e-8)
    assert second.base_shear == pytest.approx(first.base_shear, rel=1e-8)
    assert second.damping == pytest.approx(first.damping, rel=1e-8)
    # S_v F_h = D omega_eq
    omega = 2.0 * math.pi / second.period
    assert second.displacement * omega == pytest.approx(
        level * aij_2016.damping_correction(second.damping), rel=1e-8
    )


def test_the_reduction_curve():
    ratio = np.array([0.0, 0.1, 0.5, 2.0])
    displacement, shear = aij_2016.reduction_curve(ratio)
    h = 0.8 * 2.0 / np.pi * ratio / (1.0 + ratio)
    assert displacement * shear == pytest.approx(np.maximum(1.5 / (1.0 + 10.0 * h), 0.4) ** 2)
    assert shear / displacement == pytest.approx(1.0 + ratio)
    # no friction, no damping: 1.5 times the spectrum of 5 %
    assert displacement[0] == shear[0] == 1.5


def test_frictionless_limits():
    slippery = PendulumWithFriction(9000.0, 1e-8)
    omega = slippery.free_frequency
    assert aij_2016.energy_balance(slippery, 1000.0).displacement == pytest.approx(1000.0 / omega, rel=1e-5)
    for answer in (
        aij_2016.method_1(slippery, constant_velocity(1000.0)),
        aij_2016.method_2(slippery, 1000.0),
    ):
        assert answer.displacement == pytest.approx(1.5 * 1000.0 / omega, rel=1e-5)
        assert answer.period == pytest.approx(2.0 * math.pi / omega, rel=1e-5)


def test_corrections():
    # Notification 2009, as quoted word for word: 1.5 / (1 + 10 h), and 0.4 where it is below; reached at h = 0.275
    assert aij_2016.damping_correction(0.05) == pytest.approx(1.0)
    assert aij_2016.damping_correction(0.2) == pytest.approx(0.5)
    assert aij_2016.damping_correction(0.275) == pytest.approx(0.4)
    assert aij_2016.damping_correction(0.5) == 0.4


def test_damping_is_a_part_of_the_loop(pendulum):
    loop = 4.0 * 0.043 * 200.0
    elastic = 0.5 * pendulum.force(200.0) * 200.0
    assert aij_2016.equivalent_damping(pendulum, 200.0) == pytest.approx(
        0.8 / (4.0 * math.pi) * loop / elastic
    )


def test_what_is_unconfirmed(pendulum):
    spectrum = constant_velocity(1000.0)
    for usual in (aij_2016.method_1(pendulum, spectrum), aij_2016.method_2(pendulum, 1000.0)):
        assert all(word in " ".join(usual.unconfirmed) for word in ("0.8", "0.4"))
    assert aij_2016.energy_balance(pendulum, 1000.0).unconfirmed == ()


def test_refusals(pendulum):
    with pytest.raises(InputError):
        aij_2016.energy_balance(pendulum, 0.0)
    with pytest.raises(InputError):
        aij_2016.energy_balance(pendulum, 100.0, loops=0.0)
    with pytest.raises(InputError):
        aij_2016.method_2(pendulum, -1.0)
