"""Temperature along a plate over time."""

from typing import TYPE_CHECKING

import numpy as np
from matplotlib.colors import Normalize

from dcfp.errors import InputError
from dcfp.present.figures.extent import shown
from dcfp.present.figures.loop import colour_range
from dcfp.present.figures.style import calm_ticks, colour_bar_beside, new_axes, styled, warm_colours
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from dcfp.present.figures.extent import History

#: Rise of the temperature, relative to the highest one, that is shown at least [-].
_COOL = 0.01


@styled
def plot_profile(
    response: "History",
    axes: "Axes | None" = None,
    *,
    plate: int = 0,
    norm: Normalize | None = None,
    colour_bar: bool = True,
) -> "Axes":
    """Draw the temperature along a plate as an image over time, with the path of the slider's centre.

    Parameters
    ----------
    response
        An analysis or test with the precise heating model that kept profiles.
    axes
        Where to draw; by default on a new figure.
    plate
        Which plate, where they are different.
    norm
        Range of the colours, when several figures share one.
    colour_bar
        Whether a scale of the colours is drawn beside the axes.

    Raises
    ------
    InputError
        If the analysis kept no profiles.
    """
    profiles = response.profiles
    if profiles is None:
        msg = "There are no profiles; analyse with the precise heating model and profile_every."
        raise InputError(msg)
    axes = new_axes(height=1.8) if axes is None else axes
    part = shown(response)
    time = response.time[part]
    temperature = profiles.temperature[:, plate, :]
    image = axes.pcolormesh(
        profiles.time,
        profiles.position,
        temperature.T,
        cmap=warm_colours(),
        norm=colour_range(response, "temperature") if norm is None else norm,
        shading="nearest",
        rasterized=True,
    )
    path = response.bearing.shares[plate] * response.displacement[part]
    axes.plot(time, path, color="white", linewidth=0.4)
    axes.set_xlim(float(time[0]), float(time[-1]))
    axes.set_ylim(*_warm_part(profiles.position, temperature, response.heating.ambient))
    calm_ticks(axes, 8, 4)
    axes.set_xlabel(quantity("time").label)
    axes.set_ylabel(quantity("plate_position").label)
    if colour_bar:
        colour_bar_beside(axes, image, quantity("plate_temperature").label)
    return axes


def _warm_part(position: "np.ndarray", temperature: "np.ndarray", ambient: float) -> tuple[float, float]:
    """Return where the plate is ever warmer than at the start."""
    rise = temperature.max(axis=0) - ambient
    warm = position[rise > _COOL * max(float(rise.max()), 1e-9)]
    if warm.size == 0:
        return float(position[0]), float(position[-1])
    largest = 1.1 * float(np.abs(warm).max())
    return -largest, largest
