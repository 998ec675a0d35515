"""The coordinates of a study's results."""

from typing import Any

import numpy as np

from dcfp.inference.calibration import event_of
from dcfp.study.factors import factor
from dcfp.study.plan import Plan
from dcfp.study.study import RECORD, SAMPLE

Coordinate = tuple[str, Any, dict[str, str]]


def coordinates(plan: Plan) -> dict[str, Coordinate]:
    """Return each coordinate as its dimension, values and attributes."""
    found: dict[str, Coordinate] = {}
    for name, values in plan.study.factors.items():
        found[name] = (name, _array(name, list(values)), _attributes(name))
    if plan.samples:
        numbers = np.arange(plan.sizes[SAMPLE])
        found[SAMPLE] = (SAMPLE, numbers, {"long_name": "number of the sample"})
        for name, values in plan.samples.items():
            found[name] = (SAMPLE, _array(name, values.tolist()), _attributes(name))
    along = RECORD if RECORD in plan.study.factors else SAMPLE
    return found | _of_records(plan, along)


def _of_records(plan: Plan, along: str) -> dict[str, Coordinate]:
    """Return what is known of the record at each place along a dimension."""
    motions = {motion.name: motion for motion in plan.study.motions}
    names = plan.study.factors.get(RECORD) or plan.samples[RECORD].tolist()
    chosen = [motions[str(name)] for name in names]
    words: dict[str, tuple[list[Any], dict[str, str]]] = {
        "event": ([event_of(one) for one in chosen], {"long_name": "earthquake"}),
        "station": ([one.origin.station for one in chosen], {"long_name": "station"}),
        "record_sha256": ([one.digest for one in chosen], {"long_name": "SHA-256 of the record"}),
    }
    found: dict[str, Coordinate] = {
        name: (along, np.array(values, dtype=object), attributes)
        for name, (values, attributes) in words.items()
    }
    found["time_step"] = (
        along,
        np.array([one.time_step for one in chosen]),
        {"long_name": "time step of the record", "units": "s"},
    )
    found["unscaled_pgv"] = (
        along,
        np.array([one.peak_velocity for one in chosen]),
        {"long_name": "peak ground velocity of the record as it is", "units": "mm s-1"},
    )
    return found


def _array(name: str, values: list[Any]) -> "np.ndarray[Any, Any]":
    return np.array(values, dtype=np.float64 if factor(name).is_number else object)


def _attributes(name: str) -> dict[str, str]:
    one = factor(name)
    attributes = {"long_name": one.words}
    return {**attributes, "units": one.cf_unit} if one.is_number else attributes
