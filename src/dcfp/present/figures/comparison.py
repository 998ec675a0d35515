"""Predicted against analysed, for every blind method."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from dcfp.errors import InputError
from dcfp.present.figures.style import INK, PAGE_WIDTH, PALE, calm_ticks, looks, plain_numbers, style
from dcfp.schema.digits import typeset
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.arrays import FloatArray
    from dcfp.inference import Case
    from dcfp.inference.statistics import Scatter
    from dcfp.methods.method import Look, Variant
    from dcfp.schema.quantities import Quantity

#: Limits of the axes beyond the data [-].
_ROOM = 1.35
#: Numbers of cases up to which marks are large, and from which on they are small.
_FEW, _MANY = 20, 200


@dataclass(frozen=True)
class _Drawn:
    """What a panel shows: a quantity, and the methods that are compared in it."""

    name: str
    quantity: "Quantity"
    variants: "tuple[Variant, ...]"
    of_codes: bool = False


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
    if not cases:
        msg = "There is nothing to compare; give at least one case."
        raise InputError(msg)
    drawn = _drawn(cases)
    rows = (len(drawn) + 1) // 2
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, 3.95 * rows), layout="constrained")
        panels: Any = figure.subplots(rows, 2)
        for axes in panels.flat[len(drawn) :]:
            axes.set_axis_off()
        for axes, one in zip(panels.flat, drawn, strict=False):
            _draw_panel(axes, cases, one)
    return figure


def _drawn(cases: "Sequence[Case]") -> list[_Drawn]:
    """Return the panels: each quantity that more than one method predicts, and y_max by the codes where they were asked."""
    from dcfp.methods.method import Information, variants  # late: the package imports the kernels
    from dcfp.methods.prediction import prediction_methods
    from dcfp.methods.pulses import DISPLACEMENT, PREDICTION_QUANTITIES, value_of

    compared = [one for one in variants() if one.information is not Information.INFORMED]
    blind = tuple(one for one in compared if one.method in prediction_methods())
    codes = tuple(one for one in compared if one.method not in prediction_methods())

    def predicts(variant: "Variant", which: "Quantity") -> bool:
        said = (case.predicted[variant] for case in cases if variant in case.predicted)
        return any(np.isfinite(value_of(one, which)) for one in said)

    told = {
        name: which
        for name, which in PREDICTION_QUANTITIES.items()
        if sum(predicts(variant, which) for variant in blind) > 1
    }
    drawn = [_Drawn(name, which, blind) for name, which in (told or PREDICTION_QUANTITIES).items()]
    if any(case.codes for case in cases):
        name = next(name for name, one in PREDICTION_QUANTITIES.items() if one is DISPLACEMENT)
        drawn.append(_Drawn(name, DISPLACEMENT, codes, of_codes=True))
    return drawn


def _draw_panel(axes: "Axes", cases: "Sequence[Case]", drawn: _Drawn) -> None:
    entry, known = quantity(drawn.name), looks()
    analysed, predicted = _values(cases, drawn)
    low, high = _limits(analysed, predicted)
    _draw_lines(axes, low, high)
    size = 4.5 if len(cases) <= _FEW else 3.0 if len(cases) <= _MANY else 2.2
    for variant, values in zip(drawn.variants, predicted, strict=True):
        outside = np.array([_is_outside(case, variant.method) for case in cases])
        look = known[variant.method]
        _draw_method(axes, look, np.where(outside, np.nan, analysed), values, low, size)
        _draw_outside(axes, look, np.where(outside, analysed, np.nan), values, size)
    calm_ticks(axes)
    axes.set(xscale="log", yscale="log", xlim=(low, high), ylim=(low, high))
    axes.set_box_aspect(1.0)
    axes.set_xlabel(f"${entry.symbol}$ analysed [{entry.shown.name}]")
    axes.set_ylabel(f"${entry.symbol}$ predicted [{entry.shown.name}]")
    plain_numbers(axes)
    _add_legend(axes, cases, drawn)


def _is_outside(case: "Case", method: str) -> bool:
    """Whether a case is outside of the limits of a method of a code."""
    return method in case.codes and case.codes[method].valid is False


def _values(cases: "Sequence[Case]", drawn: _Drawn) -> "tuple[FloatArray, list[FloatArray]]":
    """Return what was analysed, and what each method predicts, as shown; not a number where there is nothing."""
    from dcfp.methods.pulses import NOTHING, value_of

    which, entry = drawn.quantity, quantity(drawn.name)
    analysed = np.array([value_of(case.analysed.whole, which) for case in cases])
    predicted = [
        np.array([value_of(case.predicted.get(variant, NOTHING), which) for case in cases])
        for variant in drawn.variants
    ]
    return entry.display(analysed), [entry.display(values) for values in predicted]


def _mark(look: "Look", size: float) -> dict[str, Any]:
    return {"marker": look.marker, "markersize": look.scale * size, "linestyle": "none"}


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
    axes: "Axes", look: "Look", analysed: "FloatArray", predicted: "FloatArray", low: float, size: float
) -> None:
    shown = analysed > 0.0
    there = shown & (predicted > 0.0)
    axes.plot(
        analysed[there],
        predicted[there],
        **_mark(look, size),
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
            **_mark(look, size + 1.5),
            markerfacecolor="white",
            markeredgecolor=look.colour,
            markeredgewidth=0.8,
            clip_on=False,
            zorder=look.order,
        )


def _draw_outside(
    axes: "Axes", look: "Look", analysed: "FloatArray", predicted: "FloatArray", size: float
) -> None:
    there = np.isfinite(analysed) & np.isfinite(predicted)
    axes.plot(
        analysed[there],
        predicted[there],
        **_mark(look, size),
        markerfacecolor="none",
        markeredgecolor=look.colour,
        markeredgewidth=0.5,
        alpha=0.8,
        zorder=look.order,
    )


def _add_legend(axes: "Axes", cases: "Sequence[Case]", drawn: _Drawn) -> None:
    from dcfp.inference.statistics import scatters

    found, known = scatters(cases), looks()
    handles: list[Line2D] = []
    for variant in drawn.variants:
        if (variant, drawn.quantity) in found:
            look = known[variant.method]
            label = f"{variant.method}: {_words(found[variant, drawn.quantity])}"
            handles.append(Line2D([], [], **_mark(look, 4.0), color=look.colour, label=label))
    limits = "; hollow: outside of its limits" if drawn.of_codes else ""
    axes.legend(
        handles=handles,
        title=("bias, dispersion" if len(cases) > 1 else "predicted / analysed") + limits,
        title_fontsize=7.0,
        alignment="left",
        loc="lower left",
        bbox_to_anchor=(0.0, 1.01),
        ncols=1 if drawn.of_codes else 2,
        handlelength=0.8,
    )


def _words(measures: "Scatter") -> str:
    if not measures.number:
        return "none"
    dispersion = f", {typeset(measures.dispersion, 2)}" if measures.number > 1 else ""
    without = f" ({measures.without} none)" if measures.without else ""
    return f"{typeset(measures.bias, 2)}{dispersion}{without}"
