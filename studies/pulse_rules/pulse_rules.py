"""What counts as a peak, and what does a prediction from pulses hold? ``python pulse_rules.py FOLDER``.

Writes the tables (``pulse_rules.md``) and a figure into the folder, and prints the tables, in two minutes. Needs dcfp only.
"""

import sys
import time
from collections.abc import Sequence
from pathlib import Path

import ablation
import cases
import figure
import held_out
import numpy as np
import one_pulse
import rules
import tables
from awkward import awkward
from reports import Report, amplifications, energies, named, plateau

import dcfp
from dcfp.analysis import Response
from dcfp.inference.case import Case
from dcfp.inference.refit import average_slope, change_ratio, fall_ratio, refit_as_paper, refit_by_squares
from dcfp.inference.statistics import displacement_over_change
from dcfp.methods import find_nodes, find_pulses
from dcfp.methods.li_2020.constants import DESIGN
from dcfp.methods.nodes import TOLERANCE
from dcfp.methods.pulse_march import PARTS
from dcfp.methods.pulses import THRESHOLD


def march(report: Report, many: Sequence[Response], group: Sequence[Case]) -> dict:
    """Report what is in the march and how fine it must be; return what the figure shows."""
    inputs = [case.analysed.whole.input_velocity for case in group]
    shown = {}
    for threshold in (THRESHOLD, 0.05):
        pulses = [find_pulses(one.motion, threshold) for one in many]
        shown[threshold] = ablation.ladder(pulses, many, inputs)
        report(f"Parts of the march, peaks of {threshold:g} PGV", tables.ladder(shown[threshold]))
    rows = []
    nodes = [find_nodes(one.motion) for one in many]
    for parts in (*ablation.PARTS, 96):
        mean, most = ablation.own_against_package(nodes, parts)
        rows.append([str(parts), f"{100 * mean:+.2f} %", f"{100 * most:.2f} %"])
    report("The study's march over the package's, dy", tables.table(["steps", "mean", "largest"], rows))
    themselves = ablation.records_themselves(many, inputs)
    report("The record itself with simpler friction", tables.ladder(themselves))
    fine = {(t, PARTS): ablation.fineness(t, PARTS, many, inputs) for t in ablation.TOLERANCES}
    steps = {(TOLERANCE, p): ablation.fineness(TOLERANCE, p, many, inputs) for p in ablation.PARTS}
    report("Tolerance and steps of the march", tables.fineness(fine), tables.fineness(steps))
    calls = {name: f"{1e6 * one:.0f} us" for name, one in ablation.call_times(many).items()}
    report("Times", f"Whole calls: {calls}")
    return {"ladder": shown[0.05] | themselves, "march": {t: one for (t, _), one in fine.items()}}


def constants(report: Report, group: Sequence[Case]) -> None:
    """Report the refitted constants of all cases and of each PGV, and y_max over dy_max."""
    rows, places = [], []
    for words, some in (("all", group), *((f"{g[0].pgv / 1e3:.2f}", g) for g in held_out.by_pgv(group))):
        slope = f"{average_slope(some):.0f}" if words in ("all", "0.25") else ""
        simplified, design = refit_by_squares(some), refit_by_squares(some, method=DESIGN)
        texts = [slope, f"{change_ratio(some):.2f}", f"{fall_ratio(some):.2f}"]
        texts += [f"{simplified.average_slope:.0f}", f"{simplified.fall_ratio:.2f}"]
        rows.append([words, *texts, f"{design.change_ratio:.2f}", f"{design.fall_ratio:.2f}"])
        ratio = displacement_over_change(some)
        low, middle, high = np.quantile(ratio, [0.05, 0.5, 0.95])
        places.append(
            [
                words,
                *(f"{x:.2f}" for x in (low, middle, high, ratio.max())),
                f"{100 * (ratio > 1).mean():.0f} %",
            ]
        )
    stricter = cases.with_peak_within(group)
    unmatched = sum(case.analysed.pulse is None for case in stricter)
    words = f"All, as the paper: {refit_as_paper(group)}"
    least = f"With the peak within the swing: kg_ave {average_slope(stricter):.0f}, {unmatched} unmatched"
    events = f"{len({case.event for case in group})} earthquakes"
    head = ["PGV", "kg_ave", "zeta", "eps", "kg_ave, least squares", "eps", "zeta, least squares", "eps"]
    report("Refitted constants", tables.table(head, rows), words, least, events)
    report("y_max over dy_max", tables.table(["PGV", "5 %", "median", "95 %", "largest", "above 1"], places))


def main(folder: Path) -> None:
    """Compute everything."""
    began = time.perf_counter()
    folder.mkdir(parents=True, exist_ok=True)
    report = Report()
    stored = cases.stored()
    few = cases.analyses([dcfp.load_motion(name) for name in cases.NAMED])
    many = cases.analyses([one.motion for one in stored])
    found = {name: cases.marks(rule, few, many) for name, rule in rules.candidates().items()}
    report("Rules", tables.rules(found))
    plateau(report, few, many)
    own, group = (cases.cases_by(find_pulses, some) for some in (few, many))
    named(report, own)
    energies(report, {"four records": own, "hundred": group}, few)
    amplifications(report, group)
    awkward(report, many)
    ratios = (0.2, 0.4, 0.6, 0.8, 0.9, 1.0, 1.2, 1.4)
    report("One pulse", tables.waves({ratio: one_pulse.wave(ratio) for ratio in ratios}))
    shown = march(report, many, group)
    thresholds = {part: found[f"turns back by {part:g} PGV"] for part in rules.THRESHOLDS}
    figure.draw(folder / "prediction_parts.png", shown["ladder"], shown["march"], thresholds)
    constants(report, group)
    report("Intervals for 90 %, held-out halves", tables.coverages(held_out.coverages(group)))
    report("Refitted, held-out halves", tables.refits(held_out.refits(group)))
    report("Classes, held-out halves", tables.by_class(held_out.by_class(group, stored)))
    (folder / "pulse_rules.md").write_text("\n\n".join(report.parts) + "\n", encoding="utf-8")
    print(f"{time.perf_counter() - began:.0f} s")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python pulse_rules.py FOLDER")
    main(Path(sys.argv[1]))
