"""What a prediction costs beside the analysis, and four hundred comparisons of both."""

import numpy as np
from figure import Figure
from stopwatch import in_turn, microseconds, once, ratio

import dcfp
from dcfp.inference import Methods, compare
from dcfp.inference.forecast import calibration_set
from dcfp.methods import find_pulses, march_through_pulses
from dcfp.methods.li_2020 import predict_from_pulses, predict_simplified
from dcfp.motion.named import VELOCITIES

ROUNDS = 5


def fresh(motion: dcfp.GroundMotion) -> dcfp.GroundMotion:
    """Return the motion without its velocity, which a prediction must integrate itself."""
    return dcfp.GroundMotion(motion.acceleration, motion.time_step, motion.name)


def figures() -> list[Figure]:
    """Return times over all components of FEMA P-695 at PGV 0.5 m/s, and the time of all comparisons."""
    motions = [motion.scaled_to_pgv(500.0) for motion in calibration_set()]
    tasks = (
        lambda: [predict_from_pulses(find_pulses(fresh(motion))).largest for motion in motions],
        lambda: [predict_simplified(find_pulses(fresh(motion))).largest for motion in motions],
        lambda: [march_through_pulses(fresh(motion)) for motion in motions],
        lambda: [dcfp.respond(motion) for motion in motions],
    )
    pulse, simplified, march, analysis = in_turn(
        [lambda task=task: once(task) for task in tasks], ROUNDS
    ) / len(motions)
    slowest = max(
        float(
            np.median(
                [once(lambda m=motion: predict_from_pulses(find_pulses(fresh(m)))) for _ in range(ROUNDS)]
            )
        )
        for motion in motions
    )
    methods = Methods()
    comparisons = once(
        lambda: [
            compare(motion.scaled_to_pgv(v), methods) for motion in calibration_set() for v in VELOCITIES
        ]
    )
    return [
        Figure(
            "pulse method, a record", 1e-3 * microseconds(pulse), "ms", at_most=1.0, note="pulses included"
        ),
        Figure("pulse method, slowest record", 1e3 * slowest, "ms", at_most=1.0),
        Figure("simplified over pulse method", ratio(simplified, pulse)),
        Figure("march over pulse method", ratio(march, pulse), note=f"{microseconds(march):.0f} us a record"),
        Figure(
            "analysis over march", ratio(analysis, march), note=f"{microseconds(analysis):.0f} us a record"
        ),
        Figure("400 comparisons", comparisons, "s", at_most=10.0, note="100 components, 4 PGVs, one core"),
    ]
