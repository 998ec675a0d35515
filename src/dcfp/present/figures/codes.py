"""What the methods of codes say beside the analysis, and the spectrum that they look at."""

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.figure import Figure

from dcfp.present.figures.style import BLUE, GREY, INK, OCHRE, PAGE_WIDTH, RED, drawable, style
from dcfp.present.figures.words import metres_per_second, millimetres

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.axes import Axes

    from dcfp.methods.panel import Panel

#: Periods at which a spectrum is drawn [s].
_PERIODS = np.geomspace(0.05, 10.0, 300)
_COLOURS = (BLUE, OCHRE, RED, INK, GREY, "#6699CC")
#: Height of a row of panels, and of the legend above [in].
_ROW, _HEAD = 2.3, 0.5


def plot_codes(panels: "Sequence[Panel]") -> Figure:
    """Draw for every demand the answers in the displacement spectrum, and their displacements as bars, on a new figure.

    Left the spectrum at a damping of 5 % with effective period and displacement of every method that has both; right the displacements beside the
    analysis, a line. What is outside of the limits of its method is hollow, and hatched on the right.
    """
    with style():
        figure = Figure(figsize=(PAGE_WIDTH, _HEAD + _ROW * len(panels)), layout="constrained")
        axes: Any = figure.subplots(len(panels), 2, squeeze=False, width_ratios=(1.0, 1.15))
        for row, panel in zip(axes, panels, strict=True):
            _draw_spectrum(row[0], panel)
            _draw_bars(row[1], panel)
        axes[-1][0].set_xlabel("$T$ [s]")
        axes[-1][1].set_xlabel("$D$ [mm]")
    return figure


def _draw_spectrum(axes: "Axes", panel: "Panel") -> None:
    demand = panel.spectrum.acceleration(_PERIODS) * (_PERIODS / (2.0 * np.pi)) ** 2
    axes.plot(_PERIODS, demand, color=GREY, linewidth=1.0, label="5 %")
    for colour, (name, said) in zip(_COLOURS, panel.answers.items(), strict=False):
        if said.period is not None:
            face = "white" if said.valid is False else colour
            point = ([said.period], [said.displacement])
            axes.plot(*point, "o", color=colour, markerfacecolor=face, markersize=4.0, label=name)
    axes.set_ylabel("$S_d$ [mm]")
    axes.set_ylim(bottom=0.0)
    axes.set_xlim(0.0, float(_PERIODS[-1]))
    title = drawable(panel.name) + ("" if panel.pgv is None else f",  PGV {metres_per_second(panel.pgv)}")
    axes.set_title(title, loc="left", weight="bold", parse_math=False)


def _draw_bars(axes: "Axes", panel: "Panel") -> None:
    names = list(panel.answers)
    for place, (colour, said) in enumerate(zip(_COLOURS, panel.answers.values(), strict=False)):
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
    if panel.displacement is not None:
        axes.axvline(panel.displacement, color=INK, linewidth=1.0, linestyle=(0, (4, 2)))
        axes.set_title(
            f"analysis {millimetres(panel.displacement)}; hollow: outside of its limits", loc="left"
        )
    else:
        axes.set_title("hollow: outside of its limits", loc="left")
    axes.set_yticks(range(len(names)), names)
    axes.invert_yaxis()
    axes.set_xlim(
        0.0,
        1.25 * max([said.displacement for said in panel.answers.values()] + [panel.displacement or 0.0, 1.0]),
    )
