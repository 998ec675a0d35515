"""Fragility from the results of a study: how probable it is that a capacity is exceeded, over the intensity."""

import argparse
import json
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli.parser import Numbers, Parser, fraction, not_negative, positive, whole_number
from dcfp.doors.cli.study import reading
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

    from dcfp.present.tables.columns import Column

#: Capacities up to which the observed fractions are printed.
_MOST_PRINTED = 4


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    reading.add_store(parser)
    parser.add_argument(
        "--capacity",
        action=Numbers,
        check=positive("mm, or of the unit of the quantity"),
        metavar="MM",
        help="one or several [mm]; default the displacement capacity of the study's bearing",
    )
    reading.add_quantity(parser)
    parser.add_argument(
        "--further-dispersion",
        action=Numbers,
        check=not_negative("dispersion", 2.0),
        metavar="BETA",
        help="further dispersions, of design and model for example, added as the root of the sum of squares [-]",
    )
    parser.add_argument(
        "--confidence",
        type=fraction(),
        default=0.9,
        metavar="PART",
        help="part of the draws of earthquakes inside the bounds [-]; default 0.9",
    )
    parser.add_argument(
        "--seed",
        type=whole_number(0, 2**31 - 1),
        default=2015,
        metavar="N",
        help="of the draws of earthquakes; default 2015",
    )
    reading.add_output(parser, "the curve of every capacity with its bounds")


def run(chosen: argparse.Namespace) -> int:
    """Fit the fragilities, and print their medians and dispersions."""
    outputs = reading.checked_outputs(chosen)
    from dcfp.study.assessment import fragility

    further: list[float] = chosen.further_dispersion or []
    found = fragility(
        reading.opened(chosen),
        chosen.capacity,
        chosen.quantity,
        further_dispersions={f"given {i + 1}": value for i, value in enumerate(further)},
        confidence=chosen.confidence,
        seed=chosen.seed,
        unfinished=chosen.unfinished,
    )

    def draw() -> "Figure":
        from dcfp.present.figures.assessment import plot_fragility

        figure: Any = plot_fragility(found).figure
        return figure

    reading.write(outputs, _columns(found), _curve_rows(found), draw)
    rows = _rows(found)
    if chosen.json:
        told = reading.document(
            found,
            rows,
            quantity=chosen.quantity,
            confidence=chosen.confidence,
            draws=found.attrs["draws"],
            seed=chosen.seed,
            records=found.attrs["records"],
            earthquakes=found.attrs["earthquakes"],
        )
        print(json.dumps(told, indent=2, allow_nan=False))
    else:
        _print(found, rows)
    return 0


def _capacity(found: "xarray.Dataset") -> "xarray.DataArray":
    """Return the capacities under the name of the quantity, whose unit they have."""
    return found["capacity"].rename(str(found.attrs["quantity"]))


def _rows(found: "xarray.Dataset") -> list[dict[str, Any]]:
    intensity = found[str(found.attrs["intensity"])]
    unit = reading.key(intensity).removeprefix(str(intensity.name))
    rows: list[dict[str, Any]] = []
    for i, capacity in enumerate(found["capacity"].to_numpy().tolist()):
        one = found.isel(capacity=i)
        rows.append(
            {
                f"capacity{reading.key(_capacity(found)).removeprefix(str(found.attrs['quantity']))}": capacity,
                f"median{unit}": reading.keyed(intensity, one["median"]),
                f"median_bounds{unit}": [
                    reading.keyed(intensity, end) for end in one["median_bound"].to_numpy()
                ],
                "dispersion": _known(one["dispersion"]),
                "dispersion_bounds": [_known(end) for end in one["dispersion_bound"].to_numpy()],
                "total_dispersion": _known(one["total_dispersion"]),
                "observed": [
                    {reading.key(intensity): reading.keyed(intensity, at), "fraction": _known(part)}
                    for at, part in zip(intensity.to_numpy(), one["fraction"].to_numpy(), strict=True)
                ],
            }
        )
    return rows


def _known(value: Any) -> float | None:
    number = float(value)
    return number if number == number else None


