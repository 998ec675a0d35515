"""Elements of the page that NiceGUI does not have, each a file in ``static``, and the units in which results are shown; what is put in keeps the units beside its fields."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from nicegui import ui
from nicegui.element import Element
from nicegui.elements import echart
from nicegui.elements.mixins.text_element import TextElement
from nicegui.events import GenericEventArguments

from dcfp.schema import units as known
from dcfp.schema.quantities import Quantity
from dcfp.schema.table import Table
from dcfp.schema.units import Unit

# importing it offers the browser the library of charts, which chart.js imports
del echart

#: Least time between two values of a slider that is dragged [s].
_PACE = 0.03
#: Options of a chart, as ECharts takes them.
Options = dict[str, Any]
#: What a visitor can choose from, by the package's own unit, the first at first; each with the decimals that it has more than the first.
CHOICES: dict[Unit, tuple[str, dict[Unit, int]]] = {
    known.MM: ("lengths", {known.MM: 0, known.CM: 1, known.INCH: 1}),
    known.NEWTON: ("forces", {known.KN: 0, known.KIP: 1}),
    known.MM_PER_S: ("velocities", {known.M_PER_S: 0, known.CM_PER_S: -2, known.INCH_PER_S: -1}),
    known.DEGC: ("temperatures", {known.DEGC: 0, known.DEGF: 0}),
}


@dataclass
class Units:
    """The units that a visitor has chosen, by the package's own unit."""

    chosen: dict[Unit, Unit] = field(
        default_factory=lambda: {own: next(iter(few)) for own, (_, few) in CHOICES.items()}
    )

    def of(self, one: Quantity) -> Unit:
        """Return the unit in which a quantity is shown: what is chosen for its dimension, or follows from that, or its own."""
        own, force, length = one.unit.inner_unit, self.chosen[known.NEWTON], self.chosen[known.MM]
        if own is known.N_MM:
            return known.KIP_FT if force is known.KIP else known.KN_M
        if own is known.N_PER_MM:
            return Unit(
                f"{force.name}/{length.name}", force.size / length.size, "N mm-1", base=known.N_PER_MM
            )
        # what is so long that metres are declared for it stays in metres
        return one.shown if one.shown is known.METRE else self.chosen.get(own, one.shown)

    def name(self, one: Quantity) -> str:
        """Return the name of the unit in which a quantity is shown; empty for words."""
        return self.of(one).name

    def text(self, one: Quantity, result: Any) -> str:
        """Return a quantity of a result as it is shown, without its unit."""
        return self.written(one, one.of(result))

    def written(self, one: Quantity, value: Any) -> str:
        """Return a value of a quantity as it is shown, without its unit."""
        unit = self.of(one)
        _, few = CHOICES.get(one.unit.inner_unit, ("", dict[Unit, int]()))
        if one.decimals is None or not few or unit is one.shown:
            return one.written(value, unit, one.decimals)
        finer = round(math.log10(unit.size / one.shown.size))
        more = few[unit] - few[one.shown] if one.shown in few else finer
        return one.written(value, unit, max(0, one.decimals + more))


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


class Plate(Element, component="static/plate.js"):
    """A plate seen from above, at a moment that is chosen with a slider."""

    def load(self, scene: dict[str, Any]) -> None:
        """Show another analysis."""
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
        tone_of, columns = tones or {}, table.printed
        self._props["head"] = [
            {"text": one.head or one.title, "unit": units.name(one), "number": one.is_number}
            for one in columns
        ]
        self._props["rows"] = [
            [
                {"text": units.text(one, each), "tone": tone_of[one.key](each) if one.key in tone_of else ""}
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
