"""Response and input energy spectra; what the methods of codes say beside the analysis, and the spectrum that they look at."""

from itertools import cycle
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.style import BLUE, GREY, INK, OCHRE, PAGE_WIDTH, RED, drawable, style
from dcfp.schema.digits import metres_per_second, millimetres

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.methods.code_comparison import CodeComparison
    from dcfp.methods.spectra import EnergySpectrum


_COLOURS = (BLUE, RED, OCHRE, INK, GREY, "#6699CC", "#228833", "#AA3377")
_KILO = 1e3
#: Periods that are named on the axis [s].
_TICKS = (0.1, 1.0, 10.0)


def plot_spectra(spectra: "Sequence[EnergySpectrum]", velocities: "Sequence[float]") -> Figure:
    """Draw displacement, pseudo-acceleration and equivalent velocity of the input energy over the period, on a new figure.

    `velocities` are the PGVs of the motions [mm/s], for the legend; of more motions than colours the lines are thin and grey, with their
    geometric mean.
    """
    many = len(spectra) > len(_COLOURS)
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, 2.9), layout="constrained")
        axes: Any = figure.subplots(1, 3)
        for place, (one, pgv) in enumerate(zip(spectra, velocities, strict=True)):
            label = None if many else f"{drawable(one.name)}, {metres_per_second(pgv)}"
            look = {"color": GREY, "linewidth": 0.3} if many else {"color": _COLOURS[place], "linewidth": 0.9}
            for panel, values in zip(axes, _values(one), strict=True):
                panel.plot(one.periods, values, label=label, **look)
        if many and all(np.array_equal(one.periods, spectra[0].periods) for one in spectra):
            for place, panel in enumerate(axes):
                every = np.array([_values(one)[place] for one in spectra])
                mean = np.exp(np.log(np.maximum(every, 1e-12)).mean(axis=0))
                panel.plot(
                    spectra[0].periods,
                    mean,
                    color=BLUE,
                    linewidth=1.4,
                    label=f"geometric mean of {len(spectra)}",
                )
        for panel, label in zip(axes, ("$S_d$ [mm]", "$S_a$ [m/s²]", "$V_E$ [m/s]"), strict=True):
            panel.set_xscale("log")
            panel.set_xlabel("$T$ [s]")
            panel.set_ylabel(label)
            panel.set_ylim(bottom=0.0)
            panel.set_xticks(_TICKS, [f"{tick:g}" for tick in _TICKS])
        handles, labels = axes[0].get_legend_handles_labels()
        figure.legend(handles, labels, loc="outside upper center", ncols=min(4, max(len(labels), 1)))
    return figure


def _values(one: "EnergySpectrum") -> "tuple[np.ndarray, ...]":
    omega = 2.0 * np.pi / one.periods
    return one.displacement, one.displacement * omega**2 / _KILO, np.sqrt(2.0 * one.relative) / _KILO


# What the methods of codes say beside the analysis, and the spectrum that they look at.


#: Periods at which a spectrum is drawn [s].
_PERIODS = np.geomspace(0.05, 10.0, 300)
_COLOURS_OF_METHODS = (BLUE, OCHRE, RED, INK, GREY, "#6699CC")
#: Height of a row of panels, and of the legend above [in].
_ROW, _HEAD = 2.3, 0.5


def plot_codes(comparisons: "Sequence[CodeComparison]") -> Figure:
    """Draw for every demand the results in the displacement spectrum, and their displacements as bars, on a new figure.

    Left the spectrum at a damping of 5 % with effective period and displacement of every method that has both; right the displacements beside the
    analysis, a line. What is outside of the limits of its method is hollow, and hatched on the right.
    """
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, _HEAD + _ROW * len(comparisons)), layout="constrained")
        axes: Any = figure.subplots(len(comparisons), 2, squeeze=False, width_ratios=(1.0, 1.15))
        for row, comparison in zip(axes, comparisons, strict=True):
            _draw_spectrum(row[0], comparison)
            _draw_bars(row[1], comparison)
        axes[-1][0].set_xlabel("$T$ [s]")
        axes[-1][1].set_xlabel("$D$ [mm]")
    return figure


def _draw_spectrum(axes: "Axes", comparison: "CodeComparison") -> None:
    demand = comparison.inputs.spectrum.acceleration(_PERIODS) * (_PERIODS / (2.0 * np.pi)) ** 2
    axes.plot(_PERIODS, demand, color=GREY, linewidth=1.0, label="5 %")
    for colour, (name, said) in zip(cycle(_COLOURS_OF_METHODS), comparison.results.items(), strict=False):
        if said.period is not None:
            face = "white" if said.valid is False else colour
            point = ([said.period], [said.displacement])
            axes.plot(*point, "o", color=colour, markerfacecolor=face, markersize=4.0, label=name)
    axes.set_ylabel("$S_d$ [mm]")
    axes.set_ylim(bottom=0.0)
    axes.set_xlim(0.0, float(_PERIODS[-1]))
    title = drawable(comparison.name) + (
        "" if comparison.pgv is None else f",  PGV {metres_per_second(comparison.pgv)}"
    )
    axes.set_title(title, loc="left", weight="bold", parse_math=False)


def _draw_bars(axes: "Axes", comparison: "CodeComparison") -> None:
    names = list(comparison.results)
    for place, (colour, said) in enumerate(
        zip(cycle(_COLOURS_OF_METHODS), comparison.results.values(), strict=False)
    ):
        inside = said.valid is not False
        axes.barh(
            place,
            said.displacement,
            height=0.6,
            color=colour if inside else "white",
            edgecolor=colour,
            linewidth=1.0,
            hatch=None if inside else "////",
        )
        words = axes.annotate(
            millimetres(said.displacement),
            (said.displacement, place),
            (4.0, 0.0),
            textcoords="offset points",
            va="center",
            size=6.5,
        )
        # where the line of the analysis passes behind it
        words.set_bbox({"facecolor": "white", "edgecolor": "none", "pad": 0.5})
    if comparison.displacement is not None:
        axes.axvline(comparison.displacement, color=INK, linewidth=1.0, linestyle=(0, (4, 2)))
        axes.set_title(
            f"analysis {millimetres(comparison.displacement)}; hollow: outside of its limits", loc="left"
        )
    else:
        axes.set_title("hollow: outside of its limits", loc="left")
    axes.set_yticks(range(len(names)), names)
    axes.invert_yaxis()
    axes.set_xlim(
        0.0,
        1.25
        * max(
            [said.displacement for said in comparison.results.values()]
            + [comparison.displacement or 0.0, 1.0]
        ),
    )
