"""Predictions: the printed check values, what a pulse must not depend on, and how good the intervals and our own march are."""

import math
from collections.abc import Callable
from dataclasses import asdict, replace
from functools import cache

import numpy as np

from dcfp.analysis import respond
from dcfp.inference import Case, Methods
from dcfp.inference.coverage import coverage
from dcfp.inference.forecast import cases_at
from dcfp.inference.refit import governing
from dcfp.inference.statistics import COVERED, ratios, scatter
from dcfp.methods import Nodes, Pulses, find_nodes, find_pulses, march_through_pulses
from dcfp.methods.li_2020 import LI_2020 as PAPER
from dcfp.methods.li_2020 import predict_from_pgv, predict_from_pulses
from dcfp.methods.li_2020.constants import DERIVED_DESIGN, PULSE
from dcfp.methods.method import Information, Variant
from dcfp.methods.pulse_march import NAME as MARCH
from dcfp.methods.pulses import CHANGE, DISPLACEMENT, HYSTERETIC, INPUT, value_of
from dcfp.motion import treatment
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import VELOCITIES
from dcfp.system import LI_2020, ConstantFriction, FrictionLaw, Heating, Li2020, NoHeating, SimplifiedHeating
from dcfp.verify.check import RECORDS, Found, scaled_record

#: Records whose mean kg_ave is: Li et al. (2020), Table 3.
_PAPER_RECORDS = 8
#: Dispersion of the march over that of the pulse method that was aimed at [-].
_AIM = 0.7

_PULSE = Variant(PULSE, Information.BLIND)
_MARCH = Variant(MARCH, Information.BLIND)
_QUANTITIES = {one.title: one for one in (INPUT, HYSTERETIC, CHANGE, DISPLACEMENT)}
_MODELS: dict[str, tuple[FrictionLaw, Heating]] = {
    "constant friction": (ConstantFriction(), NoHeating()),
    "friction that heats": (Li2020(), SimplifiedHeating()),
}
#: What an interval is from; None for the PGV.
_GIVEN = {
    "the PGV": (None, None), "the PGV and the spectrum": (None, Methods()), "the pulse method": (_PULSE, Methods()), "the march": (_MARCH, Methods()),
}  # fmt: skip


def design(pgv: float, quantity: str) -> Found:
    """Return what the design method gives for a PGV [m/s], and what the paper's equations do."""
    known = _QUANTITIES[quantity]
    value, last_digit = DERIVED_DESIGN[1e3 * pgv][known]
    words = {"unit": known.unit.name}
    return Found(value_of(predict_from_pgv(1e3 * pgv), known), value, 0.5 * last_digit, words)


def gravity() -> float:
    """Return g of the methods [mm/s2], from their mu_n g and mu_n."""
    return PAPER.friction_deceleration / PAPER.nominal_friction


def _largest(motion: GroundMotion) -> float:
    return predict_from_pulses(find_pulses(motion)).largest.displacement_change


def _thinned(motion: GroundMotion) -> GroundMotion:
    """Return a motion with every second value after it was made finer by the same straight lines."""
    finer = treatment.resample(motion, 3)
    return replace(finer, acceleration=finer.acceleration[::2], time_step=2.0 * finer.time_step)


#: Other ways to write a motion down.
_OTHERWISE: dict[str, Callable[[GroundMotion], GroundMotion]] = {
    "mirrored": lambda motion: motion.scaled(-1.0),
    "padded": lambda motion: replace(motion, acceleration=np.pad(motion.acceleration, 500)),
    "resampled": lambda motion: treatment.resample(motion, 3),
    "thinned": _thinned,
}


def invariance(change: str) -> dict[str, float]:
    """Return by how much dy of the pulse method differs where a record is written down otherwise, by records [-]."""
    motions = {name: scaled_record(name, 500.0) for name in reversed(RECORDS)}
    other = _OTHERWISE[change]
    return {name: abs(_largest(other(one)) / _largest(one) - 1.0) for name, one in motions.items()}


def straight_legs(nodes: Nodes | Pulses, step: float) -> GroundMotion:
    """Return the motion whose velocity goes from node to node in straight lines, each corner rounded within a step [s]."""
    start, end = float(nodes.times[0]), float(nodes.times[-1])
    time = np.arange(start - step, end + 2.0 * step, step)
    ahead, behind = (
        np.interp(time + shift, nodes.times, nodes.velocities) for shift in (0.5 * step, -0.5 * step)
    )
    return GroundMotion((ahead - behind) / step, step, "straight legs")


def march(friction: str) -> tuple[float, float]:
    """Return y_max of the march and of the analysis under the same straight legs [mm]."""
    law, heating = _MODELS[friction]
    nodes = find_nodes(scaled_record("KNA", 500.0))
    stiff = LI_2020.unchecked(elastic_stiffness=1e4 * LI_2020.elastic_stiffness)
    said = march_through_pulses(nodes, stiff, law, heating, parts=200).prediction
    return said.bound, respond(straight_legs(nodes, 0.001), stiff, law, heating).peak_displacement


@cache
def _hundred(velocity: float) -> tuple[Case, ...]:
    return tuple(cases_at(velocity, Methods()))


def average_slope() -> Found:
    """Return the mean slope of the governing pulses of the hundred, and that of the paper [mm/s2]."""
    _, slopes = governing(_hundred(VELOCITIES[0]))
    limit = float(slopes.std(ddof=1)) / math.sqrt(_PAPER_RECORDS)
    return Found(float(slopes.mean()), PAPER.average_slope, limit)


def dispersion(quantity: str) -> Found:
    """Return the dispersion of the pulse method over that of the march, and what was aimed at [-]."""
    cases = [case for velocity in VELOCITIES for case in _hundred(velocity)]
    marched, pulse = (
        scatter(ratios(cases, variant, _QUANTITIES[quantity])).dispersion for variant in (_MARCH, _PULSE)
    )
    return Found(pulse / marched, 1.0 / _AIM, words={"pulse": pulse, "march": marched})


def interval(given: str, quantity: str) -> Found:
    """Return the part of the cases inside of the 90 % interval, and what it ought to be [-]."""
    sets = [_hundred(velocity) for velocity in VELOCITIES]
    variant, methods = _GIVEN[given]
    found = coverage(sets, variant, _QUANTITIES[quantity], methods)
    return Found(found.mean, COVERED, words=asdict(found))
