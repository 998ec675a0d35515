"""The batch of stations gives what `respond` gives, lane by lane."""

import numpy as np
import pytest

import dcfp
from dcfp.analysis.batch import GroundSet, Lanes, respond_in_batch
from dcfp.analysis.plane_batch import PEAKS
from dcfp.analysis.response import FAILED, NUMBERS
from dcfp.errors import InputError
from dcfp.system import System


def refuses(pressure: float, speed: float, temperature: float) -> float:
    return 0.05 if speed < 150.0 else np.nan


MODELS = [
    System(heating=dcfp.PreciseHeating(points=20)),
    System(heating=dcfp.SimplifiedHeating()),
    System(friction=dcfp.ConstantFriction(0.05), heating=dcfp.NoHeating()),
]


def test_every_lane_is_as_alone() -> None:
    stations = [dcfp.load_station(name) for name in ("P695-FF-2", "P695-NF-9")]
    scales = np.array([[0.5, 1.3], [0.7, 0.4]])
    peaks = respond_in_batch(GroundSet.of(stations), Lanes.grid(2, scales, MODELS))
    assert set(peaks) == {*PEAKS, "status"}
    lane = 0
    for station, row in zip(stations, scales, strict=True):
        for scale in row:
            for model in MODELS:
                alone = dcfp.respond(station.scaled(float(scale)), model)
                assert [peaks[name][lane] for name in PEAKS] == [getattr(alone, name) for name in PEAKS]
                assert peaks["status"][lane] == NUMBERS[alone.status]
                lane += 1
    assert lane == len(peaks["status"])


def test_a_lane_that_fails_leaves_the_others() -> None:
    law = dcfp.UserFriction(refuses)
    grounds = GroundSet.of([dcfp.load_station("P695-FF-2")])
    models = [System(friction=law, heating=dcfp.NoHeating()), MODELS[2]]
    peaks = respond_in_batch(grounds, Lanes.grid(1, np.array([[1.0]]), models))
    assert peaks["status"][0] == FAILED
    assert np.isnan(peaks["peak_displacement"][0])
    assert peaks["status"][1] != FAILED
    assert peaks["peak_displacement"][1] > 0.0


def test_a_single_component_among_stations_is_refused() -> None:
    with pytest.raises(InputError, match="only stations, or only single components"):
        GroundSet.of([dcfp.load_station("P695-FF-2"), dcfp.load_motion("NCC")])
