"""Predicted from the record alone against analysed, with the paper's range: Figures 18 and 22 to 24."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dcfp.nomenclature import quantity
from dcfp.plots.li_2020.marks import Mark, draw_points
from dcfp.plots.style import GREY, INK, RED, calm_ticks

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.comparison import Case
    from dcfp.comparison.case import View
    from dcfp.comparison.quantities import Quantity


@dataclass(frozen=True)
class Range:
    """Smallest and largest ratio of prediction to analysis that the paper reports [-]."""

    least: float
    largest: float


#: Figures 18, 22, 23 and 24.
PULSE_CHANGE = Range(1.0, 2.1)
SIMPLIFIED_INPUT, SIMPLIFIED_HYSTERETIC, SIMPLIFIED_CHANGE = Range(0.8, 1.5), Range(0.7, 1.6), Range(0.7, 1.8)


def draw_pulse_change(axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]") -> None:
    """Draw dy by the pulse method against that of the analysis: Figure 18."""
    from dcfp.comparison.case import Basis, Method  # late: the package imports the kernels
    from dcfp.comparison.quantities import CHANGE

    view = (Method.PULSE, Basis.BLIND)
    _draw_accuracy(axes, cases, marks, view, CHANGE, "displacement_change", PULSE_CHANGE)


def draw_simplified_input(axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]") -> None:
    """Draw V_dE by the simplified method against that of the analysis: Figure 22."""
    from dcfp.comparison.case import Basis, Method
    from dcfp.comparison.quantities import INPUT

    view = (Method.SIMPLIFIED, Basis.BLIND)
    _draw_accuracy(axes, cases, marks, view, INPUT, "swing_input_velocity", SIMPLIFIED_INPUT)


def draw_simplified_hysteretic(axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]") -> None:
    """Draw V_dEhr by the simplified method against that of the analysis: Figure 23."""
    from dcfp.comparison.case import Basis, Method
    from dcfp.comparison.quantities import HYSTERETIC

    view = (Method.SIMPLIFIED, Basis.BLIND)
    _draw_accuracy(axes, cases, marks, view, HYSTERETIC, "swing_hysteretic_velocity", SIMPLIFIED_HYSTERETIC)


def draw_simplified_change(axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]") -> None:
    """Draw dy by the simplified method against that of the analysis: Figure 24."""
    from dcfp.comparison.case import Basis, Method
    from dcfp.comparison.quantities import CHANGE

    view = (Method.SIMPLIFIED, Basis.BLIND)
    _draw_accuracy(axes, cases, marks, view, CHANGE, "displacement_change", SIMPLIFIED_CHANGE)


def _draw_accuracy(
    axes: "Axes",
    cases: "Sequence[Case]",
    marks: "Mapping[str, Mark]",
    view: "View",
    which: "Quantity",
    name: str,
    known: Range,
) -> None:
    from dcfp.comparison.statistics import value_of

    entry = quantity(name)
    _, basis = view

    def point(case: "Case") -> tuple[float, float] | None:
        if view not in case.predicted:
            return None
        analysed = entry.factor * value_of(case.analysed.beside(basis), which)
        predicted = entry.factor * value_of(case.predicted[view], which)
        return (analysed, predicted) if np.isfinite(predicted) else None

    draw_points(axes, cases, marks, point)
    points = [place for place in map(point, cases) if place is not None]
    across = 1.08 * (max((x for x, _ in points), default=0.0) or 1.0)
    up = 1.08 * (max((y for _, y in points), default=0.0) or 1.0)
    _draw_range(axes, known, across)
    calm_ticks(axes, 6, 5)
    axes.set_xlim(0.0, across)
    axes.set_ylim(0.0, max(up, across))
    axes.set_xlabel(f"${entry.symbol}$ analysed [{entry.shown}]")
    axes.set_ylabel(f"${entry.symbol}$ predicted [{entry.shown}]")


def _draw_range(axes: "Axes", known: Range, across: float) -> None:
    ends = np.array([0.0, across])
    if known.least != 1.0:
        axes.plot(ends, ends, color=GREY, linewidth=0.6, zorder=1)
    for ratio, colour, dashes in (
        (known.largest, RED, (0, (5, 2))),
        (known.least, INK, (0, (1.5, 1.5)) if known.least != 1.0 else "-"),
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
