"""Constants and state of the heating model, and where each number stands.

All modes stand in one array, and all else that changes stands in another, the workspace: compiled calls pass
few arrays quickly and many arrays slowly. The names of their rows and entries are here.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

# kinds of heating
NO_HEATING = 0
POINT = 1
LINE = 2
DISC = 3

#: Halvings of the sample interval that the error control may use.
MOST_HALVINGS = 10
#: Place of the prepared step that has any other length.
ODD_LENGTH = MOST_HALVINGS + 1

# rows of the modes: the constants; then for each of two plates COMMON to RIGHT_OPEN (see `plate`); then for each
# prepared step its factors: decay, weight of the flux at its start, weight of that at its end
RATES, WEIGHTS = 0, 1
PLATE_ROW, PLATE_ROWS = 2, 6
COMMON, INSIDE, LEFT_COVERED, LEFT_OPEN, RIGHT_COVERED, RIGHT_OPEN = range(6)
STEP_ROW, STEP_ROWS = PLATE_ROW + 2 * PLATE_ROWS, 3
MODE_ROWS = STEP_ROW + STEP_ROWS * (ODD_LENGTH + 1)

# entries of the workspace: temperatures of up to two plates now, expected at the end of a step, and in between
PRESENT, EXPECTED, BETWEEN = 0, 2, 4
# so many entries after each temperature the cycling parameter, the integral of p v2 over time [N/s], for laws that fall with it
CYCLING_PARAMETER = 6
# what of the expected temperatures does not depend on the flux
COOLED = 12
# the coefficient of each of two plates over that of the bearing
RATIO = 14
# then for each plate: covered width of the right edge cell [mm], position of the slider [mm], left edge cell
PLATE_ENTRY, PLATE_ENTRIES = 16, 3
COVERED, POSITION, LEFT_CELL = range(3)
# then for each prepared step: its length [s], negative if it can only cool, and the sums of its weights
STEP_ENTRY, STEP_ENTRIES = PLATE_ENTRY + 2 * PLATE_ENTRIES, 3
WORKSPACE_SIZE = STEP_ENTRY + STEP_ENTRIES * (ODD_LENGTH + 1)


class Heat(NamedTuple):
    """Constants and state of the heating model."""

    kind: int
    ambient: float  # [degC]
    half_contact: float  # half side of the square contact [mm]
    cell: float  # width of a cell of the plate [mm]
    instant: float  # rise per flux of the modes that act at once [degC mm s/N]
    modes: NDArray[np.float64]  # (MODE_ROWS, MODES)
    workspace: NDArray[np.float64]  # (WORKSPACE_SIZE,)
    cells: NDArray[np.float64]  # (plates, cells, MODES + 1); last in a cell is the time it stands for [s]
