"""What every figure has in common: sizes, colours, fonts, numbers and names as they are written, and how it is saved."""

import re
from collections.abc import Callable, Generator
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from functools import cache, wraps
from io import BytesIO
from itertools import cycle, takewhile
from pathlib import Path
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

import matplotlib as mpl
import numpy as np
from matplotlib import font_manager
from matplotlib.axes import Axes
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.ticker import FormatStrFormatter, LogLocator, MaxNLocator, NullFormatter

from dcfp.motion.load import STATION_MARK

if TYPE_CHECKING:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Colormap

    from dcfp.methods.method import Look


P = ParamSpec("P")
T = TypeVar("T")
#: Width of the text on an A4 page, in inches as Matplotlib wants it.
PAGE_WIDTH = 7.2
#: Resolution of a PNG, and of what is drawn as an image inside a PDF [dots per inch].
RESOLUTION = 250
# Blue, ochre and red of Paul Tol's high-contrast set, which stay apart for colour-blind eyes and in grey.
BLUE = "#004488"
OCHRE = "#DDAA33"
RED = "#BB5566"
GREY = "#8A8A8A"
PALE = "#EAEFF4"
INK = "#222222"
#: Shades of the colours of panels, and of those that a method may ask for.
COLOURS = {
    "blue": BLUE,
    "ochre": OCHRE,
    "red": RED,
    "green": "#228833",
    "grey": GREY,
    "ink": INK,
    "sky": "#7FA3CB",
    "silver": "#C9C9C9",
    "white": "white",
}
#: Dashes of a limit.
DASHED = (0, (5, 3))
#: Look of a mark for nothing, on an edge of its axes.
HOLLOW: "dict[str, Any]" = {"markerfacecolor": "white", "markeredgewidth": 0.8, "clip_on": False}
_FAMILIES = (
    "DejaVu Sans", "Noto Sans CJK JP", "IPAexGothic", "Hiragino Sans", "Yu Gothic", "Microsoft JhengHei",
)  # fmt: skip
#: Colours and markers of methods that ask for none.
_FREE_COLOURS = ("#6699CC", "#228833", "#AA3377", INK)
_FREE_MARKERS = ("<", ">", "d", "H", "8", "p")


@cache
def _settings() -> "dict[str, Any]":
    found: Any = mpl.rc_params_from_file(Path(__file__).parent / "dcfp.mplstyle", use_default_template=False)
    return {**found, "font.family": _families()}


@contextmanager
def style() -> Generator[None]:
    """Draw in the style of this package; whatever was set before comes back afterwards."""
    settings: Any = _settings()
    with mpl.rc_context(settings):
        yield


def styled(draw: Callable[P, T]) -> Callable[P, T]:
    """Let a function draw in the style of this package, unless it draws on axes that it is given."""

    @wraps(draw)
    def in_style(*args: P.args, **kwargs: P.kwargs) -> T:
        given = any(isinstance(one, Axes) for one in (*args, *kwargs.values()))
        with nullcontext() if given else style():
            return draw(*args, **kwargs)

    return in_style


@cache
def _families() -> list[str]:
    installed = {font.name for font in font_manager.fontManager.ttflist}
    return [family for family in _FAMILIES if family in installed]


@cache
def _covers(character: str) -> bool:
    paths = (font_manager.findfont(family) for family in _families())
    return any(font_manager.get_font(path).get_char_index(ord(character)) for path in paths)


def drawable(text: str, longest: int | None = None) -> str:
    """Return a text without the characters that no installed font can draw, cut where it is longer than allowed.

    What the names of a station's components begin with alike then stands once, and the middle is cut, for their ends tell them apart.
    """
    drawn = " ".join("".join(c for c in text if c.isspace() or _covers(c)).split())
    if longest is None or len(drawn) <= longest:
        return drawn
    words = [re.split(r"(?<=[^A-Za-z0-9])", one) for one in drawn.split(STATION_MARK)]
    alike = sum(1 for _ in takewhile(lambda same: len(set(same)) == 1, zip(*words, strict=False)))
    first, *others = words
    drawn = STATION_MARK.join("".join(one) for one in (first, *(one[alike:] for one in others)))
    if len(drawn) <= longest:
        return drawn
    end = (longest - 1) // 2 if others else 0
    return f"{drawn[: longest - 1 - end].rstrip()}…{drawn[len(drawn) - end :].lstrip()}"


def new_figure(height: float, width: float = PAGE_WIDTH) -> Figure:
    """Return an empty figure [in]."""
    return Figure(figsize=(width, height), layout="constrained")


def new_axes(width: float = PAGE_WIDTH / 2, height: float = 2.6) -> Axes:
    """Return axes alone on a new figure [in]; their ``figure`` is what to save."""
    return new_figure(height, width).add_subplot()


def save_figure(figure: Figure, path: Path | BytesIO, form: str | None = None) -> None:
    """Save a figure as ``"png"``, ``"pdf"`` or ``"svg"``, by default as the extension of a path says.

    The same figure always gives the same bytes: no date is written into it.
    """
    chosen = form or (path.suffix.lower()[1:] if isinstance(path, Path) else "png")
    dates: dict[str, dict[str, None]] = {"pdf": {"CreationDate": None}, "svg": {"Date": None}}
    with style():
        figure.savefig(path, format=chosen, dpi=RESOLUTION, metadata=dates.get(chosen))


