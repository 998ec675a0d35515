"""Predicted against analysed, for every blind method."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from dcfp.errors import InputError
from dcfp.present.figures.style import (
    BLUE,
    ENTRIES,
    GREY,
    INK,
    OCHRE,
    PAGE_WIDTH,
    PALE,
    RED,
    calm_ticks,
    plain_numbers,
    style,
)
from dcfp.schema.digits import typeset
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.arrays import FloatArray
    from dcfp.inference import Case
    from dcfp.inference.case import Quantity, View
    from dcfp.inference.statistics import Scatter

#: Limits of the axes beyond the data [-].
_ROOM = 1.35
#: Numbers of cases up to which marks are large, and from which on they are small.
_FEW, _MANY = 20, 200


@dataclass(frozen=True)
class _Look:
    """How the predictions of one method are drawn; its name is the value of `dcfp.inference.case.Method`."""

    method: str
    marker: str
    colour: str
    order: int
    scale: float = 1.0

    def mark(self, size: float) -> dict[str, Any]:
        return {"marker": self.marker, "markersize": self.scale * size, "linestyle": "none"}


_LOOKS = (
    _Look("pulse", "o", BLUE, 4),
    _Look("simplified", "^", OCHRE, 3, 1.25),
    _Look("design", "s", GREY, 2, 0.9),
    _Look("pulse march", "D", RED, 5, 0.9),
)
#: Methods of codes, all of which look at the record's spectrum.
_CODE_LOOKS = (
    _Look("ASCE 7-16 ELF", "v", BLUE, 2),
    _Look("Eurocode 8 simplified", "p", OCHRE, 2, 1.1),
    _Look("AIJ method 1", "h", GREY, 3),
    _Look("AIJ method 2", "P", INK, 3),
    _Look("AIJ energy balance", "X", RED, 4),
    _Look("Iwan (1980)", "*", BLUE, 1, 1.2),
)


def plot_comparison(cases: "Sequence[Case]") -> Figure:
    """Draw what every blind method predicts against what the analysis gives, on a new figure.

    A legend names the methods with their bias, the geometric mean of prediction over analysis, and their dispersion, the
    standard deviation of its natural logarithm; cases in which a method predicts nothing lie as hollow marks on the lower
    edge, and are counted. Where the methods of codes were asked, a panel of their own shows their y_max; a case outside of the limits of a
    method is hollow there.

    Parameters
    ----------
    cases
        What was analysed and predicted.

    Raises
    ------
    InputError
        If there is no case.
    """
    from dcfp.inference.case import DISPLACEMENT, QUANTITIES  # late: the package imports the kernels

    if not cases:
        msg = "There is nothing to compare; give at least one case."
        raise InputError(msg)
    drawn: list[tuple[Quantity, tuple[_Look, ...]]] = [
        (which, _LOOKS) for which in QUANTITIES if which.name in ENTRIES
    ]
    if any(case.answers for case in cases):
        drawn.append((DISPLACEMENT, _CODE_LOOKS))
    rows = (len(drawn) + 1) // 2
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, 3.95 * rows), layout="constrained")
        panels: Any = figure.subplots(rows, 2)
        for axes in panels.flat[len(drawn) :]:
            axes.set_axis_off()
        for axes, (which, looks) in zip(panels.flat, drawn, strict=False):
            _draw_panel(axes, cases, which, looks)
    return figure


def _draw_panel(axes: "Axes", cases: "Sequence[Case]", which: "Quantity", looks: tuple[_Look, ...]) -> None:
    entry = quantity(ENTRIES[which.name])
    analysed, predicted = _values(cases, which, looks)
    low, high = _limits(analysed, predicted)
    _draw_lines(axes, low, high)
    size = 4.5 if len(cases) <= _FEW else 3.0 if len(cases) <= _MANY else 2.2
    for look, values in zip(looks, predicted, strict=True):
        outside = np.array([_is_outside(case, look) for case in cases])
        _draw_method(axes, look, np.where(outside, np.nan, analysed), values, low, size)
        _draw_outside(axes, look, np.where(outside, analysed, np.nan), values, size)
    calm_ticks(axes)
    axes.set(xscale="log", yscale="log", xlim=(low, high), ylim=(low, high))
    axes.set_box_aspect(1.0)
    axes.set_xlabel(f"${entry.symbol}$ analysed [{entry.shown.name}]")
    axes.set_ylabel(f"${entry.symbol}$ predicted [{entry.shown.name}]")
    plain_numbers(axes)
    _add_legend(axes, cases, which, looks)


def _is_outside(case: "Case", look: _Look) -> bool:
    """Whether a case is outside of the limits of a method of a code."""
    return look.method in case.answers and case.answers[look.method].valid is False


def _values(
    cases: "Sequence[Case]", which: "Quantity", looks: tuple[_Look, ...]
) -> "tuple[FloatArray, list[FloatArray]]":
    """Return what was analysed, and what each method predicts, as shown; not a number where there is nothing."""
    from dcfp.inference.statistics import value_of
    from dcfp.methods import NOTHING

    analysed = np.array([value_of(case.analysed.whole, which) for case in cases])
    predicted = [
        np.array([value_of(case.predicted.get(view, NOTHING), which) for case in cases])
        for view in _views(looks)
    ]
    entry = quantity(ENTRIES[which.name])
    return entry.display(analysed), [entry.display(values) for values in predicted]


def _views(looks: tuple[_Look, ...]) -> "list[View]":
    """Return the view of each method that does not know the analysis, in the order of their looks."""
    from dcfp.inference.case import VIEWS, Basis

    blind = {str(method): (method, basis) for method, basis in VIEWS if basis is not Basis.INFORMED}
    return [blind[look.method] for look in looks]


def _limits(analysed: "FloatArray", predicted: "Sequence[FloatArray]") -> tuple[float, float]:
    """Return the limits that both axes share, round the values above zero."""
    values = np.concatenate((analysed, *predicted))
    good = values[np.isfinite(values) & (values > 0.0)]
    if good.size == 0:
        return 0.1, 10.0
    return float(good.min()) / _ROOM, float(good.max()) * _ROOM


def _draw_lines(axes: "Axes", low: float, high: float) -> None:
    ends = np.array([low, high])
    axes.fill_between(ends, 0.5 * ends, 2.0 * ends, color=PALE, linewidth=0.0, zorder=0)
    axes.plot(ends, ends, color=INK, linewidth=0.7, zorder=1)


def _draw_method(
    axes: "Axes", look: _Look, analysed: "FloatArray", predicted: "FloatArray", low: float, size: float
) -> None:
    shown = analysed > 0.0
    there = shown & (predicted > 0.0)
    axes.plot(
        analysed[there],
        predicted[there],
        **look.mark(size),
        color=look.colour,
        alpha=0.9 if analysed.size <= _FEW else 0.6,
        markeredgewidth=0.0,
        zorder=look.order,
    )
    nothing = shown & (predicted == 0.0)
    if nothing.any():
        axes.plot(
            analysed[nothing],
            np.full(int(nothing.sum()), low),
            **look.mark(size + 1.5),
            markerfacecolor="white",
            markeredgecolor=look.colour,
            markeredgewidth=0.8,
            clip_on=False,
            zorder=look.order,
        )


def _draw_outside(
    axes: "Axes", look: _Look, analysed: "FloatArray", predicted: "FloatArray", size: float
) -> None:
    there = np.isfinite(analysed) & np.isfinite(predicted)
    axes.plot(
        analysed[there],
        predicted[there],
        **look.mark(size),
        markerfacecolor="none",
        markeredgecolor=look.colour,
        markeredgewidth=0.5,
        alpha=0.8,
        zorder=look.order,
    )


def _add_legend(axes: "Axes", cases: "Sequence[Case]", which: "Quantity", looks: tuple[_Look, ...]) -> None:
    from dcfp.inference.statistics import scatters

    found = scatters(cases)
    handles: list[Line2D] = []
    for look, view in zip(looks, _views(looks), strict=True):
        if (view, which) in found:
            label = f"{look.method}: {_words(found[view, which])}"
            handles.append(Line2D([], [], **look.mark(4.0), color=look.colour, label=label))
    limits = "; hollow: outside of its limits" if looks is _CODE_LOOKS else ""
    axes.legend(
        handles=handles,
        title=("bias, dispersion" if len(cases) > 1 else "predicted / analysed") + limits,
        title_fontsize=7.0,
        alignment="left",
        loc="lower left",
        bbox_to_anchor=(0.0, 1.01),
        ncols=2 if looks is _LOOKS else 1,
        handlelength=0.8,
    )


def _words(measures: "Scatter") -> str:
    if not measures.number:
        return "none"
    dispersion = f", {typeset(measures.dispersion, 2)}" if measures.number > 1 else ""
    without = f" ({measures.without} none)" if measures.without else ""
    return f"{typeset(measures.bias, 2)}{dispersion}{without}"
