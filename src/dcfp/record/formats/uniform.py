"""Times in a column: whether they are equally spaced, as far as the printed digits can tell."""

import re

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.record.formats.source import SourceText


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
    expected = time[0] + np.arange(time.size) * time_step
    off = np.abs(time - expected) > 1.001 * resolution + 1e-9 * np.abs(expected)
    if off.any():
        place = int(np.flatnonzero(off)[0])
        source.fail(
            f"the times are not equally spaced: time {place + 1} is {time[place]:g} s where "
            f"{expected[place]:g} s was expected."
        )


def uniform_step(source: SourceText, time: FloatArray, resolution: float) -> float:
    """Return the time step [s] of equally spaced times: the roundest number that agrees with all of them.

    Raises
    ------
    InputError
        If the times do not go up, are printed with too few digits, or are not equally spaced.
    """
    if time.size < 2:
        source.fail("the file holds fewer than two times.")
    if not (np.diff(time) > 0.0).all():
        place = int(np.flatnonzero(~(np.diff(time) > 0.0))[0])
        source.fail(
            f"time {place + 2} ({time[place + 1]:g} s) is not later than the one before it; "
            "times must go up and be printed with enough digits."
        )
    mean_step = float((time[-1] - time[0]) / (time.size - 1))
    step = _roundest(mean_step, resolution / (time.size - 1))
    check_times(source, time, step, resolution)
    return step


def _roundest(value: float, tolerance: float) -> float:
    for digits in range(1, 12):
        rounded = float(f"{value:.{digits}g}")
        if abs(rounded - value) <= tolerance:
            return rounded
    return value
