"""Where a motion makes the methods of Li et al. (2020) unreliable, and that they say so."""

import numpy as np
import pytest

from dcfp.methods.li_2020.cautions import rest_share
from dcfp.methods.prediction import Ground, Methods, prediction_methods
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import named_motion

STEP = 0.01
METHODS = Methods()


def motion_of(times: list[float], velocities: list[float], ripple: float = 0.0) -> GroundMotion:
    """Straight lines of ground velocity [mm/s], with ripples of an amplitude between the second and the third point, 0.5 s long."""
    time = np.arange(0.0, times[-1] + 2.0, STEP)
    velocity = np.interp(time, times, velocities)
    between = (time > times[1]) & (time < times[2])
    velocity += ripple * np.sin(4.0 * np.pi * (time - times[1])) * between
    return GroundMotion(np.gradient(velocity, STEP), STEP, "made")


def said(motion: GroundMotion, method: str) -> list[str]:
    predicted = prediction_methods()[method].predict(Ground.of(motion), METHODS)
    assert predicted is not None
    return [remark.split("unreliable, since ")[1] for remark in predicted.remarks]


#: A flat top, and the same without: rises, rests, falls by 1000 mm/s in one second, and returns.
FLAT = motion_of([1.0, 1.5, 3.5, 4.5, 5.0], [0.0, 500.0, 500.0, -500.0, 0.0])
POINTED = motion_of([1.0, 1.5, 2.5, 3.0], [0.0, 500.0, -500.0, 0.0])


@pytest.mark.parametrize("method", ["pulse", "simplified"])
def test_a_plateau_is_told_and_a_pointed_pulse_is_not_awkward(method):
    assert said(POINTED, method) == []
    (plateau,) = [one for one in said(FLAT, method) if "plateau" in one]
    assert "0.73 of the time (unreliable from 0.6 on)" in plateau


def test_the_share_of_a_plateau_is_that_of_its_picture():
    """Two seconds of rest, and 0.2 of one second's fall, of three; 0.2 of a straight line; wherever the rest is, and whatever the sign."""
    assert rest_share(FLAT, 1.5, 4.5) == pytest.approx(2.2 / 3.0, abs=0.01)
    assert rest_share(FLAT, 3.5, 4.5) == pytest.approx(0.2, abs=0.01)
    assert rest_share(FLAT.scaled(-1.0), 1.5, 4.5) == rest_share(FLAT, 1.5, 4.5)
    middle = motion_of([0.0, 1.0, 3.0, 4.0], [0.0, 250.0, 250.0, 500.0])
    assert rest_share(middle, 0.0, 4.0) == pytest.approx(0.6, abs=0.01)


def test_ripples_on_a_plateau_are_told_where_they_change_the_answer():
    rippled = motion_of([1.0, 2.0, 4.0, 5.0, 5.5], [0.0, 500.0, 500.0, -500.0, 0.0], ripple=25.0)
    (ripples,) = [one for one in said(rippled, "pulse") if "ripples" in one]
    assert (
        "down to 0.05 PGV as peaks it is 372 mm in place of 225 mm (unreliable from a factor of 1.5 on)"
        in ripples
    )
    assert not [one for one in said(rippled, "simplified") if "ripples" in one]


@pytest.mark.parametrize(("ratio", "told"), [(0.75, False), (0.77, False), (0.83, True), (0.96, True)])
def test_slopes_near_those_of_friction_are_told(ratio, told):
    rise = 500.0 / (METHODS.constants.friction_deceleration / ratio)
    motion = motion_of([1.0, 1.0 + rise, 1.0 + 2.0 * rise, 1.0 + 3.0 * rise], [0.0, 500.0, 0.0, 0.0])
    reasons = [one for one in said(motion, "pulse") if "ku/kg" in one]
    assert len(reasons) == told
    shown = [float(one.split("ku/kg of ")[1].split(" ")[0]) for one in reasons]
    assert shown == pytest.approx(
        [ratio] * told, abs=0.02
    )  # the corners of the velocity are rounded by the time step


def test_the_remarks_name_the_record_and_do_not_depend_on_its_sign():
    predicted = [
        prediction_methods()["pulse"].predict(Ground.of(one), METHODS)
        for motion in [named_motion("LPG").scaled_to_pgv(250.0)]
        for one in (motion, motion.scaled(-1.0))
    ]
    one, mirrored = (found.remarks for found in predicted if found is not None)
    assert one == mirrored
    assert len(one) == 2
    assert all(remark.startswith("LPG: dy by the pulse method is unreliable") for remark in one)
