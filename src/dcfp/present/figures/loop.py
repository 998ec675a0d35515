"""Force against displacement, and temperature along a plate over time."""

from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize

from dcfp.errors import InputError
from dcfp.present.figures.histories import line_width, shown
from dcfp.present.figures.style import (
    GREY,
    calm_ticks,
    colour_bar_beside,
    new_axes,
    styled,
    time_colours,
    warm_colours,
)
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from dcfp.arrays import FloatArray
    from dcfp.present.figures.histories import History


ColourQuantity: TypeAlias = Literal["temperature", "time"]

#: Colours that are told apart.
_LEVELS = 100
#: Number of pieces above which a line of changing colour is drawn as an image in a PDF or an SVG.
_MANY = 6000


@styled
def plot_loop(
    response: "History",
    axes: "Axes | None" = None,
    *,
    colour: ColourQuantity | None = None,
    norm: Normalize | None = None,
    colour_bar: bool = True,
    thin: float = 1.0,
) -> "Axes":
    """Draw the force against the displacement.

    Parameters
    ----------
    response
        The analysis or test.
    axes
        Where to draw; by default on a new figure.
    colour
        What the colour of the line shows; by default the temperature, or the time where nothing heats up.
    norm
        Range of the colours, when several figures share one.
    colour_bar
        Whether a scale of the colours is drawn beside the axes.
    thin
        Factor on the width of the line, for small axes [-].
    """
    axes = new_axes() if axes is None else axes
    shows = colour_quantity(response) if colour is None else colour
    part = shown(response)
    values = (response.temperature if shows == "temperature" else response.time)[part]
    displacement = quantity("displacement").display(response.displacement[part])
    force = quantity("force").display(response.force[part])
    scale = colour_range(response, shows) if norm is None else norm
    pieces, colours = _pieces(displacement, force, values, scale)
    line = LineCollection(
        pieces,
        array=colours,
        cmap=warm_colours() if shows == "temperature" else time_colours(),
        norm=scale,
        linewidths=thin * line_width(response),
        capstyle="round",
        rasterized=len(pieces) > _MANY,
    )
    draw_cross(axes)
    axes.add_collection(line)
    reach, height = (1.08 * max(float(np.abs(values).max()), 1e-6) for values in (displacement, force))
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-height, height)
    calm_ticks(axes, 5, 6)
    axes.set_xlabel(quantity("displacement").label)
    axes.set_ylabel(quantity("force").label)
    if colour_bar:
        colour_bar_beside(axes, line, quantity(shows).label)
    return axes


def draw_cross(axes: "Axes") -> None:
    """Draw thin lines through zero."""
    axes.axhline(0.0, color=GREY, linewidth=0.4, zorder=0)
    axes.axvline(0.0, color=GREY, linewidth=0.4, zorder=0)


def _pieces(
    displacement: "FloatArray", force: "FloatArray", values: "FloatArray", scale: Normalize
) -> "tuple[list[FloatArray], FloatArray]":
    """Cut the loop where its colour changes visibly; return the pieces and the value that colours each."""
    points = np.column_stack((displacement, force))
    middle = 0.5 * (values[:-1] + values[1:])
    levels = np.floor(_LEVELS * np.asarray(scale(middle)))
    starts = np.concatenate(([0], np.flatnonzero(np.diff(levels)) + 1))
    stops = np.append(starts[1:], middle.size)
    pieces = [points[start : stop + 1] for start, stop in zip(starts, stops, strict=True)]
    return pieces, middle[starts]


def colour_quantity(response: "History") -> ColourQuantity:
    """Return what the colour of a loop shows best."""
    rise = float(response.temperature.max()) - response.heating.ambient
    return "temperature" if rise > 1.0 else "time"


def colour_range(response: "History", shows: ColourQuantity) -> Normalize:
    """Return the range of the colours of a loop, which the temperature of the plates shares."""
    if shows == "time":
        time = response.time[shown(response)]
        return Normalize(float(time[0]), float(time[-1]))
    highest = float(response.temperature.max())
    if response.profiles is not None:
        highest = max(highest, float(response.profiles.temperature.max()))
    ambient = response.heating.ambient
    return Normalize(min(ambient, float(response.temperature.min())), max(highest, ambient + 1.0))


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
