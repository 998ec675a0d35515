"""Constants and state of the heating model, and where each number stands.

All modes stand in one array, the *bank*, and all else that changes stands in another, the *notes*: compiled calls pass
few arrays quickly and many arrays slowly. The names of their rows and entries are here.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

# kinds of heating
NO_HEATING = 0
POINT = 1
LINE = 2

#: Halvings of the sample interval that the error control may use.
FINEST_LEVEL = 10
#: Place of the prepared step that has any other length.
ODD_LENGTH = FINEST_LEVEL + 1

# rows of the bank: the constants; then for each of two plates COMMON to RIGHT_OPEN (see `plate`); then for each
# prepared step what it does to the modes: fade, weight of the flux at its start, weight of that at its end
RATES, WEIGHTS = 0, 1
PLATE_ROW, PLATE_ROWS = 2, 6
COMMON, INSIDE, LEFT_COVERED, LEFT_OPEN, RIGHT_COVERED, RIGHT_OPEN = range(6)
STEP_ROW, STEP_ROWS = PLATE_ROW + 2 * PLATE_ROWS, 3
BANK_ROWS = STEP_ROW + STEP_ROWS * (ODD_LENGTH + 1)

# notes: temperatures of up to two plates now, expected at the end of a step, and in between
PRESENT, EXPECTED, BETWEEN = 0, 2, 4
# so many entries after each temperature the dose of rubbing, the integral of p v2 over time [N/s], for laws that wear off with it
DOSE = 6
# the coefficient of each of two plates over that of the bearing
RATIO = 12
# then for each plate: covered width of the right edge cell [mm], position of the slider [mm], left edge cell
PLATE_NOTE, PLATE_NOTES = 14, 3
COVERED, POSITION, LEFT_CELL = range(3)
# then for each prepared step: its length [s], negative if it can only cool, and the sums of its weights
STEP_NOTE, STEP_NOTES = PLATE_NOTE + 2 * PLATE_NOTES, 3
NOTES = STEP_NOTE + STEP_NOTES * (ODD_LENGTH + 1)


class Heat(NamedTuple):
    """Constants and state of the heating model."""

    kind: int
    ambient: float  # [degC]
    half_contact: float  # half side of the square contact [mm]
    cell: float  # width of a cell of the plate [mm]
    instant: float  # rise per flux of the modes that act at once [degC mm s/N]
    bank: NDArray[np.float64]  # (BANK_ROWS, MODES)
    notes: NDArray[np.float64]  # (NOTES,)
    cells: NDArray[
        np.float64
    ]  # (plates, cells, MODES + 1); the last entry of a cell is the time it stands for [s]
