"""The page of the isolated building: a project as text at the side, and what follows from it."""

import asyncio
import base64
from dataclasses import replace
from pathlib import Path
from typing import Any

from nicegui import ui

from dcfp.analysis.plan import PlanResponse, respond_plan
from dcfp.analysis.plan.quantities import bearing_table, level_table
from dcfp.doors.app.analysis import Task, figure_png, table_of
from dcfp.doors.app.elements import Grid, Text
from dcfp.doors.app.fields import RecordsPanel, card, switch_field
from dcfp.doors.app.session import Session
from dcfp.doors.app.tab import Tab, write_list
from dcfp.errors import InputError
from dcfp.methods.spectra.of_floors import floor_spectra
from dcfp.methods.torsion import TORSION, code_torsion
from dcfp.motion.measures import motion_remarks
from dcfp.motion.station import in_plane
from dcfp.present.tables import write_responses
from dcfp.schema.table import Table
from dcfp.system.project import example_project, plan_of

#: Analysed at first.
_STATION = "P695-FF-2"
#: Largest project [characters], and most bearings and storeys: what a page can be kept waiting for.
_LONGEST, _MOST_BEARINGS, _MOST_STOREYS = 200_000, 400, 64


class BuildingTab(Tab):
    """Fields and results of an isolated building."""

    of_one_bearing = False

    def __init__(self, session: Session) -> None:
        self._text, self._overturning, self._shown = example_project(), True, 0
        self._responses: list[PlanResponse] = []
        # the visitor's files and units, and a choice of records of its own: a building wants both directions
        session = replace(session, chosen=[_STATION])
        super().__init__(session, "What is built and what shakes it", "Building")

    def add_fields(self) -> None:
        """Add the records and the project."""
        RecordsPanel(self.session, self.ask)
        with card("Project"):
            area = ui.textarea("PROJECT.toml", value=self._text).classes("project")
            area.props('outlined dense autogrow spellcheck=false debounce=600 input-style="font-family: monospace; font-size: 12px; white-space: pre; overflow-x: auto"')  # fmt: skip
            area.on_value_change(lambda event: self._put(str(event.value or "")))
            switch_field("Loads follow the overturning moment", self._overturning, self._set_overturning)
            Text("p", "Types of bearings, their places in m, the building, and the storeys from below.").classes("note")  # fmt: skip

    def add_results(self) -> None:
        """Add tables and figure."""
        with card("Analyses", "h3"):
            self._peaks = Grid("Peaks of every analysis", self._pick)
        self._remarks = ui.element("ul").classes("remarks")
        with card("Plan, histories and profiles", "h3"):
            self._figure = ui.element("img").props('alt="Plan with the paths of the bearings, histories, and profiles over the height"').style("max-width: 100%")  # fmt: skip
        with card("Corner over centre by the torsion formulas of codes", "h3"):
            self._torsion = Grid("Corner over centre by codes")
        with card("Bearings", "h3"):
            self._bearings = Grid("Peaks of every bearing")
        with card("Slab and floors", "h3"):
            self._damping = Text("p").classes("note")
            self._levels = Grid("Peaks of slab and floors")
        self.add_files(
            ("Project (TOML)", "project.toml", lambda: self._text.encode()),
            ("Histories (CSV)", "building.csv", lambda: table_of(write_responses, self._one(), ".csv")),
            ("All data (NetCDF)", "building.nc", lambda: table_of(write_responses, self._responses, ".nc")),
            ("Figure (PNG)", "building.png", lambda: figure_png(self._one()[0].plot()) if self._responses else None),
            ("Floor spectra (PNG)", "floors.png", self._spectra),
        )  # fmt: skip

    async def work(self) -> None:
        """Analyse the building under every record."""
        task, text, overturning = Task.of(self.session), self._text, self._overturning
        self.busy.text = "Calculating …"
        try:
            responses = await asyncio.to_thread(_analysed, task, text, overturning)
            figures = await asyncio.to_thread(lambda: figure_png(responses[0].plot()))
        finally:
            if not self.is_gone:
                self.busy.text = ""
        if self.is_gone:
            return
        self.complain("")
        self._responses, self._shown = responses, 0
        self._draw(figures)
        self.show_again()

    def show_again(self) -> None:
        """Show the same in other units, or another analysis of them."""
        if not self._responses:
            return
        units, response = self.session.units, self._responses[self._shown]
        self.title.text = response.title
        self._peaks.show(Table(tuple(response.quantities.values()), self._responses), units, self._shown)
        self._torsion.show(Table(TORSION, code_torsion(response.plan, response.peak_displacement)), units)
        self._bearings.show(bearing_table(response), units)
        self._damping.text = f"Damping of the storeys: {response.damping_words}."
        self._levels.show(level_table(response), units)
        write_list(self._remarks, [*motion_remarks(response.motion, with_scale=False), *response.remarks])

    def _one(self) -> list[PlanResponse]:
        return self._responses[self._shown : self._shown + 1]

    def _spectra(self) -> bytes | None:
        if not self._responses:
            return None
        from dcfp.present.figures.plan import plot_floor_spectra  # late: Matplotlib takes long to import

        return figure_png(plot_floor_spectra(floor_spectra(self._responses[self._shown])))

    def _draw(self, picture: bytes) -> None:
        self._figure.props["src"] = f"data:image/png;base64,{base64.b64encode(picture).decode('ascii')}"

    def _pick(self, row: int) -> None:
        self._shown = row
        self.show_again()

        async def draw() -> None:
            picture = await asyncio.to_thread(lambda: figure_png(self._responses[row].plot()))
            if not self.is_gone and self._shown == row:
                self._draw(picture)

        ui.timer(0.0, draw, once=True)

    def _put(self, text: str) -> None:
        self._text = text
        self.ask()

    def _set_overturning(self, value: bool) -> None:
        self._overturning = value
        self.ask()


def _analysed(task: Task, text: str, overturning: bool) -> list[PlanResponse]:
    """Read the project and analyse it under every motion."""
    if len(text) > _LONGEST:
        msg = f"The project has {len(text)} characters; a page takes at most {_LONGEST}."
        raise InputError(msg)
    plan = plan_of(text.encode(), Path("project"), None)
    if plan.count > _MOST_BEARINGS or len(plan.storeys) > _MOST_STOREYS:
        msg = f"A page analyses at most {_MOST_BEARINGS} bearings and {_MOST_STOREYS} storeys; for more there is dcfp building."
        raise InputError(msg)
    motions = [in_plane(one) for one in task.scaled()]
    settings: dict[str, Any] = {"overturning": overturning, "vertical": task.vertical}
    return [respond_plan(plan, one, **settings) for one in motions]
