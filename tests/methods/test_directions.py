"""The methods of one direction put to a station."""

from dataclasses import replace

import numpy as np
import pytest

from dcfp.methods import find_pulses
from dcfp.methods.directions import DIRECTIONS, predict_in_directions
from dcfp.methods.li_2020 import predict_from_pgv, predict_from_pulses, predict_simplified
from dcfp.methods.prediction import Methods
from dcfp.motion.load import load_station
from dcfp.motion.station import Station


def station(name: str = "P695-FF-2", pgv: float = 500.0) -> Station:
    return load_station(name).scaled_to_pgv(pgv)


def changes(of: Station, methods: Methods | None = None) -> dict[str, float]:
    said = predict_in_directions(of, Methods() if methods is None else methods)
    return {one.method: one.prediction.displacement_change for one in said}


@pytest.mark.parametrize("angle", [7.0, 90.0, 180.0, -33.0])
def test_it_does_not_depend_on_where_x_and_y_point(angle: float) -> None:
    one, other = (predict_in_directions(of, Methods()) for of in (station(), station().rotated(angle)))
    for before, after in zip(one, other, strict=True):
        assert after.prediction.displacement_change == pytest.approx(
            before.prediction.displacement_change, rel=1e-9
        )
        if before.direction is not None and after.direction is not None:
            turned = (after.direction - before.direction - angle) % 180.0
            assert min(turned, 180.0 - turned) == pytest.approx(0.0, abs=1e-9)


def test_along_a_line_it_is_the_method_of_one_direction() -> None:
    found = station("P695-FF-5", 750.0)
    still = replace(found.y, acceleration=np.zeros_like(found.y.acceleration))
    line = replace(found, y=still, parts=()).rotated(25.0)
    pulses, constants = find_pulses(found.x), Methods().constants
    said = changes(line)
    assert said["design"] == pytest.approx(
        predict_from_pgv(found.x.peak_velocity, constants).displacement_change
    )
    for name, predict in (("pulse", predict_from_pulses), ("simplified", predict_simplified)):
        assert said[name] == pytest.approx(predict(pulses, constants).largest.displacement_change, rel=1e-9)


def test_it_is_the_largest_of_the_directions() -> None:
    found, constants = station(), Methods().constants
    peak = found.velocity[np.argmax(np.hypot(*found.velocity.T))]
    first = np.degrees(np.arctan2(peak[1], peak[0]))
    assert DIRECTIONS == 12
    each = []
    for part in range(12):
        angle = np.radians(first + 15.0 * part)
        along = replace(
            found.x,
            acceleration=np.cos(angle) * found.x.acceleration + np.sin(angle) * found.y.acceleration,
        )
        each.append(predict_from_pulses(find_pulses(along), constants).largest.displacement_change)
    assert changes(found)["pulse"] == pytest.approx(np.nanmax(each), rel=1e-9)


def test_what_does_not_move_is_of_no_direction() -> None:
    weak = station(pgv=5.0)
    pulse = next(one for one in predict_in_directions(weak, Methods()) if one.method == "pulse")
    assert np.isnan(pulse.prediction.displacement_change)
    assert pulse.direction is None


def test_a_method_that_cannot_be_used_is_left_out() -> None:
    methods = Methods()
    stiff = replace(methods, constants=replace(methods.constants, nominal_friction=0.2))
    assert set(changes(station(), stiff)) == {"pulse"}
