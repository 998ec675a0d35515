"""What is reported of the paper's own records and of the rules."""

from collections.abc import Sequence
from functools import partial

import cases
import numpy as np
import rules
import tables

from dcfp.analysis import Response
from dcfp.inference.case import Case
from dcfp.inference.statistics import scatter
from dcfp.methods import find_pulses
from dcfp.methods.li_2020.constants import PRINTED_ROUNDING, PULSE
from dcfp.methods.method import Variant


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
                found = cases.view_ratios(some, Variant(PULSE, basis))
                texts = []
                for values in found[1:]:
                    one = scatter(values)
                    texts += [
                        f"{one.least:.2f}–{one.largest:.2f}",
                        f"{one.bias:.2f}",
                        f"{one.dispersion:.3f}",
                    ]
                number = cases.inside(some, Variant(PULSE, basis), PRINTED_ROUNDING)
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
        found = cases.view_ratios(group, Variant(method, cases.BASES[0]))
        for case, values in zip(group, found.T, strict=True):
            texts = [f"{value:.2f}" for value in (*values, *cases.friction_ratios(case))]
            rows.append([f"{case.record} at {case.pgv / 1e3:.2f} m/s, {method}", *texts])
    head = ["", "dy", "V_dE", "V_dEhr", "ku/kg, blind", "ku/kg, informed"]
    report("The four records, blind", tables.table(head, rows))
