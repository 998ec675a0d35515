"""Predicted from the record alone against analysed, with the paper's range: Figures 18 and 22 to 24."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.present.figures.li_2020.marks import Mark, draw_points
from dcfp.present.figures.predicted import ENTRIES
from dcfp.present.figures.style import GREY, INK, RED, calm_ticks
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.inference import Case
    from dcfp.inference.case import Quantity, View


def draw_accuracy(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", view: "View", which: "Quantity"
) -> None:
    """Draw what a blind method predicts against the analysis, with the range of their ratio that the paper prints."""
    from dcfp.inference.printed import RANGES  # late: the package imports the kernels
    from dcfp.inference.statistics import value_of

    entry = quantity(ENTRIES[which.name])
    least, largest, _ = RANGES[view, which]

    def point(case: "Case") -> tuple[float, float] | None:
        if view not in case.predicted:
            return None
        analysed = entry.display(value_of(case.analysed.whole, which))
        predicted = entry.display(value_of(case.predicted[view], which))
        return (analysed, predicted) if np.isfinite(predicted) else None

    draw_points(axes, cases, marks, point)
    points = [place for place in map(point, cases) if place is not None]
    across = 1.08 * (max((x for x, _ in points), default=0.0) or 1.0)
    up = 1.08 * (max((y for _, y in points), default=0.0) or 1.0)
    _draw_range(axes, least, largest, across)
    calm_ticks(axes, 6, 5)
    axes.set_xlim(0.0, across)
    axes.set_ylim(0.0, max(up, across))
    axes.set_xlabel(f"${entry.symbol}$ analysed [{entry.shown.name}]")
    axes.set_ylabel(f"${entry.symbol}$ predicted [{entry.shown.name}]")


def _draw_range(axes: "Axes", least: float, largest: float, across: float) -> None:
    ends = np.array([0.0, across])
    if least != 1.0:
        axes.plot(ends, ends, color=GREY, linewidth=0.6, zorder=1)
    for ratio, colour, dashes in (
        (largest, RED, (0, (5, 2))),
        (least, INK, (0, (1.5, 1.5)) if least != 1.0 else "-"),
    ):
        axes.plot(
            ends,
            ratio * ends,
            color=colour,
            linewidth=0.8,
            linestyle=dashes,
            label=f"ratio {ratio:.1f}",
            zorder=1,
        )
    axes.legend(loc="lower right", borderaxespad=0.7)
