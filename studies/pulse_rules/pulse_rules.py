"""What counts as a peak, and what does a prediction from pulses hold? ``python pulse_rules.py FOLDER``.

Writes the tables (``pulse_rules.md``) and a figure into the folder, and prints the tables, in two minutes. Needs dcfp only.
"""

import sys
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path

import ablation
import cases
import figure
import held_out
import numpy as np
import one_pulse
import rules
import tables

import dcfp
from dcfp.comparison.case import Case, Method
from dcfp.comparison.refit import (
    average_slope,
    change_ratio,
    fall_ratio,
    refit_as_paper,
    refit_design,
    refit_simplified,
)
from dcfp.comparison.statistics import displacement_over_change, scatter
from dcfp.prediction import find_pulses
from dcfp.prediction.pulse_march import PARTS
from dcfp.prediction.pulses import THRESHOLD
from dcfp.response import Response


class Report:
    """Prints, and keeps what it printed."""

    def __init__(self) -> None:
        self.parts: list[str] = []

    def __call__(self, heading: str, *paragraphs: str) -> None:
        """Report paragraphs under a heading."""
        text = "\n\n".join((f"## {heading}", *paragraphs))
        self.parts.append(text)
        print(text + "\n", flush=True)


def plateau(report: Report, few: Sequence[Response], many: Sequence[Response]) -> None:
    """Report the number of ratios within the paper's ranges for thresholds close together, and where prominence differs."""
    rows = []
    for percent in range(8, 34, 2):
        one = cases.marks(partial(find_pulses, threshold=percent / 100.0), few, many)
        rows.append([f"{percent / 100.0:.2f}", *map(str, one.inside.values()), f"{one.slope_of_all:.0f}"])
        rows[-1] += [f"{one.change.dispersion:.3f}", f"{one.change_simplified.dispersion:.3f}"]
    head = ["threshold", *(f"{m}, {b}" for m in cases.RANGES for b in cases.BASES)]
    head += ["kg, 100", "disp. dy", "disp. simpl."]
    differ = sum(
        not np.array_equal(find_pulses(one.motion, part).times, rules.by_prominence(one.motion, part).times)
        for one in many
        for part in (0.1, 0.2, 0.3)
    )
    words = f"Prominence gives other peaks than turning back in {differ} of {3 * len(many)} cases."
    report("Thresholds close together", tables.table(head, rows), words)


def energies(report: Report, groups: dict[str, list[Case]], few: Sequence[Response]) -> None:
    """Report the ranges with the factor of 1.5 in all equations and in Eq. (20) only."""
    rows = []
    for words, group in groups.items():
        for kind, some in (("all", group), ("Eq. (20)", cases.without_amplified_energies(group))):
            for basis in cases.BASES:
                found = cases.view_ratios(some, (Method.PULSE, basis))
                texts = []
                for values in found[1:]:
                    one = scatter(values)
                    texts += [
                        f"{one.least:.2f}–{one.largest:.2f}",
                        f"{one.bias:.2f}",
                        f"{one.dispersion:.3f}",
                    ]
                number = cases.inside(some, (Method.PULSE, basis), cases.ROUNDED)
                rows.append([f"{words}, {kind}, {basis}", *texts, f"{number} of {found.size}"])
    head = ["factor in", "V_dE", "bias", "disp.", "V_dEhr", "bias", "disp.", "within, rounded"]
    net = scatter(cases.against_net_input(groups["four records"], few))
    words = f"{net.least:.2f}–{net.largest:.2f}, bias {net.bias:.2f}, dispersion {net.dispersion:.3f}"
    words = f"V_dE of the four records, blind, over the input of whole swings, Eq. (15): {words}"
    report("Factor of 1.5: all equations or Eq. (20) only", tables.table(head, rows), words)


def amplifications(report: Report, group: Sequence[Case]) -> None:
    """Report other factors than 1.5 and other limits than 0.8."""
    rows = []
    for factor, limit in ((1.0, 0.8), (1.1, 0.8), (1.2, 0.8), (1.3, 0.8), (1.5, 0.8), (1.5, 0.9), (1.2, 0.6)):
        change, energy = cases.with_amplification(group, factor, limit)
        texts = [f"{value:.3f}" for one in (change, energy) for value in (one.bias, one.dispersion)]
        rows.append([f"{factor:g} from {limit:g}", *texts])
    head = ["factor", "bias dy", "disp. dy", "bias V_dE", "disp. V_dE"]
    report("Other factors, 400 cases, blind", tables.table(head, rows))


def named(report: Report, group: Sequence[Case]) -> None:
    """Report the ratios of the paper's records one by one."""
    rows = []
    for method in cases.RANGES:
        found = cases.view_ratios(group, (method, cases.BASES[0]))
        for case, values in zip(group, found.T, strict=True):
            texts = [f"{value:.2f}" for value in values]
            rows.append([f"{case.record} at {case.pgv / 1e3:.2f} m/s, {method}", *texts])
    report("The four records, blind", tables.table(["", "dy", "V_dE", "V_dEhr"], rows))


def march(report: Report, many: Sequence[Response], group: Sequence[Case]) -> dict:
    """Report what is in the march and how fine it must be; return what the figure shows."""
    inputs = [case.analysed.whole.input_velocity for case in group]
    shown = {}
    for threshold in (THRESHOLD, 0.05, 0.01):
        pulses = [find_pulses(one.motion, threshold) for one in many]
        shown[threshold] = ablation.ladder(pulses, many, inputs)
        report(f"Parts of the march, peaks of {threshold:g} PGV", tables.ladder(shown[threshold]))
    rows = []
    for parts in (*ablation.PARTS, 96):
        mean, most = ablation.own_against_package([find_pulses(one.motion, 0.05) for one in many], parts)
        rows.append([str(parts), f"{100 * mean:+.2f} %", f"{100 * most:.2f} %"])
    report("The study's march over the package's, dy", tables.table(["steps", "mean", "largest"], rows))
    themselves = ablation.records_themselves(many, inputs)
    report("The record itself with simpler friction", tables.ladder(themselves))
    fine = {(t, PARTS): ablation.fineness(t, PARTS, many, inputs) for t in ablation.THRESHOLDS}
    steps = {(t, p): ablation.fineness(t, p, many, inputs) for t in (0.01, 0.02, 0.05) for p in (2, 4, 6, 24)}
    report("Threshold and steps of the march", tables.fineness(fine), tables.fineness(steps))
    elapsed = 1e6 * np.array([one.elapsed for one in many])
    words = f"Compiled code of the analysis: mean {elapsed.mean():.0f} us, median {np.median(elapsed):.0f} us"
    calls = {name: f"{1e6 * one:.0f} us" for name, one in ablation.call_times(many).items()}
    report("Times", words, f"Whole calls: {calls}")
    return {"ladder": shown[0.05] | themselves, "march": {t: one for (t, _), one in fine.items()}}


def constants(report: Report, group: Sequence[Case]) -> None:
    """Report the refitted constants of all cases and of each PGV, and y_max over dy_max."""
    rows, places = [], []
    for words, some in (("all", group), *((f"{g[0].pgv / 1e3:.2f}", g) for g in held_out.by_pgv(group))):
        slope = f"{average_slope(some):.0f}" if words in ("all", "0.25") else ""
        simplified, design = refit_simplified(some), refit_design(some)
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
    head = ["PGV", "kg_ave", "zeta", "eps", "kg_ave, least squares", "eps", "zeta, least squares", "eps"]
    report("Refitted constants", tables.table(head, rows), f"All, as the paper: {refit_as_paper(group)}")
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
