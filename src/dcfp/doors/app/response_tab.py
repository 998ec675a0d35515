"""The page of the response: fields at the side, and what follows from them."""

import asyncio
import math
from dataclasses import replace
from typing import Any

import numpy as np
from nicegui import ui

from dcfp.analysis import Response, Status
from dcfp.analysis.plane_response import PLANE_PEAKS, PlaneResponse
from dcfp.analysis.response import PEAKS
from dcfp.doors.app.analysis import Predicted, Task, figure_png, predict, remarks_on, scenario_text, table_of
from dcfp.doors.app.charts import chart, colour_of, level, rows, warm_colours
from dcfp.doors.app.elements import Chart, Grid, Options, Section, Text, Units
from dcfp.doors.app.fields import RecordsPanel, card
from dcfp.doors.app.plane_view import PlaneView
from dcfp.doors.app.session import Session, capitalised
from dcfp.doors.app.tab import Latest, Tab, write_list
from dcfp.errors import DcfpError
from dcfp.inference import Case
from dcfp.inference.told import Told
from dcfp.methods.method import Information, variants
from dcfp.present import panels
from dcfp.present.tables import write_responses
from dcfp.schema.quantities import NOTHING, Quantity, quantity
from dcfp.schema.table import Table
from dcfp.schema.units import INCH, MM, NONE

_TONES = {Status.OK: "good", Status.BEYOND_CAPACITY: "bad", Status.STILL_MOVING: "doubt"}
#: Frames of the animation at most, and its least time step [s].
_MOST_FRAMES, _LEAST_STEP = 3000, 0.02
_LENGTH = replace(quantity("displacement"), decimals=1)
_COLOURS = {
    Information.BLIND: panels.BLUE,
    Information.INFORMED: panels.GREY,
    Information.PGV: panels.OCHRE,
    Information.SPECTRUM: panels.INK,
}


