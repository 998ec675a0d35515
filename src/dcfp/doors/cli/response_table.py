"""The tables of `dcfp respond` and `dcfp records`."""

from typing import TYPE_CHECKING

from dcfp.constants import STANDARD_GRAVITY
from dcfp.doors.cli.tables import add_row, grouped, new_table, page, print_labelled, print_remarks
from dcfp.motion.measures import motion_remarks

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dcfp.analysis import Response
    from dcfp.doors.cli.records import Described
    from dcfp.motion.named import NamedRecord
    from dcfp.system import Bearing


_KILO = 1e3

_NUMBERS: "tuple[tuple[str, Callable[[Response], str]], ...]" = (
    ("PGV\n[m/s]", lambda r: f"{r.motion.peak_velocity / _KILO:.3f}"),
    ("y_max\n[mm]", lambda r: f"{r.peak_displacement:.1f}"),
    ("dy_max\n[mm]", lambda r: f"{r.peak_change:.1f}"),
    ("v_max\n[m/s]", lambda r: f"{r.peak_velocity / _KILO:.3f}"),
    ("resid.\n[mm]", lambda r: f"{r.residual_displacement:.1f}"),
    ("F_max\n[kN]", lambda r: f"{r.peak_force / _KILO:.0f}"),
    ("F/W\n[-]", lambda r: f"{r.peak_force / r.bearing.vertical_force:.3f}"),
    ("T_max\n[°C]", lambda r: f"{r.peak_temperature:.0f}"),
    ("mu_min\n[-]", lambda r: f"{r.least_friction:.4f}"),
    ("V_E\n[m/s]", lambda r: f"{r.input_velocity / _KILO:.3f}"),
    ("V_Eh\n[m/s]", lambda r: f"{r.hysteretic_velocity / _KILO:.3f}"),
)


def print_responses(responses: "Sequence[Response]") -> None:
    """Print what was analysed, one row for each analysis, and the remarks."""
    first = responses[0]
    labelled = [
        ("Bearing", bearing_line(first.bearing)),
        ("Friction", f"{first.friction_law.name}, reference coefficient {first.friction_law.reference:g}"),
        ("Heating", f"{first.heating.name}, from {first.heating.ambient:g} °C"),
    ]
    table = new_table(["Record"], [head for head, _ in _NUMBERS], ["Status"])
    for response in responses:
        numbers = [show(response) for _, show in _NUMBERS]
        add_row(table, [response.motion.name, *numbers, response.status.value])
    with page() as out:
        print_labelled(out, labelled)
        out.print()
        out.print(table)
        print_remarks(out, _remarks(responses))


def bearing_line(bearing: "Bearing") -> str:
    """Return a bearing in a line."""
    radii = " + ".join(f"{radius:g}" for radius in bearing.radii)
    capacity = bearing.displacement_capacity
    return (
        f"{bearing.name}: radius {radii} mm, slider {bearing.slider_diameter:g} mm,"
        f" {bearing.pressure:g} N/mm², {bearing.elastic_stiffness / _KILO:g} kN/mm,"
        f" W {bearing.vertical_force / _KILO:.0f} kN, period {bearing.period:.2f} s,"
        f" capacity {'not given' if capacity is None else f'{capacity:g} mm'}"
    )


def _remarks(responses: "Sequence[Response]") -> list[str]:
    """Return the remarks; the scale of a motion is left out, for it shows in its PGV."""
    return grouped(
        (response.motion.name, remark)
        for response in responses
        for remark in (*motion_remarks(response.motion, with_scale=False), *response.remarks)
    )


# The tables of `dcfp records`.


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
