"""AIJ method 1 on the spectrum of the notification, step by step as on paper.

No published example of an isolated building by Notification 2009 could be read; the numbers below are worked by hand from the formulas, with four digits.
"""

import math

import pytest

from dcfp.methods.aij_2016 import Notification2000Spectrum, method_1
from dcfp.methods.equivalent_linear import PendulumWithFriction


def test_the_iteration_by_hand() -> None:
    """R 6000 mm, mu 0.05, soil 2: beyond 0.864 s the spectrum is 5.12 x 2.025 / T m/s2."""
    radius, mu, g = 6000.0, 0.05, 9806.65
    displacement = 300.0  # mm
    for _ in range(40):
        stiffness = 1.0 / radius + mu / displacement  # of the weight [1/mm]
        period = 2.0 * math.pi / math.sqrt(g * stiffness)  # s
        loop = 4.0 * mu * displacement  # of the weight [mm]
        strain = 0.5 * stiffness * displacement**2
        damping = 0.8 * loop / (4.0 * math.pi * strain)
        factor = max(1.5 / (1.0 + 10.0 * damping), 0.4)
        acceleration = 5120.0 / period * 2.025  # mm/s2
        displacement = acceleration * (period / (2.0 * math.pi)) ** 2 * factor
    answer = method_1(PendulumWithFriction(radius, mu), Notification2000Spectrum(2))
    assert period > 0.864
    assert answer.displacement == pytest.approx(displacement, rel=1e-6)
    assert answer.period == pytest.approx(period, rel=1e-6)
    assert answer.damping == pytest.approx(damping, rel=1e-6)
    assert answer.base_shear == pytest.approx(mu + displacement / radius, rel=1e-6)
