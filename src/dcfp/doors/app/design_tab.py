"""The page of the design chart."""

import asyncio

from nicegui import ui

from dcfp.analysis.response import PEAKS
from dcfp.doors.app import downloads
from dcfp.doors.app.charts import design as charts
from dcfp.doors.app.elements import Chart, Grid, Slider, Text
from dcfp.doors.app.fields import card, choice_field
from dcfp.doors.app.session import Session
from dcfp.doors.app.surveys import PGVS, SETS, Question, Surveys
from dcfp.doors.app.tab import Tab
from dcfp.errors import DcfpError
from dcfp.inference.design_space import COEFFICIENTS, RADII, DesignSpace

_PARTS = {
    "0.5": "half of the earthquakes",
    "0.84": "84 % of the earthquakes",
    "0.95": "95 % of the earthquakes",
}
_ALLOWED = (50.0, 1000.0)


class DesignTab(Tab):
    """Fields and results of the design chart.

    Parameters
    ----------
    session
        Of the visitor.
    surveys
        Surveys that were made before.
    """

    def __init__(self, session: Session, surveys: Surveys) -> None:
        self._surveys = surveys
        self._pgv, self._allowed, self._part, self._records = 0.5, 300.0, "0.95", "P695-FF"
        self._space: DesignSpace | None = None
        varies = ("lower_radius", "upper_radius", "capacity", "mu")
        super().__init__(session, "What is asked", "Design chart", varies)

    def add_fields(self) -> None:
        """Add the question."""
        with card("Question"):
            Slider("PGV", "m/s", 1, self._pgv, (PGVS[0], PGVS[-1]), 0.1, self._set_pgv)
            Slider("Allowed displacement", "mm", 0, self._allowed, _ALLOWED, 10.0, self._set_allowed)
            choice_field("Not exceeded in", _PARTS, self._part, self._set_part)
            choice_field("Records", SETS, self._records, self._set_records)

    def add_results(self) -> None:
        """Add charts and table."""
        with ui.element("div").classes("progress").props('aria-hidden="true"') as self._progress:
            self._done = ui.element("div").style("width: 0%")
        shades = (
            "Shaded: the allowed displacement holds. Blue: displacement. Grey, dashed: force over weight."
        )
        with card("Which friction and radius hold it", "h3", shades):
            self._chart = Chart("Displacement over friction and radius", "middle")
        with card("Least friction that holds", "h3"):
            self._table = Grid("Least coefficient of friction that holds the displacement, by radius")
        with card(
            "Displacement against friction", "h3", "A line for each radius, the strongest the smallest."
        ):
            self._curves = Chart("Displacement against friction for each radius")
        self.add_files([("Figure (PNG)", "design-chart.png", self._figure)])
        Text("p", f"Analyses of every record on {RADII.size * COEFFICIENTS.size} bearings for each PGV, made once and kept; the slider steps from one PGV to the next.").classes("note")  # fmt: skip

    def ask(self) -> None:
        """Show what is at hand at once, and make what is not."""
        try:
            found = self._surveys.at_hand(self._question(self._pgv))
        except DcfpError as error:
            self.complain(str(error))
            return
        if found is not None:
            self._show(found)
        self.latest.ask()

    def _question(self, pgv: float) -> Question:
        return Question.of(self.session.bearing.system(), self._records, pgv)

    async def work(self) -> None:
        """Make the survey that is asked for, then the others, the nearest first, as long as nothing else is asked."""
        try:
            await self._make(self._pgv)
            for pgv in sorted(PGVS, key=lambda one: abs(one - self._pgv)):
                if self.latest.outdated or self.is_gone or not self.is_seen:
                    return
                await self._make(pgv)
        finally:
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
        if self.is_gone:
            return
        if pgv == self._pgv and found is not self._space and question == self._question(self._pgv):
            self._show(found)

    def _say_progress(self, share: float | None, pgv: float = 0.0) -> None:
        if self.is_gone:
            return
        self.busy.text = "" if share is None else f"Analysing at {pgv:.1f} m/s …"
        self._progress.style(f"visibility: {'hidden' if share is None else 'visible'}")
        self._done.style(f"width: {100.0 * (share or 0.0):.0f}%")

    def _show(self, space: DesignSpace) -> None:
        self._space = space
        self.complain("")
        self.show_again()

    def show_again(self) -> None:
        """Show the same in other units, or beside another displacement."""
        space = self._space
        if space is None:
            return
        units, part, pgv = self.session.units, float(self._part), PEAKS["peak_ground_velocity"]
        allowed = charts.allowed_words(self._allowed, units)
        self.title.text = f"{allowed} at a PGV of {units.written(pgv, space.pgv)} {units.name(pgv)}"
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

    def _figure(self) -> bytes | None:
        from dcfp.present.figures.assessment import plot_design_chart  # late: it takes long to import

        space = self._space
        return None if space is None else downloads.figure_png(plot_design_chart([space], self._allowed))
