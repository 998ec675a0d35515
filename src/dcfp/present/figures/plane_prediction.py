"""A station that is predicted drawn: the ground velocity in the plane with its nodes, and the path of the march, beside that of the analysis."""

from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.methods.nodes import find_nodes
from dcfp.methods.plane_march import NAME, march_in_plane
from dcfp.present.figures import style
from dcfp.present.figures.drawing import draw_cross
from dcfp.schema.formulas import metres_per_second, millimetres
from dcfp.schema.quantities import quantity

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.methods.prediction import Methods
    from dcfp.motion.station import Station


@style.styled
def plot_plane_prediction(station: "Station", methods: "Methods") -> "Figure":
    """Draw the path of the ground velocity with the straight legs that the march knows of it, and the path of the march over that of the analysis, on a new figure."""
    from dcfp.analysis.plane_history import analyse_plane  # late: it loads the kernels

    nodes = find_nodes(station, methods.march_tolerance)
    march, response = march_in_plane(nodes, methods.system), analyse_plane(station, methods.system)
    figure = style.new_figure(3.9)
    left, right = figure.subplots(1, 2)

    velocity = quantity("ground_velocity")
    legs = velocity.display(nodes.velocities)
    _draw(left, velocity.display(station.velocity), style.COLOURS["silver"], 0.8, "record")
    _draw(left, legs, style.BLUE, 0.6, f"{nodes.count} nodes, straight legs")
    style.draw_marks(left, legs[:, 0], legs[:, 1], "o", 2.0, style.BLUE)
    _finish(left, "ground velocity", velocity.shown.name)

    analysed = np.column_stack(
        [response.histories[f"displacement_{name}"].of(response) for name in ("x", "y")]
    )
    peak = march.prediction.bound
    _draw(
        right,
        analysed,
        style.COLOURS["silver"],
        0.8,
        f"analysis, $y_{{max}}$ {millimetres(response.peak_displacement)}",
    )
    _draw(right, march.displacement, style.BLUE, 0.7, f"{NAME}, $y_{{max}}$ {millimetres(peak)}")
    style.draw_circle(right, 0.0, 0.0, peak, style.BLUE, 0.5)
    _finish(right, "displacement", quantity("displacement").shown.name)
    style.write_title(
        figure,
        f"{style.drawable(station.name, 60)}, PGV {metres_per_second(station.peak_velocity)} (resultant)",
    )
    return figure


def _draw(axes: "Axes", path: "np.ndarray", colour: str, width: float, label: str) -> None:
    style.draw_line(axes, path[:, 0], path[:, 1], colour, width, label=label)


def _finish(axes: "Axes", name: str, unit: str) -> None:
    """Name both axes, with the same limits about the middle for both, and put the legend above them."""
    lines: Any = axes.get_lines()
    reach = 1.06 * max(float(np.abs(line.get_xydata()).max()) for line in lines)
    draw_cross(axes)
    x, y = (f"{name}, direction {direction} [{unit}]" for direction in ("x", "y"))
    style.label_axes(axes, x, y, 5, 5, xlim=(-reach, reach), ylim=(-reach, reach))
    axes.set_aspect("equal")
    style.legend_above(axes)