def _columns(found: "xarray.Dataset") -> "list[Column]":
    from dcfp.present.tables.columns import Column

    intensity = reading.column(found[str(found.attrs["intensity"])])
    return [
        Column("capacity", "capacity", str(found["capacity"].attrs.get("units", ""))),
        Column("at", intensity.name, intensity.unit),
        *(Column(name, name, "1") for name in ("probability", "low", "high")),
    ]


def _curve_rows(found: "xarray.Dataset") -> list[dict[str, Any]]:
    name = str(found.attrs["intensity"])
    points = found[f"{name}_of_curve"].to_numpy().tolist()
    rows: list[dict[str, Any]] = []
    for i, capacity in enumerate(found["capacity"].to_numpy().tolist()):
        one = found.isel(capacity=i)
        low, high = one["probability_bound"].to_numpy().tolist()
        for at, *parts in zip(points, one["probability"].to_numpy().tolist(), low, high, strict=True):
            values = dict(zip(("probability", "low", "high"), map(_known, parts), strict=True))
            rows.append({"capacity": capacity, "at": reading.keyed(found[name], at), **values})
    return rows


def _print(found: "xarray.Dataset", rows: list[dict[str, Any]]) -> None:
    intensity = found[str(found.attrs["intensity"])]
    factor = reading.shown_factor(intensity)
    unit = reading.head(intensity).partition("\n")[2]
    capacity = reading.head(_capacity(found)).partition("\n")[2]
    table = new_table(
        [],
        [
            f"capacity\n{capacity}",
            f"median\n{unit}",
            f"bounds\n{unit}",
            "beta\n[-]",
            "bounds\n[-]",
            "total beta\n[-]",
        ],
    )
    for i in range(len(rows)):
        one = found.isel(capacity=i)
        cells = [
            reading.number(float(one["capacity"]) * reading.shown_factor(_capacity(found))),
            reading.number(float(one["median"]) * factor),
            _between(one["median_bound"], factor),
            reading.number(float(one["dispersion"]), 3),
            _between(one["dispersion_bound"], 1.0),
            reading.number(float(one["total_dispersion"]), 3),
        ]
        add_row(table, cells)
    with page() as out:
        print_labelled(
            out,
            [
                *reading.study_lines(found),
                (
                    "Question",
                    f"at which intensity {found.attrs['quantity'].replace('_', ' ')} exceeds the capacity",
                ),
                ("From", f"{found.attrs['records']} records of {found.attrs['earthquakes']} earthquakes"),
            ],
        )
        out.print()
        out.print(table)
        if found.sizes["capacity"] <= _MOST_PRINTED:
            out.print()
            out.print(_observed(found))
        part = f"{100.0 * found.attrs['confidence']:g} %"
        bounds = f"Bounds hold {part} of {found.attrs['draws']} draws of whole earthquakes with replacement."
        print_remarks(out, [*str(found.attrs["remarks"]).splitlines(), bounds])


def _between(ends: "xarray.DataArray", factor: float) -> str:
    low, high = (reading.number(float(end) * factor, 3) for end in ends.to_numpy())
    return "–" if low == "–" else f"{low} to {high}"


def _observed(found: "xarray.Dataset") -> Any:
    """Return a table of the fractions that are observed, and of the probabilities that are fitted."""
    from dcfp.study.assessment.fragility_fit import lognormal_probability
    from dcfp.study.assessment.selection import shown_value

    intensity = found[str(found.attrs["intensity"])]
    heads: list[str] = []
    columns: list[list[float]] = []
    for i in range(found.sizes["capacity"]):
        one = found.isel(capacity=i)
        name = shown_value(_capacity(found), one["capacity"].item())
        heads += [f"{name}:\nobserved", "\nfitted"]
        fitted = lognormal_probability(
            intensity.to_numpy(), float(one["median"]), float(one["total_dispersion"])
        )
        columns += [one["fraction"].to_numpy().tolist(), fitted.tolist()]
    table = new_table([], [reading.head(intensity), *heads])
    for at, *cells in zip(intensity.to_numpy().tolist(), *columns, strict=True):
        parts = ["–" if cell != cell else f"{cell:.3f}" for cell in cells]
        add_row(table, [f"{at * reading.shown_factor(intensity):.4g}", *parts])
    return table
