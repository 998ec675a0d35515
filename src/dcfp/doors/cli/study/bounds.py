"""Property bounds from the results of a study: the envelope over property factors and ambient temperatures, and what governs it."""

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

_VALUES = ("least", "nominal", "largest")


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    reading.add_store(parser)
    parser.add_argument(
        "--over",
        nargs="+",
        metavar="FACTOR",
        help="the property factors; default those of lambda and ambient that vary",
    )
    parser.add_argument(
        "--nominal",
        action="extend",
        nargs="+",
        type=reading.pair,
        default=[],
        metavar="FACTOR=VALUE",
        help="the nominal value of each; default lambda=1 ambient=20",
    )
    parser.add_argument(
        "--quantities",
        nargs="+",
        metavar="NAME",
        help="the results; default peak_displacement force_ratio residual_displacement peak_temperature",
    )
    parser.add_argument(
        "--quantiles",
        action=Numbers,
        check=fraction(),
        default=[0.5, 0.84],
        metavar="PART",
        help="parts of the records that do not exceed [-]; the figure shows the first; default 0.5 0.84",
    )
    reading.add_output(parser, "least, nominal and largest by result, quantile and intensity")


def run(chosen: argparse.Namespace) -> int:
    """Make the envelopes, and print them."""
    outputs = reading.checked_outputs(chosen)
    from dcfp.study.assessment import bounds
    from dcfp.study.assessment.bounds import NOMINAL, QUANTITIES

    dataset = reading.opened(chosen)
    found = bounds(
        dataset,
        chosen.over,
        {**NOMINAL, **reading.values_of_pairs(dataset, chosen.nominal)},
        chosen.quantities or QUANTITIES,
        chosen.quantiles,
        unfinished=chosen.unfinished,
    )
    rows = _rows(found)

    def draw() -> "Figure":
        from dcfp.present.figures.assessment import plot_bounds

        return plot_bounds(found)

    reading.write(outputs, _columns(found), rows, draw)
    if chosen.json:
        told = reading.document(
            found, rows, over=found.attrs["over"].split(", "), nominal=found.attrs["nominal"]
        )
        print(json.dumps(told, indent=2, allow_nan=False))
    else:
        _print(found, rows)
    return 0


def _rows(found: "xarray.Dataset") -> list[dict[str, Any]]:
    intensity = found[str(found.attrs["intensity"])]
    rows: list[dict[str, Any]] = []
    for name in str(found.attrs["quantities"]).split(", "):
        for i, part in enumerate(found["quantile"].to_numpy().tolist()):
            for j, at in enumerate(intensity.to_numpy().tolist()):
                one = found.isel({"quantile": i, str(intensity.name): j})
                row = {
                    "quantity": name,
                    "unit": str(found[name].attrs.get("units", "1")),
                    "quantile": part,
                    reading.key(intensity): reading.keyed(intensity, at),
                }
                row |= {side: reading.keyed(found[name], one[f"{name}_{side}"]) for side in _VALUES}
                ratio = float(one[f"{name}_ratio"])
                row["largest_over_nominal"] = ratio if ratio == ratio else None
                row |= {f"{side}_at": one[f"{name}_{side}_at"].item() for side in ("least", "largest")}
                rows.append(row)
    return rows


def _columns(found: "xarray.Dataset") -> "list[Column]":
    from dcfp.present.tables.columns import Column

    return [
        Column("quantity", "quantity"),
        Column("unit", "unit"),
        Column("quantile", "quantile", "1"),
        reading.column(found[str(found.attrs["intensity"])]),
        *(Column(name, name) for name in _VALUES),
        Column("largest_over_nominal", "largest_over_nominal", "1"),
        Column("least_at", "least_at"),
        Column("largest_at", "largest_at"),
    ]


def _print(found: "xarray.Dataset", rows: list[dict[str, Any]]) -> None:
    intensity = found[str(found.attrs["intensity"])]
    table = new_table(
        ["Result", "Records"],
        [reading.head(intensity), "least", "nominal", "largest", "over\nnominal"],
        ["largest at"],
    )
    before = ("", "")
    for row in rows:
        name = str(row["quantity"])
        factor = reading.shown_factor(found[name])
        label = (
            reading.head(found[name]).replace("\n", " ").replace(" [-]", ""),
            f"{100.0 * row['quantile']:g} %",
        )
        shown = label if label[0] != before[0] else ("", "" if label == before else label[1])
        values = [None if row[side] is None else row[side] * factor for side in _VALUES]
        at = row[reading.key(intensity)] * (
            1.0 if intensity.name == "pgv" else reading.shown_factor(intensity)
        )
        cells = [*shown, f"{at:.4g}", *map(reading.number, values)]
        add_row(table, [*cells, reading.number(row["largest_over_nominal"], 3), row["largest_at"]])
        before = label
    with page() as out:
        print_labelled(
            out,
            [
                *reading.study_lines(found),
                (
                    "Question",
                    f"between which bounds the results are over {found.attrs['over'].replace(', ', ' and ')}",
                ),
                ("Nominal", str(found.attrs["nominal"])),
            ],
        )
        out.print()
        out.print(table)
        print_remarks(out, str(found.attrs["remarks"]).splitlines())
