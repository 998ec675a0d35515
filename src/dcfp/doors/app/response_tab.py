"""The page of the response: fields at the side, and what follows from them."""

import asyncio
from collections.abc import Callable

from nicegui import ui

from dcfp.analysis import Response
from dcfp.doors.app import downloads
from dcfp.doors.app.analysis import Predicted, Task, analyse, predict, scenario_text
from dcfp.doors.app.bearing_panel import BearingPanel
from dcfp.doors.app.elements import Text
from dcfp.doors.app.fields import Alert, action, card
from dcfp.doors.app.latest import Latest
from dcfp.doors.app.records_panel import RecordsPanel
from dcfp.doors.app.response_results import ResponseResults
from dcfp.doors.app.session import Session
from dcfp.errors import DcfpError


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
