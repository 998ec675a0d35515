"""The page of the response: fields at the side, and what follows from them."""

import asyncio

from nicegui import ui

from dcfp.analysis import Response, Status
from dcfp.analysis.response import PEAKS
from dcfp.doors.app import downloads
from dcfp.doors.app.analysis import Predicted, Task, analyse, predict, remarks_on, scenario_text
from dcfp.doors.app.charts import response as charts
from dcfp.doors.app.charts.look import chart, rows
from dcfp.doors.app.elements import Cell, Chart, Grid, Section, Text
from dcfp.doors.app.fields import card
from dcfp.doors.app.forms import label_of
from dcfp.doors.app.records_panel import RecordsPanel
from dcfp.doors.app.session import Session
from dcfp.doors.app.tab import Latest, Tab, write_list
from dcfp.errors import DcfpError
from dcfp.present import panels
from dcfp.schema.quantities import NOTHING

_TONES = {Status.OK: "good", Status.BEYOND_CAPACITY: "bad", Status.STILL_MOVING: "doubt"}
_CELL_TONES = {status.value: tone for status, tone in _TONES.items()}


class ResponseTab(Tab):
    """Fields and results of the response.

    Parameters
    ----------
    session
        Of the visitor.
    """

    def __init__(self, session: Session) -> None:
        self._shown = 0
        self._task: Task | None = None
        self._responses: list[Response] = []
        self._predicted: Predicted | None = None
        self._latest_prediction = Latest(lambda: self.safely(self._predict))
        super().__init__(session, "What is analysed", "Response")

    def add_fields(self) -> None:
        """Add the records."""
        RecordsPanel(self.session, self.ask)

    def add_results(self) -> None:
        """Add numbers, table and charts."""
        self._tiles: dict[str, tuple[Text, Text]] = {}
        with ui.element("div").classes("tiles"):
            for name, one in PEAKS.items():
                if one.printed and one.is_number:
                    with ui.element("div").classes("tile"):
                        Text("div", label_of(one)).classes("tile-name")
                        value = Text("span", NOTHING).classes("tile-value").props(f"data-tile={name}")
                        self._tiles[name] = (value, Text("span").classes("tile-unit"))
        self._remarks = ui.element("ul").classes("remarks")
        with card("All records", "h3") as self._summary_card:
            self._summary = Grid("Peaks of every record", self._pick)
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
        self._add_files()

    def _add_files(self) -> None:
        def figure() -> bytes | None:
            return downloads.figure_png(self._responses[self._shown].plot()) if self._responses else None

        def histories() -> bytes | None:
            one = self._responses[self._shown : self._shown + 1]
            return downloads.responses_file(one, ".csv") if one else None

        def everything() -> bytes | None:
            return downloads.responses_file(self._responses, ".nc") if self._responses else None

        self.add_files(
            (
                ("Scenario (TOML)", "scenario.toml", lambda: scenario_text(self.session).encode()),
                ("Histories (CSV)", "response.csv", histories),
                ("All data (NetCDF)", "response.nc", everything),
                ("Figure (PNG)", "response.png", figure),
                ("Report (PDF)", "report.pdf", lambda: downloads.report_pdf(Task.of(self.session))),
                ("Workbook (Excel)", "response.xlsx", lambda: downloads.workbook(Task.of(self.session))),
            )
        )
        Text(
            "p",
            "Your files stay in the memory of this page and are gone when you close it. A scenario file looks for them in its own folder.",
        ).classes("note")

    async def work(self) -> None:
        """Analyse every record."""
        try:
            task = Task.of(self.session)
            self.busy.text = "Calculating …"
            responses = await asyncio.to_thread(analyse, task)
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
        predicted = await asyncio.to_thread(predict, responses[shown], system)
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
            quantity = PEAKS[name]
            value.text = units.text(quantity, one)
            unit.text = units.name(quantity) if quantity.shown.has_dimension else ""
        write_list(self._remarks, remarks_on(one))
        self._summary_card.set_visibility(len(self._responses) > 1)
        told = [quantity for quantity in PEAKS.values() if quantity.printed]
        cells = [[units.text(quantity, each) for quantity in told] for each in self._responses]
        marked = [[Cell(text, _CELL_TONES.get(text, "")) for text in row] for row in cells]
        self._summary.fill(units.heads(told), marked, self._shown)
        self._loop.draw(chart(panels.loop(one), units))
        self._section.load(charts.scene(one, units))
        histories = (panels.velocities, panels.displacement, panels.temperature, panels.friction)
        self._histories.draw(rows([describe(one) for describe in histories], units))
        self._energy.draw(chart(panels.energies(one), units))
        self._plate_card.set_visibility(one.profiles is not None)
        if one.profiles is not None:
            self._plate.draw(chart(panels.profile(one), units))
        self._show_predictions()

    def _show_predictions(self) -> None:
        """Show predictions and codes beside the analysis."""
        if self._predicted is None:
            return
        units, case, nominal = self.session.units, self._predicted.case, self._predicted.nominal
        response = self._responses[self._shown]
        self._pulses.draw(chart(panels.pulses(response, case.pulses, case.analysed.pulse), units))
        self._nominal.text = f"The methods take a constant µ of {nominal.value:.4g}: {nominal.source}."
        self._bars.draw(charts.bars(case, units))
        self._predictions.fill(charts.prediction_head(units), charts.prediction_rows(case, units), 0)
        write_list(self._code_remarks, charts.code_remarks(case))
