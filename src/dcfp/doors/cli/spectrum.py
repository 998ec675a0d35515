"""Elastic response and input energy spectra of records, or of a set of them."""

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

from dcfp.doors.cli import inputs, options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Numbers, Parser, number_from, positive
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks

if TYPE_CHECKING:
    from dcfp.methods.spectra import EnergySpectrum
    from dcfp.motion.ground_motion import GroundMotion

_KILO = 1000.0
#: Periods of the table [s]; the data have all.
_SHOWN = (0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0)


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    options.add_records(parser, "+", "name of a record or set, or a file, FILE::COMPONENT")
    group = parser.add_argument_group("oscillators")
    group.add_argument(
        "--damping",
        type=number_from(0.0, 0.99),
        default=0.05,
        metavar="RATIO",
        help="ratio of critical damping [-]; default 0.05",
    )
    group.add_argument(
        "--periods",
        action=Numbers,
        check=positive("s", 0.01, 100.0),
        metavar="S",
        help="periods [s], increasing; default 200 from 0.05 to 10",
    )
    options.add_treatment(parser)
    options.add_output(parser, "every period of every record as CSV (.csv)")


def run(chosen: argparse.Namespace) -> int:
    """Make the spectra of every record at every PGV."""
    inputs.record_names(chosen)
    outputs = Outputs.checked(chosen, inputs.input_files(chosen), (".csv",))
    import numpy as np

    from dcfp.doors.cli.progress import progress
    from dcfp.methods.spectra import input_energy_spectrum
    from dcfp.methods.spectra.of_record import PERIODS
    from dcfp.motion.measures import refuse_a_drift

    motions = inputs.scaled(inputs.load_motions(chosen), chosen.pgv)
    periods = PERIODS if chosen.periods is None else np.array(chosen.periods)
    spectra: list[EnergySpectrum] = []
    with progress("records", len(motions)) as advance:
        for motion in motions:
            refuse_a_drift(motion)
            spectra.append(input_energy_spectrum(motion, periods, chosen.damping))
            advance()
    rows = [row for motion, found in zip(motions, spectra, strict=True) for row in _rows(motion, found)]
    _write(motions, spectra, rows, outputs)
    if chosen.json:
        print(json.dumps(_document(motions, spectra, rows), indent=2, allow_nan=False))
    else:
        _print(motions, spectra, given=chosen.periods is not None)
    return 0


def _rows(motion: "GroundMotion", found: "EnergySpectrum") -> list[dict[str, Any]]:
    omega = (2.0 * 3.141592653589793 / found.periods).tolist()
    return [
        {
            "record": motion.name,
            "pgv_m_s": round(motion.peak_velocity / _KILO, 12),
            "period_s": float(found.periods[i]),
            "S_d_mm": float(found.displacement[i]),
            "S_v_mm_s": float(found.displacement[i]) * omega[i],
            "S_a_mm_s2": float(found.displacement[i]) * omega[i] ** 2,
            "V_E_mm_s": (2.0 * float(found.relative[i])) ** 0.5,
            "V_E_absolute_mm_s": (2.0 * float(found.absolute[i])) ** 0.5,
        }
        for i in range(found.periods.size)
    ]


def _maxima(motion: "GroundMotion") -> dict[str, Any]:
    """Return the largest input energies over the periods, and the formula of Fajfar et al. (1989) beside them."""
    from dcfp.methods.fajfar_1989 import maximum_input_energy
    from dcfp.methods.uang_bertero_1988 import maximum_input_energies

    found, formula = maximum_input_energies(motion), maximum_input_energy(motion)
    return {
        "record": motion.name,
        "pgv_m_s": round(motion.peak_velocity / _KILO, 12),
        "V_E_max_mm_s": (2.0 * found.energies.relative) ** 0.5,
        "at_period_s": found.relative_period,
        "V_E_absolute_max_mm_s": (2.0 * found.energies.absolute) ** 0.5,
        "at_period_absolute_s": found.absolute_period,
        "significant_duration_s": found.duration,
        "V_E_fajfar_1989_unconfirmed_mm_s": formula.equivalent_velocity,
    }


def _document(
    motions: "list[GroundMotion]", spectra: "list[EnergySpectrum]", rows: list[dict[str, Any]]
) -> dict[str, Any]:
    return {
        "damping": spectra[0].damping,
        "spectra": rows,
        "maxima": [_maxima(motion) for motion in motions if motion.peak_acceleration > 0.0],
    }


