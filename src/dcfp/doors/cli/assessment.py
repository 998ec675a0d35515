"""``dcfp study ida``, ``fragility``, ``bounds``, ``sensitivity`` and ``chart``: what follows from the results of a study."""

import argparse
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from dcfp.doors.cli.console import Page, grid
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.doors.cli.study import values_in
from dcfp.errors import InputError
from dcfp.inference.design_space import PARTS, DesignSpace, held_table
from dcfp.schema.table import Table
from dcfp.study import assessment
from dcfp.study.assessment import told as tables
from dcfp.study.assessment.bounds import NOMINAL, QUANTITIES
from dcfp.study.assessment.design_chart import at_pgv
from dcfp.study.assessment.selection import described, remarks_of, select
from dcfp.study.results import INTENSITIES, OF_STATIONS, is_in_plane, open_store

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

#: Capacities up to which the observed fractions are printed.
_MOST_PRINTED = 4


def _opened(chosen: argparse.Namespace) -> "xarray.Dataset":
    """Return what is chosen of a study."""
    dataset = open_store(Path(chosen.store))
    return select(dataset, values_in(dataset, chosen.at), keep=("record", "sample", *INTENSITIES))


def _answer(
    found: "xarray.Dataset",
    question: Sequence[tuple[str, str]],
    table: Table,
    draw: "Callable[[], Figure]",
    *,
    repeated: int = 0,
    below: Table | None = None,
    csv: Table | None = None,
    remarks: Sequence[str] = (),
    **more: Any,
) -> Answer:
    """Return an answer about a study: the lines above its table, the table with `repeated` first columns, what is below it or in its place as CSV."""
    lines = [*tables.lines_of(found), *question]
    grids = [grid(table, repeated=repeated), *([] if below is None else [grid(below)])]
    return Answer(
        lambda: tables.document(found, tables.nested(table.objects()), **more),
        lambda: Page([lines, *grids], [*remarks_of(found), *remarks]),
        lambda part, kind: (csv or table).csv(),
        draw,
    )


def ida(chosen: argparse.Namespace) -> Answer:
    """Make the curves of the records, and their quantiles."""
    parts = {} if chosen.quantiles is None else {"quantiles": chosen.quantiles}
    found = assessment.ida(_opened(chosen), chosen.quantity, **parts, unfinished=chosen.unfinished)
    table = tables.ida_table(found, chosen.quantity)
    values: xarray.DataArray = found[str(chosen.quantity)]
    words = described(values).words
    question = [("Question", f"{words}: what parts of {found.sizes['record']} records do not exceed")]
    draw = drawn("assessment.plot_ida", found)
    return _answer(found, question, table, draw, quantity=chosen.quantity)


def fragility(chosen: argparse.Namespace) -> Answer:
    """Fit the fragilities."""
    further: list[float] = chosen.further_dispersion or []
    found = assessment.fragility(
        _opened(chosen),
        chosen.capacity,
        chosen.quantity,
        further_dispersions={f"given {i + 1}": value for i, value in enumerate(further)},
        confidence=chosen.confidence,
        seed=chosen.seed,
        unfinished=chosen.unfinished,
    )
    about = found.attrs
    question = [
        ("Question", f"at which intensity {about['quantity'].replace('_', ' ')} exceeds the capacity"),
        ("From", f"{about['records']} records of {about['earthquakes']} earthquakes"),
    ]
    few = found.sizes["capacity"] <= _MOST_PRINTED
    bounds = f"Bounds hold {100.0 * about['confidence']:g} % of {about['draws']} draws of whole earthquakes with replacement."
    return _answer(
        found,
        question,
        tables.fragility_table(found),
        drawn("assessment.plot_fragility", found),
        below=tables.fragility_observed(found) if few else None,
        csv=tables.fragility_curves(found),
        remarks=[bounds],
        quantity=chosen.quantity,
        confidence=chosen.confidence,
        draws=about["draws"],
        seed=chosen.seed,
        records=about["records"],
        earthquakes=about["earthquakes"],
    )


