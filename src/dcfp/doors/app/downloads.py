"""Files to take away, made in memory or in a folder that is gone when they are sent."""

from collections.abc import Callable, Sequence
from io import BytesIO
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from dcfp.analysis import Response
from dcfp.analysis.rig import Loops
from dcfp.doors.app.analysis import Task, scenario_of
from dcfp.present.tables import write_responses, write_tests
from dcfp.study.scenario import calculate

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def responses_file(responses: Sequence[Response], kind: str) -> bytes:
    """Return analyses as ``".nc"``, or as ``".csv"`` the histories of one or the peaks of several."""
    return _file(lambda path: write_responses(path, responses, kind))


def tests_file(tests: Sequence[Loops], kind: str) -> bytes:
    """Return tests as ``".nc"``, or as ``".csv"`` the history of one or the measures of several."""
    return _file(lambda path: write_tests(path, tests, kind))


def report_pdf(task: Task) -> bytes:
    """Return the report of a task as PDF."""
    from dcfp.present.report import build_report, check_typst, pdf_of  # late: it needs another package

    check_typst()
    return pdf_of(build_report(calculate(scenario_of(task))))


def workbook(task: Task) -> bytes:
    """Return every result of a task as a workbook."""
    from dcfp.exchange import write_workbook

    return _file(lambda path: write_workbook(path, calculate(scenario_of(task))))


def figure_png(figure: "Figure") -> bytes:
    """Return a figure as PNG."""
    from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import

    stream = BytesIO()
    save_figure(figure, stream, "png")
    return stream.getvalue()


def _file(write: Callable[[Path], Any]) -> bytes:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "results"
        write(path)
        return path.read_bytes()
