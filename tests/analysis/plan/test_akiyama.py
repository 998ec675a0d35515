"""Akiyama (1985): the total input energy of a building is well estimated by that of a structure of one mass.

The one mass here is the rigid structure of Li et al. (2020) on the same bearing.
"""

from functools import cache

import pytest

from dcfp import System, load_motion
from dcfp.analysis import respond
from dcfp.analysis.plan.shear_building import respond_in_one_direction, shear_building

NAMES = ("NCC", "KNA", "LPG", "IVD")


@cache
def ratio(name, pgv, period):
    """V_E of five storeys over V_E of the rigid structure."""
    motion = load_motion(name).scaled_to_pgv(pgv)
    building = respond_in_one_direction(shear_building(5, period, System()), motion)
    return building.input_velocity / respond(motion).input_velocity


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("pgv", [500.0, 750.0, 1000.0])
@pytest.mark.parametrize("period", [0.5, 1.0])
def test_where_it_slides_well_the_input_energy_is_that_of_the_rigid_structure(name, pgv, period):
    # found: 0.931 (NCC) to 1.085 (LPG), both at 1.0 s and 0.5 m/s. Isolation is at work: the storeys hardly deform compared with the
    # layer, and the mass that slides is the same. A tenth is what "well estimated" is taken to mean here.
    assert ratio(name, pgv, period) == pytest.approx(1.0, abs=0.1)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("period", [0.5, 1.0])
def test_where_it_hardly_slides_the_storeys_have_a_say(name, period):
    # found at 0.25 m/s: 1.06 to 1.16 at 0.5 s, 0.80 (KNA) to 1.26 (IVD) at 1.0 s. The layer slides a few centimetres, so the storeys'
    # own period decides which part of the motion goes in.
    assert ratio(name, 250.0, period) == pytest.approx(1.0, abs=0.2 if period == 0.5 else 0.3)


def test_the_estimate_grows_better_with_the_ground_motion():
    def worst(pgv):
        return max(abs(ratio(name, pgv, period) - 1.0) for name in NAMES for period in (0.5, 1.0))

    assert worst(250.0) > worst(500.0) > worst(1000.0)
    assert worst(250.0) > 0.15  # so a band of 15 % does not hold for weak motions
