"""A multi-storey shear building on the bearing, beside the rigid structure: energies, drifts and floor accelerations."""

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli import inputs, options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Parser, number_from, positive, whole_number
from dcfp.doors.cli.response_table import bearing_line
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    from dcfp.analysis import Response
    from dcfp.analysis.building import BuildingResponse, ShearBuilding

_KILO = 1000.0
_MOST_STOREYS = 60
#: Columns of the data, with their units (UDUNITS).
_COLUMNS = (
    ("record", ""),
    ("pgv_m_s", "m s-1"),
    ("y_max_mm", "mm"),
    ("y_max_rigid_mm", "mm"),
    ("V_E_mm_s", "mm s-1"),
    ("V_E_rigid_mm_s", "mm s-1"),
    ("drift_max_mm", "mm"),
    ("floor_acceleration_max_m_s2", "m s-2"),
    ("temperature_max_degC", "degC"),
    ("energy_residual", "1"),
)


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    options.add_records(parser, "+", "name of a record or set, or a file, FILE::COMPONENT")
    group = parser.add_argument_group("building: equal storeys on a base as heavy as a floor")
    group.add_argument(
        "--storeys",
        type=whole_number(1, _MOST_STOREYS),
        default=5,
        metavar="N",
        help="number of storeys; default 5",
    )
    group.add_argument(
        "--fixed-base-period",
        type=positive("s", 0.01, 10.0),
        default=0.5,
        metavar="S",
        help="first period on a fixed base [s]; default 0.5",
    )
    group.add_argument(
        "--damping",
        type=number_from(0.0, 0.5),
        default=0.02,
        metavar="RATIO",
        help="of the first mode on a fixed base, proportional to the stiffness [-]; default 0.02",
    )
    options.add_treatment(parser)
    options.add_bearing(parser)
    group = parser.add_argument_group("output")
    group.add_argument("--json", action="store_true", help="one JSON document on standard output")
    group.add_argument("--out", metavar="FILE", help="a line for each analysis as CSV (.csv)")
    group.add_argument("--overwrite", action="store_true", help="replace files that exist")


def run(chosen: argparse.Namespace) -> int:
    """Analyse the building and the rigid structure under every record at every PGV."""
    inputs.record_names(chosen)
    outputs = Outputs.checked(chosen, inputs.input_files(chosen), (".csv",))
    from dcfp.analysis import respond
    from dcfp.analysis.building import StiffnessProportional, respond_building, uniform_building
    from dcfp.doors.cli.progress import progress
    from dcfp.motion.measures import refuse_a_drift

    model = inputs.model(chosen)
    damping = StiffnessProportional(chosen.damping) if chosen.damping else None
    building = uniform_building(chosen.storeys, chosen.fixed_base_period, damping=damping)
    motions = inputs.scaled(inputs.load_motions(chosen), chosen.pgv)
    rows: list[dict[str, Any]] = []
    with progress("analyses", len(motions)) as advance:
        for motion in motions:
            refuse_a_drift(motion)
            response = respond_building(motion, building, model.bearing, model.friction, model.heating)
            rows.append(_row(response, respond(motion, model.bearing, model.friction, model.heating)))
            advance()

    def data(part: Path, kind: str) -> None:
        from dcfp.present.tables.columns import Column, table_text

        del kind
        columns = [Column(key, key, unit) for key, unit in _COLUMNS]
        part.write_text(table_text(columns, rows), encoding="utf-8")

    outputs.write_with(data, lambda part, form: None)
    if chosen.json:
        print(json.dumps(rows, indent=2, allow_nan=False))
    else:
        _print(rows, building, model)
    return 0


def _row(response: "BuildingResponse", rigid: "Response") -> dict[str, Any]:
    return {
        "record": response.motion.name,
        "pgv_m_s": round(response.motion.peak_velocity / _KILO, 12),
        "y_max_mm": response.peak_displacement,
        "y_max_rigid_mm": rigid.peak_displacement,
        "V_E_mm_s": response.input_velocity,
        "V_E_rigid_mm_s": rigid.input_velocity,
        "drift_max_mm": float(response.peak_drift.max()),
        "drifts_mm": response.peak_drift.tolist(),
        "floor_acceleration_max_m_s2": float(response.peak_acceleration.max()) / _KILO,
        "floor_accelerations_m_s2": (response.peak_acceleration / _KILO).tolist(),
        "temperature_max_degC": response.peak_temperature,
        "energy_residual": response.energy.relative_residual,
        "rests": response.rests,
        "remarks": [*_beyond(response), *(remark for remark in rigid.remarks if "capacity" not in remark)],
    }


def _beyond(response: "BuildingResponse") -> list[str]:
    """Return a sentence where the displacement is beyond the capacity, and where it still moves at the end."""
    name, capacity = response.motion.name, response.bearing.displacement_capacity
    remarks: list[str] = []
    if capacity is not None and response.peak_displacement > capacity:
        remarks.append(
            f"{name}: the displacement of {response.peak_displacement:.0f} mm exceeds the capacity of {capacity:.0f} mm."
        )
    if not response.rests:
        remarks.append(f"{name}: the building still oscillates at the end of the analysis.")
    return remarks


def _print(rows: list[dict[str, Any]], building: "ShearBuilding", model: "inputs.System") -> None:
    heads = (
        "PGV\n[m/s]",
        "y_max\n[mm]",
        "rigid\n[mm]",
        "V_E\n[m/s]",
        "rigid\n[m/s]",
        "V_E over\nrigid",
        "drift\n[mm]",
        "floor acc.\n[m/s²]",
    )
    table = new_table(["Record"], heads)
    for row in rows:
        ratio = row["V_E_mm_s"] / row["V_E_rigid_mm_s"] if row["V_E_rigid_mm_s"] > 0.0 else float("nan")
        cells = [
            f"{row['pgv_m_s']:.3f}",
            f"{row['y_max_mm']:.1f}",
            f"{row['y_max_rigid_mm']:.1f}",
            f"{row['V_E_mm_s'] / _KILO:.3f}",
            f"{row['V_E_rigid_mm_s'] / _KILO:.3f}",
            f"{ratio:.3f}" if ratio == ratio else "–",
            f"{row['drift_max_mm']:.1f}",
            f"{row['floor_acceleration_max_m_s2']:.2f}",
        ]
        add_row(table, [row["record"], *cells])
    periods = ", ".join(f"{period:.2f}" for period in building.fixed_base_periods[:3])
    with page() as out:
        print_labelled(
            out,
            [
                ("Bearing", bearing_line(model.bearing)),
                ("Friction", f"{model.friction.name}, heating {model.heating.name}"),
                ("Building", f"{building.storeys} equal storeys; first periods on a fixed base {periods} s"),
            ],
        )
        out.print()
        out.print(table)
        print_remarks(
            out,
            [
                *(remark for row in rows for remark in row["remarks"]),
                "rigid: the rigid structure of the same mass; V_E: equivalent velocity of the relative input energy at the end, which Akiyama (1985) takes to be the same"
                " for both; drift and floor acceleration: the largest of all storeys, and of the base and all floors (absolute).",
            ],
        )
