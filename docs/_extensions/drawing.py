"""Figures for sphinx-gallery: those that a script has made, which belong to no window."""

from pathlib import Path
from typing import Any

from matplotlib.figure import Figure
from matplotlib.mathtext import MathTextParser
from sphinx_gallery.scrapers import figure_rst

from dcfp.present.figures import save_figure

# every figure has a reader of formulas of its own: let all find what one has read
MathTextParser.__hash__ = lambda self: hash(self._output_type)
MathTextParser.__eq__ = lambda self, other: self._output_type == other._output_type


def scrape(block: Any, variables: dict[str, Any], settings: dict[str, Any]) -> str:
    """Save every figure that a block has made and return the text that shows them."""
    seen: set[int] = variables.setdefault("figures_seen", set())
    paths: list[str] = []
    for value in list(variables["example_globals"].values()):
        if isinstance(value, Figure) and id(value) not in seen:
            seen.add(id(value))
            path = str(next(variables["image_path_iterator"]))
            save_figure(value, Path(path))
            paths.append(path)
    return figure_rst(paths, settings["src_dir"])
