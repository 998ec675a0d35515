"""From what a visitor chose to analyses and predictions: calls of the package, in another thread."""

from dataclasses import dataclass

from dcfp.analysis import Response, respond
from dcfp.analysis.integration import PLATES
from dcfp.doors.app.session import Session
from dcfp.errors import InputError
from dcfp.inference import Case, Methods, compare
from dcfp.methods.prediction import Nominal, nominal_coefficient
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import motion_remarks, refuse_a_drift
from dcfp.motion.treatment import treated
from dcfp.study import Study
from dcfp.study.scenario import Heading, Scenario, scenario_toml
from dcfp.system import System


@dataclass(frozen=True, eq=False)
class Task:
    """What is to be analysed; a copy of the fields, so that they may change meanwhile.

    Attributes
    ----------
    motions
        As they are in their files.
    model
        The bearing, its law and its heating.
    pgv
        To which they are scaled [mm/s], or None.
    baseline, corner
        How they are treated; the corner of a high-pass filter [Hz], or None.
    """

    motions: tuple[GroundMotion, ...]
    model: System
    pgv: float | None
    baseline: bool
    corner: float | None

    @classmethod
    def of(cls, session: Session) -> "Task":
        """Copy the fields.

        Raises
        ------
        InputError
            If there is no record, or a field is empty or out of range.
        """
        if not session.chosen:
            msg = "Choose at least one record."
            raise InputError(msg)
        return cls(
            tuple(session.motion(key) for key in session.chosen),
            session.bearing.system(),
            None if session.as_recorded else session.pgv * 1e3,
            session.baseline,
            session.corner,
        )

    def treated(self) -> list[GroundMotion]:
        """Return the motions with their treatment, unscaled."""
        return [treated(motion, baseline=self.baseline, corner=self.corner) for motion in self.motions]

    def scaled(self) -> list[GroundMotion]:
        """Return the motions as they shake the bearing.

        Raises
        ------
        InputError
            If one cannot be scaled.
        """
        motions = self.treated()
        if self.pgv is None:
            return motions
        for motion in motions:
            refuse_a_drift(motion)
        return [motion.scaled_to_pgv(self.pgv) for motion in motions]


def analyse(task: Task) -> list[Response]:
    """Analyse every motion; with precise heating the temperature along the plates is kept."""
    return [respond(motion, task.model, keep=PLATES) for motion in task.scaled()]


@dataclass(frozen=True, eq=False)
class Predicted:
    """What is predicted of one analysis.

    Attributes
    ----------
    case
        Predictions and codes beside the analysis.
    methods, nominal
        How it was predicted.
    """

    case: Case
    methods: Methods
    nominal: Nominal


def predict(response: Response, model: System) -> Predicted:
    """Ask every method and every code what it says of a motion that was analysed."""
    nominal = nominal_coefficient(model)
    methods = Methods.of(model, nominal)
    return Predicted(compare(response.motion, methods, codes=True, response=response), methods, nominal)


def remarks_on(response: Response) -> list[str]:
    """Return the sentences that must stand beside an analysis; its scale stands in the head."""
    return [*motion_remarks(response.motion, with_scale=False), *response.remarks]


def scenario_text(session: Session, heading: Heading | None = None) -> str:
    """Return the scenario file of what is chosen; the visitor's own files are named as beside it.

    Raises
    ------
    InputError
        If a field is empty or out of range.
    """
    task = Task.of(session)
    motion: dict[str, bool | float | str] = {}
    if task.baseline:
        motion["baseline"] = True
    if task.corner is not None:
        motion["high_pass"] = task.corner
    for key in session.chosen:
        if key in session.sent:
            motion |= session.sent[key].options
    return scenario_toml(
        [session.file_of(key) for key in session.chosen],
        task.model,
        title=f"{', '.join(one.name for one in task.motions)} on {task.model.bearing.name}",
        pgvs=None if task.pgv is None else [task.pgv],
        heading=heading,
        motion=motion,
    )


def scenario_of(task: Task) -> Scenario:
    """Return the same as a scenario, whose motions are at hand."""
    factors = {} if task.pgv is None else {"pgv": [task.pgv]}
    title = f"{', '.join(one.name for one in task.motions)} on {task.model.bearing.name}"
    return Scenario(Study(task.treated(), factors, model=task.model, title=title))
