"""Predicted from the record alone against analysed, with the paper's range: Figures 18 and 22 to 24."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.nomenclature import quantity
from dcfp.plots.li_2020.marks import Mark, draw_points
from dcfp.plots.predicted import ENTRIES
from dcfp.plots.style import GREY, INK, RED, calm_ticks

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.comparison import Case
    from dcfp.comparison.case import View
    from dcfp.comparison.quantities import Quantity


def draw_accuracy(
    axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", view: "View", which: "Quantity"
) -> None:
    """Draw what a blind method predicts against the analysis, with the range of their ratio that the paper prints."""
    from dcfp.comparison.printed import RANGES  # late: the package imports the kernels
    from dcfp.comparison.statistics import value_of

    entry = quantity(ENTRIES[which.name])
    least, largest, _ = RANGES[view, which]

    def point(case: "Case") -> tuple[float, float] | None:
        if view not in case.predicted:
            return None
        analysed = entry.factor * value_of(case.analysed.whole, which)
        predicted = entry.factor * value_of(case.predicted[view], which)
        return (analysed, predicted) if np.isfinite(predicted) else None

    draw_points(axes, cases, marks, point)
    points = [place for place in map(point, cases) if place is not None]
    across = 1.08 * (max((x for x, _ in points), default=0.0) or 1.0)
    up = 1.08 * (max((y for _, y in points), default=0.0) or 1.0)
    _draw_range(axes, least, largest, across)
    calm_ticks(axes, 6, 5)
    axes.set_xlim(0.0, across)
    axes.set_ylim(0.0, max(up, across))
    axes.set_xlabel(f"${entry.symbol}$ analysed [{entry.shown}]")
    axes.set_ylabel(f"${entry.symbol}$ predicted [{entry.shown}]")


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
