"""``dcfp compare`` of stations: predictions against the analysis in the plane."""

import argparse
from collections.abc import Sequence
from typing import Any

from dcfp.doors.cli import inputs
from dcfp.doors.cli.console import Block, Page, each, grid, grouped
from dcfp.doors.cli.outputs import Answer
from dcfp.doors.cli.predict_plane import NOTES, figure_of
from dcfp.errors import InputError
from dcfp.inference.plane_comparison import (
    compare_station,
    comparison_lines,
    comparison_objects,
    comparison_scatter,
)
from dcfp.methods.prediction import Methods
from dcfp.motion.station import Station

#: Most stations and PGVs that are printed one by one.
_MOST_CASES = 8


def run(
    chosen: argparse.Namespace,
    stations: Sequence[Station],
    methods: Methods,
    above: list[tuple[str, str]],
) -> Answer:
    """Analyse and predict every station at every PGV; `above` stands above the tables."""
    if chosen.held_out:
        msg = "--held-out is for single components, such as P695; compare stations without it (dcfp predict STATION --interval has intervals)."
        raise InputError(msg)
    moved = inputs.scaled(stations, chosen.pgv)
    figure = figure_of(chosen, moved, methods)
    cases = each("comparisons", moved, lambda station: compare_station(station, methods))
    table = comparison_scatter(cases)

    def document() -> dict[str, Any]:
        return {"cases": comparison_objects(cases), "scatter": table.objects(), "held_out": None}

    def page() -> Page:
        blocks: list[Block] = [above]
        if len(cases) <= _MOST_CASES:
            blocks.append(grid(comparison_lines(cases), 2))
        if len(cases) > 1:
            blocks.append(("Prediction over the analysis in the plane:", grid(table, repeated=2)))
        told = grouped((one.analysed.station.name, remark) for one in cases for remark in one.remarks)
        return Page(blocks, [*told, *NOTES, *_SCATTER])

    return Answer(document, page, lambda part, kind: comparison_lines(cases).csv(), figure)


_SCATTER = (
    "Ratios are prediction over analysis, of y_max for a method without one that of its dy. Bias: geometric mean; Dispersion: standard deviation of the natural logarithm; Below: share of all cases"
    " with a prediction below the analysis; Without: nothing moves by the method, which counts as below and nowhere else.",
)
