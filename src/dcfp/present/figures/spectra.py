"""Response and input energy spectra."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.style import BLUE, GREY, INK, OCHRE, PAGE_WIDTH, RED, drawable, style
from dcfp.present.figures.words import metres_per_second

if TYPE_CHECKING:
    from collections.abc import Sequence

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
