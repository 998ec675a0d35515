"""What is checked of every analysis, each with what was found, what is allowed, and who says so."""

from dataclasses import replace

from dcfp.present.report.document import written
from dcfp.schema.check import Check
from dcfp.study.scenario import ScenarioResult

ANALYSIS = "analysis"


def label_of(result: ScenarioResult) -> str:
    """Return the name of a case: the record and the PGV."""
    return f"{result.motion.name}, {written('pgv_m_s', result.motion.peak_velocity / 1e3)} m/s"


def checks_of(result: ScenarioResult) -> tuple[Check, ...]:
    """Return every check of a case: those of the analysis, then the conditions of each code."""
    of_analysis = [replace(one, of=ANALYSIS) for one in result.response.checks]
    of_codes = [replace(one, of=name) for name, said in result.case.codes.items() for one in said.conditions]
    return (*of_analysis, *of_codes)
