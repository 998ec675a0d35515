"""Methods of one direction for a station: ours, by what did best over FEMA P-695; ``docs/prediction.md`` has the evidence.

A method of pulses is put to every horizontal direction by itself, and the one counts in which the displacement changes most. A method that knows the PGV alone is given that of the resultant.
"""

import math
from typing import NamedTuple

import numpy as np

from dcfp.methods.method import Information
from dcfp.methods.prediction import Ground, Methods, prediction_methods
from dcfp.methods.pulses import NOTHING, Prediction, find_pulses_along
from dcfp.motion.station import Station

#: Directions over half a turn, the first of which is that of the peak velocity.
DIRECTIONS = 12


class InDirections(NamedTuple):
    """What a method of one direction says of a station, by which direction, from x towards y [degrees]; None where it is of none."""

    method: str
    information: Information
    prediction: Prediction
    direction: float | None


def predict_in_directions(station: Station, methods: Methods) -> list[InDirections]:
    """Return what the methods of Li et al. (2020) say of a station, as far as they can be used.

    It does not depend on where x and y point, nor on the sign of the motion.
    """
    known = prediction_methods().values()
    pgv = Ground(station.peak_velocity)
    found = [
        InDirections(one.name, Information.PGV, said.prediction, None)
        for one in known
        if one.knows == (Information.PGV,) and (said := one.predict(pgv, methods)) is not None
    ]
    directions = _directions(station)
    pulses = [find_pulses_along(station, angle, methods.threshold) for angle in directions]
    for one in known:
        if one.of_pulses is None:
            continue
        said = [by_pulse.largest for of in pulses if (by_pulse := one.of_pulses(of, methods)) is not None]
        if said:
            changes = [prediction.displacement_change for prediction in said]
            most = int(np.nanargmax([0.0, *changes])) - 1
            moves = most >= 0
            prediction, direction = (said[most], directions[most]) if moves else (NOTHING, None)
            found.append(InDirections(one.name, Information.BLIND, prediction, direction))
    return found


def _directions(station: Station) -> list[float]:
    """Return the directions from x towards y [degrees], from 0 to 180."""
    x, y = station.velocity[np.argmax(np.sum(station.velocity**2, axis=1))]
    first = math.degrees(math.atan2(y, x))
    return [(first + part * 180.0 / DIRECTIONS) % 180.0 for part in range(DIRECTIONS)]
