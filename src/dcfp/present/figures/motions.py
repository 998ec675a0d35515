"""Ground motions beside each other."""

import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.errors import InputError
from dcfp.motion.measures import baseline_warning
from dcfp.present.figures.drawing import between_equal_limits, mark_peak
from dcfp.present.figures.style import (
    BLUE,
    PAGE_WIDTH,
    RED,
    draw_line,
    drawable,
    label_axes,
    style,
)
from dcfp.schema.digits import metres_per_second, millimetres
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.motion.ground_motion import GroundMotion

#: Most motions beside each other, and on a page.
_COLUMNS, MOST = 4, 12
_ROW_HEIGHT, _HEAD_HEIGHT = 0.95, 0.5
#: Characters of a head in the width of the page.
_HEAD_WIDTH = 108
#: Peaks that differ by more than this factor do not share an axis [-].
_COMPARABLE = 4.0


def plot_motions(motions: "Sequence[GroundMotion]") -> Figure:
    """Draw acceleration, velocity and displacement of motions, a column for each, on a new figure.

    Four stand beside each other; those that follow stand below. The motions beside each other share their scales
    where their peaks are comparable.

    Raises
    ------
    InputError
        If there are more than a page can hold.
    """
    check_count(len(motions))
    columns = min(len(motions), _COLUMNS)
    blocks = [motions[first : first + columns] for first in range(0, len(motions), columns)]
    height = 3.0 * _ROW_HEIGHT + _HEAD_HEIGHT
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, height * len(blocks)), layout="constrained")
        panels = figure.subplots(3 * len(blocks), columns, squeeze=False)
        for number, block in enumerate(blocks):
            _draw_block(panels[3 * number : 3 * number + 3], block)
        figure.align_ylabels(list(panels[:, 0]))
    return figure


def check_count(count: int) -> None:
    """Check that a page can hold so many motions.

    Raises
    ------
    InputError
        If not.
    """
    if count > MOST:
        msg = f"a figure holds at most {MOST} motions, not {count}; name fewer records."
        raise InputError(msg)


def _draw_block(panels: "np.ndarray", motions: "Sequence[GroundMotion]") -> None:
    columns = panels.shape[1]
    for axes in panels[:, len(motions) :].ravel():
        axes.set_axis_off()
    for column, motion in enumerate(motions):
        _draw_column(panels[:, column], motion, columns)
        _write_head(panels[0, column], motion, _HEAD_WIDTH // columns)
    for axes in panels[:, 1:].ravel():
        axes.set_ylabel("")
    for row in panels[:, : len(motions)]:
        _share_limits(list(row))


def _draw_column(panels: "np.ndarray", motion: "GroundMotion", columns: int) -> None:
    width = 0.5 if motion.duration * columns > 60.0 else 0.7
    for axes, name, words in zip(
        panels,
        ("acceleration", "velocity", "displacement"),
        (_metres_per_second_squared, metres_per_second, millimetres),
        strict=True,
    ):
        entry, values = quantity(f"ground_{name}"), getattr(motion, name)
        heights = entry.display(values)
        draw_line(axes, motion.time, heights, BLUE, width)
        label_axes(axes, "", entry.label, max(4, 10 // columns), 4)
        mark_peak(axes, motion.time, heights, words(float(np.abs(values).max())))
        axes.set_xlim(0.0, motion.duration)
        between_equal_limits(axes, float(np.abs(heights).max()))
        axes.tick_params(labelbottom=axes is panels[-1])
    panels[-1].set_xlabel(quantity("time").label)
    if baseline_warning(motion) is not None:
        place: Any = {"xy": (0.02, 0.03), "xycoords": "axes fraction"}
        panels[-1].annotate("baseline in doubt", color=RED, va="bottom", **place)


def _metres_per_second_squared(value: float) -> str:
    return metres_per_second(value).replace("m/s", "m/s²")


def _share_limits(row: "list[Axes]") -> None:
    limits = [axes.get_ylim()[1] for axes in row]
    if max(limits) > _COMPARABLE * min(limits):
        return
    for axes in row:
        axes.set_ylim(-max(limits), max(limits))
    for axes in row[1:]:
        axes.tick_params(labelleft=False)


def _write_head(axes: "Axes", motion: "GroundMotion", width: int) -> None:
    origin = motion.origin
    words = [origin.station, origin.event, origin.component]
    lines = textwrap.wrap(
        ", ".join(drawable(word) for word in words if word), width, max_lines=3, placeholder=" …"
    )
    name = textwrap.shorten(drawable(motion.name), max(width - 4, 12), placeholder=" …")
    place: dict[str, Any] = {"xytext": (0.0, 4.0), "xycoords": "axes fraction", "textcoords": "offset points"}
    look: dict[str, Any] = {"va": "bottom", "size": 6.5, "color": "#555555", "parse_math": False}
    axes.annotate("\n".join(lines), (0.0, 1.0), **place, **look)
    axes.set_title(name, loc="left", weight="bold", pad=6.0 + 9.0 * len(lines), parse_math=False)
