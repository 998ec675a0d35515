"""Elements of the page that NiceGUI does not have; each is a file in ``static``."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from nicegui import ui
from nicegui.element import Element
from nicegui.elements import echart
from nicegui.elements.mixins.text_element import TextElement
from nicegui.events import GenericEventArguments

# importing it offers the browser the library of charts, which chart.js imports
del echart

#: Least time between two values of a slider that is dragged [s].
_PACE = 0.03
#: Options of a chart, as ECharts takes them.
Options = dict[str, Any]


class Text(TextElement):
    """Words in an element of HTML, such as a heading; never markup."""

    def __init__(self, tag: str, text: str = "") -> None:
        super().__init__(tag=tag, text=text)


class Chart(Element, component="static/chart.js"):
    """A chart; `label` says in words what it shows."""

    def __init__(self, label: str, size: str = "") -> None:
        super().__init__()
        self._props["label"] = label
        self.classes(f"chart {size}")

    def draw(self, options: Options) -> None:
        """Show other options."""
        self.run_method("draw", options)


class Section(Element, component="static/section.js"):
    """The bearing in section, moving."""

    def load(self, scene: dict[str, Any]) -> None:
        """Show another motion."""
        self.run_method("load", scene)


@dataclass(frozen=True)
class Head:
    """Head of a column of a `Grid`."""

    text: str
    unit: str = ""
    number: bool = True


@dataclass(frozen=True)
class Cell:
    """Cell of a `Grid`; `tone` is ``"good"``, ``"bad"``, ``"doubt"`` or nothing."""

    text: str
    tone: str = ""


class Grid(Element, component="static/grid.js"):
    """A table of text."""

    def __init__(self, caption: str, pick: Callable[[int], None] | None = None) -> None:
        super().__init__()
        self._props.update(caption=caption, head=[], rows=[], chosen=-1, pick=pick is not None)
        if pick is not None:
            self.on("pick", lambda event: pick(int(event.args)))

    def fill(self, head: Sequence[Head], rows: Sequence[Sequence[Cell | str]], chosen: int = -1) -> None:
        """Show other rows; `chosen` is the number of the one that is marked."""
        self._props["head"] = [asdict(one) for one in head]
        self._props["rows"] = [
            [asdict(Cell(cell) if isinstance(cell, str) else cell) for cell in row] for row in rows
        ]
        self._props["chosen"] = chosen
        self.update()


class Slider(Element, component="static/slider.js"):
    """A slider with its label and value; `move` is called with the value while it is dragged.

    Parameters
    ----------
    label, unit
        As shown.
    decimals
        Of the value.
    value
        Where it stands.
    ends
        Where it can stand, least and most.
    step
        From one value to the next.
    move
        Called with a new value.
    """

    def __init__(
        self,
        label: str,
        unit: str,
        decimals: int,
        value: float,
        ends: tuple[float, float],
        step: float,
        move: Callable[[float], None],
    ) -> None:
        super().__init__()
        self._props.update(name=self.id, label=label, unit=unit, decimals=decimals, value=value, off=False)
        self._props.update(least=ends[0], most=ends[1], step=step)
        self._ends, self._move = ends, move
        self.on("move", self._moved, throttle=_PACE)

    def set_off(self, off: bool) -> None:
        """Let it be moved or not."""
        self._props["off"] = off
        self.update()

    def _moved(self, event: GenericEventArguments) -> None:
        value = float(event.args)
        if self._ends[0] <= value <= self._ends[1]:
            self._move(value)


class FileDrop(ui.upload, component="static/file_drop.js"):
    """A place to choose files or to drop them."""

    def __init__(self, hint: str, largest: int, **handlers: Any) -> None:
        super().__init__(multiple=True, max_file_size=largest, **handlers)
        self._props["hint"] = hint
