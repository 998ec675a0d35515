"""Predictions: the printed check values, what a pulse must not depend on, and how good the intervals and our own march are."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial

import numpy as np

from dcfp.analysis import respond
from dcfp.inference import Case, Methods
from dcfp.inference.forecast import cases_at
from dcfp.inference.refit import governing
from dcfp.inference.statistics import COVERED, coverage, ratios, scatter
from dcfp.methods import Pulses, find_pulses, march_through_pulses
from dcfp.methods.li_2020 import LI_2020 as PAPER
from dcfp.methods.li_2020 import predict_from_pgv, predict_from_pulses
from dcfp.methods.li_2020.constants import PRINTED_DESIGN, PULSE
from dcfp.methods.method import Information, Variant
from dcfp.methods.pulse_march import NAME as MARCH
from dcfp.methods.pulses import CHANGE, DISPLACEMENT, MARCH_THRESHOLD, value_of
from dcfp.motion import treatment
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.named import VELOCITIES
from dcfp.schema.quantities import Quantity
from dcfp.system import LI_2020, ConstantFriction, FrictionLaw, Heating, Li2020, NoHeating, SimplifiedHeating
from dcfp.verify.check import RECORDS, Finding, Task, scaled_record

GROUP = "Prediction"
_PAPER = "Li et al. (2020)"
#: Records whose mean kg_ave is: Li et al. (2020), Table 3.
_PAPER_RECORDS = 8
#: Dispersion of the march over that of the pulse method that was aimed at [-].
_AIM = 0.7
#: How far a coverage may be from 90 %: 85 to 95 % was aimed at [-].
_COVERAGE_MARGIN = 0.05

_PULSE = Variant(PULSE, Information.BLIND)
_MARCH = Variant(MARCH, Information.BLIND)


def _design(pgv: float, quantity: Quantity, value: float, last_digit: float) -> Finding:
    said = value_of(predict_from_pgv(pgv), quantity)
    note = "Allowed: half of the last printed digit."
    return Finding(said, value, quantity.unit.name, 0.5 * last_digit, note, f"{_PAPER}, Eqs (31)-(33)")


def _largest(motion: GroundMotion) -> float:
    return predict_from_pulses(find_pulses(motion)).largest.displacement_change


def _mirrored(motion: GroundMotion) -> GroundMotion:
    return motion.scaled(-1.0)


def _padded(motion: GroundMotion) -> GroundMotion:
    silence = np.zeros(500)
    return replace(motion, acceleration=np.concatenate((silence, motion.acceleration, silence)))


def _resampled(motion: GroundMotion) -> GroundMotion:
    return treatment.resample(motion, 3)


def _thinned(motion: GroundMotion) -> GroundMotion:
    """Return every second value of a motion that was made finer first by the same straight lines."""
    finer = treatment.resample(motion, 3)
    return replace(finer, acceleration=finer.acceleration[::2], time_step=2.0 * finer.time_step)


def _invariance(change: Callable[[GroundMotion], GroundMotion], limit: float) -> Finding:
    worst, name = 0.0, ""
    for one in RECORDS:
        motion = scaled_record(one, 500.0)
        off = abs(_largest(change(motion)) / _largest(motion) - 1.0)
        if off >= worst:
            worst, name = off, one
    note = f"dy of the pulse method, largest relative difference of four records: {name}."
    return Finding(worst, 0.0, "-", limit, note, "the same record, otherwise written down")


def half_cosines(pulses: Pulses, step: float) -> GroundMotion:
    """Return the motion whose velocity goes from peak to peak in half cosines."""
    start, end = float(pulses.times[0]), float(pulses.times[-1])
    time = np.arange(0.0, end - start + step, step) + start
    leg = np.clip(np.searchsorted(pulses.times, time, side="right") - 1, 0, pulses.times.size - 2)
    length = np.diff(pulses.times)[leg]
    phase = np.clip((time - pulses.times[leg]) / length, 0.0, 1.0)
    amplitude = 0.5 * math.pi * np.diff(pulses.velocities)[leg] / length
    return GroundMotion(amplitude * np.sin(math.pi * phase), step, "half cosines")


def _march(friction: FrictionLaw, heating: Heating) -> Finding:
    pulses = find_pulses(scaled_record("KNA", 500.0), MARCH_THRESHOLD)
    stiff = LI_2020.unchecked(elastic_stiffness=1e4 * LI_2020.elastic_stiffness)
    said = march_through_pulses(pulses, stiff, friction, heating, parts=200).prediction
    analysed = respond(half_cosines(pulses, 0.001), stiff, friction, heating)
    note = "y_max under the pulses of KNA at 0.5 m/s; 200 steps a leg. Allowed: what the samples and the stiff spring (b) of the analysis leave."
    source = "response history analysis of the same half cosines with spring (b) 10 000 times as stiff"
    return Finding(said.bound, analysed.peak_displacement, "mm", 2e-3, note, source, relative=True)


@cache
def _hundred(velocity: float) -> tuple[Case, ...]:
    return tuple(cases_at(velocity, Methods()))


def _average_slope() -> Finding:
    _, slopes = governing(_hundred(VELOCITIES[0]))
    limit = float(slopes.std(ddof=1)) / math.sqrt(_PAPER_RECORDS)
    note = "Mean of the governing pulses of 100 components at PGV 0.25 m/s. Allowed: the standard error of a mean of eight such records."
    source = f"{_PAPER}, section 6.2.2, of eight records"
    return Finding(float(slopes.mean()), PAPER.average_slope, "mm/s2", limit, note, source)


def _dispersion(quantity: Quantity) -> Finding:
    cases = [case for velocity in VELOCITIES for case in _hundred(velocity)]
    march, pulse = (scatter(ratios(cases, variant, quantity)).dispersion for variant in (_MARCH, _PULSE))
    note = f"400 cases: {pulse:.3f} over {march:.3f}. Expected: the least that was aimed at; more is better."
    source = "logarithmic dispersion of prediction over analysis, pulse method over march"
    return Finding(pulse / march, 1.0 / _AIM, "-", 0.0, note, source, more_is_better=True)


def _coverage(variant: Variant | None, quantity: Quantity) -> Finding:
    found = coverage([_hundred(velocity) for velocity in VELOCITIES], variant, quantity)
    note = f"Mean of {found.splits} random halves of 19 earthquakes, 5 to 95 % of which have {found.low:.2f} to {found.high:.2f}; an interval is {found.width:.2f} wide, upper over lower end."
    return Finding(
        found.mean,
        COVERED,
        "-",
        _COVERAGE_MARGIN,
        note,
        "part of the held-out cases inside the 90 % interval",
    )


def _task(name: str, measure: Callable[[], Finding]) -> Task:
    return Task(GROUP, name, measure)


TASKS = (
    *(
        _task(f"design method, {q.title} at PGV {pgv / 1e3:g} m/s", partial(_design, pgv, q, value, digit))
        for pgv, known in PRINTED_DESIGN.items()
        for q, (value, digit) in known.items()
    ),
    _task("pulses, mirrored record", partial(_invariance, _mirrored, 1e-12)),
    _task("pulses, zeros before and after", partial(_invariance, _padded, 1e-2)),
    _task("pulses, record at a third of its step", partial(_invariance, _resampled, 1e-9)),
    _task("pulses, record at two thirds of its step", partial(_invariance, _thinned, 1e-2)),
    _task("march, constant friction", partial(_march, ConstantFriction(), NoHeating())),
    _task("march, friction that heats", partial(_march, Li2020(), SimplifiedHeating())),
    _task("kg_ave of the hundred", _average_slope),
    *(
        _task(f"pulse method against march, {q.title}", partial(_dispersion, q))
        for q in (CHANGE, DISPLACEMENT)
    ),
    *(
        _task(f"90 % interval from {words}, {q.title}", partial(_coverage, variant, q))
        for variant, words in ((None, "the PGV"), (_PULSE, "the pulse method"), (_MARCH, "the march"))
        for q in (CHANGE, DISPLACEMENT)
    ),
)
