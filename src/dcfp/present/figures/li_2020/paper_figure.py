"""A figure after one of the paper, with its caption."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure


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
