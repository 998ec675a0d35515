"""How much hotter than the points of the grid the plate becomes between them."""

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.kernels import plane_heat as heat
from dcfp.kernels import plane_point as k
from dcfp.kernels.sum_of_exponentials import MODES
from dcfp.system import System
from dcfp.system.fields import PlaneHeat
from dcfp.system.plates import modes_of


def rise_between_points(
    system: System,
    plates: PlaneHeat,
    displacement: FloatArray,
    flux: FloatArray,
    mean: FloatArray,
    ratios: FloatArray,
    interval: float,
) -> float:
    """Return by how much a point beside the hottest one of the grid becomes hotter than that [degC].

    The histories of both are followed along the path, so that only their difference rests on the intervals of the path.

    Parameters
    ----------
    system
        Bearing with its friction law and heating model.
    plates
        The heat at the end of the path, which began at the ambient temperature.
    displacement
        Path of the isolation layer [mm], shape (n, 2).
    flux, mean
        Heat flux mu p |v| at the ends of the intervals [N/(mm s)], shape (n,), and its mean over each of them, shape (n - 1,).
    ratios
        Coefficient of each plate that differs over that of the bearing [-], shape (n, plates).
    interval
        Between two places of the path [s].
    """
    if not plates.field.points.size:  # another heating model than the precise one
        return 0.0
    tallies = plates.field.tallies
    plate = int(np.argmax(tallies[:, heat.HOTTEST]))
    if tallies[plate, heat.PEAK_ROW] < 0.0:
        return 0.0
    share = system.bearing.shares[plate]
    rates, weights, instant = modes_of(system.heating)
    factor = system.heating.rise_factor
    modes = np.zeros((k.ROWS, MODES))
    modes[k.RATES], modes[k.WEIGHTS] = rates, weights * factor
    path = np.zeros((len(displacement), k.COLUMNS))
    path[:, k.PLACE_X : k.PLACE_Y + 1] = share * displacement
    # linear in the interval, and raised to the mean
    ends, felt = flux[:-1] + flux[1:], share * ratios[:, plate]
    raised = mean * np.divide(2.0, ends, out=np.zeros_like(ends), where=ends > 0.0)
    path[1:, k.OPENING], path[1:, k.CLOSING], path[:, k.NOW] = (
        felt[1:] * raised * flux[:-1],
        felt[1:] * raised * flux[1:],
        felt * flux,
    )
    middle = 0.5 * (plates.field.points.shape[1] - 1)
    row, column = tallies[plate, heat.PEAK_ROW : heat.PEAK_COLUMN + 1] - middle
    spacing = plates.field.spacing
    point = complex(spacing * column, spacing * row)
    return k.rise_between(modes, instant * factor, path, interval, plates.field.radius, point, spacing)
