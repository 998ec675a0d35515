"""Times in a column: whether they are equally spaced, as far as the printed digits can tell."""

import re
from collections.abc import Iterator

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.motion.formats.source import SourceText


def printed_resolution(word: str) -> float:
    """Return the last digit's place in a printed number: 0.01 for ``"1.25"`` and for ``"1.25e0"``."""
    mantissa, _, exponent = word.strip().upper().replace("D", "E").partition("E")
    decimals = len(mantissa.partition(".")[2])
    power = int(exponent) if re.fullmatch(r"[+-]?\d{1,3}", exponent) else 0
    return float(10.0 ** max(min(power - decimals, 300), -300))


def check_times(source: SourceText, time: FloatArray, time_step: float, resolution: float) -> None:
    """Check that `time` [s] goes up by `time_step` [s], within the rounding of its printed digits.

    Raises
    ------
    InputError
        If a time is off by more than `resolution` [s].
    """
    with np.errstate(over="ignore", invalid="ignore"):
        expected = time[0] + np.arange(time.size) * time_step
        off = ~(np.abs(time - expected) <= 1.001 * resolution + 1e-9 * np.abs(expected))
    if off.any():
        place = int(np.flatnonzero(off)[0])
        source.fail(
            f"the times are not equally spaced: time {place + 1} is {time[place]:g} s where "
            f"{expected[place]:g} s was expected."
        )


def uniform_step(source: SourceText, time: FloatArray, resolution: float) -> float:
    """Return the step [s] of equally spaced times: the roundest step or rate that agrees with them.

    Raises
    ------
    InputError
        If the times do not go up, are printed with too few digits, or are not equally spaced.
    """
    if time.size < 2:
        source.fail("the file holds fewer than two times.")
    with np.errstate(over="ignore"):
        steps = np.diff(time)
    if not (steps > 0.0).all():
        place = int(np.flatnonzero(~(steps > 0.0))[0])
        source.fail(
            f"time {place + 2} ({time[place + 1]:g} s) is not later than the one before it; "
            "times must go up and be printed with enough digits."
        )
    mean_step = (float(time[-1]) - float(time[0])) / (time.size - 1)
    step, tolerance = next(_fitting_steps(time, mean_step, resolution), (mean_step, resolution))
    if tolerance > 0.0 and resolution > 0.5 * mean_step:
        source.fail("the times are printed with too few digits to tell their step; print more digits.")
    check_times(source, time, step, resolution)
    return step


def _fitting_steps(time: FloatArray, mean_step: float, resolution: float) -> Iterator[tuple[float, float]]:
    """Yield steps, or rates, of few digits and how far the times are off: not at all, rounded, or cut off."""
    if not 1e-9 < mean_step < 1e9:
        return
    place = np.arange(time.size)
    for tolerance in (0.0, 0.5 * resolution, resolution):
        for digits in range(1, 10):
            for step in (float(f"{mean_step:.{digits}g}"), 1.0 / float(f"{1.0 / mean_step:.{digits}g}")):
                off = np.abs(time - time[0] - place * step).max()
                if off <= tolerance + 1e-3 * resolution:
                    yield step, tolerance