class ResponseTab(Tab):
    """Fields and results of the response."""

    def __init__(self, session: Session) -> None:
        self._shown = 0
        self._task: Task | None = None
        self._responses: list[Response] | list[PlaneResponse] = []
        self._predicted: Predicted | None = None
        self._latest_prediction = Latest(lambda: self.safely(self._predict))
        super().__init__(session, "What is analysed", "Response")

    def add_fields(self) -> None:
        """Add the records."""
        RecordsPanel(self.session, self._ask_again)

    def _ask_again(self) -> None:
        self.refresh_bearing()  # stations have another usual heating model
        self.ask()

    def add_results(self) -> None:
        """Add numbers, table and charts."""
        self._tiles: dict[str, tuple[Text, Text]] = {}
        self._tile_places: dict[str, ui.element] = {}
        with ui.element("div").classes("tiles"):
            for name, one in PLANE_PEAKS.items():
                # there is more room than in a table of stations
                if one.is_number and (one.printed or (name in PEAKS and PEAKS[name].printed)):
                    with ui.element("div").classes("tile") as self._tile_places[name]:
                        Text("div", capitalised(one.words)).classes("tile-name")
                        value = Text("span", NOTHING).classes("tile-value").props(f"data-tile={name}")
                        self._tiles[name] = (value, Text("span").classes("tile-unit"))
        self._remarks = ui.element("ul").classes("remarks")
        with card("All records", "h3") as self._summary_card:
            self._summary = Grid("Peaks of every record", self._pick)
        self._plane = PlaneView()
        self._plane.set_visibility(False)
        with ui.element("div").classes("results") as self._line:
            self._add_line()
        self._add_files()

    def _add_line(self) -> None:
        """Add what is shown of an analysis in one direction."""
        with ui.element("div").classes("halves"):
            with card("Force and displacement", "h3"):
                self._loop = Chart("Horizontal force against displacement")
            with card("The bearing in section, to scale", "h3"):
                self._section = Section()
                Text("p", "Colour: temperature of the contact. Radii and slider are to scale, thicknesses are not known and drawn for the eye.").classes("note")  # fmt: skip
        with card("Histories", "h3"):
            self._histories = Chart("Velocities, displacement, temperature and friction over time", "tall")
        with card("Temperature on the lower plate", "h3") as self._plate_card:
            self._plate = Chart("Temperature along the plate over time, with the path of the slider")
        with ui.element("div").classes("halves"):
            with card("Energy", "h3"):
                self._energy = Chart("Energies over time")
            with card("Pulses of the ground velocity", "h3"):
                self._pulses = Chart("Ground velocity with its pulses")
        with card("Predictions and codes against the analysis", "h3"):
            self._nominal = Text("p").classes("note")
            self._bars = Chart("What each method offers for the largest displacement", "middle")
            self._predictions = Grid("Predictions beside the analysis")
            self._code_remarks = ui.element("ul").classes("remarks")

    def _add_files(self) -> None:
        def figure() -> bytes | None:
            return figure_png(self._responses[self._shown].plot()) if self._responses else None

        def table(kind: str) -> bytes | None:
            # a table is of what is shown, data are of all
            part = slice(self._shown, self._shown + 1) if kind == ".csv" else slice(None)
            return table_of(write_responses, self._responses[part], kind)

        self.add_files(
            ("Scenario (TOML)", "scenario.toml", lambda: scenario_text(self.session).encode()),
            ("Histories (CSV)", "response.csv", lambda: table(".csv")),
            ("All data (NetCDF)", "response.nc", lambda: table(".nc")),
            ("Figure (PNG)", "response.png", figure),
            ("Report (PDF)", "report.pdf", lambda: Task.of(self.session).report_pdf()),
            ("Workbook (Excel)", "response.xlsx", lambda: Task.of(self.session).workbook()),
        )
        Text("p", "Your files stay in the memory of this page and are gone when you close it. A scenario file looks for them in its own folder.").classes("note")  # fmt: skip

    async def work(self) -> None:
        """Analyse every record."""
        try:
            task = Task.of(self.session)
            self.busy.text = "Calculating …"
            responses = await asyncio.to_thread(task.analysed)
        except DcfpError:
            if not self.is_gone:
                self.status.text = "of the last valid input"
                self.status.classes(replace="status old")
            raise
        if self.is_gone:
            return
        self._task, self._responses, self._predicted = task, responses, None
        self._shown = min(self._shown, len(responses) - 1)
        self.complain("")
        self.show_again()
        self._latest_prediction.ask()

    async def _predict(self) -> None:
        """Predict what is shown; neither these numbers of the analysis nor the next ones wait for it."""
        if self._task is None or self.latest.outdated:
            return
        responses, shown, system = self._responses, self._shown, self._task.model
        response = responses[shown]
        if isinstance(response, PlaneResponse):
            self.busy.text = ""
            return
        predicted = await asyncio.to_thread(predict, response, system)
        if self.is_gone or responses is not self._responses or shown != self._shown:
            return  # something else is shown by now
        self._predicted = predicted
        self._show_predictions()
        self.busy.text = ""

    def complain(self, sentence: str) -> None:
        """Say what is wrong; nothing is being calculated then."""
        super().complain(sentence)
        if sentence and not self.is_gone:
            self.busy.text = ""

    def _pick(self, number: int) -> None:
        if 0 <= number < len(self._responses):
            self._shown = number
            self.ask()

    def show_again(self) -> None:
        """Show the analyses, one of them in all detail, and what is predicted of it."""
        if not self._responses:
            return
        one, units = self._responses[self._shown], self.session.units
        pgv = PEAKS["peak_ground_velocity"]
        self.title.text = f"{one.motion.name}, PGV {units.text(pgv, one)} {units.name(pgv)}"
        self.status.text = one.status.value
        self.status.classes(replace=f"status {_TONES[one.status]}")
        self.status.set_visibility(True)
        for name, (value, unit) in self._tiles.items():
            self._tile_places[name].set_visibility(name in one.quantities)
            if name not in one.quantities:
                continue
            quantity = one.quantities[name]
            value.text = units.text(quantity, one)
            unit.text = units.name(quantity) if quantity.shown.has_dimension else ""
        write_list(self._remarks, remarks_on(one))
        self._summary_card.set_visibility(len(self._responses) > 1)
        peaks = Table(tuple(one.quantities.values()), self._responses)
        self._summary.show(peaks, units, self._shown, {"status": lambda one: _TONES[one.status]})
        in_plane = isinstance(one, PlaneResponse)
        self._plane.set_visibility(in_plane)
        self._line.set_visibility(not in_plane)
        if isinstance(one, PlaneResponse):
            self._plane.show(one, units)
        else:
            self._show_line(one)

    def _show_line(self, one: Response) -> None:
        units = self.session.units
        self._loop.draw(chart(panels.loop(one), units))
        self._section.load(scene(one, units))
        histories = (panels.velocities, panels.displacement, panels.temperature, panels.friction)
        self._histories.draw(rows([describe(one) for describe in histories], units))
        self._energy.draw(chart(panels.energies(one), units))
        self._plate_card.set_visibility(one.profiles is not None)
        if one.profiles is not None:
            self._plate.draw(chart(panels.profile(one), units))
        self._show_predictions()

    def _show_predictions(self) -> None:
        if self._predicted is None:
            return
        units, (case, nominal) = self.session.units, self._predicted
        response = self._responses[self._shown]
        if isinstance(response, PlaneResponse):
            return
        self._pulses.draw(chart(panels.pulses(response, case.pulses, case.analysed.pulse), units))
        self._nominal.text = f"The methods take a constant µ of {nominal.value:.4g}: {nominal.source}."
        self._bars.draw(bars(case, units))
        self._predictions.show(predictions_of(case), units, 0, {"verdict": _tone_of_verdict})
        write_list(self._code_remarks, code_remarks(case))


