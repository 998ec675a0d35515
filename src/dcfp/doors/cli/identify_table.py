"""The tables of `dcfp identify`."""

from typing import TYPE_CHECKING

from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    from rich.console import Console

    from dcfp.inference.identification import Identification

_FORM = (
    "mu = mu_0 gamma alpha beta; gamma = (1 - pressure_floor) (p / reference_pressure)^-pressure_exponent + pressure_floor,"
    " alpha = 1 - speed_drop exp(-speed_rate |v|), beta = exp(-temperature_rate (T - reference_temperature))"
)


def print_identification(found: "Identification") -> None:
    """Print the estimates, what was held and why, the residuals, the predictions and the remarks."""
    bearing = found.bearing
    radii = " + ".join(f"{radius:g}" for radius in bearing.radii)
    with page() as out:
        print_labelled(
            out,
            [
                ("Bearing", f"{bearing.name}: radius {radii} mm, slider {bearing.slider_diameter:g} mm"),
                ("Law", _FORM),
                ("Heating", f"{found.heating.name}, from {found.heating.ambient:g} °C"),
            ],
        )
        _print_estimates(out, found)
        _print_correlation(out, found)
        _print_residuals(out, found)
        _print_predictions(out, found)
        print_remarks(out, [*_notes(found), *found.remarks])


def _print_estimates(out: "Console", found: "Identification") -> None:
    table = new_table(["Fitted"], ["Estimate", "Std. error", "95 % from", "to"], ["Unit"])
    for one in found.estimates:
        numbers = [f"{value:.5g}" for value in (one.value, one.standard_error, one.lower, one.upper)]
        add_row(table, [one.name, *numbers, one.unit or "-"])
    out.print()
    out.print(table)
    table = new_table(["Held"], ["Value"], ["Unit", "Why"])
    for one in found.held:
        add_row(table, [one.name, f"{one.value:.5g}", one.unit or "-", one.reason])
    out.print()
    out.print(table)


def _print_correlation(out: "Console", found: "Identification") -> None:
    if len(found.estimates) < 2:
        return
    table = new_table(["Correlation"], [_head(one.name) for one in found.estimates])
    for one, row in zip(found.estimates, found.correlation.tolist(), strict=True):
        add_row(table, [one.name, *(f"{value:.3f}" for value in row)])
    out.print()
    out.print(table)


def _print_residuals(out: "Console", found: "Identification") -> None:
    table = new_table(
        ["Test"],
        ["p\n[N/mm²]", "v_max\n[mm/s]", "T_max\n[°C]", "used", "left out", "scatter\n[-]", "of mu\n[%]", "mean\n[-]", "lag-1 corr.\n[-]"],
    )  # fmt: skip
    for one in found.residuals:
        numbers = [
            f"{one.pressure:.1f}", f"{one.peak_speed:.0f}", f"{one.peak_temperature:.0f}", f"{one.samples}", f"{one.left_out}",
            f"{one.scatter:.5f}", f"{100.0 * one.relative_scatter:.2f}", f"{one.bias:+.5f}", f"{one.correlation:.2f}",
        ]  # fmt: skip
        add_row(table, [one.name, *numbers])
    out.print()
    out.print(table)


def _print_predictions(out: "Console", found: "Identification") -> None:
    if not found.predictions:
        return
    quantities = (("k_eff\n[kN/mm]", "keff_kN_mm", ".3f"), ("E\n[kN m]", "energy_kN_m", ".1f"), ("mu at 0\n[-]", "friction_at_zero", ".4f"))  # fmt: skip
    heads = [head for name, _, _ in quantities for head in (name, "predicted\n", "ratio\n")]
    table = new_table(["Held out", "Cycle"], heads)
    for prediction in found.predictions:
        for row in prediction.rows():
            cells: list[str] = []
            for _, key, form in quantities:
                for part, shown in (("measured", form), ("predicted", form), ("ratio", ".3f")):
                    value = row[f"{key}_{part}"]
                    cells.append(format(value, shown) if isinstance(value, float) else "")
            add_row(table, [str(row["test"]), str(row["cycle"]), *cells])
    out.print()
    out.print(table)


def _notes(found: "Identification") -> list[str]:
    notes = [
        f"Intervals: leaving out one of {found.blocks} blocks (strokes) after another, so that errors within a stroke may depend on each other."
    ]
    notes += [
        f"{one.name}: the force that was predicted is {100.0 * one.force_error:.1f} % of the largest measured one away from it (root mean square)."
        for one in found.predictions
    ]
    return notes


def _head(name: str) -> str:
    """Return a name in two lines where it is long."""
    return name.replace("_", "\n", 1) if len(name) > 6 else name
