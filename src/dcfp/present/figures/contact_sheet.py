"""Figures of any size on one sheet."""

import io
import math
import textwrap
from typing import TYPE_CHECKING, Any

from matplotlib.figure import Figure
from matplotlib.image import imread

from dcfp.present.figures.style import save_figure, style

if TYPE_CHECKING:
    from collections.abc import Sequence

#: Width of the sheet, the gap between two figures, and the height of a title [in].
_WIDTH, _GAP, _TITLE = 14.8, 0.2, 0.4
#: Characters of a title in an inch.
_CHARACTERS = 14


def contact_sheet(figures: "Sequence[tuple[str, Figure]]") -> Figure:
    """Return a new figure that shows all others as images, in rows and in their order, each at its own size below its title."""
    rows: list[list[tuple[str, Figure]]] = [[]]
    for title, figure in figures:
        if rows[-1] and _length(rows[-1]) + _GAP + figure.get_figwidth() > _WIDTH:
            rows.append([])
        rows[-1].append((title, figure))
    heights = [_TITLE + max((figure.get_figheight() for _, figure in row), default=1.0) for row in rows]
    height = sum(heights) + _GAP * (len(rows) - 1)
    with style():
        sheet = Figure(figsize=(_WIDTH, height))
        top = height
        for row, tallest in zip(rows, heights, strict=True):
            _draw_row(sheet, row, top)
            top -= tallest + _GAP
    return sheet


def _draw_row(sheet: Figure, row: "Sequence[tuple[str, Figure]]", top: float) -> None:
    height = sheet.get_figheight()
    left = 0.0
    for title, figure in row:
        width, tall = figure.get_figwidth(), figure.get_figheight()
        below = top - _TITLE
        words = textwrap.fill(title, max(12, int(_CHARACTERS * width)))
        sheet.text(left / _WIDTH, below / height, words, weight="bold", va="bottom", size=8.0)
        axes = sheet.add_axes((left / _WIDTH, (below - tall) / height, width / _WIDTH, tall / height))
        axes.imshow(_drawn(figure), aspect="auto", interpolation="none")
        axes.set_axis_off()
        left += width + _GAP


def _length(row: "Sequence[tuple[str, Figure]]") -> float:
    return math.fsum(figure.get_figwidth() for _, figure in row) + _GAP * (len(row) - 1)


def _drawn(figure: Figure) -> Any:
    stream = io.BytesIO()
    save_figure(figure, stream, "png")
    stream.seek(0)
    return imread(stream, format="png")
