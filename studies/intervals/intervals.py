"""Do the intervals of a prediction hold on earthquakes that are in no set? ``python intervals.py RECORDS FOLDER``.

`RECORDS` is a folder of accelerograms in any format that `dcfp` reads, of other sets than FEMA P-695. Writes what is derived from each of them (``facts.csv``) and the tables (``intervals.md``) into
`FOLDER`, and prints the tables, in three minutes for 75 records. The facts that are kept beside this script are those of 73 old PEER records and two of the Kobe earthquake.
"""

import csv
import math
import sys
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import NamedTuple

import numpy as np

import dcfp
from dcfp.inference import coverage as judging
from dcfp.inference.case import Case, compare
from dcfp.inference.conditional import Experience, of_record
from dcfp.inference.forecast import blind_variants, calibration_set
from dcfp.inference.statistics import errors, interval
from dcfp.methods.method import Variant
from dcfp.methods.prediction import Methods
from dcfp.methods.pulses import CHANGE, DISPLACEMENT, TOTAL, value_of
from dcfp.motion.load import load_horizontal
from dcfp.motion.named import VELOCITIES
from dcfp.schema.quantities import Quantity

QUANTITIES = (CHANGE, DISPLACEMENT, TOTAL)
METHODS = Methods()
SPLITS = 60


class View(NamedTuple):
    """What an interval is from: its name, the method, and whether the spectrum is known."""

    name: str
    variant: Variant | None
    spectrum: bool


VIEWS = [
    View("PGV only", None, False),
    View("PGV and spectrum", None, True),
    *(View(one.method, one, True) for one in blind_variants()),
]


def read(folder: Path) -> list[dcfp.GroundMotion]:
    """Return the horizontal components of a folder; what cannot be taken as one is told and left out."""
    motions: list[dcfp.GroundMotion] = []
    for path in sorted(folder.iterdir()):
        try:
            motions.append(load_horizontal(path))
        except dcfp.InputError as error:
            print(f"left out: {error}", file=sys.stderr)
    return motions


def in_halves(groups: Sequence[Sequence[Case]], view: View, quantity: Quantity) -> list[str]:
    """Return, for each PGV, how many are inside in percent and how wide the intervals are, over random halves by earthquake."""
    found = [
        judging.coverage([cases], view.variant, quantity, METHODS if view.spectrum else None)
        for cases in groups
    ]
    return [f"{100.0 * one.mean:.0f} ({one.width:.2f})" for one in found]


def on_others(
    groups: Sequence[tuple[Sequence[Case], Sequence[Case]]], view: View, quantity: Quantity
) -> list[str]:
    """Return the same of the other set's records, with intervals from the hundred components of FEMA P-695."""
    return [_of_others(*pair, view, quantity) for pair in groups]


def _of_others(known: Sequence[Case], others: Sequence[Case], view: View, quantity: Quantity) -> str:
    experience, inside, widths = Experience.of_cases(known, METHODS), [], []
    off = errors(known, view.variant, quantity)
    for case in others:
        analysed = value_of(case.analysed.whole, quantity)
        said = 1.0 if view.variant is None else value_of(case.predicted[view.variant], quantity)
        if not (analysed > 0.0 and said > 0.0) or case.motion is None:
            continue
        if view.spectrum:
            found = experience.interval(off, quantity, of_record(case.motion, experience.periods), said)
            if found is None:
                continue
            about = found[0]
        else:
            about = interval(off, said)
        inside.append(about.low <= analysed <= about.high)
        widths.append(math.log(about.high / about.low))
    return f"{100.0 * np.mean(inside):.0f} ({math.exp(np.mean(widths)):.2f})" if inside else "–"


def table(title: str, rows: Sequence[Sequence[str]]) -> str:
    """Return a Markdown table of a line for each quantity and view."""
    head = ["from", "quantity", *(f"{pgv / 1e3:g} m/s" for pgv in VELOCITIES)]
    lines = [head, ["---"] * len(head), *rows]
    return f"## {title}\n\n" + "\n".join("| " + " | ".join(row) + " |" for row in lines)


def facts(cases: Sequence[Case], experience: Experience) -> list[dict[str, object]]:
    """Return what is derived from each record at one PGV: what the analysis gives, and what its errors are regressed on."""
    return [
        {
            "record": case.record, "event": case.event, "pgv_m_s": f"{case.pgv / 1e3:.6g}",
            **{one.key: f"{value_of(case.analysed.whole, one):.5g}" for one in QUANTITIES},
            **{f"ln_{name}": f"{value:.4f}" for name, value in zip(("sv_short", "sv_long", "lasting"), known, strict=True)},
            **{f"{view.name} {one.key}": f"{value_of(case.predicted[view.variant], one):.5g}" for view in VIEWS if view.variant for one in QUANTITIES},
        }
        for case, known in zip(cases, experience.known, strict=True)
    ]  # fmt: skip


def main(records: Path, folder: Path) -> None:
    """Compute everything."""
    folder.mkdir(parents=True, exist_ok=True)
    judging.grouped_splits = partial(judging.grouped_splits, splits=SPLITS)
    of_set, others = calibration_set(), read(records)
    analysed = [
        ([compare(one.scaled_to_pgv(pgv), METHODS) for one in of_set], [compare(one.scaled_to_pgv(pgv), METHODS) for one in others])
        for pgv in VELOCITIES
    ]  # fmt: skip
    together = [[*known, *new] for known, new in analysed]
    pairs = [
        (view, quantity)
        for view in VIEWS
        for quantity in QUANTITIES
        if np.isfinite(errors(together[0], view.variant, quantity)).any()
    ]
    parts = [
        table(
            f"Halves by earthquake of {len(together[0])} components: inside in percent (upper over lower end)",
            [[view.name, one.title, *in_halves(together, view, one)] for view, one in pairs],
        ),
        table(
            f"{len(others)} components of other sets, from FEMA P-695",
            [[view.name, one.title, *on_others(analysed, view, one)] for view, one in pairs],
        ),
    ]
    text = "\n\n".join(parts) + "\n"
    print(text)
    (folder / "intervals.md").write_text(text, encoding="utf-8")
    rows = [row for known, new in analysed for row in facts(new, _read_as(known, new))]
    with (folder / "facts.csv").open("w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def _read_as(known: Sequence[Case], new: Sequence[Case]) -> Experience:
    """Return the experience of new cases, their spectra read at the periods of the known ones."""
    periods = Experience.of_cases(known, METHODS).periods
    return Experience(
        [case.event for case in new],
        periods,
        np.array([of_record(case.motion, periods) for case in new if case.motion]),
    )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: python intervals.py RECORDS FOLDER")
    main(Path(sys.argv[1]), Path(sys.argv[2]))
