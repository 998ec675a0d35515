"""The page of the response: fields at the side, and what follows from them."""

import asyncio
from collections.abc import Callable

from nicegui import ui

from dcfp.analysis import Response, Status
from dcfp.analysis.response import PEAKS
from dcfp.doors.app import downloads
from dcfp.doors.app.analysis import Predicted, Task, analyse, predict, remarks_on, scenario_text
from dcfp.doors.app.charts import response as charts
from dcfp.doors.app.charts.look import chart, rows
from dcfp.doors.app.elements import Cell, Chart, Grid, Section, Text
from dcfp.doors.app.fields import Alert, BearingPanel, action, card
from dcfp.doors.app.forms import label_of
from dcfp.doors.app.records_panel import RecordsPanel
from dcfp.doors.app.session import Latest, Session
from dcfp.doors.app.units import Units
from dcfp.errors import DcfpError
from dcfp.present import panels
from dcfp.schema.quantities import NOTHING, Quantity


class ResponseTab:
    """Fields and results of the response.

    Parameters
    ----------
    session
        Of the visitor.
    """

    def __init__(self, session: Session) -> None:
        self._session = session
        self._client = ui.context.client
        self._shown = 0
        self._task: Task | None = None
        self._responses: list[Response] = []
        self._predicted: Predicted | None = None
        self._latest = Latest(self._work)
        self._latest_prediction = Latest(self._predict)
        with ui.element("div").classes("body"):
            with ui.element("aside").classes("side").props('aria-label="What is analysed"'):
                RecordsPanel(session, self.ask)
                self._bearing = BearingPanel(session.bearing, self.ask)
            with ui.element("div").classes("results"):
                self._alert = Alert()
                self._results = ResponseResults(self._pick)
                self._add_downloads()

    def open(self) -> None:
        """Show the fields as another page may have left them, and analyse."""
        self._bearing.refresh()
        self.ask()

    def ask(self) -> None:
        """Analyse what the fields hold."""
        self._latest.ask()

    def show_again(self) -> None:
        """Show the same in other units."""
        if self._responses:
            self._results.show(self._responses, self._shown, self._session.units)
            if self._predicted is not None:
                self._results.show_predictions(
                    self._responses[self._shown], self._predicted, self._session.units
                )

    async def _work(self) -> None:
        session = self._session
        try:
            task = Task.of(session)
            self._results.say_busy(True)
            responses = await asyncio.to_thread(analyse, task)
        except DcfpError as error:
            self._complain(str(error))
            if not self._client.is_deleted:
                self._results.say_old()
            return
        if self._client.is_deleted:
            return
        self._task, self._responses, self._predicted = task, responses, None
        self._shown = min(self._shown, len(responses) - 1)
        self._alert.say("")
        self._results.show(responses, self._shown, session.units)
        self._latest_prediction.ask()

    async def _predict(self) -> None:
        """Predict what is shown; neither these numbers of the analysis nor the next ones wait for it."""
        if self._task is None or self._latest.outdated:
            return
        responses, response, model = self._responses, self._responses[self._shown], self._task.model
        try:
            predicted = await asyncio.to_thread(predict, response, model)
        except DcfpError as error:
            self._complain(str(error))
            return
        if (
            self._client.is_deleted
            or responses is not self._responses
            or response is not responses[self._shown]
        ):
            return  # something else is shown by now
        self._predicted = predicted
        self._results.show_predictions(response, predicted, self._session.units)
        self._results.say_busy(False)

    def _complain(self, sentence: str) -> None:
        if not self._client.is_deleted:
            self._alert.say(sentence)
            self._results.say_busy(False)

    def _pick(self, number: int) -> None:
        if 0 <= number < len(self._responses):
            self._shown = number
            self._latest.ask()

    def _add_downloads(self) -> None:
        def of_shown(make: Callable[[Response], bytes]) -> Callable[[], bytes]:
            return lambda: make(self._responses[self._shown])

        files: list[tuple[str, str, Callable[[], bytes]]] = [
            ("Scenario (TOML)", "scenario.toml", lambda: scenario_text(self._session).encode()),
            ("Histories (CSV)", "response.csv", of_shown(lambda one: downloads.responses_csv([one]))),
            ("All data (NetCDF)", "response.nc", lambda: downloads.responses_netcdf(self._responses)),
            ("Figure (PNG)", "response.png", of_shown(downloads.response_png)),
            ("Report (PDF)", "report.pdf", lambda: downloads.report_pdf(Task.of(self._session))),
            ("Workbook (Excel)", "response.xlsx", lambda: downloads.workbook(Task.of(self._session))),
        ]
        with card("Take it away", "h3"), ui.element("div").classes("actions"):
            for label, name, make in files:
                self._add_download(label, name, make)
        Text(
            "p",
            "Your files stay in the memory of this page and are gone when you close it. A scenario file looks for them in its own folder.",
        ).classes("note")

    def _add_download(self, label: str, name: str, make: Callable[[], bytes]) -> None:
        async def give() -> None:
            if not self._responses:
                return
            try:
                content = await asyncio.to_thread(make)
            except DcfpError as error:
                self._complain(str(error))
                return
            if not self._client.is_deleted:
                ui.download(content, name)

        action(label, give)


