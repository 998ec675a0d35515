"""Design chart from the results of a study: which radius and friction hold a displacement at a PGV."""

import argparse
import json
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.doors.cli.parser import Parser, positive
from dcfp.doors.cli.study import reading
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks
from dcfp.errors import InputError

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

    from dcfp.inference.design_space import DesignSpace
    from dcfp.present.tables.columns import Column

_KILO = 1e3
#: Probabilities for which the least coefficient is given [-], where there are enough records.
_PARTS = (0.5, 0.95)


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    reading.add_store(parser)
    parser.add_argument(
        "--pgv",
        type=positive("m/s", 1e-3, 20.0),
        metavar="M_PER_S",
        help="which PGV of the study; not needed where it has only one",
    )
    parser.add_argument(
        "--allow",
        type=positive("mm", 1.0, 1e4),
        required=True,
        metavar="MM",
        help="the displacement that is to hold [mm]",
    )
    reading.add_output(parser, "the least coefficient for every radius")


def run(chosen: argparse.Namespace) -> int:
    """Find which bearings hold the displacement, and print and draw them."""
    outputs = reading.checked_outputs(chosen)
    from dcfp.study.assessment import design_space
    from dcfp.study.assessment.design_chart import at_pgv

    dataset = at_pgv(reading.opened(chosen), None if chosen.pgv is None else chosen.pgv * _KILO)
    space = design_space(dataset, unfinished=chosen.unfinished)
    rows = _rows(space, chosen.allow)

    def draw() -> "Figure":
        from dcfp.present.figures.design_chart import plot_design_chart

        return plot_design_chart([space], chosen.allow)

    reading.write(outputs, _columns(rows), rows, draw)
    remarks = _remarks(dataset, space, chosen.allow)
    if chosen.json:
        told = reading.document(dataset, rows, allowed_mm=chosen.allow, records=space.records)
        print(json.dumps(told | {"remarks": remarks}, indent=2, allow_nan=False))
    else:
        _print(dataset, space, chosen.allow, rows, remarks)
    return 0


def _parts(space: "DesignSpace") -> list[float]:
    return [part for part in _PARTS if part * (space.records + 1) <= space.records]


def _rows(space: "DesignSpace", allowed: float) -> list[dict[str, Any]]:
    found = {part: [values.tolist() for values in space.holding(allowed, part)] for part in _parts(space)}
    rows: list[dict[str, Any]] = []
    for i, radius in enumerate(space.radii.tolist()):
        row: dict[str, Any] = {"pgv_m_s": space.pgv / _KILO, "radius_mm": radius}
        for part, values in found.items():
            row |= {key: _known(one[i]) for key, one in zip(_keys(part), values, strict=True)}
        rows.append(row)
    return rows


def _keys(part: float) -> tuple[str, str]:
    """Return the names of coefficient and force that hold with a probability."""
    return f"least_coefficient_{100 * part:g}_percent", f"force_over_weight_{100 * part:g}_percent"


def _known(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _columns(rows: list[dict[str, Any]]) -> "list[Column]":
    from dcfp.present.tables.columns import Column

    units = {"pgv_m_s": "m s-1", "radius_mm": "mm"}
    return [Column(key, key, units.get(key, "1")) for key in rows[0]]


def _remarks(dataset: "xarray.Dataset", space: "DesignSpace", allowed: float) -> list[str]:
    from dcfp.study.assessment.completeness import remarks_of

    remarks = remarks_of(dataset)
    left_out = dataset.sizes.get("record", 1) - space.records
    if left_out:
        remarks.append(f"{left_out} records without a result on every bearing are left out.")
    remarks.append(
        "mu: the least reference coefficient from which on y_max stays below for that part of the records, between the bearings of the study on straight"
        f" lines, and the horizontal force over the weight that goes with it; – where no coefficient, up to {space.coefficients[-1]:g}, is enough."
    )
    if _PARTS[-1] not in _parts(space):
        remarks.append(f"What 95 % do not exceed needs more than {space.records} records.")
    else:
        remarks.append(_spread(space, allowed))
    if "lambda" in dataset.coords and float(dataset["lambda"]) != 1.0:
        remarks.append(f"mu is before the property factor lambda of {float(dataset['lambda']):g}.")
    return remarks


def _spread(space: "DesignSpace", allowed: float) -> str:
    """Return how sure the coefficients are."""
    try:
        low, high = space.spread(allowed, _PARTS[-1])
    except InputError:  # a draw of earthquakes has fewer records than the study
        return f"How sure mu, 95 %, is cannot be said from {space.records} records."
    told = (
        f"Other earthquakes of the same kind would give a mu, 95 %, mean of the radii, between {low:.3g} and {high:.3g} (earthquakes drawn"
        " with replacement, 5 to 95 %)"
    )
    most = float(space.coefficients[-1])
    enough = np.isfinite(space.holding(allowed, _PARTS[-1])[0]).all() and high < most
    return f"{told}." if enough else f"{told}; where none is enough, {most:g} counts, which is too low."


def _print(
    dataset: "xarray.Dataset",
    space: "DesignSpace",
    allowed: float,
    rows: list[dict[str, Any]],
    remarks: list[str],
) -> None:
    words = {0.5: "half", 0.95: "95 %"}
    heads = [
        head for part in _parts(space) for head in (f"mu, {words[part]}\n[-]", f"F/W, {words[part]}\n[-]")
    ]
    table = new_table([], ["Radius\n[mm]", *heads])
    for row in rows:
        cells: list[str] = []
        for part in _parts(space):
            coefficient, force = (row[key] for key in _keys(part))
            at_most = "≤ " if coefficient == float(space.coefficients[0]) else ""
            cells += [f"{at_most}{reading.number(coefficient, 3)}", reading.number(force, 3)]
        add_row(table, [f"{row['radius_mm']:.0f}", *cells])
    with page() as out:
        print_labelled(
            out,
            [
                *reading.study_lines(dataset),
                ("Question", f"which friction and radius hold y_max to {allowed:g} mm"),
                ("From", f"{space.records} records of {len(set(space.events))} earthquakes"),
            ],
        )
        out.print()
        out.print(table)
        print_remarks(out, remarks)
