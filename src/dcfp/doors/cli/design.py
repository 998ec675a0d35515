"""Which friction and radius hold a displacement: the part of `dcfp predict` that is asked with ``--allow``."""

import argparse
import json
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli.response_table import bearing_line
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks
from dcfp.errors import InputError

if TYPE_CHECKING:
    from dcfp.doors.cli.outputs import Outputs
    from dcfp.inference import Setting
    from dcfp.inference.design_space import DesignSpace

#: Probabilities for which the least coefficient is given [-].
_PARTS = (0.5, 0.95)
_KILO = 1e3


def check(chosen: argparse.Namespace) -> None:
    """Check that the options fit each other.

    Raises
    ------
    InputError
        If not.
    """
    if chosen.pgv_only is None:
        msg = "--allow asks for a design, which is for PGVs without a record; say which with --pgv-only."
        raise InputError(msg)
    if chosen.interval:
        msg = "--allow and --interval answer different questions; give one of the two."
        raise InputError(msg)
    for name in ("radius", "mu"):
        if getattr(chosen, name) is not None:
            msg = f"--allow varies what --{name} sets; leave out one of the two."
            raise InputError(msg)


def run(chosen: argparse.Namespace, setting: "Setting", outputs: "Outputs") -> int:
    """Look at a grid of bearings for every PGV, and print and draw which of them hold the displacement."""
    spaces = _survey([pgv * _KILO for pgv in chosen.pgv_only], setting)
    rows = [row for space in spaces for row in _rows(space, chosen.allow, setting)]

    def data(part: Path, kind: str) -> None:
        from dcfp.present.tables.columns import Column, table_text

        del kind
        part.write_text(table_text([Column(key, key) for key in rows[0]], rows), encoding="utf-8")

    def figure(part: Path, form: str) -> None:
        from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import
        from dcfp.present.figures.design_chart import plot_design_chart

        save_figure(plot_design_chart(spaces, chosen.allow), part, form)

    outputs.write_with(data, figure)
    if chosen.json:
        print(json.dumps(rows, indent=2, allow_nan=False))
    else:
        _print(rows, chosen.allow, setting)
    return 0


def _survey(pgvs: list[float], setting: "Setting") -> "list[DesignSpace]":
    from dcfp.doors.cli.progress import progress
    from dcfp.inference.calibration import calibration_set
    from dcfp.inference.design_space import RADII, survey

    with progress("radii", len(pgvs) * RADII.size) as advance:
        return [survey(calibration_set(), pgv, setting, report=advance) for pgv in pgvs]


def _rows(space: "DesignSpace", allowed: float, setting: "Setting") -> list[dict[str, Any]]:
    from dcfp.methods.li_2020 import friction_that_holds

    found = {part: [values.tolist() for values in space.holding(allowed, part)] for part in _PARTS}
    low, high = space.spread(allowed, _PARTS[-1])
    least = float(space.coefficients[0])
    nominal = friction_that_holds(allowed, space.pgv, setting.constants)
    rows: list[dict[str, Any]] = []
    for i, radius in enumerate(space.radii.tolist()):
        row: dict[str, Any] = {
            "pgv_m_s": space.pgv / _KILO,
            "allowed_mm": allowed,
            "radius_mm": radius,
            "nominal_friction_design_method": nominal,
            "least_of_the_grid": least,
            "spread_low": low,
            "spread_high": high,
        }
        for part, (coefficients, forces) in found.items():
            row |= zip(_keys(part), (_known(coefficients[i]), _known(forces[i])), strict=True)
        rows.append(row)
    return rows


def _keys(part: float) -> tuple[str, str]:
    """Return the names of coefficient and force that hold with a probability."""
    return f"least_coefficient_{100 * part:g}_percent", f"force_over_weight_{100 * part:g}_percent"


def _known(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _print(rows: list[dict[str, Any]], allowed: float, setting: "Setting") -> None:
    from dcfp.inference.calibration import SET
    from dcfp.inference.design_space import COEFFICIENTS

    found = [head for words in ("half", "95 %") for head in (f"mu, {words}\n[-]", "F/W\n[-]")]
    table = new_table([], ["PGV\n[m/s]", "Radius\n[mm]", *found, "mu_n, Eq. (33)\n[-]"])
    for row in rows:
        found = [_shown(row[key], row["least_of_the_grid"]) for part in _PARTS for key in _keys(part)]
        nominal = _shown(row["nominal_friction_design_method"])
        add_row(table, [f"{row['pgv_m_s']:g}", f"{row['radius_mm']:.0f}", *found, nominal])
    with page() as out:
        print_labelled(
            out,
            [
                ("Bearing", f"{bearing_line(setting.bearing)}; its radii are varied"),
                (
                    "Question",
                    f"which reference coefficient of {setting.friction.name} holds y_max to {allowed:g} mm",
                ),
                ("Answer from", f"analyses of {SET} at each PGV, on a grid of bearings"),
            ],
        )
        out.print()
        out.print(table)
        print_remarks(
            out,
            [
                "mu: the least reference coefficient from which on y_max stays below for half and for 95 % of the components, and the"
                " horizontal force over the weight that goes with it; – where no coefficient of the grid, up to"
                f" {COEFFICIENTS[-1]:g}, is enough.",
                *_spreads(rows),
                "Eq. (33) of Li et al. (2020) gives a nominal coefficient for dy, and does not know the radius.",
            ],
        )


def _spreads(rows: list[dict[str, Any]]) -> list[str]:
    """Return how sure the coefficients are, for each PGV."""
    spreads = {row["pgv_m_s"]: (row["spread_low"], row["spread_high"]) for row in rows}
    return [
        f"At {pgv:g} m/s other earthquakes of the same kind would give a mu, 95 % between {low:.2f} and {high:.2f} (19 earthquakes drawn with"
        " replacement, 5 to 95 %): trends with the radius within that are chance."
        for pgv, (low, high) in spreads.items()
    ]


def _shown(value: float | None, least: float = 0.0) -> str:
    if value is None:
        return "–"
    return f"≤ {value:.3f}" if value == least else f"{value:.3f}"
