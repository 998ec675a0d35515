"""Sobol indices from the results of a study: which sampled factor the variance of a result comes from."""

import argparse
import json
from itertools import product
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli.parser import Parser, fraction, whole_number
from dcfp.doors.cli.study import reading
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

    from dcfp.present.tables.columns import Column

_INDICES = ("S1", "S1_confidence", "ST", "ST_confidence")


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    reading.add_store(parser, may_be_unfinished=False)
    reading.add_quantity(parser)
    parser.add_argument(
        "--over-records",
        type=_reduction,
        metavar="WAY",
        help="how the records are taken together: geometric-mean (default), or a quantile between 0 and 1",
    )
    parser.add_argument(
        "--logarithm", action="store_true", help="the variance of the logarithm of the result"
    )
    parser.add_argument(
        "--confidence",
        type=fraction(),
        default=0.95,
        metavar="PART",
        help="of the intervals [-]; default 0.95",
    )
    parser.add_argument(
        "--seed",
        type=whole_number(1, 2**31 - 1),
        default=2010,
        metavar="N",
        help="of the intervals; default 2010",
    )
    reading.add_output(parser, "the indices by factor and intensity")


def run(chosen: argparse.Namespace) -> int:
    """Estimate the indices, and print them."""
    outputs = reading.checked_outputs(chosen)
    from dcfp.study.assessment import sensitivity

    found = sensitivity(
        reading.opened(chosen),
        chosen.quantity,
        chosen.over_records,
        logarithm=chosen.logarithm,
        confidence=chosen.confidence,
        seed=chosen.seed,
    )
    rows = _rows(found)

    def draw() -> "Figure":
        from dcfp.present.figures.assessment import plot_sensitivity

        return plot_sensitivity(found)

    reading.write(outputs, _columns(found), rows, draw)
    if chosen.json:
        told = reading.document(
            found,
            rows,
            quantity=chosen.quantity,
            over_records=found.attrs["over_records"],
            logarithm=chosen.logarithm,
            confidence=chosen.confidence,
        )
        print(json.dumps(told, indent=2, allow_nan=False))
    else:
        _print(found, rows)
    return 0


def _reduction(text: str) -> str | float:
    if text == "geometric-mean":
        return text
    try:
        return fraction()(text)
    except argparse.ArgumentTypeError as error:
        msg = f"must be geometric-mean or a quantile between 0 and 1, not {text!r}"
        raise argparse.ArgumentTypeError(msg) from error


def _left(found: "xarray.Dataset") -> "list[xarray.DataArray]":
    """Return the factors that are left of the grid."""
    return [found[str(name)] for name in found["S1"].dims if name != "factor"]


def _rows(found: "xarray.Dataset") -> list[dict[str, Any]]:
    left = _left(found)
    rows: list[dict[str, Any]] = []
    for places in product(*(range(one.size) for one in left)):
        at = {str(one.name): place for one, place in zip(left, places, strict=True)}
        where = {
            reading.key(one): reading.keyed(one, one.to_numpy()[place].item())
            for one, place in zip(left, places, strict=True)
        }
        for i, name in enumerate(found["factor"].to_numpy().tolist()):
            one = found.isel({**at, "factor": i})
            values = {index: float(one[index]) for index in _INDICES}
            rows.append({**where, "factor": name, **{k: v if v == v else None for k, v in values.items()}})
    return rows


def _columns(found: "xarray.Dataset") -> "list[Column]":
    from dcfp.present.tables.columns import Column

    return [
        *(reading.column(one) for one in _left(found)),
        Column("factor", "factor"),
        *(Column(name, name, "1") for name in _INDICES),
    ]


def _print(found: "xarray.Dataset", rows: list[dict[str, Any]]) -> None:
    from dcfp.study.assessment.selection import is_number

    left = _left(found)
    table = new_table([*(reading.head(one) for one in left), "Factor"], ["first order\n[-]", "total\n[-]"])
    before: list[str] = []
    for row in rows:
        where = [
            f"{row[reading.key(one)] * (1.0 if one.name == 'pgv' else reading.shown_factor(one)):.4g}"
            if is_number(one)
            else str(row[reading.key(one)])
            for one in left
        ]
        cells = [_with_interval(row[name], row[f"{name}_confidence"]) for name in ("S1", "ST")]
        add_row(table, [*(where if where != before else [""] * len(where)), row["factor"], *cells])
        before = where
    words = str(found.attrs["quantity"]).replace("_", " ")
    with page() as out:
        print_labelled(
            out,
            [
                *reading.study_lines(found),
                (
                    "Question",
                    f"from which factor the variance of {'the logarithm of ' if found.attrs['logarithm'] else ''}{words} comes",
                ),
                ("Records", str(found.attrs["over_records"])),
            ],
        )
        out.print()
        out.print(table)
        print_remarks(out, str(found.attrs["remarks"]).splitlines())


def _with_interval(value: float | None, half: float | None) -> str:
    return "–" if value is None or half is None else f"{value:.3f} ± {half:.3f}"