def bounds(chosen: argparse.Namespace) -> Answer:
    """Make the envelopes over property factors and temperatures."""
    dataset = _opened(chosen)
    found = assessment.bounds(
        dataset,
        chosen.over,
        {**NOMINAL, **values_in(dataset, chosen.nominal)},
        chosen.quantities or QUANTITIES,
        chosen.quantiles or (0.5, 0.84),
        unfinished=chosen.unfinished,
    )
    over, nominal = str(found.attrs["over"]), str(found.attrs["nominal"])
    question = [
        ("Question", f"between which bounds the results are over {over.replace(', ', ' and ')}"),
        ("Nominal", nominal),
    ]
    draw = drawn("assessment.plot_bounds", found)
    told: dict[str, Any] = {"over": over.split(", "), "nominal": nominal}
    return _answer(found, question, tables.bounds_table(found), draw, repeated=2, **told)


def sensitivity(chosen: argparse.Namespace) -> Answer:
    """Estimate the indices."""
    found = assessment.sensitivity(
        _opened(chosen),
        chosen.quantity,
        chosen.over_records,
        logarithm=chosen.logarithm,
        confidence=chosen.confidence,
        seed=chosen.seed,
    )
    of = "the logarithm of " if found.attrs["logarithm"] else ""
    words = str(found.attrs["quantity"]).replace("_", " ")
    question = [
        ("Question", f"from which factor the variance of {of}{words} comes"),
        ("Records", str(found.attrs["over_records"])),
    ]
    return _answer(
        found,
        question,
        tables.sensitivity_table(found),
        drawn("assessment.plot_sensitivity", found),
        repeated=found["S1"].ndim - 1,
        quantity=chosen.quantity,
        over_records=found.attrs["over_records"],
        logarithm=chosen.logarithm,
        confidence=chosen.confidence,
    )


def chart(chosen: argparse.Namespace) -> Answer:
    """Find which bearings hold the displacement."""
    dataset = at_pgv(_opened(chosen), chosen.pgv)
    space = assessment.design_space(dataset, unfinished=chosen.unfinished)
    # what a part of the records do not exceed needs enough of them
    parts = [part for part in PARTS if part * (space.records + 1) <= space.records]
    table = held_table([space], chosen.allow, parts)
    question = [
        ("Question", f"which friction and radius hold y_max to {chosen.allow:g} mm"),
        ("From", f"{space.records} records of {len(set(space.events))} earthquakes"),
    ]
    remarks = _chart_remarks(dataset, space, chosen.allow, parts)
    draw = drawn("assessment.plot_design_chart", [space], chosen.allow)
    told: dict[str, Any] = {"allowed_mm": chosen.allow, "records": space.records}
    answer = _answer(dataset, question, table, draw, remarks=remarks, **told)
    every = [*remarks_of(dataset), *remarks]
    return replace(answer, document=lambda: {**answer.document(), "remarks": every})


def _chart_remarks(
    dataset: "xarray.Dataset", space: DesignSpace, allowed: float, parts: Sequence[float]
) -> list[str]:
    left_out = dataset.sizes.get("record", 1) - space.records
    remarks = [OF_STATIONS] if is_in_plane(dataset) else []
    remarks += [f"{left_out} records without a result on every bearing are left out."] if left_out else []
    remarks.append(
        "mu: the least reference coefficient from which on y_max stays below for that part of the records, between the bearings of the study on straight"
        f" lines, and the horizontal force over the weight that goes with it; – where no coefficient, up to {space.coefficients[-1]:g}, is enough."
    )
    if PARTS[-1] in parts:
        remarks.append(_spread(space, allowed))
    else:
        remarks.append(f"What 95 % do not exceed needs more than {space.records} records.")
    if "lambda" in dataset.coords and float(dataset["lambda"]) != 1.0:
        remarks.append(f"mu is before the property factor lambda of {float(dataset['lambda']):g}.")
    return remarks


def _spread(space: DesignSpace, allowed: float) -> str:
    """Return how sure the coefficients are."""
    try:
        low, high = space.spread(allowed, PARTS[-1])
    except InputError:  # a draw of earthquakes has fewer records than the study
        return f"How sure mu, 95 %, is cannot be said from {space.records} records."
    told = (
        f"Other earthquakes of the same kind would give a mu, 95 %, mean of the radii, between {low:.3g} and {high:.3g} (earthquakes drawn"
        " with replacement, 5 to 95 %)"
    )
    most = float(space.coefficients[-1])
    enough = np.isfinite(space.holding(allowed, PARTS[-1])[0]).all() and high < most
    return f"{told}." if enough else f"{told}; where none is enough, {most:g} counts, which is too low."
