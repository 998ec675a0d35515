"""The page of the design chart."""

import asyncio

from nicegui import ui

from dcfp.analysis.response import PEAKS
from dcfp.doors.app import downloads
from dcfp.doors.app.charts import design as charts
from dcfp.doors.app.elements import Chart, Grid, Slider, Text
from dcfp.doors.app.fields import Alert, BearingPanel, action, card, choice_field
from dcfp.doors.app.session import Latest, Session
from dcfp.doors.app.surveys import PGVS, SETS, Question, Surveys
from dcfp.errors import DcfpError
from dcfp.inference.design_space import COEFFICIENTS, RADII, DesignSpace

_PARTS = {
    "0.5": "half of the earthquakes",
    "0.84": "84 % of the earthquakes",
    "0.95": "95 % of the earthquakes",
}
_ALLOWED = (50.0, 1000.0)


class DesignTab:
    """Fields and results of the design chart.

    Parameters
    ----------
    session
        Of the visitor.
    surveys
        Surveys that were made before.
    """

    def __init__(self, session: Session, surveys: Surveys) -> None:
        self._session, self._surveys = session, surveys
        self._client = ui.context.client
        self._pgv, self._allowed, self._part, self._records = 0.5, 300.0, "0.95", "P695-FF"
        self._space: DesignSpace | None = None
        self._open = False
        self._latest = Latest(self._work)
        with ui.element("div").classes("body"):
            with ui.element("aside").classes("side").props('aria-label="What is asked"'):
                with card("Question"):
                    Slider("PGV", "m/s", 1, self._pgv, (PGVS[0], PGVS[-1]), 0.1, self._set_pgv)
                    Slider("Allowed displacement", "mm", 0, self._allowed, _ALLOWED, 10.0, self._set_allowed)
                    choice_field("Not exceeded in", _PARTS, self._part, self._set_part)
                    choice_field("Records", SETS, self._records, self._set_records)
                self._bearing = BearingPanel(
                    session.bearing, self.ask, ("lower_radius", "upper_radius", "capacity", "mu")
                )
            with ui.element("div").classes("results"):
                self._alert = Alert()
                self._add_results()  # fmt: skip

    def _add_results(self) -> None:
        with ui.element("div").classes("head-row"):
            self._title = Text("h2", "Design chart")
            self._busy = Text("span", "").classes("busy").props("role=status")
        with ui.element("div").classes("progress").props('aria-hidden="true"') as self._progress:
            self._done = ui.element("div").style("width: 0%")
        with card(
            "Which friction and radius hold it",
            "h3",
            "Shaded: the allowed displacement holds. Blue: displacement. Grey, dashed: force over weight.",
        ):
            self._chart = Chart("Displacement over friction and radius", "middle")
        with card("Least friction that holds", "h3"):
            self._table = Grid("Least coefficient of friction that holds the displacement, by radius")
        with card(
            "Displacement against friction", "h3", "A line for each radius, the strongest the smallest."
        ):
            self._curves = Chart("Displacement against friction for each radius")
        with card("Take it away", "h3"), ui.element("div").classes("actions"):
            action("Figure (PNG)", self._give_figure)
        Text("p", f"Analyses of every record on {RADII.size * COEFFICIENTS.size} bearings for each PGV, made once and kept; the slider steps from one PGV to the next.").classes("note")  # fmt: skip

    def open(self) -> None:
        """Begin to make surveys."""
        self._open = True
        self._bearing.refresh()
        self.ask()

    def close(self) -> None:
        """Stop making surveys in advance."""
        self._open = False

    def ask(self) -> None:
        """Show what is at hand at once, and make what is not."""
        try:
            found = self._surveys.at_hand(self._question(self._pgv))
        except DcfpError as error:
            self._alert.say(str(error))
            return
        if found is not None:
            self._show(found)
        self._latest.ask()

    def show_again(self) -> None:
        """Show the same in other units."""
        if self._space is not None:
            self._show(self._space)

    def _question(self, pgv: float) -> Question:
        return Question.of(self._session.bearing.system(), self._records, pgv)

    async def _work(self) -> None:
        try:
            await self._make(self._pgv)
            # then the others, the nearest first, as long as nothing else is asked
            for pgv in sorted(PGVS, key=lambda one: abs(one - self._pgv)):
                if self._latest.outdated or self._client.is_deleted or not self._open:
                    return
                await self._make(pgv)
        except DcfpError as error:
            if not self._client.is_deleted:
                self._alert.say(str(error))
        finally:
            if not self._client.is_deleted:
                self._say_progress(None)

    async def _make(self, pgv: float) -> None:
        question = self._question(pgv)
        found = self._surveys.at_hand(question)
        if found is None:
            loop, done = asyncio.get_running_loop(), 0

            def report() -> None:
                nonlocal done
                done += 1
                loop.call_soon_threadsafe(self._say_progress, done / RADII.size, pgv)

            self._say_progress(0.0, pgv)
            found = await self._surveys.find(question, report)
        if self._client.is_deleted:
            return
        if pgv == self._pgv and found is not self._space and question == self._question(self._pgv):
            self._show(found)

    def _say_progress(self, share: float | None, pgv: float = 0.0) -> None:
        if self._client.is_deleted:
            return
        self._busy.text = "" if share is None else f"Analysing at {pgv:.1f} m/s …"
        self._progress.style(f"visibility: {'hidden' if share is None else 'visible'}")
        self._done.style(f"width: {100.0 * (share or 0.0):.0f}%")

    def _show(self, space: DesignSpace) -> None:
        self._space = space
        self._alert.say("")
        units, part = self._session.units, float(self._part)
        pgv = PEAKS["peak_ground_velocity"]
        allowed = charts.allowed_words(self._allowed, units)
        self._title.text = f"{allowed} at a PGV of {units.written(pgv, space.pgv)} {units.name(pgv)}"
        self._chart.draw(charts.chart(space, self._allowed, part, units))
        self._curves.draw(charts.curves(space, self._allowed, part, units))
        self._table.fill(charts.holding_head(), charts.holding_rows(space, self._allowed))

    def _set_pgv(self, value: float) -> None:
        self._pgv = min(PGVS, key=lambda one: abs(one - value))
        self.ask()

    def _set_allowed(self, value: float) -> None:
        self._allowed = value
        self.show_again()

    def _set_part(self, value: str) -> None:
        self._part = value
        self.show_again()

    def _set_records(self, value: str) -> None:
        self._records = value
        self.ask()

    async def _give_figure(self) -> None:
        space = self._space
        if space is None:
            return

        def make() -> bytes:
            from dcfp.present.figures.design_chart import (
                plot_design_chart,  # late: Matplotlib takes long to import
            )

            return downloads.figure_png(plot_design_chart([space], self._allowed))

        ui.download(await asyncio.to_thread(make), "design-chart.png")
