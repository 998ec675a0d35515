"""A bearing as the methods of codes take it, and motions."""

import pytest

from dcfp.codes.equivalent_linear import PendulumWithFriction
from dcfp.record import named_motion


@pytest.fixture(scope="session")
def pendulum():
    return PendulumWithFriction(9000.0, 0.043)


@pytest.fixture(scope="session")
def motions():
    """The four records of the paper that come with the package, by name."""
    return {name: named_motion(name) for name in ("KNA", "NCC", "LPG", "IVD")}
