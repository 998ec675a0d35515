"""The plate seen from above at one moment of an analysis or a test in the plane: its temperature, the path of the slider until then, and its rim."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import Normalize
from matplotlib.patheffects import Normal, Stroke
from matplotlib.ticker import MaxNLocator

from dcfp.errors import InputError
from dcfp.present.figures import style
from dcfp.schema.formulas import typeset
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.analysis.plane_response import PlaneResponse
    from dcfp.analysis.rig import PlaneLoops
    from dcfp.arrays import FloatArray

#: Lines of equal temperature, at most.
_LEVELS = 12
#: Room around what was ever hot.
_ROOM = 1.06


def heat_scale(responses: "Sequence[PlaneResponse | PlaneLoops]") -> Normalize | None:
    """Return one range of colours for the temperatures of contacts and of plates; None where nothing heats up."""
    histories = [one.temperature for one in responses]
    histories += [one.fields.temperature for one in responses if one.fields is not None]
    coldest, hottest = min(float(one.min()) for one in histories), max(float(one.max()) for one in histories)
    return Normalize(coldest, hottest) if hottest > coldest else None


@style.styled
def plot_field(
    response: "PlaneResponse | PlaneLoops",
    moment: float | None = None,
    axes: "Axes | None" = None,
    *,
    plate: int = 0,
    norm: Normalize | None = None,
    colour_bar: bool = True,
) -> "Axes":
    """Draw the temperature of a plate at one moment, with the path of the slider's centre until then, its rim and the hottest point.

    Parameters
    ----------
    response
        An analysis in the plane with the precise heating model that kept the temperature of the plates, or a test with that model.
    moment
        When [s]: the nearest one that was kept; by default when a point is hottest.
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
        If the analysis kept no temperatures of the plates.
    """
    fields = response.fields
    if fields is None:
        msg = "The temperature of the plates was not kept; analyse with the precise heating model and keep=Keep(profiles=60)."
        raise InputError(msg)
    axes = style.new_axes(height=3.2) if axes is None else axes
    number = fields.nearest(moment)
    values, time = fields.temperature[number, plate], float(fields.time[number])
    entry, place = quantity("plate_temperature"), quantity("plate_position")
    x, y = place.display(fields.x), place.display(fields.y)
    ambient = response.heating.ambient
    scale = norm or Normalize(ambient, max(float(values.max()), ambient + 1.0))
    colours = style.colours_of("temperature")
    drawn = axes.pcolormesh(x, y, entry.display(values), cmap=colours, norm=scale, shading="nearest", rasterized=True)  # fmt: skip
    axes.set_facecolor(colours(float(scale(ambient))))
    _draw_levels(axes, x, y, entry.display(values), scale)
    _draw_slider(axes, response, time, plate)
    row, column = np.unravel_index(int(values.argmax()), values.shape)
    _mark_hottest(axes, float(x[column]), float(y[row]), f"{typeset(float(values.max()))} {entry.shown.name}")
    reach = _ROOM * max(float(np.abs(x).max()), float(np.abs(y).max()))
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)
    axes.set_aspect("equal")
    axes.text(
        0.03, 0.97, f"{time:.2f} s", transform=axes.transAxes, va="top", color="white", fontsize="small"
    )
    where = f"on the plate [{place.shown.name}]"
    style.label_axes(axes, f"direction x, {where}", f"direction y, {where}", 5, 5)
    if colour_bar:
        style.colour_bar_beside(axes, drawn, entry.label)
    return axes


def _draw_levels(
    axes: "Axes", x: "FloatArray", y: "FloatArray", values: "FloatArray", scale: Normalize
) -> None:
    """Draw lines of equal temperature: the shades of a hot contact are close to each other."""
    ends = float(scale.vmin or 0.0), float(scale.vmax or 1.0)
    levels = MaxNLocator(_LEVELS).tick_values(*ends)
    within = [one for one in levels if ends[0] < one < float(values.max())]
    if not within:
        return
    axes.contour(x, y, values, within, colors=style.INK, linewidths=0.35, alpha=0.6)


def _draw_slider(axes: "Axes", response: "PlaneResponse | PlaneLoops", time: float, plate: int) -> None:
    """Draw the path of the slider's centre until a time, and its rim then."""
    place = quantity("plate_position")
    so_far = response.time <= time + 1e-9
    path = response.bearing.shares[plate] * response.displacement_vectors[so_far]
    x, y = place.display(path).T
    # dark on what is hot, with an edge for what is not
    style.draw_line(
        axes, x, y, style.INK, 0.6, path_effects=[Stroke(linewidth=1.4, foreground="white"), Normal()]
    )
    style.draw_circle(axes, x[-1], y[-1], place.display(0.5 * response.bearing.slider_diameter), "white", 0.8)


def _mark_hottest(axes: "Axes", x: float, y: float, words: str) -> None:
    """Mark a point and write words beside it, where there is most room."""
    style.draw_marks(axes, x, y, "o", 3.0, style.INK, markeredgecolor="white", markeredgewidth=0.6, zorder=4)
    sides: dict[str, Any] = {"ha": "right" if x > 0.0 else "left", "va": "center"}
    box = {"boxstyle": "square,pad=0.15", "facecolor": "white", "edgecolor": "none", "alpha": 0.9}
    beside = (-5 if x > 0.0 else 5, 0)
    axes.annotate(words, (x, y), xytext=beside, textcoords="offset points", bbox=box, fontsize="small", zorder=5, **sides)  # fmt: skip
