"""Rules for what counts as a peak of the ground velocity. Each takes a ground motion and returns its pulses."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
import scipy.signal
from numpy.typing import NDArray

from dcfp.methods import Pulses, find_pulses
from dcfp.methods.li_2020 import LI_2020
from dcfp.motion.ground_motion import GroundMotion

Array = NDArray[np.float64]
Rule = Callable[[GroundMotion], Pulses]

#: Turn-back, relative to PGV, with which every extreme of a record counts [-].
ALL = 1e-9
THRESHOLDS = (0.02, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5)


def by_turning_back(motion: GroundMotion, threshold: float) -> Pulses:
    """Return peaks from which the velocity turns back by a part of the PGV: the package's rule."""
    return find_pulses(motion, threshold)


def by_prominence(motion: GroundMotion, prominence: float) -> Pulses:
    """Return peaks and troughs of a topographic prominence, a part of the PGV."""
    times, velocities = _extremes(motion)
    least = prominence * float(np.abs(velocities).max())
    high = scipy.signal.find_peaks(velocities, prominence=least)[0]
    low = scipy.signal.find_peaks(-velocities, prominence=least)[0]
    kept = np.concatenate((high, low))
    kinds = np.concatenate((np.ones(high.size), -np.ones(low.size)))
    order = np.argsort(kept)
    return _alternate(times, velocities, kept[order], kinds[order])


def by_zero_crossing(motion: GroundMotion, least: float) -> Pulses:
    """Return the furthest point between two zero crossings; those below a part of the PGV are dropped."""
    times, velocities = _extremes(motion)
    sides = np.sign(velocities)
    runs = np.split(np.arange(velocities.size), np.flatnonzero(np.diff(sides)) + 1)
    kept = np.array([run[np.argmax(np.abs(velocities[run]))] for run in runs])
    kept = kept[np.abs(velocities[kept]) > least * np.abs(velocities).max()]
    return _alternate(times, velocities, kept, sides[kept])


def by_filter(motion: GroundMotion, corner: float, own_values: bool = True) -> Pulses:
    """Return all peaks of the velocity behind a low-pass filter of fourth order without phase, `corner` [Hz].

    Their velocities are those behind the filter, or the furthest of the record halfway to the next peaks.
    """
    sections = scipy.signal.butter(2, corner, fs=1.0 / motion.time_step, output="sos")
    still = np.zeros(round(2.0 / corner / motion.time_step))
    padded = np.concatenate((still, motion.acceleration, still))
    smooth = scipy.signal.sosfiltfilt(sections, padded)
    found = find_pulses(replace(motion, acceleration=smooth), 1e-3)  # not the filter's ringing in the silence
    times = found.times - still.size * motion.time_step
    if own_values:
        return Pulses(times, found.velocities)
    all_times, all_velocities = _extremes(motion)
    borders = np.concatenate(([-np.inf], 0.5 * (times[1:] + times[:-1]), [np.inf]))
    first = 1.0 if found.velocities[0] > found.velocities[1] else -1.0
    kept, kinds = [], []
    for i in range(times.size):
        inside = np.flatnonzero((borders[i] <= all_times) & (all_times < borders[i + 1]))
        if inside.size:
            kinds.append(first * (-1.0) ** i)
            kept.append(inside[np.argmax(kinds[-1] * all_velocities[inside])])
    return _alternate(all_times, all_velocities, np.array(kept), np.array(kinds))


def by_duration(motion: GroundMotion, threshold: float, shortest: float) -> Pulses:
    """Return peaks by turning back that are `shortest` [s] apart.

    Of the legs that are shorter the smallest goes first; one larger than both its neighbours stays.
    """
    pulses = find_pulses(motion, threshold)
    times, velocities = list(pulses.times), list(pulses.velocities)
    while len(times) > 2:
        sizes = np.abs(np.diff(velocities))
        beside = np.maximum(np.concatenate(([0.0], sizes[:-1])), np.concatenate((sizes[1:], [0.0])))
        goes = np.flatnonzero((np.diff(times) < shortest) & (sizes < beside))
        if goes.size == 0:
            break
        leg = int(goes[np.argmin(sizes[goes])])
        # at an end of the record only the outermost peak goes
        start, stop = (leg if leg < len(times) - 2 else leg + 1), (leg + 2 if leg else 1)
        del times[start:stop], velocities[start:stop]
    return Pulses(np.array(times), np.array(velocities), threshold)


def by_friction(motion: GroundMotion, duration: float) -> Pulses:
    """Return peaks from which the velocity turns back by what friction changes in a `duration` [s]."""
    return find_pulses(motion, min(1.0, LI_2020.friction_deceleration * duration / motion.peak_velocity))


def _extremes(motion: GroundMotion) -> tuple[Array, Array]:
    """Return time and velocity of all extremes."""
    every = find_pulses(motion, ALL)
    return every.times, every.velocities


def _alternate(times: Array, velocities: Array, kept: NDArray[np.int64], kinds: Array) -> Pulses:
    """Return pulses of peaks (kind 1) and troughs (-1): of equal ones in a row the furthest, and the two ends as the package sets them."""
    chosen: list[int] = []
    last = 0.0
    for place, kind in zip(kept, kinds, strict=True):
        if kind != last:
            chosen.append(int(place))
        elif kind * velocities[place] > kind * velocities[chosen[-1]]:
            chosen[-1] = int(place)
        last = kind
    if not chosen:
        return Pulses(times[:0], velocities[:0])
    before, after = velocities[: chosen[0]], velocities[chosen[-1] + 1 :]
    if before.size:
        chosen.insert(0, before.size - 1 - int(np.argmin(kinds[0] * before[::-1])))
    if after.size:
        chosen.append(chosen[-1] + 1 + int(np.argmin(last * after)))
    return Pulses(times[chosen], velocities[chosen])


def candidates() -> dict[str, Rule]:
    """Return the rules by their names in tables."""
    rules: dict[str, Rule] = {}
    for part in THRESHOLDS:
        rules[f"turns back by {part:g} PGV"] = partial(by_turning_back, threshold=part)
    for part in (0.1, 0.2, 0.3):
        rules[f"prominence {part:g} PGV"] = partial(by_prominence, prominence=part)
    for part in (0.0, 0.05, 0.1, 0.2):
        rules[f"zero crossings, from {part:g} PGV"] = partial(by_zero_crossing, least=part)
    for own, words in ((True, ""), (False, ", record's values")):
        for corner in (0.5, 1.0, 2.0, 4.0):
            rules[f"low-pass {corner:g} Hz{words}"] = partial(by_filter, corner=corner, own_values=own)
    for part in (0.1, 0.2):
        for shortest in (0.1, 0.2, 0.3):
            name = f"turns back by {part:g} PGV, {shortest:g} s apart"
            rules[name] = partial(by_duration, threshold=part, shortest=shortest)
    for duration in (0.1, 0.2, 0.4):
        rules[f"turns back by mu_n g × {duration:g} s"] = partial(by_friction, duration=duration)
    return rules
