"""From what a visitor chose to analyses, predictions and files to take away: calls of the package, in another thread."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, TypeAlias

from dcfp.analysis import Response, respond
from dcfp.analysis.integration import PLATES
from dcfp.analysis.plane_response import PlaneResponse
from dcfp.analysis.response import RigidResponse
from dcfp.doors.app.session import Session
from dcfp.errors import InputError
from dcfp.exchange import write_workbook
from dcfp.inference import Case, Methods, compare
from dcfp.methods.prediction import Nominal, nominal_coefficient
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import motion_remarks, refuse_a_drift
from dcfp.motion.station import Station, stations_of
from dcfp.motion.treatment import record_treated
from dcfp.study import Study
from dcfp.study.scenario import Scenario, calculate, scenario_toml
from dcfp.system import System

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Predictions and codes beside an analysis, and the coefficient of friction that they took.
Predicted: TypeAlias = tuple[Case, Nominal]


@dataclass(frozen=True, eq=False)
class Task:
    """What is to be analysed: a copy of the fields, so that they may change meanwhile.

    Motions are as they are in their files; the PGV is in mm/s, the corner of a high-pass filter in Hz and the angle by which stations are turned in degrees, or None.
    """

    motions: tuple[GroundMotion | Station, ...]
    model: System
    pgv: float | None
    baseline: bool
    corner: float | None
    rotate: float | None = None
    vertical: bool = False

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
        motions = tuple(session.motion(key) for key in session.chosen)
        pgv = None if session.as_recorded else session.pgv * 1e3
        return cls(motions, session.bearing.system(), pgv, session.baseline, session.corner, session.rotate, session.vertical)  # fmt: skip

    @property
    def title(self) -> str:
        """What is analysed, in words."""
        return f"{', '.join(one.name for one in self.motions)} on {self.model.bearing.name}"

    @property
    def in_plane(self) -> bool:
        """Whether the motions are stations.

        Raises
        ------
        InputError
            If there are stations and single components.
        """
        return bool(stations_of(self.motions))

    def treated(self) -> list[GroundMotion | Station]:
        """Return the motions with their treatment, and stations turned, unscaled."""
        found = [record_treated(one, baseline=self.baseline, corner=self.corner) for one in self.motions]
        return [
            one.rotated(self.rotate) if self.rotate and isinstance(one, Station) else one for one in found
        ]

    def scaled(self) -> list[GroundMotion | Station]:
        """Return the motions with their treatment, stations turned, and scaled.

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

    def analysed(self) -> list[Response] | list[PlaneResponse]:
        """Analyse every motion; with precise heating the temperature of the plates is kept.

        Raises
        ------
        InputError
            If one cannot be scaled, or there are stations and single components.
        """
        motions = self.scaled()
        if self.in_plane:
            return [
                respond(one, self.model, vertical=self.vertical, keep=PLATES) for one in stations_of(motions)
            ]
        singles = [one for one in motions if isinstance(one, GroundMotion)]
        return [respond(motion, self.model, keep=PLATES) for motion in singles]

    def scenario(self) -> Scenario:
        """Return the same as a scenario, whose motions are at hand.

        Raises
        ------
        InputError
            If there are stations and single components, or the vertical component that is to be followed is missing.
        """
        factors = {} if self.pgv is None else {"pgv": [self.pgv]}
        vertical = self.vertical and self.in_plane
        return Scenario(Study(self.treated(), factors, model=self.model, title=self.title, vertical=vertical))

    def report_pdf(self) -> bytes:
        """Return the report as PDF."""
        from dcfp.present.report import build_report, check_typst, pdf_of  # late: it needs another package

        check_typst()
        return pdf_of(build_report(calculate(self.scenario())))

    def workbook(self) -> bytes:
        """Return every result as a workbook."""
        return file_of(lambda path: write_workbook(path, calculate(self.scenario())))


def predict(response: Response, model: System) -> Predicted:
    """Ask every method and every code what it says of a motion that was analysed."""
    nominal = nominal_coefficient(model)
    methods = Methods.of(model, nominal)
    return compare(response.motion, methods, codes=True, response=response), nominal


def remarks_on(response: RigidResponse) -> list[str]:
    """Return the sentences that must stand beside an analysis; its scale stands in the head."""
    return [*motion_remarks(response.motion, with_scale=False), *response.remarks]


def scenario_text(session: Session) -> str:
    """Return the scenario file of what is chosen; the visitor's own files are named as beside it.

    Raises
    ------
    InputError
        If a field is empty or out of range.
    """
    task = Task.of(session)
    if task.in_plane and task.rotate:
        msg = "A scenario file takes stations as they stand: leave out the angle, or take the report or the workbook."
        raise InputError(msg)
    motion: dict[str, bool | float | str] = {"baseline": True} if task.baseline else {}
    if task.corner is not None:
        motion["high_pass"] = task.corner
    for key in session.chosen:
        if key in session.sent:
            motion |= session.sent[key].options
    files = [session.file_of(key) for key in session.chosen]
    pgvs = None if task.pgv is None else [task.pgv]
    return scenario_toml(
        files,
        task.model,
        title=task.title,
        pgvs=pgvs,
        motion=motion,
        vertical=task.vertical and task.in_plane,
    )


def file_of(write: Callable[[Path], Any]) -> bytes:
    """Return the file that a function writes to a path."""
    with TemporaryDirectory() as folder:
        path = Path(folder) / "results"
        write(path)
        return path.read_bytes()


def table_of(
    write: Callable[[Path, Sequence[Any], str], Any], results: Sequence[Any], kind: str
) -> bytes | None:
    """Return results as ``".nc"``, or as ``".csv"`` the histories of one or the measures of several; None without any."""
    return file_of(lambda path: write(path, results, kind)) if results else None


def figure_png(figure: "Figure") -> bytes:
    """Return a figure as PNG."""
    from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import

    stream = BytesIO()
    save_figure(figure, stream, "png")
    return stream.getvalue()
