"""The loop with the simplified heating model beside that with the precise one: Figure 10."""

from typing import TYPE_CHECKING, Any

from dcfp.present.figures.extent import line_width, shown
from dcfp.present.figures.loop import draw_cross
from dcfp.present.figures.style import BLUE, OCHRE, calm_ticks
from dcfp.present.figures.words import metres_per_second
from dcfp.schema.nomenclature import quantity

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from dcfp.analysis import Response

#: Record of Figure 10, which no open data set has, and the other one of that earthquake.
_RECORDS = ("JKB", "KNA")


def loops_record(loops: "Mapping[tuple[str, float], tuple[Response, Response]]") -> str:
    """Return the record to be drawn: that of the paper, else the other one of its earthquake, else that of the largest displacement."""
    records = {record for record, _ in loops}
    for record in _RECORDS:
        if record in records:
            return record
    largest = max(loops.items(), key=lambda item: item[1][0].peak_displacement)
    return largest[0][0]


def draw_loops_of_both_models(
    figure: "Figure", loops: "Mapping[tuple[str, float], tuple[Response, Response]]"
) -> None:
    """Draw force against displacement with the simplified and the precise heating model, at the lowest and the highest PGV: Figure 10.

    `loops` has both analyses, simplified and precise, by record and PGV [mm/s].
    """
    record = loops_record(loops)
    pgvs = sorted(pgv for name, pgv in loops if name == record)
    chosen = pgvs if len(pgvs) == 1 else [pgvs[0], pgvs[-1]]
    panels: Any = figure.subplots(1, len(chosen), squeeze=False)[0]
    for axes, pgv, letter in zip(panels, chosen, "ab", strict=False):
        _draw_pair(axes, *loops[record, pgv])
        axes.set_title(f"({letter}) PGV {metres_per_second(pgv)}", loc="left")
    handles, labels = panels[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper right", ncols=2, borderaxespad=0.4)


def _draw_pair(axes: "Axes", simplified: "Response", precise: "Response") -> None:
    draw_cross(axes)
    for response, colour, dashes, label in (
        (simplified, BLUE, "-", "simplified"),
        (precise, OCHRE, (0, (4, 2)), "precise"),
    ):
        part = shown(response)
        axes.plot(
            quantity("displacement").display(response.displacement[part]),
            quantity("force").display(response.force[part]),
            color=colour,
            linewidth=line_width(response),
            linestyle=dashes,
            label=label,
        )
    calm_ticks(axes, 5, 5)
    axes.set_xlabel(quantity("displacement").label)
    axes.set_ylabel(quantity("force").label)
