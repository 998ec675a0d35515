"""One step of sliding: the friction that moved the structure is the parabola that the law gives."""

import numpy as np
import pytest

from dcfp.kernels.friction import mean_coefficient
from dcfp.kernels.heat_state import MOST_HALVINGS, PRESENT
from dcfp.kernels.motion import GroundInput, Motion, SpringState, StepControl, StepStart
from dcfp.kernels.oscillator import advance_oscillator
from dcfp.kernels.sliding import slide_step
from dcfp.system import Constantinou1990, NoHeating, System
from dcfp.system.plates import cold_plates, kernel_model


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("speed", [30.0, 60.0, 120.0])
@pytest.mark.parametrize("push", [-500.0, 300.0, 4000.0])
def test_the_friction_that_moved_it_is_a_parabola_through_start_and_end(
    sign: int, speed: float, push: float
) -> None:
    system = System(friction=Constantinou1990(0.08, 0.02, 0.02), heating=NoHeating())
    model = kernel_model(system, cold_plates(system))
    constants = model.system
    first = mean_coefficient(model, speed, PRESENT)
    elongation = sign * first * constants.yield_per_mu
    ground = GroundInput(-sign * push, sign * 2e4)
    begin = StepStart(
        ground, Motion(sign * 15.0, sign * speed), SpringState(elongation, sign, first), 0.0, 0.04
    )
    # a step that cannot be halved any more is taken however far its friction is from straight
    control = StepControl(0.02 * 2**MOST_HALVINGS, 0, 1e-6)
    step, _ = slide_step(model, control, None, begin, False, MOST_HALVINGS)
    assert step.length == 0.02

    # two unknowns of the parabola, slope and curve, from how far and how fast it has gone
    pull = -sign * constants.gravity
    start = -ground.acceleration - constants.restoring * begin.motion.displacement + pull * first

    def moved(slope: float, curve: float) -> np.ndarray:
        there = advance_oscillator(
            constants.restoring,
            step.length,
            begin.motion.velocity,
            start,
            pull * slope - ground.rate,
            pull * curve,
        )
        return np.array([begin.motion.displacement + there.displacement, there.velocity])

    straight = moved(0.0, 0.0)
    per_one = np.column_stack([moved(1.0, 0.0) - straight, moved(0.0, 1.0) - straight])
    slope, curve = np.linalg.solve(per_one, np.array(step.motion) - straight)
    last = first + step.length * (slope + step.length * curve)
    bend = -0.25 * curve * step.length**2
    assert abs(bend) > 2e-5  # else there is nothing to see
    assert last == pytest.approx(step.spring.friction, abs=1e-7)
    # it is expected from the speeds that the acceleration at the start would bring
    jerk = -ground.rate - constants.restoring * begin.motion.velocity
    half = 0.5 * step.length
    speeds = [abs(begin.motion.velocity + t * (start + 0.5 * t * jerk)) for t in (half, step.length)]
    middle, end = (mean_coefficient(model, one, PRESENT) for one in speeds)
    assert step.spring.friction == pytest.approx(end, rel=1e-12)
    assert bend == pytest.approx(middle - 0.5 * (first + end), abs=1e-7)
