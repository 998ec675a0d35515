"""The page of the design chart, and the surveys of bearings that it shows."""

import asyncio
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from nicegui import ui

from dcfp.analysis.response import PEAKS
from dcfp.doors.app.analysis import figure_png
from dcfp.doors.app.charts import chart
from dcfp.doors.app.elements import Chart, Grid, Slider, Text
from dcfp.doors.app.fields import card, choice_field
from dcfp.doors.app.session import Session
from dcfp.doors.app.tab import Tab
from dcfp.errors import DcfpError, InputError
from dcfp.inference.design_space import COEFFICIENTS, RADII, DesignSpace, held_table, survey
from dcfp.motion.named import record_set
from dcfp.present import panels
from dcfp.schema.quantities import quantity
from dcfp.system import System

_PARTS = {"0.5": "half of the earthquakes"} | {
    str(part): f"{100.0 * part:.0f} % of the earthquakes" for part in (0.84, 0.95)
}
_ALLOWED = (50.0, 1000.0)
_GRID = {"right": 24, "bottom": 46}
#: PGVs that the chart has [m/s].
_PGVS = tuple(np.round(np.arange(0.1, 1.55, 0.1), 2).tolist())
_SETS = {
    "P695-FF": "far-field set of FEMA P-695, 44 components",
    "P695-NF": "near-field set of FEMA P-695, 56 components",
    "P695": "both sets of FEMA P-695, 100 components",
}
#: Surveys that are kept.
_MOST = 200


@dataclass(frozen=True)
class Question:
    """What a survey is made for: a bearing, whose radii and coefficient are those of none in particular, a set of records by name, and a PGV [m/s]."""

    model: System
    records: str
    pgv: float

    @classmethod
    def of(cls, model: System, records: str, pgv: float) -> "Question":
        """Leave out of a bearing what a survey varies, so that the same question is known as such."""
        bearing = replace(
            model.bearing, radii=(RADII[0],) * 2, displacement_capacity=None, capacity_note="", name="bearing"
        )
        law = model.friction
        if law.reference_parameter:
            law = law.with_reference(0.05)
        return cls(System(bearing, law, model.heating), records, pgv)


class Surveys:
    """Surveys by question, each made once, of which the latest are kept.

    A survey rests on named records and on the numbers of a bearing, and on nothing else of a visitor; so that one that is at hand may be
    shown to anyone who asks for the same.
    """

    def __init__(self) -> None:
        self._found: dict[Question, DesignSpace] = {}
        self._lock = asyncio.Lock()

    def at_hand(self, question: Question) -> DesignSpace | None:
        """Return a survey that was made before."""
        return self._found.get(question)

    async def find(self, question: Question, report: Callable[[], None]) -> DesignSpace:
        """Return a survey, made in other threads where it is not at hand; `report` is called after each radius.

        Raises
        ------
        DcfpError
            If it cannot be made.
        """
        async with self._lock:  # one survey takes every core
            found = self._found.get(question)
            if found is None:
                found = await asyncio.to_thread(_make, question, report)
                self._found[question] = found
                for old in list(self._found)[:-_MOST]:
                    del self._found[old]
            return found


def _make(question: Question, report: Callable[[], None]) -> DesignSpace:
    motions = record_set(question.records)
    if motions is None:
        msg = f"There is no record set {question.records!r}."
        raise InputError(msg)
    return survey(motions, question.pgv * 1e3, question.model, report=report)


class DesignTab(Tab):
    """Fields and results of the design chart."""

    def __init__(self, session: Session, surveys: Surveys) -> None:
        self._surveys = surveys
        self._pgv, self._allowed, self._part, self._records = 0.5, 300.0, "0.95", "P695-FF"
        self._space: DesignSpace | None = None
        varies = ("lower_radius", "upper_radius", "capacity", "mu")
        super().__init__(session, "What is asked", "Design chart", varies)

    def add_fields(self) -> None:
        """Add the question."""
        with card("Question"):
            put: Any = partial(partial, self._put)
            Slider("PGV", "m/s", 1, self._pgv, (_PGVS[0], _PGVS[-1]), 0.1, put("pgv"))
            Slider("Allowed displacement", "mm", 0, self._allowed, _ALLOWED, 10.0, put("allowed"))
            choice_field("Not exceeded in", _PARTS, self._part, put("part"))
            choice_field("Records", _SETS, self._records, put("records"))

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
        shades = "A line for each radius, the strongest the smallest."
        with card("Displacement against friction", "h3", shades):
            self._curves = Chart("Displacement against friction for each radius")
        self.add_files(("Figure (PNG)", "design-chart.png", self._figure))
        Text("p", "The sets hold single components, each analysed in one direction; both directions of a station at once move the bearing further, which the page Response shows.").classes("note")  # fmt: skip
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
            for pgv in sorted(_PGVS, key=lambda one: abs(one - self._pgv)):
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
        length = quantity("displacement")
        allowed = f"{units.of(length).shown(self._allowed):.4g} {units.name(length)}"
        self.title.text = f"{allowed} at a PGV of {units.written(pgv, space.pgv)} {units.name(pgv)}"
        self._chart.draw(chart(panels.design(space, self._allowed, part), units, grid=_GRID))
        self._curves.draw(chart(panels.design_curves(space, self._allowed, part), units, grid=_GRID))
        self._table.show(held_table([space], self._allowed), units)

    def _put(self, name: str, value: Any) -> None:
        if name == "pgv":
            value = min(_PGVS, key=lambda one: abs(one - value))
        setattr(self, f"_{name}", value)
        if name in ("pgv", "records"):
            self.ask()
        else:
            self.show_again()

    def _figure(self) -> bytes | None:
        # late: Matplotlib takes long to import
        from dcfp.present.figures.assessment import plot_design_chart

        return None if self._space is None else figure_png(plot_design_chart([self._space], self._allowed))
