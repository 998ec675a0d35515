"""The plate as a line of cells, for the precise heating model.

A point that has always been under the slider has the state of the *common* modes, which feel every flux. A point in contact differs from them by modes that
only decay; a point in the open cools by itself. So a step costs the common modes, the sum *inside* of the differences under the slider, and the two cells that
the edges are in: each has a part that is covered (kept as difference to the common modes) and a part in the open (kept as it is), both summed over their width.
The contact is a whole number of cells long, so both edges are at the same place in their cells.
"""

import numpy as np
from numpy.typing import NDArray

from dcfp.kernels._jit import kernel
from dcfp.kernels.heat_state import (
    COMMON,
    COVERED,
    INSIDE,
    LEFT_CELL,
    LEFT_COVERED,
    LEFT_OPEN,
    PLATE_ENTRIES,
    PLATE_ENTRY,
    PLATE_ROW,
    PLATE_ROWS,
    POSITION,
    RATES,
    RIGHT_COVERED,
    RIGHT_OPEN,
    Heat,
)
from dcfp.kernels.sum_of_exponentials import MODES, decay, exp_neg, fill_decay, total


@kernel
def _cells_across(heat: Heat) -> int:
    """Count the cells that the contact is long."""
    return int(2.0 * heat.half_contact / heat.cell + 0.5)


@kernel
def mean_difference(heat: Heat, plate: int) -> float:
    """Mean of the differences over the contact [degC]."""
    return total(heat.modes, PLATE_ROW + plate * PLATE_ROWS + INSIDE) / (2.0 * heat.half_contact)


@kernel
def decay_edges(heat: Heat, factors: int, plate: int) -> None:
    """Let the edge cells decay over a step."""
    first = PLATE_ROW + plate * PLATE_ROWS
    for row in range(first + LEFT_COVERED, first + RIGHT_OPEN + 1):
        decay(heat.modes, factors, row)


@kernel
def expect_sweep(heat: Heat, plate: int, time: float, travel: float) -> float:
    """Change of the sum inside [degC mm] when the slider moves by `travel` [mm] from `time` [s] on.

    With the edge cells as they are, or with the next ones where an edge is about to enter them.
    """
    modes = heat.modes
    first = PLATE_ROW + plate * PLATE_ROWS
    covered = heat.workspace[PLATE_ENTRY + plate * PLATE_ENTRIES + COVERED]
    if travel >= 0.0:
        width = heat.cell - covered
        gain = total(modes, first + RIGHT_OPEN) - total(modes, first + LEFT_COVERED)
    else:
        width = covered
        gain = total(modes, first + LEFT_OPEN) - total(modes, first + RIGHT_COVERED)
    if width < 0.01 * heat.cell:
        width, gain = heat.cell, _next_gain(heat, plate, time, 1 if travel >= 0.0 else -1)
    # what is further away than the contact is long cannot be seen from its edges
    reach = min(abs(travel), 2.0 * heat.half_contact)
    return reach * (gain / width - total(modes, first + COMMON))


@kernel
def _next_gain(heat: Heat, plate: int, time: float, direction: int) -> float:
    """Return what the contact gains [degC mm] by covering the next cell ahead and uncovering the next one behind."""
    left = int(heat.workspace[PLATE_ENTRY + plate * PLATE_ENTRIES + LEFT_CELL]) + direction
    right = left + _cells_across(heat)
    if left < 0 or right >= heat.cells.shape[1]:
        return 0.0
    ahead, behind = (right, left) if direction > 0 else (left, right)
    return _decayed_cell(heat, plate, ahead, time) - _decayed_cell(heat, plate, behind, time)


@kernel
def _decayed_cell(heat: Heat, plate: int, cell: int, time: float) -> float:
    """Sum of the modes of a cell that was put away, brought up to `time` [s]."""
    elapsed = time - heat.cells[plate, cell, MODES]
    rise = 0.0
    for j in range(MODES):
        rise += exp_neg(heat.modes[RATES, j] * elapsed) * heat.cells[plate, cell, j]
    return rise