def _over_analysis(name: str) -> Quantity:
    def ratio(one: Told) -> float:
        said, analysed = one.said, getattr(one.of.analysed.beside(one.information), name)
        return getattr(said, name) / analysed if analysed > 0.0 else math.nan

    return Quantity(
        f"{name}_ratio", "prediction over analysis", NONE, decimals=2, head="over analysis", get=ratio
    )


def _tone_of_verdict(one: Told) -> str:
    code = None if one.variant is None else one.of.codes.get(one.variant.method)
    if code is None or not code.conditions:
        return ""
    return {True: "good", False: "bad", None: "doubt"}[code.valid]


_PREDICTIONS = (
    Quantity("method", "method", head="Method", get=lambda one: one.variant.method if one.variant else "analysis"),
    Quantity("knows", "what it knows", head="Knows", get=lambda one: one.information.value if one.variant else "everything"),
    Quantity("dy", "largest change of displacement", MM, decimals=1, get="said.displacement_change"),
    _over_analysis("displacement_change"),
    Quantity("bound", "largest displacement", MM, decimals=1, head="y_max offered", get="said.bound"),
    _over_analysis("bound"),
    Quantity("verdict", "verdict", head="Verdict", get="verdict"),
)  # fmt: skip


def predictions_of(case: Case) -> Table:
    """Return a row for the analysis and for every method."""
    known = [None, *(one for one in variants() if one in case.predicted)]
    return Table(_PREDICTIONS, [Told(case, None, one) for one in known])


def bars(case: Case, units: Units) -> Options:
    """Draw what each method offers for the largest displacement, and the analysis as a line."""
    known = [variant for variant in reversed(variants()) if variant in case.predicted]
    length = units.of(_LENGTH)
    shown = {one: round(length.shown(case.predicted[one].bound), 4) for one in known}
    data = [
        {"value": value, "itemStyle": {"color": colour_of(_COLOURS[one.information])}}
        for one, value in shown.items()
    ]
    analysed = case.analysed.whole.bound
    words = f"analysis {units.written(_LENGTH, analysed)} {length.name}"
    line = level((length.shown(analysed),), "xAxis", words, panels.INK)
    line["markLine"]["label"] |= {"position": "end", "fontSize": 12}
    names = [
        one.method if one.information is Information.SPECTRUM else f"{one.method}, {one.information.value}"
        for one in known
    ]
    return {
        "xAxis": {"name": f"y_max offered [{length.name}]", "scale": False, "splitLine": {"show": True}},
        "yAxis": {"type": "category", "data": names, "axisLabel": {"width": 150, "overflow": "truncate"}},
        "series": [{"type": "bar", "name": "y_max", "data": data, "barWidth": "58%", **line}],
        "grid": {"left": 162, "right": 24, "top": 30},
        "tooltip": {"show": False},
    }


def code_remarks(case: Case) -> list[str]:
    """Return which conditions are broken, and what could not be confirmed."""
    remarks: list[str] = []
    for name, result in case.codes.items():
        broken = [
            f"{one.name} {one.found_words}, {one.limit_words}"
            for one in result.conditions
            if one.verdict.value == "not met"
        ]
        remarks += [f"{name}, not met: {'; '.join(broken)}."] if broken else []
        remarks += [f"{name}, unconfirmed: {'; '.join(result.unconfirmed)}."] if result.unconfirmed else []
    return remarks


def scene(response: Response, units: Units) -> dict[str, Any]:
    """Return what the animation shows: displacement and temperature at equal steps, and the geometry."""
    part = panels.shown(response)
    span = float(response.time[part][-1])
    step = max(_LEAST_STEP, span / _MOST_FRAMES)
    time = np.arange(0.0, span + step, step)
    displacement = np.interp(time, response.time, response.displacement)
    temperature = np.interp(time, response.time, response.temperature)
    bearing = response.bearing
    capacity = bearing.displacement_capacity or 0.0
    length, heat = units.of(_LENGTH), units.of(quantity("temperature"))
    bar = 200.0 if length is not INCH else 254.0
    return {
        "step": step,
        "displacement": np.round(displacement, 2).tolist(),
        "temperature": np.round(temperature, 1).tolist(),
        "shows": round(float(time[int(np.abs(displacement).argmax())]), 2),
        "radii": list(bearing.radii if len(bearing.radii) == 2 else bearing.radii * 2),
        "diameter": bearing.slider_diameter,
        "tall": 0.35 * bearing.slider_diameter,
        "reach": max(capacity, response.peak_displacement, 50.0),
        "low": response.heating.ambient,
        "high": max(response.peak_temperature, response.heating.ambient + 1.0),
        "colours": warm_colours(),
        "length": {"unit": length.name, "size": length.size, "decimals": 1 if length is MM else 2},
        "heat": {"unit": heat.name, "size": heat.size, "zero": heat.zero},
        "bar": {"mm": bar, "words": f"{length.shown(bar):.0f} {length.name}"},
    }  # fmt: skip
