"""A report from a calculation."""

from dcfp.errors import InputError
from dcfp.present.report.closing import appendix, remarks_section, sources_section
from dcfp.present.report.document import Document
from dcfp.present.report.inputs import inputs_section
from dcfp.present.report.numbers import numbers_of
from dcfp.present.report.results import methods_section, results_section
from dcfp.present.report.verdicts import checks_section, front_blocks
from dcfp.present.report.worked import worked_out
from dcfp.study.scenario import Calculation
from dcfp.version import version


def build_report(calculation: Calculation) -> Document:
    """Return the report of a calculation, to be written by `pdf_of` or `page_of`.

    Raises
    ------
    InputError
        If there is no result to report.
    """
    if not calculation.results:
        msg = "there is no analysis to report; the scenario has no ground motion."
        raise InputError(msg)
    scenario = calculation.scenario
    worked = worked_out(calculation)
    return Document(
        title=scenario.title,
        heading=scenario.heading,
        front=front_blocks(calculation),
        sections=(
            inputs_section(calculation),
            results_section(calculation),
            methods_section(calculation),
            checks_section(calculation),
            *worked.sections,
            remarks_section(calculation),
            sources_section(calculation),
            *appendix(calculation),
        ),
        maker=f"dcfp {version()}",
        with_contents=True,
        numbers=numbers_of(calculation, worked.formulas),
    )
