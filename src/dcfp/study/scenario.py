"""A scenario, one bearing under some ground motions: what is to be calculated and for whom, its file, and all that is calculated of it."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from datetime import date
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

import tomli_w

from dcfp.analysis.integration import NOTHING, PLATES
from dcfp.analysis.response import Response, RigidResponse
from dcfp.analysis.response_history import analyse_record
from dcfp.errors import InputError
from dcfp.inference import Case, compare
from dcfp.methods.code import CodeResult
from dcfp.methods.prediction import Methods, Nominal, nominal_coefficient
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.station import Station
from dcfp.schema.declared import Declared, declared
from dcfp.schema.notebook import card, told
from dcfp.schema.parameters import PGV, Parameter, table_in
from dcfp.schema.quantities import Quantities
from dcfp.schema.reading import complaints_name, read_toml
from dcfp.study import Study, read_study
from dcfp.study.results import peaks_of
from dcfp.system import System

#: What is said where there are stations.
OF_ONE_DIRECTION = (
    "Predictions and the methods of codes are of one direction and are left out here: beside the resultant of two directions they would look safer than they are."
    " dcfp compare and dcfp codes give them for a single component."
)
#: Analyses that a scenario has at most: each gets pages of its own in a report.
MOST_ANALYSES = 40


@declared
class Heading(Declared):
    """What stands at the top of a report; all of it may be empty."""

    noun = "a report"

    project: Annotated[str, Parameter("project")] = ""
    client: Annotated[str, Parameter("client")] = ""
    author: Annotated[str, Parameter("who has calculated it")] = ""
    checker: Annotated[str, Parameter("who has checked it")] = ""
    number: Annotated[str, Parameter("report number")] = ""
    date: Annotated[str, Parameter("date")] = ""
    notes: Annotated[str, Parameter("notes")] = ""


@dataclass(frozen=True, eq=False)
class Scenario:
    """One bearing under ground motions, each at one or several intensities: a study that varies nothing else.

    Raises
    ------
    InputError
        If the study varies anything else, or has too many analyses.
    """

    study: Study
    heading: Heading = field(default_factory=Heading)

    def __post_init__(self) -> None:
        varied = ("record", self.study.intensity)
        for name, values in self.study.factors.items():
            if name not in varied and len(values) > 1:
                msg = f"a scenario has one bearing, but factor {name!r} has {len(values)} values; that is a study (dcfp study)."
                raise InputError(msg)
        if self.study.sampling is not None:
            msg = "a scenario has one bearing, but there is a [sampling]; that is a study (dcfp study)."
            raise InputError(msg)
        if "procedure" in self.study.factors:
            msg = "a scenario is calculated by every procedure; leave out the factor 'procedure'."
            raise InputError(msg)
        if self.study.plan.count > MOST_ANALYSES:
            msg = f"a scenario has at most {MOST_ANALYSES} analyses, not {self.study.plan.count}; for more there is dcfp study."
            raise InputError(msg)

    @property
    def title(self) -> str:
        """Title of the report and of the page."""
        return self.study.title

    @cached_property
    def model(self) -> System:
        """The bearing, its friction law and its heating model."""
        return self.study.plan.models_at_ends()[0]

    @cached_property
    def motions(self) -> list[GroundMotion | Station]:
        """The ground motions as they shake the bearing, in the order of the study."""
        plan = self.study.plan
        every = (plan.cases(block).lanes for block in plan.blocks())
        return [plan.motion(lanes, lane) for lanes in every for lane in range(len(lanes))]

    def _repr_html_(self) -> str:
        facts = {
            "bearing": self.model.bearing.name,
            "friction": repr(self.model.friction),
            "heating": repr(self.model.heating),
            "ground motions": tuple(motion.name for motion in self.motions),
        }
        return card(self.title, facts)


def read_scenario(path: str | Path) -> Scenario:
    """Read a scenario file: as for `dcfp.read_study`, with several values of the record and its intensity only.

    A table ``[report]`` has the `Heading`.

    Parameters
    ----------
    path
        TOML as for `dcfp.read_study`, in which only ``record`` and one of ``pgv``, ``pga`` and ``scale`` may have several values, and a table
        ``[report]`` with any of ``project``, ``client``, ``author``, ``checker``, ``number``, ``date`` and ``notes``.

    Raises
    ------
    InputError
        If the file cannot be read, or anything in it cannot be used; the sentence begins with its name.
    """
    study = read_study(path)
    heading = read_heading(path)
    with complaints_name(path):
        return Scenario(study, heading)


def read_heading(path: str | Path) -> Heading:
    """Return what a table ``[report]`` of a TOML file says; raises as `read_scenario`."""
    with complaints_name(path):
        table = table_in(read_toml(path, "a scenario is a TOML file"), "report")
        if isinstance(table.get("date"), date):  # one of TOML stands for its own text
            table["date"] = table["date"].isoformat()
        return Heading.from_table(table, "[report]")


def scenario_toml(
    records: list[str],
    model: System,
    *,
    title: str,
    pgvs: list[float] | None = None,
    heading: Heading | None = None,
    motion: dict[str, Any] | None = None,
    vertical: bool = False,
) -> str:
    """Return the text of a file that reads back as the same scenario.

    Parameters
    ----------
    records
        Names of records or files.
    pgvs
        PGVs that each record is scaled to [mm/s]; None leaves the records as they are.
    motion
        The table ``[motion]``: how files are read and treated.
    vertical
        Whether the vertical force follows the vertical components of stations.
    """
    content: dict[str, Any] = {"title": title, "factors": {"record": records}}
    if pgvs is not None:
        content["factors"]["pgv"] = {"values": [PGV.written(pgv) for pgv in pgvs], "unit": PGV.unit.text}
    if motion:
        content["motion"] = motion
    if vertical:
        content["analysis"] = {"vertical": True}
    content["bearing"] = model.to_table()
    if heading is not None and heading.to_table():
        content["report"] = heading.to_table()
    return tomli_w.dumps(content)


@dataclass(frozen=True, eq=False)
class ScenarioResult:
    """One ground motion on the bearing, the analysis, and beside it the predictions and what the codes say, which are of one direction: None of a station."""

    motion: GroundMotion | Station
    response: RigidResponse
    case: Case | None

    @property
    def codes(self) -> dict[str, CodeResult]:
        """What the codes say, by name."""
        return {} if self.case is None else self.case.codes

    def _repr_html_(self) -> str:
        facts = told(self.response.quantities.values(), self.response)
        return card(f"Response to {self.motion.name}", facts, remarks=self.response.remarks)


@dataclass(frozen=True, eq=False)
class Calculation:
    """A scenario, how its records are predicted and with which nominal coefficient, and its results."""

    scenario: Scenario
    methods: Methods
    nominal: Nominal
    results: tuple[ScenarioResult, ...]

    @property
    def in_plane(self) -> bool:
        """Whether the ground motions are stations, of which nothing is predicted."""
        return self.scenario.study.in_plane

    @property
    def vertical_force(self) -> str:
        """What the vertical force does, in words."""
        follows = self.scenario.study.vertical
        return "follows the vertical component of the record" if follows else "constant"

    @property
    def quantities(self) -> Quantities:
        """What is told of each analysis."""
        return peaks_of(in_plane=self.in_plane)

    @cached_property
    def summary(self) -> list[dict[str, Any]]:
        """The peaks of each analysis, as the JSON of ``dcfp respond`` has them, with its remarks."""
        return [{**one.response.summary(), "remarks": list(one.response.remarks)} for one in self.results]

    def _repr_html_(self) -> str:
        responses = [one.response for one in self.results]
        rows = [told(one.quantities.values(), one) for one in responses]
        remarks = [remark for one in responses for remark in one.remarks]
        return card(self.scenario.title, rows=rows, remarks=remarks)


def calculate(
    scenario: Scenario,
    report: Callable[[], None] | None = None,
    *,
    responses: Sequence[RigidResponse] | None = None,
) -> Calculation:
    """Analyse and predict every ground motion of a scenario.

    Parameters
    ----------
    scenario
        What is calculated.
    report
        Called after each ground motion.
    responses
        The analyses of the scenario, where they are at hand.

    Raises
    ------
    AnalysisError
        If an analysis cannot be finished.
    """
    nominal = nominal_coefficient(scenario.model)
    methods = Methods.of(scenario.model, nominal)
    results: list[ScenarioResult] = []
    model, settings = scenario.model, scenario.study.settings
    for place, motion in enumerate(scenario.motions):
        keep = NOTHING if isinstance(motion, Station) else PLATES
        response = (
            analyse_record(motion, model, settings, vertical=scenario.study.vertical, keep=keep)
            if responses is None
            else responses[place]
        )
        of_line = isinstance(response, Response)
        case = compare(response.motion, methods, codes=True, response=response) if of_line else None
        results.append(ScenarioResult(motion, response, case))
        if report is not None:
            report()
    return Calculation(scenario, methods, nominal, tuple(results))
