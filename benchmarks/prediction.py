"""What a prediction costs beside the analysis, of one direction and of a station, and four hundred comparisons of both."""

from functools import partial

import numpy as np
from figure import Figure
from stopwatch import in_turn, microseconds, once, ratio

import dcfp
from dcfp.inference import Methods, compare
from dcfp.inference.forecast import calibration_set
from dcfp.inference.plane_forecast import calibration_stations
from dcfp.methods import find_nodes, find_pulses, march_in_plane, march_through_pulses
from dcfp.methods.li_2020 import predict_from_pulses, predict_simplified
from dcfp.motion.named import VELOCITIES

ROUNDS = 5
#: PGVs of the stations [mm/s].
STATION_PGVS = (500.0, 750.0, 1000.0)


def fresh(motion: dcfp.GroundMotion) -> dcfp.GroundMotion:
    """Return the motion without its velocity, which a prediction must integrate itself."""
    return dcfp.GroundMotion(motion.acceleration, motion.time_step, motion.name)


def fresh_station(station: dcfp.Station) -> dcfp.Station:
    """Return a station of such motions."""
    return dcfp.Station(fresh(station.x), fresh(station.y), name=station.name)


def of_stations() -> list[Figure]:
    """Return the times of the march in the plane over all stations of FEMA P-695, at each PGV, with the least of all rounds."""
    least, ratios = [], []
    for case in (one.scaled_to_pgv(v) for one in calibration_stations() for v in STATION_PGVS):
        parts = (
            lambda of=case: march_in_plane(find_nodes(fresh_station(of))),
            lambda of=case: find_nodes(fresh_station(of)),
            lambda of=case: dcfp.respond(fresh_station(of)),
        )
        times = in_turn([partial(once, part) for part in parts], ROUNDS)
        least.append(1e3 * times.min(axis=1))
        ratios.append(ratio(times[2], times[0]))
    march, nodes, _ = np.transpose(least)
    whole, found = float(np.median(march)), float(np.median(nodes))
    return [
        Figure(
            "march of a station, median", whole, "ms", at_most=2.0,
            note=f"nodes included, {found:.2f} ms; mean {march.mean():.2f}, slowest {march.max():.2f} ms",
        ),
        Figure("analysis in the plane over march", float(np.median(ratios)), note=f"{len(ratios)} cases"),
    ]  # fmt: skip


def figures() -> list[Figure]:
    """Return times over all components of FEMA P-695 at PGV 0.5 m/s, those of all stations, and the time of all comparisons."""
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
        *of_stations(),
        Figure("400 comparisons", comparisons, "s", at_most=10.0, note="100 components, 4 PGVs, one core"),
    ]
