"""Sobol indices as bars."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.errors import InputError
from dcfp.present.figures.style import BLUE, INK, OCHRE, PAGE_WIDTH, style

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

#: Most panels of a figure.
_MOST = 4
_BARS = (("S1", "first order", OCHRE, -0.19), ("ST", "total", BLUE, 0.19))


def plot_sensitivity(found: "xarray.Dataset") -> Figure:
    """Draw first-order and total Sobol indices by factor with their intervals, on a new figure.

    A panel for each value of the one factor that is left of the grid, of many for some of them.

    Parameters
    ----------
    found
        What `dcfp.study.assessment.sensitivity` returns.

    Raises
    ------
    InputError
        If several factors are left.
    """
    from dcfp.study.assessment.selection import (  # late: the package imports the kernels
        described,
        shown_value,
    )

    left = [str(name) for name in found["S1"].dims if name != "factor"]
    if len(left) > 1:
        msg = f"A figure of Sobol indices is over one factor of the grid, and {' and '.join(left)} are left; choose values first."
        raise InputError(msg)
    number = found.sizes[left[0]] if left else 1
    places = np.unique(np.linspace(0, number - 1, min(number, _MOST)).round().astype(int)).tolist()
    with style():
        height = 1.15 + 0.36 * found.sizes["factor"]
        width = PAGE_WIDTH if len(places) > 1 else 0.55 * PAGE_WIDTH
        figure = Figure(figsize=(width, height), layout="constrained")
        panels: Any = figure.subplots(1, len(places), squeeze=False, sharex=True, sharey=True)
        for axes, place in zip(panels.flat, places, strict=True):
            _draw(axes, found.isel({left[0]: place}) if left else found)
            if left:
                along = found[left[0]]
                symbol = "PGV" if left[0] == "pgv" else described(along).title
                axes.set_title(f"{symbol} {shown_value(along, along.to_numpy()[place])}")
        last = panels.flat[-1]  # all share its limits
        low, high = last.get_xlim()
        last.set_xlim(min(0.0, low), max(1.0, high))
        last.set_xticks([0.0, 0.5, 1.0])
        figure.supxlabel(f"part of the variance of the {_words(found)}", fontsize=7.5, color=INK)
        handles, labels = panels.flat[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper center", ncols=2, borderaxespad=0.3)
    return figure


def _draw(axes: "Axes", one: "xarray.Dataset") -> None:
    names = one["factor"].to_numpy().tolist()
    heights = np.arange(len(names), dtype=np.float64)
    for name, words, colour, shift in _BARS:
        axes.barh(
            heights + shift,
            one[name].to_numpy(),
            0.34,
            xerr=one[f"{name}_confidence"].to_numpy(),
            color=colour,
            label=words,
            error_kw={"elinewidth": 0.7, "capsize": 1.8, "capthick": 0.7, "ecolor": INK},
        )
    axes.axvline(0.0, color=INK, linewidth=0.6)
    axes.set_yticks(heights, names)
    axes.set_ylim(len(names) - 0.45, -0.55)


def _words(found: "xarray.Dataset") -> str:
    from dcfp.schema.nomenclature import NOMENCLATURE

    name = str(found.attrs["quantity"])
    entry = NOMENCLATURE.get(name)
    words = name.replace("_", " ") if entry is None else entry.words
    return f"{'logarithm of the ' if found.attrs['logarithm'] else ''}{words}"
