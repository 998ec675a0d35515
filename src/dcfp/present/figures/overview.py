"""Several analyses beside each other, and figures of any size on one sheet."""

import io
import math
import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.image import imread

from dcfp.present.figures.loop import ColourQuantity, colour_quantity, colour_range, plot_loop
from dcfp.present.figures.style import (
    INK,
    PAGE_WIDTH,
    RED,
    calm_ticks,
    drawable,
    finish_colour_bar,
    metres_per_second,
    millimetres,
    number,
    save_figure,
    style,
    time_colours,
    warm_colours,
)
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.analysis import Response


#: Most panels in a row, when they follow each other and when each is a PGV.
_COLUMNS, _TABLE_COLUMNS = 5, 7
#: Characters of a title in the width of the page.
_TITLE_WIDTH = 92
#: Height of two lines of numbers [in].
_NUMBERS_HEIGHT = 0.36


def plot_overview(responses: "Sequence[Response]") -> Figure:
    """Draw the loops of several analyses to the same scales, on a new figure.

    Records are rows and PGVs columns where every record was analysed at the same PGVs; otherwise the panels
    follow each other, each with its own title.
    """
    grid = _grid(responses)
    columns = len(grid[0])
    width = PAGE_WIDTH
    panel = (width - 0.9) / max(columns, 3)
    with style():
        figure = Figure(
            figsize=(min(width, panel * columns + 0.9), 0.62 + len(grid) * (0.85 * panel + 0.1)),
            layout="constrained",
        )
        axes = figure.subplots(len(grid), columns, squeeze=False)
        warm = any(colour_quantity(response) == "temperature" for response in responses)
        shows: ColourQuantity = "temperature" if warm else "time"
        norm = _shared_range(responses, shows)
        for panels, row in zip(axes, grid, strict=True):
            for one, response in zip(panels, row, strict=True):
                if response is None:
                    one.set_axis_off()
                else:
                    _draw_panel(one, response, shows, norm)
        _name_panels(axes, grid)
        _share_limits(axes, responses)
        _add_scale(figure, axes, shows, norm)
        figure.supxlabel(quantity("displacement").label, fontsize=8)
        figure.supylabel(quantity("force").label, fontsize=8)
    return figure


def _grid(responses: "Sequence[Response]") -> "list[list[Response | None]]":
    """Return rows of analyses: one row for each record if all have the same PGVs, else rows of a few."""
    records: dict[str, list[Response]] = {}
    for response in responses:
        records.setdefault(response.motion.name, []).append(response)
    velocities = [[_pgv(response) for response in row] for row in records.values()]
    if all(row == velocities[0] for row in velocities) and 1 < len(velocities[0]) <= _TABLE_COLUMNS:
        return [list(row) for row in records.values()]
    columns = min(_COLUMNS, math.ceil(math.sqrt(len(responses))))
    filled: list[Response | None] = [*responses, *([None] * (-len(responses) % columns))]
    return [filled[first : first + columns] for first in range(0, len(filled), columns)]


def _pgv(response: "Response") -> str:
    return metres_per_second(response.motion.peak_velocity)


def _is_table(grid: "list[list[Response | None]]") -> bool:
    return all(len({r.motion.name if r else "" for r in row}) == 1 for row in grid) and len(grid[0]) > 1


def _draw_panel(axes: "Axes", response: "Response", shows: ColourQuantity, norm: Normalize) -> None:
    plot_loop(response, axes, colour=shows, norm=norm, colour_bar=False, thin=0.7)
    axes.set_xlabel("")
    axes.set_ylabel("")
    numbers = f"{millimetres(response.peak_displacement)}\n{number(response.peak_temperature)} °C"
    beyond = response.status.value == "beyond capacity"
    axes.text(
        0.03,
        0.98,
        numbers,
        transform=axes.transAxes,
        va="top",
        color=RED if beyond else INK,
        bbox={"boxstyle": "square,pad=0.05", "facecolor": "white", "edgecolor": "none", "alpha": 0.85},
    )


def _name_panels(axes: "np.ndarray", grid: "list[list[Response | None]]") -> None:
    table = _is_table(grid)
    width = _TITLE_WIDTH // max(len(grid[0]), 3)
    for row, (panels, responses) in enumerate(zip(axes, grid, strict=True)):
        for one, response in zip(panels, responses, strict=True):
            if response is None:
                continue
            name = drawable(response.motion.name)
            if not table:
                one.set_title(_folded(f"{name}, ", response, width), parse_math=False)
            elif row == 0:
                one.set_title(_folded("PGV ", response, width))
            if table and one is panels[0]:
                one.set_ylabel(textwrap.fill(name, 16), weight="bold", parse_math=False)


def _folded(words: str, response: "Response", width: int) -> str:
    """Return words and a PGV in lines of at most `width` characters, the number and its unit together."""
    velocity = _pgv(response).replace(" ", "\u00a0")
    return textwrap.fill(words + velocity, width).replace("\u00a0", " ")


def _share_limits(axes: "np.ndarray", responses: "Sequence[Response]") -> None:
    """Give all panels the same limits, and only the outer ones numbers."""
    reach = 1.06 * max(max(response.peak_displacement for response in responses), 1e-6)
    height = 1.1 * quantity("force").display(max(max(response.peak_force for response in responses), 1e-3))
    columns = axes.shape[1]
    # in small panels the two lines of numbers need a band of their own above the loop
    band = 0.0 if columns <= _COLUMNS else min(0.5, _NUMBERS_HEIGHT * columns / PAGE_WIDTH)
    capacity = responses[0].bearing.displacement_capacity
    shown = np.array([[one.axison for one in row] for row in axes])
    for (row, column), one in np.ndenumerate(axes):
        one.set_xlim(-reach, reach)
        one.set_ylim(-height, height * (1.0 + band) / (1.0 - band))
        calm_ticks(one, 4 if columns <= _COLUMNS else 2, 5)
        lowest = row + 1 == len(axes) or not shown[row + 1, column]
        one.tick_params(labelbottom=bool(lowest), labelleft=column == 0)
        if capacity is not None and capacity < reach and one.axison:
            for side in (-capacity, capacity):
                one.axvline(side, color=RED, linewidth=0.5, linestyle=(0, (5, 3)), zorder=0)


def _shared_range(responses: "Sequence[Response]", shows: ColourQuantity) -> Normalize:
    ranges = [colour_range(response, shows) for response in responses]
    return Normalize(min(float(r.vmin or 0.0) for r in ranges), max(float(r.vmax or 0.0) for r in ranges))


def _add_scale(figure: Figure, axes: "np.ndarray", shows: ColourQuantity, norm: Normalize) -> None:
    colours = warm_colours() if shows == "temperature" else time_colours()
    bar: Any = figure.colorbar(
        ScalarMappable(norm, colours), ax=axes, pad=0.015, aspect=18 * len(axes), fraction=0.03
    )
    finish_colour_bar(bar, quantity(shows).label)


# Figures of any size on one sheet.


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
