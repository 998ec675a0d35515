"""A calculation as a workbook: peaks, inputs, methods, conditions, histories, provenance."""

from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.errors import InputError
from dcfp.exchange.excel.histories import write_histories, write_summary
from dcfp.exchange.excel.inputs import write_inputs, write_provenance
from dcfp.exchange.excel.methods import write_conditions, write_methods
from dcfp.exchange.excel.sheet import Formats, Sheet, sheet_names
from dcfp.present.tables import group_names
from dcfp.version import version

if TYPE_CHECKING:
    from dcfp.study.scenario import Calculation

SUMMARY, INPUTS, METHODS, CONDITIONS = "Summary", "Inputs", "Predictions and codes", "Conditions"
PROVENANCE = "Provenance"
#: A cell is what it is: what a user named must not become a formula or a link.
_OPTIONS = {"strings_to_formulas": False, "strings_to_urls": False, "strings_to_numbers": False}


def write_workbook(path: Path, calculation: "Calculation") -> None:
    """Write a workbook with every result of a calculation.

    Parameters
    ----------
    path
        File to write.
    calculation
        By `dcfp.study.scenario.calculate`.

    Raises
    ------
    InputError
        If the package XlsxWriter is not installed.
    """
    title = calculation.scenario.title
    book = _new_book(path)
    book.set_properties(
        {"title": title, "author": calculation.scenario.heading.author, "comments": f"dcfp {version()}"}
    )
    formats = Formats(book)
    cases = group_names([one.response for one in calculation.results])
    fixed = (SUMMARY, INPUTS, METHODS, CONDITIONS, PROVENANCE)
    summary, inputs, methods, conditions = (Sheet(book, formats, name, title) for name in fixed[:4])
    write_summary(summary, calculation, cases)
    write_inputs(inputs, calculation, cases)
    write_methods(methods, calculation, cases)
    write_conditions(conditions, calculation, cases)
    for name, one in zip(sheet_names(cases, fixed), calculation.results, strict=True):
        write_histories(Sheet(book, formats, name, title), book, one.response)
    write_provenance(Sheet(book, formats, PROVENANCE, title), calculation)
    book.close()


def _new_book(path: Path) -> Any:
    try:
        from xlsxwriter import Workbook
    except ImportError as error:
        msg = "a workbook needs the package XlsxWriter; install it with pip install 'dcfp[excel]'."
        raise InputError(msg) from error
    return Workbook(str(path), _OPTIONS)
