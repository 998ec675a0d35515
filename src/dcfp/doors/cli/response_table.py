"""The table of `dcfp respond`."""

from typing import TYPE_CHECKING

from dcfp.doors.cli.remarks import grouped
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks
from dcfp.motion.measures import motion_remarks

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dcfp.analysis import Response
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
