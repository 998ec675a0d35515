"""``dcfp export`` and ``dcfp report``: a scenario for another program, and as a calculation report."""

import argparse
from pathlib import Path

from dcfp.doors.cli.console import progress
from dcfp.doors.cli.outputs import Answer
from dcfp.errors import InputError
from dcfp.present.tables import write_responses
from dcfp.study.scenario import Calculation, Scenario, calculate, read_scenario

#: Figures of a case of a report.
_FIGURES = 2


def export(chosen: argparse.Namespace) -> Answer:
    """Write a scenario as a script for OpenSees, a workbook, or its analyses as data."""
    from dcfp.exchange import opensees_script, write_workbook  # late: the report needs neither

    scenario = read_scenario(chosen.scenario)
    script = None
    if Path(chosen.out).suffix.lower() == ".py":
        if len(scenario.motions) != 1:
            msg = (
                f"a script is of one record at one intensity, but the scenario has {len(scenario.motions)} analyses;"
                " leave one in it, or write .xlsx."
            )
            raise InputError(msg)
        model = scenario.model
        script = opensees_script(scenario.motions[0], model)
    calculation = _calculated(scenario)

    def data(part: Path, kind: str) -> str | None:
        if kind == ".xlsx":
            write_workbook(part, calculation)
        elif kind != ".py":
            write_responses(part, [one.response for one in calculation.results], kind)
        return script

    return Answer.of_file(chosen.out, data, {"file": chosen.out, "analyses": calculation.summary})


def report(chosen: argparse.Namespace) -> Answer:
    """Calculate a scenario and write its report."""
    from dcfp.present.report import build_report, check_typst, page_of, pdf_of  # late: it draws figures

    kind = Path(chosen.out or "").suffix.lower()
    if kind == ".pdf":
        check_typst()
    calculation = _calculated(read_scenario(chosen.scenario))
    document = build_report(calculation)

    def data(part: Path, kind: str) -> str | None:
        with progress("figures", _FIGURES * len(calculation.results)) as advance:
            if kind != ".pdf":
                return page_of(document, advance)
            part.write_bytes(pdf_of(document, advance))
            return None

    return Answer.of_file(chosen.out, data, document.numbers)


def _calculated(scenario: Scenario) -> Calculation:
    with progress("analyses", len(scenario.motions)) as advance:
        return calculate(scenario, advance)
