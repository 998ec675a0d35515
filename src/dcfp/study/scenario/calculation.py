"""Everything that is calculated of a scenario: analyses, predictions and codes, each result once."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from dcfp.analysis import Response, respond
from dcfp.inference import Case, Setting, compare
from dcfp.inference.nominal import Nominal
from dcfp.motion.ground_motion import GroundMotion
from dcfp.schema.notebook import card, with_units
from dcfp.study.procedures import setting_of
from dcfp.study.scenario.scenario import Scenario

#: Frames of the temperature along the plates that an analysis with precise heating keeps, about.
FRAMES = 200


@dataclass(frozen=True, eq=False)
class Result:
    """One ground motion on the bearing.

    Attributes
    ----------
    motion
        As it shakes the bearing.
    response
        The analysis.
    case
        The predictions and what the codes say, beside the analysis.
    """

    motion: GroundMotion
    response: Response
    case: Case

    def _repr_html_(self) -> str:
        title = f"Response to {self.motion.name}"
        return card(title, with_units(self.response.summary()), remarks=self.response.remarks)


@dataclass(frozen=True, eq=False)
class Calculation:
    """A scenario with all its results.

    Attributes
    ----------
    scenario
        What was asked.
    setting
        How records are predicted.
    nominal
        The nominal coefficient in it, and where that comes from.
    results
        For each ground motion.
    """

    scenario: Scenario
    setting: Setting
    nominal: Nominal
    results: tuple[Result, ...]

    @cached_property
    def summary(self) -> list[dict[str, Any]]:
        """The peaks of each analysis, as the JSON of ``dcfp respond`` has them, with its remarks."""
        return [{**one.response.summary(), "remarks": list(one.response.remarks)} for one in self.results]

    def _repr_html_(self) -> str:
        rows = [
            with_units({key: value for key, value in row.items() if key != "remarks"}) for row in self.summary
        ]
        remarks = [remark for one in self.results for remark in one.response.remarks]
        return card(self.scenario.title, rows=rows, remarks=remarks)


def calculate(scenario: Scenario, report: Callable[[], None] | None = None) -> Calculation:
    """Analyse and predict every ground motion of a scenario; `report` is called after each.

    Raises
    ------
    AnalysisError
        If an analysis cannot be finished.
    """
    setting, nominal = setting_of(scenario.model)
    results: list[Result] = []
    for motion in scenario.motions:
        results.append(_result(motion, scenario, setting))
        if report is not None:
            report()
    return Calculation(scenario, setting, nominal, tuple(results))


def _result(motion: GroundMotion, scenario: Scenario, setting: Setting) -> Result:
    model, settings = scenario.model, scenario.study.settings
    precise = model.heating.name == "precise"
    step = motion.time_step if settings.step is None else min(settings.step, motion.time_step)
    response = respond(
        motion,
        model.bearing,
        model.friction,
        model.heating,
        tail=settings.tail,
        tolerance=settings.tolerance,
        step=settings.step,
        profile_every=max(1, round(motion.duration / step / FRAMES)) if precise else None,
    )
    return Result(motion, response, compare(motion, setting, codes=True, response=response))