def calm_ticks(axes: Axes, along_x: int = 6, along_y: int = 4) -> None:
    """Give axes few ticks at round numbers."""
    axes.xaxis.set_major_locator(MaxNLocator(along_x, steps=[1, 2, 2.5, 5, 10]))
    axes.yaxis.set_major_locator(MaxNLocator(along_y, steps=[1, 2, 2.5, 5, 10]))
    _keep_ticks(axes)


def _keep_ticks(axes: Axes) -> None:
    """Fix the look of ticks that are yet to be made: they are made when a figure is drawn, in the style of then."""
    now: Any = mpl.rcParams
    for name in ("x", "y"):
        size, length, width, colour = (
            now[f"{name}tick.{what}"] for what in ("labelsize", "major.size", "major.width", "color")
        )
        axes.tick_params(axis=name, labelsize=size, length=length, width=width, color=colour)


def draw_line(axes: Axes, x: Any, y: Any, colour: str, width: float = 0.7, **look: Any) -> None:
    """Draw a line of a colour and a width [pt]."""
    axes.plot(x, y, color=colour, linewidth=width, **look)


def draw_circle(axes: Axes, x: float, y: float, radius: float, colour: str, width: float) -> None:
    """Draw a dashed circle about a place."""
    angle = np.linspace(0.0, 2.0 * np.pi, 181)
    draw_line(axes, x + radius * np.cos(angle), y + radius * np.sin(angle), colour, width, linestyle=DASHED)


def draw_marks(axes: Axes, x: Any, y: Any, marker: str, size: float, colour: str, **look: Any) -> None:
    """Draw points as marks of a form, a size [pt] and a colour, and no line."""
    axes.plot(x, y, marker=marker, markersize=size, color=colour, linestyle="none", **look)


def label_axes(axes: Axes, x: str, y: str, along_x: int = 6, along_y: int = 4, **more: Any) -> None:
    """Name both axes, set what else is given, such as limits, and give them few ticks at round numbers."""
    axes.set(xlabel=x, ylabel=y, **more)
    calm_ticks(axes, along_x, along_y)


def legend_above(axes: Axes) -> None:
    """Put the legend in one row above the axes, at the right, where it can hide nothing."""
    handles, labels = axes.get_legend_handles_labels()
    axes.legend(handles, labels, loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=len(labels))


def legend_outside(axes: Axes, columns: int, place: str = "upper center", **look: Any) -> None:
    """Put the legend of axes above the panels of their figure."""
    figure: Any = axes.get_figure()
    figure.legend(*axes.get_legend_handles_labels(), loc=f"outside {place}", ncols=columns, **look)


def write_title(figure: Figure, words: str, **look: Any) -> None:
    """Write what a figure shows above it, at the left."""
    figure.suptitle(words, fontsize=8.5, x=0.01, ha="left", parse_math=False, **look)


def colour_bar_beside(axes: Axes, drawn: "ScalarMappable", label: str) -> None:
    """Draw the scale of what is drawn in colours, as high as the axes and right of them."""
    place = axes.inset_axes((1.03, 0.0, 0.035, 1.0))
    figure: Any = axes.get_figure(root=False)
    finish_colour_bar(figure.colorbar(drawn, cax=place), label)


def finish_colour_bar(bar: Any, label: str) -> None:
    """Write the label of a scale of colours and take away its frame."""
    bar.set_label(label)
    bar.outline.set_visible(False)
    _keep_ticks(bar.ax)


@cache
def colours_of(shows: str) -> "Colormap":
    """Return the colours of times, or of temperatures: inferno without its ends, which vanish on black and on white."""
    name, first, last = ("viridis", 0.0, 0.9) if shows == "time" else ("inferno", 0.06, 0.86)
    parts = mpl.colormaps[name](np.linspace(first, last, 256))
    return LinearSegmentedColormap.from_list(f"{name}_middle", parts)


def plain_numbers(axes: Axes) -> None:
    """Write the numbers of axes that are logarithmic both ways in full: at 1, 2 and 5, in a short range also between, in a long one at 1."""
    low, high = axes.get_xlim()
    decades = float(np.log10(high / low))
    steps = (1.0, 2.0, 3.0, 5.0, 7.0) if decades < 0.8 else (1.0, 2.0, 5.0) if decades < 2.5 else (1.0,)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=steps, numticks=20))
        axis.set_major_formatter(FormatStrFormatter("%g"))
        axis.set_minor_formatter(NullFormatter())


def looks() -> "dict[str, Look]":
    """Return how every method is drawn, by its name; one that does not say so gets the next colour and the next marker."""
    from dcfp.methods import METHODS  # late: the package imports the kernels

    colours, markers = cycle(_FREE_COLOURS), cycle(_FREE_MARKERS)
    found: dict[str, Look] = {}
    for method in METHODS.values():
        look = method.look
        colour = COLOURS.get(look.colour, look.colour) or next(colours)
        found[method.name] = replace(look, colour=colour, marker=look.marker or next(markers))
    return found
