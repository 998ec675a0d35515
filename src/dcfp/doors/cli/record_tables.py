"""The tables of `dcfp records`."""

from typing import TYPE_CHECKING

from dcfp.constants import STANDARD_GRAVITY
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dcfp.doors.cli.records import Described
    from dcfp.motion.named import NamedRecord


def print_named(rows: "Sequence[NamedRecord]") -> None:
    """Print the list of named records."""
    table = new_table(
        ["Record", "In P-695"],
        ["dt\n[s]", "length\n[s]", "PGA\n[g]", "PGV\n[m/s]", "M\n[-]"],
        ["Event", "Station"],
    )
    for row in rows:
        add_row(
            table,
            [
                row.alias or row.name,
                row.name if row.alias else "",
                _shown(row.time_step, 1.0, "g"),
                _shown(row.duration, 1.0, ".1f"),
                _shown(row.peak_acceleration, 1.0 / STANDARD_GRAVITY, ".3f"),
                _shown(row.peak_velocity, 1e-3, ".3f"),
                _shown(row.magnitude, 1.0, ".1f"),
                f"{row.event} {row.year}",
                row.station,
            ],
        )
    with page() as out:
        out.print(table)
        print_remarks(out, [f"{row.name}: {row.note}." for row in rows if row.note])


def print_described(described: "Sequence[Described]") -> None:
    """Print the measures of motions, what is in their data, and what is doubtful."""
    table = new_table(
        ["Record", "Component"],
        [
            "dt\n[s]",
            "length\n[s]",
            "PGA\n[g]",
            "PGV\n[m/s]",
            "PGD\n[mm]",
            "Arias\n[m/s]",
            "D5-95\n[s]",
            "CAV\n[m/s]",
            "drift\n[%]",
        ],
    )
    for entry in described:
        found = entry.measures
        add_row(
            table,
            [
                entry.motion.name,
                entry.motion.origin.component,
                f"{entry.motion.time_step:g}",
                f"{entry.motion.duration:.1f}",
                f"{found.peak_acceleration / STANDARD_GRAVITY:.3f}",
                f"{found.peak_velocity / 1e3:.3f}",
                f"{found.peak_displacement:.1f}",
                f"{found.arias_intensity / 1e3:.2f}",
                f"{found.significant_duration:.1f}",
                f"{found.cumulative_absolute_velocity / 1e3:.2f}",
                f"{100.0 * found.baseline_drift:.1f}",
            ],
        )
    with page() as out:
        out.print(table)
        for lines in dict.fromkeys(_origin(entry) for entry in described):
            out.print()
            print_labelled(out, lines)
        print_remarks(out, [remark for entry in described for remark in entry.remarks])


def _origin(entry: "Described") -> tuple[tuple[str, str], ...]:
    origin = entry.motion.origin
    lines = (
        ("Event", origin.event),
        ("Station", origin.station),
        ("Source", f"{origin.source} ({origin.file_format})" if origin.file_format else origin.source),
        ("In the data", origin.processing or "the source does not say which baseline or filter"),
        ("Cite", origin.citation),
    )
    return tuple(line for line in lines if line[1])


def _shown(value: float | None, factor: float, form: str) -> str:
    return "" if value is None else format(value * factor, form)