# What is shown of analyses.


_TONES = {Status.OK: "good", Status.BEYOND_CAPACITY: "bad", Status.STILL_MOVING: "doubt"}


class ResponseResults:
    """Numbers, table and charts.

    Parameters
    ----------
    pick
        Called with the number of the analysis that is to be shown.
    """

    def __init__(self, pick: Callable[[int], None]) -> None:
        with ui.element("div").classes("head-row"):
            with ui.element("div").classes("title-row"):
                self._title = Text("h2", "Response")
                self._status = Text("span", "").classes("status")
            self._busy = Text("span", "Calculating …").classes("busy").props("role=status")
        self._tiles = self._add_tiles()
        self._remarks = ui.element("ul").classes("remarks")
        with card("All records", "h3") as self._summary_card:
            self._summary = Grid("Peaks of every record", pick)
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

    @staticmethod
    def _add_tiles() -> dict[str, tuple[Text, Text]]:
        """Add a tile for each number that is told of a response, and return its value and its unit by name."""
        tiles: dict[str, tuple[Text, Text]] = {}
        with ui.element("div").classes("tiles"):
            for name, one in PEAKS.items():
                if one.printed and one.is_number:
                    with ui.element("div").classes("tile"):
                        Text("div", label_of(one)).classes("tile-name")
                        value = Text("span", NOTHING).classes("tile-value").props(f"data-tile={name}")
                        tiles[name] = (value, Text("span").classes("tile-unit"))
        return tiles

    def say_busy(self, busy: bool) -> None:
        """Say whether something is being calculated."""
        self._busy.text = "Calculating …" if busy else ""

    def say_old(self) -> None:
        """Say that what is shown is not of the input that was refused since."""
        self._status.text = "of the last valid input"
        self._status.classes(replace="status old")

    def show(self, responses: list[Response], number: int, units: Units) -> None:
        """Show analyses, one of them in all detail."""
        one = responses[number]
        pgv = PEAKS["peak_ground_velocity"]
        self._title.text = f"{one.motion.name}, PGV {units.text(pgv, one)} {units.name(pgv)}"
        self._status.text = one.status.value
        self._status.classes(replace=f"status {_TONES[one.status]}")
        for name, (value, unit) in self._tiles.items():
            quantity = PEAKS[name]
            value.text = units.text(quantity, one)
            unit.text = units.name(quantity) if quantity.shown.has_dimension else ""
        _write_list(self._remarks, remarks_on(one))
        self._summary_card.set_visibility(len(responses) > 1)
        told = [quantity for quantity in PEAKS.values() if quantity.printed]
        self._summary.fill(units.heads(told), [_row(told, each, units) for each in responses], number)
        self._loop.draw(chart(panels.loop(one), units))
        self._section.load(charts.scene(one, units))
        histories = (panels.velocities, panels.displacement, panels.temperature, panels.friction)
        self._histories.draw(rows([describe(one) for describe in histories], units))
        self._energy.draw(chart(panels.energies(one), units))
        self._plate_card.set_visibility(one.profiles is not None)
        if one.profiles is not None:
            self._plate.draw(chart(panels.profile(one), units))

    def show_predictions(self, response: Response, predicted: Predicted, units: Units) -> None:
        """Show predictions and codes beside the analysis."""
        case, nominal = predicted.case, predicted.nominal
        self._pulses.draw(chart(panels.pulses(response, case.pulses, case.analysed.pulse), units))
        self._nominal.text = f"The methods take a constant µ of {nominal.value:.4g}: {nominal.source}."
        self._bars.draw(charts.bars(case, units))
        self._predictions.fill(charts.prediction_head(units), charts.prediction_rows(case, units), 0)
        _write_list(self._code_remarks, charts.code_remarks(case))


def _write_list(place: ui.element, sentences: list[str]) -> None:
    place.clear()
    place.set_visibility(bool(sentences))
    with place:
        for sentence in sentences:
            Text("li", sentence)


def _row(told: list[Quantity], response: Response, units: Units) -> list[Cell | str]:
    tones = {status.value: tone for status, tone in _TONES.items()}
    texts = [units.text(one, response) for one in told]
    return [Cell(text, tones.get(text, "")) for text in texts]
