"""Elements of the page that NiceGUI does not have; each is a file in ``static``."""

from collections.abc import Callable, Mapping
from typing import Any

from nicegui import ui
from nicegui.element import Element
from nicegui.elements import echart
from nicegui.elements.mixins.text_element import TextElement
from nicegui.events import GenericEventArguments

from dcfp.doors.app.units import Units
from dcfp.schema.table import Table

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


class Grid(Element, component="static/grid.js"):
    """A table of text; `tones` are ``"good"``, ``"bad"``, ``"doubt"`` or nothing."""

    def __init__(self, caption: str, pick: Callable[[int], None] | None = None) -> None:
        super().__init__()
        self._props.update(caption=caption, head=[], rows=[], chosen=-1, pick=pick is not None)
        if pick is not None:
            self.on("pick", lambda event: pick(int(event.args)))

    def show(
        self,
        table: Table,
        units: Units,
        chosen: int = -1,
        tones: Mapping[str, Callable[[Any], str]] | None = None,
    ) -> None:
        """Show what people read of a table in the visitor's units, with one row marked as chosen; `tones` return the tone of a cell by the key of its column."""
        known, columns = tones or {}, table.printed
        self._props["head"] = [
            {"text": one.head or one.title, "unit": units.name(one), "number": one.is_number}
            for one in columns
        ]
        self._props["rows"] = [
            [
                {"text": units.text(one, each), "tone": known[one.key](each) if one.key in known else ""}
                for one in columns
            ]
            for each in table.results
        ]
        self._props["chosen"] = chosen
        self.update()


class Slider(Element, component="static/slider.js"):
    """A slider with its label and value, which stands between two ends; `move` is called with the value while it is dragged."""

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
