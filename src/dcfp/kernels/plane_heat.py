r"""Heat under a disc of contact that goes about a plate in two directions.

The plate is a grid of points. A point that has always been under the slider has the state of the *common* modes, which feel every flux. Another covered point
differs from them by modes that only decay, and a point in the open cools by itself: both are brought up to date only when the rim passes them, from the time that is kept with
them. So a step costs the common modes, the sum *inside* of the differences under the slider, and the points that the rim passes.
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import called_kernel, kernel
from dcfp.kernels.heat_state import (
    COMMON,
    COOLED,
    CYCLING_PARAMETER,
    DISC,
    EXPECTED,
    INSIDE,
    NO_HEATING,
    PLATE_ROW,
    PLATE_ROWS,
    POINT,
    PRESENT,
    RATES,
    RATIO,
    STEP_ENTRIES,
    STEP_ENTRY,
    STEP_ROW,
    STEP_ROWS,
    Heat,
)
from dcfp.kernels.motion import SystemConstants, share, speed_factor
from dcfp.kernels.plane_step import length_of, times
from dcfp.kernels.sum_of_exponentials import (
    MODES,
    accumulate,
    decay,
    decayed_total,
    exp_neg,
    fill_decay,
    total,
)

# what is counted on a plate: covered points; those of them that have felt every flux; change of the mean by what the rim passes [degC/s]; the highest
# temperature of a point so far [degC], and a point that is likely to be the hottest; which one was the
# hottest so far, below zero while it has always been covered; where the disc was last moved to, in spacings
(
    COVERED_POINTS,
    ALWAYS,
    SWEEP_RATE,
    HOTTEST,
    HOT_ROW,
    HOT_COLUMN,
    PEAK_ROW,
    PEAK_COLUMN,
    DISC_X,
    DISC_Y,
    TALLIES,
) = range(11)
#: How far the disc may be from its place before it is moved, in spacings: far less than what the grid leaves open.
_AWAY = 0.02
#: Time over which the change of the mean by what the rim passes is smoothed [s].
_SMOOTH = 0.02
#: How close to the highest temperature of a point all points need not be looked at [degC].
_CLOSE = 0.1
# rows of the modes of a plate: a bound of the differences from the common modes, mode by mode; and of the first plate, room for factors
BOUND = 2
_SCRATCH = PLATE_ROW + PLATE_ROWS - 1


class Field(NamedTuple):
    """Grids of points on the plates, whose origin is the point in the middle."""

    spacing: float  # [mm]
    radius: float  # of the slider [mm]
    points: NDArray[
        np.float64
    ]  # (plates, rows, columns, MODES + 1); last of a point is the time it stands for [s]
    spans: NDArray[np.int64]  # (plates, rows, 2): first covered column, and the first beyond
    tallies: NDArray[np.float64]  # (plates, TALLIES)


@kernel
def _covered_part(heat: Heat, portion: float, start: float, end: float) -> float:
    """Part of a step in which the flux reaches the modes of a plate: of the way between two distances from the centre [mm], what is within Eq. (12)."""
    if heat.kind != POINT:
        return 1.0
    before, after = portion * start <= heat.half_contact, portion * end <= heat.half_contact
    if before == after:
        return 1.0 if after else 0.0
    part = (heat.half_contact / portion - start) / (end - start)
    return part if before else 1.0 - part


@kernel
def crosses_edge(heat: Heat, system: SystemConstants, start: float, end: float) -> bool:
    """Whether the point in the centre of a plate comes under the slider or leaves it between two distances [mm]."""
    if heat.kind != POINT:
        return False
    for i in range(system.plates):
        portion = share(system, i)
        if (portion * start <= heat.half_contact) != (portion * end <= heat.half_contact):
            return True
    return False


@kernel
def expect_cooling(heat: Heat, field: Field, system: SystemConstants, place: int, length: float) -> None:
    """Store the temperatures to expect at the end of a step without friction, from which `expect` goes on."""
    factors = STEP_ROW + STEP_ROWS * place
    for i in range(system.plates):
        rise = heat.ambient
        if heat.kind != NO_HEATING:
            first = PLATE_ROW + i * PLATE_ROWS
            rise += decayed_total(heat.modes, factors, first + COMMON)
            if heat.kind == DISC:
                inside = decayed_total(heat.modes, factors, first + INSIDE)
                rise += inside / field.tallies[i, COVERED_POINTS] + length * field.tallies[i, SWEEP_RATE]
        heat.workspace[COOLED + i] = rise


@kernel
def expect(
    heat: Heat,
    system: SystemConstants,
    place: int,
    start: float,
    end: float,
    opening: float,
    closing: float,
    rubbing: float,
) -> None:
    """Store the temperatures and cycling parameters to expect at the end of a step, without taking it, after `expect_cooling`.

    Distances from the centre at `start` and `end` [mm], fluxes mu p |v| then [N/(mm s)], `rubbing` the integral of p v2 [N/s].
    """
    workspace, entry = heat.workspace, STEP_ENTRY + STEP_ENTRIES * place
    for i in range(system.plates):
        rise = workspace[COOLED + i]
        if heat.kind != NO_HEATING:
            portion, felt = share(system, i), 0.0
            if _covered_part(heat, portion, start, end) == 1.0:
                felt = portion * workspace[RATIO + i]
            if felt * closing + opening > 0.0:
                rise += felt * (
                    workspace[entry + 1] * opening + (workspace[entry + 2] + heat.instant) * closing
                )
        workspace[EXPECTED + i] = rise
        workspace[EXPECTED + CYCLING_PARAMETER + i] = (
            workspace[PRESENT + CYCLING_PARAMETER + i] + speed_factor(system, i) ** 2 * rubbing
        )


@kernel
def heat_up(
    heat: Heat,
    field: Field,
    system: SystemConstants,
    place: int,
    time: float,
    length: float,
    start: complex,
    middle: complex,
    end: complex,
    opening: float,
    closing: float,
    now: float,
    rubbing: float,
) -> bool:
    """Take a step of `length` [s] from `time` [s] on; return False where the grid ends.

    Displacements [mm] at its `start`, `middle` and `end`. The flux is as if it went linearly from `opening` to `closing`; `now` is what it is at the end [N/(mm s)].
    """
    modes, workspace = heat.modes, heat.workspace
    for i in range(system.plates):
        workspace[PRESENT + CYCLING_PARAMETER + i] += speed_factor(system, i) ** 2 * rubbing
    if heat.kind == NO_HEATING:
        return True
    factors = STEP_ROW + STEP_ROWS * place
    fits = True
    for i in range(system.plates):
        portion, first = share(system, i), PLATE_ROW + i * PLATE_ROWS
        felt = portion * workspace[RATIO + i]
        if heat.kind == POINT:
            r0, r1 = length_of(start), length_of(end)
            part = _covered_part(heat, portion, r0, r1)
            rise = accumulate(modes, factors, first + COMMON, part * felt * opening, part * felt * closing)
            if portion * r1 <= heat.half_contact:
                rise += heat.instant * felt * now
            workspace[PRESENT + i] = heat.ambient + rise
            continue
        # half of the way before the heat and half after it: second order in the step
        swept = -total(modes, first + INSIDE) / field.tallies[i, COVERED_POINTS]
        fits = sweep(heat, field, i, time, times(portion, middle)) and fits
        swept += total(modes, first + INSIDE) / field.tallies[i, COVERED_POINTS]
        common = accumulate(modes, factors, first + COMMON, felt * opening, felt * closing)
        difference = decay(modes, factors, first + INSIDE)
        swept -= difference / field.tallies[i, COVERED_POINTS]
        fits = sweep(heat, field, i, time + length, times(portion, end)) and fits
        difference = total(modes, first + INSIDE) / field.tallies[i, COVERED_POINTS]
        swept += difference
        field.tallies[i, SWEEP_RATE] += (1.0 - exp_neg(length / _SMOOTH)) * (
            swept / length - field.tallies[i, SWEEP_RATE]
        )
        common += heat.instant * felt * now
        workspace[PRESENT + i] = heat.ambient + common + difference
        if field.tallies[i, HOTTEST] < math.inf:  # else nobody asks for it
            _note_hottest(heat, field, i, time + length, heat.ambient + common, factors)
    return fits


@kernel
def cool_down(heat: Heat, field: Field, system: SystemConstants, place: int, length: float) -> None:
    """Take a step without sliding: everything decays."""
    if heat.kind == NO_HEATING:
        return
    factors = STEP_ROW + STEP_ROWS * place
    for i in range(system.plates):
        first = PLATE_ROW + i * PLATE_ROWS
        rise = decay(heat.modes, factors, first + COMMON)
        if heat.kind == DISC:
            rise += decay(heat.modes, factors, first + INSIDE) / field.tallies[i, COVERED_POINTS]
            decay(heat.modes, factors, first + BOUND)
            field.tallies[i, SWEEP_RATE] *= exp_neg(length / _SMOOTH)
        heat.workspace[PRESENT + i] = heat.ambient + rise


@called_kernel
def _note_hottest(heat: Heat, field: Field, plate: int, time: float, common: float, factors: int) -> None:
    """Note the temperature of the hottest covered point if it is the highest so far; `common` [degC] is that of a point that has felt every flux.

    No point differs from the common modes by more, in any mode, than the bound that is kept: all points are looked at only where that could matter.
    """
    tallies, modes, bound = field.tallies, heat.modes, PLATE_ROW + plate * PLATE_ROWS + BOUND
    if tallies[plate, ALWAYS] > 0.0:
        if common > tallies[plate, HOTTEST]:
            tallies[plate, HOTTEST], tallies[plate, PEAK_ROW] = common, -1.0
        return
    decay(modes, factors, bound)
    if common + total(modes, bound) <= tallies[plate, HOTTEST] + _CLOSE:
        return
    row, column = int(tallies[plate, HOT_ROW]), int(tallies[plate, HOT_COLUMN])
    if field.spans[plate, row, 0] <= column < field.spans[plate, row, 1]:
        there = common + _difference(heat, field, plate, row, column, time)
        _note(tallies[plate], there)
        if common + total(modes, bound) <= tallies[plate, HOTTEST] + _CLOSE:
            return
    highest = -math.inf
    for j in range(MODES):
        modes[bound, j] = -math.inf
    for row in range(field.spans.shape[1]):
        for column in range(field.spans[plate, row, 0], field.spans[plate, row, 1]):
            difference = _difference(heat, field, plate, row, column, time)
            point = field.points[plate, row, column]
            for j in range(MODES):
                modes[bound, j] = max(modes[bound, j], modes[_SCRATCH, j] * point[j])
            if difference > highest:
                highest = difference
                tallies[plate, HOT_ROW], tallies[plate, HOT_COLUMN] = row, column
    _note(tallies[plate], common + highest)


@kernel
def _note(tallies: NDArray[np.float64], temperature: float) -> None:
    """Note a temperature of the point that is likely to be the hottest, if it is the highest so far."""
    if temperature > tallies[HOTTEST]:
        tallies[HOTTEST] = temperature
        tallies[PEAK_ROW], tallies[PEAK_COLUMN] = tallies[HOT_ROW], tallies[HOT_COLUMN]


@kernel
def _difference(heat: Heat, field: Field, plate: int, row: int, column: int, time: float) -> float:
    """Return the difference of a covered point to the common modes [degC], and leave the factors of its decay in the scratch row."""
    point = field.points[plate, row, column]
    fill_decay(heat.modes, RATES, time - point[MODES], _SCRATCH)
    difference = 0.0
    for j in range(MODES):
        difference += heat.modes[_SCRATCH, j] * point[j]
    return difference


@kernel
def sweep(heat: Heat, field: Field, plate: int, time: float, position: complex) -> bool:
    """Move the disc on a plate to a position [mm]; return False where the grid ends."""
    rows, columns = field.points.shape[1], field.points.shape[2]
    c, tallies = field.spacing, field.tallies[plate]
    x, y = position.real / c + 0.5 * (columns - 1), position.imag / c + 0.5 * (rows - 1)
    reach = field.radius / c
    inside = x - reach >= 1.0 and x + reach <= columns - 2.0 and y - reach >= 1.0 and y + reach <= rows - 2.0
    if not inside:  # or not a number
        return False
    gone = complex(x - tallies[DISC_X], y - tallies[DISC_Y])
    if gone.real * gone.real + gone.imag * gone.imag >= _AWAY * _AWAY:
        _move_disc(
            heat.modes, PLATE_ROW + plate * PLATE_ROWS, field.points[plate], field.spans[plate], tallies,
            time, x, y, reach,
        )  # fmt: skip
    return True


@called_kernel
def _move_disc(
    modes: NDArray[np.float64],
    first_mode: int,
    points: NDArray[np.float64],
    spans: NDArray[np.int64],
    tallies: NDArray[np.float64],
    time: float,
    x: float,
    y: float,
    reach: float,
) -> None:
    """Move the disc on a plate, whose modes begin with the row `first_mode`; its place and `reach` are in spacings."""
    tallies[DISC_X], tallies[DISC_Y] = x, y
    lowest, highest = math.ceil(y - reach), math.floor(y + reach)
    # rows that are left, on either side
    row = lowest - 1
    while row >= 0 and spans[row, 1] > spans[row, 0]:
        for column in range(spans[row, 0], spans[row, 1]):
            _leave(modes, first_mode, points[row, column], tallies, row, column, time)
        spans[row, 1] = spans[row, 0]
        row -= 1
    row = highest + 1
    while row < spans.shape[0] and spans[row, 1] > spans[row, 0]:
        for column in range(spans[row, 0], spans[row, 1]):
            _leave(modes, first_mode, points[row, column], tallies, row, column, time)
        spans[row, 1] = spans[row, 0]
        row += 1
    for row in range(lowest, highest + 1):
        old_first, old_last = spans[row, 0], spans[row, 1]
        away = row - y
        square = reach * reach - away * away
        # mostly the points at the ends are still inside, and those beyond them outside
        left, right = old_first - x, old_last - 1 - x
        if left * left <= square < (left - 1.0) * (left - 1.0) and right * right <= square < (right + 1.0) * (
            right + 1.0
        ):
            continue
        half = math.sqrt(max(square, 0.0))
        first, last = math.ceil(x - half), math.floor(x + half) + 1
        if old_first >= old_last:
            old_first = old_last = first
        for column in range(old_first, min(old_last, first)):
            _leave(modes, first_mode, points[row, column], tallies, row, column, time)
        for column in range(max(old_first, last), old_last):
            _leave(modes, first_mode, points[row, column], tallies, row, column, time)
        for column in range(first, min(last, old_first)):
            _enter(modes, first_mode, points[row, column], tallies, time)
        for column in range(max(first, old_last), last):
            _enter(modes, first_mode, points[row, column], tallies, time)
        spans[row, 0], spans[row, 1] = first, last


@called_kernel
def _enter(
    modes: NDArray[np.float64],
    first: int,
    point: NDArray[np.float64],
    tallies: NDArray[np.float64],
    time: float,
) -> None:
    """Cover a point: from its own state to the difference from the common modes."""
    fill_decay(modes, RATES, time - point[MODES], _SCRATCH)
    for j in range(MODES):
        difference = point[j] * modes[_SCRATCH, j] - modes[first + COMMON, j]
        point[j] = difference
        modes[first + INSIDE, j] += difference
        modes[first + BOUND, j] = max(modes[first + BOUND, j], difference)
    point[MODES] = time
    tallies[COVERED_POINTS] += 1.0
    if point[0] == 0.0:
        tallies[ALWAYS] += 1.0


@called_kernel
def _leave(
    modes: NDArray[np.float64],
    first: int,
    point: NDArray[np.float64],
    tallies: NDArray[np.float64],
    row: int,
    column: int,
    time: float,
) -> None:
    """Uncover a point: from the difference to a state of its own."""
    if point[0] == 0.0:
        tallies[ALWAYS] -= 1.0
        if tallies[ALWAYS] == 0.0 and tallies[PEAK_ROW] < 0.0:  # the last one of these
            tallies[PEAK_ROW], tallies[PEAK_COLUMN] = row, column
    fill_decay(modes, RATES, time - point[MODES], _SCRATCH)
    for j in range(MODES):
        difference = point[j] * modes[_SCRATCH, j]
        point[j] = difference + modes[first + COMMON, j]
        modes[first + INSIDE, j] -= difference
    point[MODES] = time
    tallies[COVERED_POINTS] -= 1.0
