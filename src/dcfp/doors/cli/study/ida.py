"""Incremental dynamic analysis from the results of a study: the curves of the records, and what parts of them do not exceed."""

import argparse
import json
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli.parser import Numbers, Parser, fraction
from dcfp.doors.cli.study import reading
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

    from dcfp.present.tables.columns import Column

#: Those of `dcfp.study.assessment.ida`.
_QUANTILES = (0.16, 0.5, 0.84)


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    reading.add_store(parser)
    reading.add_quantity(parser)
    parser.add_argument(
        "--quantiles",
        action=Numbers,
        check=fraction(),
        default=list(_QUANTILES),
        metavar="PART",
        help="parts of the records that do not exceed [-]; default 0.16 0.5 0.84",
    )
    reading.add_output(parser, "the quantiles and every record by intensity")


def run(chosen: argparse.Namespace) -> int:
    """Make the curves, and print their quantiles."""
    outputs = reading.checked_outputs(chosen)
    from dcfp.study.assessment import ida

    found = ida(reading.opened(chosen), chosen.quantity, chosen.quantiles, unfinished=chosen.unfinished)
    rows = _rows(found, chosen.quantity)

    def draw() -> "Figure":
        from dcfp.present.figures.assessment import plot_ida

        figure: Any = plot_ida(found).figure
        return figure

    reading.write(outputs, _columns(found, chosen.quantity), [_flat(row) for row in rows], draw)
    if chosen.json:
        told = reading.document(found, rows, quantity=chosen.quantity)
        print(json.dumps(told, indent=2, allow_nan=False))
    else:
        _print(found, chosen.quantity, rows)
    return 0


def _rows(found: "xarray.Dataset", quantity: str) -> list[dict[str, Any]]:
    values = found[quantity]
    intensity = found[str(values.dims[1])]
    parts = [f"{part:g}" for part in found["quantile"].to_numpy().tolist()]
    names = found["record"].to_numpy().tolist()
    quantiles = found[f"{quantity}_quantile"].to_numpy().T.tolist()
    beyond = found["beyond_capacity"].sum("record").to_numpy().tolist()
    rows: list[dict[str, Any]] = []
    for i, (at, single) in enumerate(
        zip(intensity.to_numpy().tolist(), values.to_numpy().T.tolist(), strict=True)
    ):
        rows.append(
            {
                reading.key(intensity): reading.keyed(intensity, at),
                "quantiles": {
                    part: reading.keyed(values, one) for part, one in zip(parts, quantiles[i], strict=True)
                },
                "beyond_capacity": int(beyond[i]),
                "records": {
                    name: reading.keyed(values, one) for name, one in zip(names, single, strict=True)
                },
            }
        )
    return rows


def _flat(row: dict[str, Any]) -> dict[str, Any]:
    flat = {name: value for name, value in row.items() if not isinstance(value, dict)}
    for kind in ("quantiles", "records"):
        flat |= {f"{kind} {name}": value for name, value in row[kind].items()}
    return flat


def _columns(found: "xarray.Dataset", quantity: str) -> "list[Column]":
    from dcfp.present.tables.columns import Column

    values = found[quantity]
    unit = str(values.attrs.get("units", ""))
    parts = [f"{part:g}" for part in found["quantile"].to_numpy().tolist()]
    return [
        reading.column(found[str(values.dims[1])]),
        *(Column(f"quantiles {part}", f"{quantity} {part}", unit) for part in parts),
        Column("beyond_capacity", "beyond_capacity", "1"),
        *(Column(f"records {name}", str(name), unit) for name in found["record"].to_numpy().tolist()),
    ]


def _print(found: "xarray.Dataset", quantity: str, rows: list[dict[str, Any]]) -> None:
    values = found[quantity]
    intensity = found[str(values.dims[1])]
    unit = reading.head(values).partition("\n")[2]
    heads = [f"{100.0 * float(part):g} %\n{unit}" for part in rows[0]["quantiles"]]
    table = new_table([], [reading.head(intensity), *heads, "beyond\ncapacity"])
    for row, at in zip(rows, intensity.to_numpy().tolist(), strict=True):
        shown = [
            None if one is None else one * reading.shown_factor(values) for one in row["quantiles"].values()
        ]
        add_row(
            table,
            [
                f"{at * reading.shown_factor(intensity):.4g}",
                *map(reading.number, shown),
                f"{row['beyond_capacity']} of {found.sizes['record']}",
            ],
        )
    with page() as out:
        print_labelled(
            out,
            [
                *reading.study_lines(found),
                (
                    "Question",
                    f"{_words(values)}: what parts of {found.sizes['record']} records do not exceed",
                ),
            ],
        )
        out.print()
        out.print(table)
        print_remarks(out, str(found.attrs["remarks"]).splitlines())


def _words(values: "xarray.DataArray") -> str:
    from dcfp.study.assessment.selection import described

    return described(values).words
