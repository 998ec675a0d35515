"""The figures of Li et al. (2020) about ground motions and predictions, drawn from our own analyses."""

from dcfp.present.figures.li_2020.figures import paper_figures as paper_figures
from dcfp.present.figures.li_2020.marks import PaperFigure as PaperFigure