@kernel
def sweep_to(heat: Heat, plate: int, time: float, position: float) -> bool:
    """Move the contact on a plate to `position` [mm], cell by cell; return False where the cells end."""
    entry = PLATE_ENTRY + plate * PLATE_ENTRIES
    workspace = heat.workspace
    travel = position - workspace[entry + POSITION]
    workspace[entry + POSITION] = position
    first = PLATE_ROW + plate * PLATE_ROWS
    direction = 1 if travel > 0.0 else -1
    left = abs(travel)
    while left > 0.0:
        covered = workspace[entry + COVERED]
        width = heat.cell - covered if direction > 0 else covered
        moved = min(left, width)
        if moved > 0.0 and direction > 0:
            _sweep(heat.modes, first, RIGHT_OPEN, RIGHT_COVERED, LEFT_COVERED, LEFT_OPEN, moved, width)
        elif moved > 0.0:
            _sweep(heat.modes, first, LEFT_OPEN, LEFT_COVERED, RIGHT_COVERED, RIGHT_OPEN, moved, width)
        workspace[entry + COVERED] = covered + direction * moved
        left -= moved
        if left > 0.0 and not _next_cells(heat, plate, time, direction):
            return False
    return True


@kernel
def _sweep(
    modes: NDArray[np.float64],
    first: int,
    ahead_open: int,
    ahead_covered: int,
    behind_covered: int,
    behind_open: int,
    travel: float,
    width: float,
) -> None:
    """Cover `travel` of the `room` [mm] ahead, and uncover as much behind."""
    part = travel / width
    for j in range(MODES):
        lost = part * modes[first + behind_covered, j]
        met = part * modes[first + ahead_open, j]
        common = travel * modes[first + COMMON, j]
        modes[first + behind_covered, j] -= lost
        modes[first + behind_open, j] += lost + common
        modes[first + ahead_open, j] -= met
        modes[first + ahead_covered, j] += met - common
        modes[first + INSIDE, j] += met - common - lost


@kernel
def _next_cells(heat: Heat, plate: int, time: float, direction: int) -> bool:
    """Put the edge cells away, up to date, and take in hand the next ones in `direction`."""
    entry = PLATE_ENTRY + plate * PLATE_ENTRIES
    first = PLATE_ROW + plate * PLATE_ROWS
    left = int(heat.workspace[entry + LEFT_CELL])
    right = left + _cells_across(heat)
    if left + direction < 0 or right + direction >= heat.cells.shape[1]:
        return False
    _store_cell(heat, plate, left, first + LEFT_COVERED, time)
    _store_cell(heat, plate, right, first + RIGHT_COVERED, time)
    heat.workspace[entry + LEFT_CELL] = left + direction
    heat.workspace[entry + COVERED] = 0.0 if direction > 0 else heat.cell
    # going right, the new left cell is all covered and the new right cell all open; going left, the reverse
    if direction > 0:
        _load_cell(heat, plate, left + 1, first + LEFT_COVERED, first + LEFT_OPEN, time)
        _load_cell(heat, plate, right + 1, first + RIGHT_OPEN, first + RIGHT_COVERED, time)
    else:
        _load_cell(heat, plate, left - 1, first + LEFT_OPEN, first + LEFT_COVERED, time)
        _load_cell(heat, plate, right - 1, first + RIGHT_COVERED, first + RIGHT_OPEN, time)
    return True


@kernel
def _store_cell(heat: Heat, plate: int, cell: int, row: int, time: float) -> None:
    for j in range(MODES):
        heat.cells[plate, cell, j] = heat.modes[row, j] + heat.modes[row + 1, j]
    heat.cells[plate, cell, MODES] = time


@kernel
def _load_cell(heat: Heat, plate: int, cell: int, row: int, other_row: int, time: float) -> None:
    fill_decay(heat.modes, RATES, time - heat.cells[plate, cell, MODES], row)
    for j in range(MODES):
        heat.modes[row, j] *= heat.cells[plate, cell, j]
        heat.modes[other_row, j] = 0.0


@kernel
def write_profile(heat: Heat, plate: int, time: float, flux: float, rises: NDArray[np.float64]) -> None:
    """Write the temperature rise [degC] of every cell of a plate at `time` [s] under `flux` [N/(mm s)] into `rises`."""
    modes, workspace = heat.modes, heat.workspace
    first = PLATE_ROW + plate * PLATE_ROWS
    entry = PLATE_ENTRY + plate * PLATE_ENTRIES
    left = int(workspace[entry + LEFT_CELL])
    right = left + _cells_across(heat)
    under = total(modes, first + COMMON) + heat.instant * flux
    for n in range(heat.cells.shape[1]):
        rise = _decayed_cell(heat, plate, n, time) / heat.cell
        rises[n] = rise + under if left < n < right else rise
    covered = workspace[entry + COVERED]
    for cell, row, width in ((left, LEFT_COVERED, heat.cell - covered), (right, RIGHT_COVERED, covered)):
        rise = total(modes, first + row) + total(modes, first + row + 1) + under * width
        rises[cell] = rise / heat.cell
