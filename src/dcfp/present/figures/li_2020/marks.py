"""A figure after one of the paper with its caption, and one mark for each record, the same in every figure."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from dcfp.present.figures.style import BLUE, PAGE_WIDTH, drawable

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from matplotlib.axes import Axes

    from dcfp.inference import Case

    Point: TypeAlias = Callable[[Case], tuple[float, float] | None]


#: Records of Li et al. (2020), Table 3, in its order; each has the mark of its place.
_PAPER_RECORDS = ("JKB", "KNA", "TC1", "NCC", "LPG", "IVD", "TSD", "TIM")
#: Paul Tol's muted colours, which stay apart for colour-blind eyes; the marks differ too.
_MARKS = (
    ("o", "#332288"),
    ("s", "#CC6677"),
    ("v", "#117733"),
    ("^", "#882255"),
    ("D", "#999933"),
    ("P", "#44AA99"),
    ("X", "#AA4499"),
    ("<", "#88CCEE"),
)
#: Characters of a legend in an inch of a figure's width, and those that a mark takes.
_CHARACTERS, _MARK_WIDTH = 16.5, 6


@dataclass(frozen=True)
class Mark:
    """Form and colour of a record's points."""

    marker: str
    colour: str
    size: float

    @property
    def look(self) -> dict[str, Any]:
        """Form and size, as Matplotlib takes them."""
        return {"marker": self.marker, "markersize": self.size, "linestyle": "none"}


def marks_of(cases: "Sequence[Case]") -> dict[str, Mark]:
    """Return the mark of every record, in the order of the cases; more records than there are marks look all the same."""
    records = list(dict.fromkeys(case.record for case in cases))
    if len(records) > len(_MARKS):
        return dict.fromkeys(records, Mark("o", BLUE, 2.4))
    taken = {name: _PAPER_RECORDS.index(name) for name in records if name in _PAPER_RECORDS}
    free = iter([place for place in range(len(_MARKS)) if place not in taken.values()])
    places = {name: taken[name] if name in taken else next(free) for name in records}
    return {
        name: Mark(*_MARKS[place], 5.2 if _MARKS[place][0] in "PX" else 4.2) for name, place in places.items()
    }


def draw_points(axes: "Axes", cases: "Sequence[Case]", marks: "Mapping[str, Mark]", point: "Point") -> None:
    """Draw a point for each case that has one, hollow where its ordinate is zero."""
    for record, mark in marks.items():
        found = [point(case) for case in cases if case.record == record]
        drawn = np.array([place for place in found if place is not None], dtype=np.float64).reshape(-1, 2)
        zero = drawn[:, 1] == 0.0
        alpha = 0.85 if mark.size > 3.0 else 0.55
        axes.plot(*drawn[~zero].T, **mark.look, color=mark.colour, markeredgewidth=0.0, alpha=alpha, zorder=3)
        if zero.any():
            hollow: dict[str, Any] = {
                "markerfacecolor": "white",
                "markeredgecolor": mark.colour,
                "markeredgewidth": 0.8,
            }
            axes.plot(*drawn[zero].T, **mark.look, **hollow, clip_on=False, zorder=3)


def small_figure(columns: int = 1) -> Figure:
    """Return an empty figure as wide as a column of the page, or as the page."""
    return Figure(figsize=(3.5 if columns == 1 else PAGE_WIDTH, 2.8), layout="constrained")


def name_records(figure: Figure, marks: "Mapping[str, Mark]") -> None:
    """Write the records and their marks above a figure."""
    if len(set(marks.values())) < len(marks):
        mark = next(iter(marks.values()))
        entries = {f"{len(marks)} records": mark}
    else:
        entries = {drawable(name): mark for name, mark in marks.items()}
    handles = [
        Line2D([], [], **mark.look, color=mark.colour, markeredgewidth=0.0, label=name)
        for name, mark in entries.items()
    ]
    longest = max((len(name) for name in entries), default=1)
    legend = figure.legend(
        handles=handles,
        loc="outside upper left",
        ncols=max(1, int(_CHARACTERS * figure.get_figwidth() / (longest + _MARK_WIDTH))),
        handlelength=0.9,
        columnspacing=1.0,
        borderaxespad=0.4,
    )
    for text in legend.get_texts():
        text.set_parse_math(False)


@dataclass(frozen=True, eq=False)
class PaperFigure:
    """A figure after one of Li et al. (2020).

    Attributes
    ----------
    number
        In the paper.
    title
        What it shows, in a few words.
    words
        The same in a sentence, for a caption.
    figure
        As drawn.
    """

    number: str
    title: str
    words: str
    figure: "Figure"
