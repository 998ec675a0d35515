"""Figures of any size on one sheet."""

import io
import math
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from matplotlib.image import imread

from dcfp.plots.style import save_figure

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Width of the sheet, and the gap between two figures [in].
_WIDTH, _GAP = 14.8, 0.2


def contact_sheet(figures: "Sequence[Figure]") -> Figure:
    """Return a new figure that shows all others as images, in rows and in their order, each at its own size."""
    rows: list[list[Figure]] = [[]]
    for figure in figures:
        if rows[-1] and _length(rows[-1]) + _GAP + figure.get_figwidth() > _WIDTH:
            rows.append([])
        rows[-1].append(figure)
    heights = [max((figure.get_figheight() for figure in row), default=1.0) for row in rows]
    height = sum(heights) + _GAP * (len(rows) - 1)
    sheet = Figure(figsize=(_WIDTH, height))
    top = height
    for row, tallest in zip(rows, heights, strict=True):
        left = 0.0
        for figure in row:
            width, tall = figure.get_figwidth(), figure.get_figheight()
            place = (left / _WIDTH, (top - tall) / height, width / _WIDTH, tall / height)
            axes = sheet.add_axes(place)
            axes.imshow(_drawn(figure), aspect="auto", interpolation="none")
            axes.set_axis_off()
            left += width + _GAP
        top -= tallest + _GAP
    return sheet


def _length(row: "Sequence[Figure]") -> float:
    return math.fsum(figure.get_figwidth() for figure in row) + _GAP * (len(row) - 1)


def _drawn(figure: Figure) -> object:
    stream = io.BytesIO()
    save_figure(figure, stream, "png")
    stream.seek(0)
    return imread(stream, format="png")
