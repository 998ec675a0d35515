"""What the commands on the results of a study share: the store, the selection, and what goes where."""

import argparse
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli import options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser
from dcfp.errors import InputError

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

    from dcfp.present.tables.columns import Column


def add_store(parser: Parser, *, may_be_unfinished: bool = True) -> None:
    """Add the store of the study and what is chosen of it."""
    parser.add_argument("store", metavar="STORE", help="results of a study: a folder .zarr, or a file .nc")
    add_selection(parser)
    if may_be_unfinished:
        parser.add_argument(
            "--unfinished",
            action="store_true",
            help="leave out the analyses that have not been run, rather than refuse the study",
        )


def add_selection(parser: Parser) -> None:
    """Add which value of each factor is meant."""
    parser.add_argument(
        "--at",
        action="extend",
        nargs="+",
        type=pair,
        default=[],
        metavar="FACTOR=VALUE",
        help="one value of each factor that is not looked at: pgv in m/s, the others in the units of the tables",
    )


def add_quantity(parser: Parser) -> None:
    """Add which result is looked at."""
    parser.add_argument(
        "--quantity",
        default="peak_displacement",
        metavar="NAME",
        help="the result: peak_displacement (default), force_ratio, peak_temperature, residual_displacement, ...",
    )


def add_output(parser: Parser, data: str) -> None:
    """Add where the results go; `data` says what a CSV holds."""
    options.add_output(parser, f"{data} as CSV (.csv)")


def checked_outputs(chosen: argparse.Namespace) -> Outputs:
    """Return the outputs of a command once it is known that each can be written."""
    return Outputs.checked(chosen, [Path(chosen.store)], (".csv",))


def opened(chosen: argparse.Namespace) -> "xarray.Dataset":
    """Return what is chosen of a study."""
    from dcfp.study.assessment.selection import select  # late: xarray takes long to import
    from dcfp.study.results import INTENSITIES, open_store

    dataset = open_store(Path(chosen.store))
    return select(dataset, values_of_pairs(dataset, chosen.at), keep=("record", "sample", *INTENSITIES))


def pair(text: str) -> tuple[str, str]:
    """Return the name and the value of ``FACTOR=VALUE``."""
    name, sign, value = text.partition("=")
    if not (name.strip() and sign and value.strip()):
        msg = f"must be FACTOR=VALUE, for example radius=4500, not {text!r}"
        raise argparse.ArgumentTypeError(msg)
    return name.strip(), value.strip()


def values_of_pairs(dataset: "xarray.Dataset", pairs: Sequence[tuple[str, str]]) -> dict[str, float | str]:
    """Return the values of factors in the units of the data set, from those that a user writes.

    Raises
    ------
    InputError
        If a factor is named twice, or its value is no number where its others are.
    """
    found: dict[str, float | str] = {}
    for name, text in pairs:
        if name in found:
            msg = f"{name} is chosen twice; give one value."
            raise InputError(msg)
        found[name] = _value(dataset, name, text)
    return found


def shown_factor(variable: "xarray.DataArray") -> float:
    """Return shown value over value [-]."""
    from dcfp.study.assessment.selection import described

    return 1.0 / described(variable).shown.size


def head(variable: "xarray.DataArray") -> str:
    """Return the head of a column of a table."""
    from dcfp.study.assessment.selection import described

    name = "PGV" if variable.name == "pgv" else "PGA" if variable.name == "pga" else str(variable.name)
    return f"{name.replace('_', ' ')}\n[{described(variable).shown.name.replace('–', '-')}]"


def key(variable: "xarray.DataArray") -> str:
    """Return the name of a value in JSON: with its unit, PGV in m/s and all else in the units of the data set."""
    if variable.name == "pgv":
        return "pgv_m_s"
    unit = str(variable.attrs.get("units", "1"))
    return (
        str(variable.name)
        if unit == "1"
        else f"{variable.name}_{unit.replace(' ', '_').replace('-1', '').replace('-', '')}"
    )


def keyed(variable: "xarray.DataArray", value: Any) -> Any:
    """Return a value of a factor or a result as JSON has it; None for what is not a number."""
    if isinstance(value, str):
        return value
    number = float(value) * (shown_factor(variable) if variable.name == "pgv" else 1.0)
    return float(f"{number:.9g}") if number == number else None


def study_lines(found: "xarray.Dataset") -> list[tuple[str, str]]:
    """Return what was looked at, for the top of a page."""
    from dcfp.study.assessment.selection import fixed_values

    fixed = fixed_values(found)
    return [("Study", str(found.attrs.get("title", "")) or "–"), *([("At", fixed)] if fixed else [])]


def document(found: "xarray.Dataset", rows: Sequence[Mapping[str, Any]], **more: Any) -> dict[str, Any]:
    """Return what a command prints as JSON."""
    from dcfp.study.assessment.completeness import remarks_of
    from dcfp.study.assessment.selection import OF_RECORDS, coordinates_of

    fixed = {
        key(one): keyed(one, one.item())
        for name, one in coordinates_of(found).items()
        if one.ndim == 0 and name not in OF_RECORDS
    }
    return {
        "study": str(found.attrs.get("study_name", "")),
        "at": fixed,
        **more,
        "results": list(rows),
        "remarks": remarks_of(found),
        "references": str(found.attrs.get("references", "")).splitlines(),
    }


def write(
    outputs: Outputs,
    columns: "Sequence[Column]",
    rows: Sequence[Mapping[str, Any]],
    draw: "Callable[[], Figure]",
) -> None:
    """Write the table and the figure that are wanted."""

    def data(part: Path, kind: str) -> None:
        from dcfp.present.tables.columns import table_text

        del kind
        part.write_text(table_text(columns, rows), encoding="utf-8")

    def figure(part: Path, form: str) -> None:
        from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import

        save_figure(draw(), part, form)

    outputs.write_with(data, figure)


def column(variable: "xarray.DataArray") -> "Column":
    """Return the column of a factor or a result in a CSV."""
    from dcfp.present.tables.columns import Column

    unit = "m s-1" if variable.name == "pgv" else str(variable.attrs.get("units", ""))
    return Column(key(variable), str(variable.name), unit)


def number(value: float | None, digits: int = 4) -> str:
    """Return a number of a table with so many digits; a dash for none."""
    return "–" if value is None or value != value else f"{value:.{digits}g}"


def _value(dataset: "xarray.Dataset", name: str, text: str) -> float | str:
    from dcfp.study.assessment.selection import is_number

    factor = dataset[name] if name in dataset.dims or name in dataset.coords else None
    if factor is not None and not is_number(factor):
        return text
    try:
        return float(text) / (1.0 if factor is None else shown_factor(factor))
    except ValueError:
        return text  # refused with the values that are there
