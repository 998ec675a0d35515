"""The march along straight legs against exact sliding, and against the response history analysis."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp.analysis import respond
from dcfp.analysis.swings import swings_of
from dcfp.constants import STANDARD_GRAVITY
from dcfp.methods import Pulses, march_through_pulses
from dcfp.methods.li_2020 import Constants, predict_from_pulses
from dcfp.system import (
    LI_2020,
    Bearing,
    ConstantFriction,
    FrictionLaw,
    Heating,
    Li2020,
    Lomiento2013,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
)

MU_G = ConstantFriction().mu * STANDARD_GRAVITY
#: Plates so flat that spring (a) gives 1e-9 of the friction force in a metre.
FLAT = LI_2020.unchecked(radii=(5e14, 5e14))
MODELS = [
    (ConstantFriction(), NoHeating()),
    (Li2020(), NoHeating()),
    (Li2020(), SimplifiedHeating()),
    (Li2020(), PreciseHeating()),
    (Lomiento2013(), NoHeating()),
]
every_model = pytest.mark.parametrize(("law", "heating"), MODELS, ids=lambda model: model.name)


# ----- against exact sliding -----


@pytest.fixture(scope="module")
def slides() -> list[Pulses]:
    """Forty pulses of every size that slides."""
    random = np.random.default_rng(5)
    found = []
    for _ in range(40):
        length = random.uniform(0.2, 0.35)
        fall = length * random.uniform(1.05, 1.6)  # slower than the rise, so that no slide back is larger
        change = MU_G * length * random.uniform(1.3, 5.0)
        found.append(Pulses(np.cumsum([3.0, length, fall]), np.array([0.0, change, 0.0])))
    return found


def test_one_pulse_on_flat_plates_slides_as_the_paper_has_it(slides: list[Pulses]) -> None:
    """Eqs (20), (23) and (24) of Li et al. (2020) are exact for one pulse from rest, in a closed form for each of its legs."""
    constants = Constants(nominal_friction=ConstantFriction().mu, gravity=STANDARD_GRAVITY)
    for pulses in slides:
        march = march_through_pulses(pulses, FLAT, ConstantFriction(), NoHeating(), parts=1)
        said = predict_from_pulses(replace(pulses), constants)
        if pulses.mean_accelerations[0] * 0.8 < MU_G:  # there the paper multiplies by 1.5
            continue
        found, paper = march.prediction, said.largest
        assert found.displacement_change == pytest.approx(paper.displacement_change, rel=1e-6)
        assert found.input_velocity == pytest.approx(paper.input_velocity, rel=1e-6)
        assert found.hysteretic_velocity == pytest.approx(paper.hysteretic_velocity, rel=1e-6)
        assert march.leg == 0
        assert march.nodes == 3


def test_without_friction_all_of_the_ground_s_velocity_is_relative_velocity(one_pulse) -> None:
    march = march_through_pulses(one_pulse(300.0, 600.0, 700.0), FLAT, ConstantFriction(1e-9), NoHeating())
    assert march.prediction.input_velocity == pytest.approx(300.0, rel=1e-6)


# ----- against the response history analysis -----


@every_model
def test_the_analysis_of_the_same_motion_agrees(
    six_legs: Pulses, straight_legs, law: FrictionLaw, heating: Heating
) -> None:
    """With a spring (b) a million times as stiff, which leaves 3e-5; the temperatures differ by the steps of the analysis."""
    stiff = LI_2020.unchecked(elastic_stiffness=1e6 * LI_2020.elastic_stiffness)
    analysis = respond(straight_legs(six_legs, 1e-4), stiff, law, heating)
    march = march_through_pulses(six_legs, stiff, law, heating, parts=1000)
    found = march.prediction
    assert found.displacement_change == pytest.approx(analysis.peak_change, rel=2e-4)
    assert found.displacement == pytest.approx(analysis.peak_displacement, rel=2e-4)
    assert found.total_velocity == pytest.approx(analysis.input_velocity, rel=2e-4)
    swings = swings_of(analysis)
    assert found.input_velocity == pytest.approx(swings.input_velocity, rel=2e-4)
    assert found.hysteretic_velocity == pytest.approx(swings.hysteretic_velocity, rel=2e-4)
    assert march.residual_displacement == pytest.approx(analysis.residual_displacement, abs=0.1)
    assert march.peak_temperature == pytest.approx(analysis.peak_temperature, abs=0.05)


def test_what_is_left_is_the_spring_that_is_taken_as_rigid(six_legs: Pulses, straight_legs) -> None:
    """Its oscillation has a velocity in proportion to 1/sqrt(kf): a hundred times as stiff, a tenth of the difference."""
    motion = straight_legs(six_legs, 1e-3)
    march = march_through_pulses(six_legs, LI_2020, ConstantFriction(), NoHeating(), parts=2000).prediction
    gaps = []
    for factor in (1.0, 100.0):
        bearing = LI_2020.unchecked(elastic_stiffness=factor * LI_2020.elastic_stiffness)
        analysis = respond(motion, bearing, ConstantFriction(), NoHeating())
        gaps.append(1.0 - march.displacement_change / analysis.peak_change)
    assert 0.0 < gaps[0] < 0.03
    assert gaps[0] / gaps[1] == pytest.approx(10.0, rel=0.15)


@every_model
def test_the_default_steps_suffice(six_legs: Pulses, law: FrictionLaw, heating: Heating) -> None:
    """Error of the steps alone: far below the scatter of any prediction."""
    default = march_through_pulses(six_legs, LI_2020, law, heating).prediction
    fine = march_through_pulses(six_legs, LI_2020, law, heating, parts=1000).prediction
    assert default.displacement_change == pytest.approx(fine.displacement_change, rel=0.02)
    assert default.total_velocity == pytest.approx(fine.total_velocity, rel=0.01)


def test_a_creep_that_never_turns_is_counted_by_neither(straight_legs) -> None:
    """With 0.45 of its friction at rest, Li's law lets the pendulum creep back for ever; the analysis says that it still moves."""
    pulses = Pulses(np.array([0.0, 0.37, 1.72, 2.09]), np.array([0.0, 630.0, 566.0, 1356.0]))
    bearing = Bearing((3490.0,), 400.0, 60.0, 1e9).unchecked(elastic_stiffness=1e10)
    analysis = respond(straight_legs(pulses, 1e-4), bearing, Li2020(), NoHeating())
    march = march_through_pulses(pulses, bearing, Li2020(), NoHeating(), parts=1000)
    assert not analysis.rests
    assert march.prediction.displacement_change == pytest.approx(analysis.peak_change, rel=2e-4)
    assert march.residual_displacement == pytest.approx(analysis.residual_displacement, abs=1e-3)