def _write(
    motions: "list[GroundMotion]",
    spectra: "list[EnergySpectrum]",
    rows: list[dict[str, Any]],
    outputs: Outputs,
) -> None:
    def data(part: Path, kind: str) -> None:
        from dcfp.present.tables.columns import Column, table_text

        del kind
        columns = [
            Column("record", "record"),
            Column("pgv_m_s", "pgv", "m s-1"),
            Column("period_s", "period", "s"),
        ]
        columns += [
            Column("S_d_mm", "S_d", "mm"),
            Column("S_v_mm_s", "S_v", "mm s-1"),
            Column("S_a_mm_s2", "S_a", "mm s-2"),
        ]
        columns += [
            Column("V_E_mm_s", "V_E", "mm s-1"),
            Column("V_E_absolute_mm_s", "V_E_absolute", "mm s-1"),
        ]
        part.write_text(table_text(columns, rows), encoding="utf-8")

    def figure(part: Path, form: str) -> None:
        from dcfp.present.figures import save_figure  # late: Matplotlib takes long to import
        from dcfp.present.figures.spectra import plot_spectra

        save_figure(plot_spectra(spectra, [motion.peak_velocity for motion in motions]), part, form)

    outputs.write_with(data, figure)


def _print(motions: "list[GroundMotion]", spectra: "list[EnergySpectrum]", *, given: bool) -> None:
    import numpy as np

    table = new_table(
        ["Record"],
        ["PGV\n[m/s]", "T\n[s]", "S_d\n[mm]", "S_v\n[m/s]", "S_a\n[m/s²]", "V_E\n[m/s]", "V_E abs.\n[m/s]"],
    )
    for motion, found in zip(motions, spectra, strict=True):
        every = _rows(motion, found)
        places = (
            range(len(every))
            if given
            else sorted({int(np.argmin(np.abs(found.periods - T))) for T in _SHOWN})
        )
        for count, place in enumerate(places):
            row = every[place]
            head = [row["record"], f"{row['pgv_m_s']:.3f}"] if count == 0 else ["", ""]
            velocities = [
                row[key] / _KILO for key in ("S_v_mm_s", "S_a_mm_s2", "V_E_mm_s", "V_E_absolute_mm_s")
            ]
            add_row(
                table,
                [*head, f"{row['period_s']:.3g}", f"{row['S_d_mm']:.1f}", *(f"{v:.3f}" for v in velocities)],
            )
    largest = new_table(
        ["Record"],
        [
            "PGV\n[m/s]",
            "V_E max\n[m/s]",
            "at T\n[s]",
            "V_E abs. max\n[m/s]",
            "at T\n[s]",
            "t_D\n[s]",
            "Fajfar\n[m/s]",
        ],
    )
    for motion in motions:
        if motion.peak_acceleration > 0.0:
            one = _maxima(motion)
            add_row(
                largest,
                [
                    one["record"],
                    f"{one['pgv_m_s']:.3f}",
                    f"{one['V_E_max_mm_s'] / _KILO:.3f}",
                    f"{one['at_period_s']:.2f}",
                    f"{one['V_E_absolute_max_mm_s'] / _KILO:.3f}",
                    f"{one['at_period_absolute_s']:.2f}",
                    f"{one['significant_duration_s']:.1f}",
                    f"{one['V_E_fajfar_1989_unconfirmed_mm_s'] / _KILO:.3f}",
                ],
            )
    with page() as out:
        print_labelled(out, [("Damping", f"{100.0 * spectra[0].damping:g} %")])
        out.print()
        out.print(table)
        out.print()
        out.print("Largest input energies over the periods, at a damping of 5 %:")
        out.print(largest)
        print_remarks(
            out,
            [
                "S_v, S_a: pseudo-velocity and pseudo-acceleration; V_E: equivalent velocity of the relative, abs. of the absolute input energy, each the largest at any time"
                " (Uang and Bertero 1988); t_D: 5 to 95 % of the Arias intensity.",
                "Fajfar: sqrt(2 E/m) of E/m = 2.2 t_D^0.5 PGA PGV, after Fajfar, Vidic and Fischinger (1989), unconfirmed.",
            ],
        )
