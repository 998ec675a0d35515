"""Pulses to predict from and the ground motion whose peaks they are; a bearing as the methods of codes take it, and motions."""

from collections.abc import Callable

import numpy as np
import pytest

from dcfp.methods import Pulses
from dcfp.methods.equivalent_linear import PendulumWithFriction
from dcfp.motion import named_motion
from dcfp.motion.ground_motion import GroundMotion
from dcfp.verify import prediction as verification

Made = Callable[..., Pulses]


@pytest.fixture(scope="session")
def one_pulse() -> Made:
    """Make the pulse with a velocity change [mm/s], a slope before the peak and one after it [mm/s2]; both slopes as amounts."""

    def make(change: float, slope: float, next_slope: float, start: float = 0.0) -> Pulses:
        times = np.cumsum([0.0, abs(change) / slope, abs(change) / next_slope])
        return Pulses(times, np.array([start, start + change, start]))

    return make


@pytest.fixture(scope="session")
def six_legs() -> Pulses:
    """Five pulses, all of which move a bearing of the usual friction."""
    times = np.array([0.0, 0.6, 1.2, 2.0, 2.5, 3.5, 4.5])
    return Pulses(times, np.array([0.0, 400.0, -500.0, 300.0, -200.0, 450.0, 0.0]))


@pytest.fixture(scope="session")
def straight_legs() -> Callable[..., GroundMotion]:
    """Sample the motion whose velocity is straight between nodes."""
    return verification.straight_legs


@pytest.fixture(scope="session")
def pendulum():
    return PendulumWithFriction(9000.0, 0.043)


@pytest.fixture(scope="session")
def motions():
    """The four records of the paper that come with the package, by name."""
    return {name: named_motion(name) for name in ("KNA", "NCC", "LPG", "IVD")}
