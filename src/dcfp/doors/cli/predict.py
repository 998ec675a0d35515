"""Displacement and energy from the velocity pulses of a record, or from the PGV alone, without a response history analysis."""

import argparse
import json
from pathlib import Path
from typing import TYPE_CHECKING

from dcfp.doors.cli import design, inputs, options
from dcfp.doors.cli.outputs import Outputs
from dcfp.doors.cli.parser import Numbers, Parser, positive
from dcfp.errors import InputError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from dcfp.inference import Case, Setting
    from dcfp.inference.forecast import Forecast
    from dcfp.motion.ground_motion import GroundMotion


_KILO = 1000.0
#: Options that mean something for a record only.
_OF_RECORDS = ("component", "units", "time_step", "baseline", "high_pass", "threshold")


def add_arguments(parser: Parser) -> None:
    """Add the options of the command."""
    options.add_records(parser, "*", "name of a record (dcfp records lists them) or a file, FILE::COMPONENT")
    parser.add_argument(
        "--pgv-only",
        action=Numbers,
        check=positive("m/s", 1e-3, 20.0),
        metavar="M_PER_S",
        help="instead of records: the design method for these PGVs",
    )
    parser.add_argument(
        "--interval",
        action="store_true",
        help="also where 90 %% of analyses lie, from the 100 components of FEMA P-695 at the same PGV",
    )
    parser.add_argument(
        "--allow",
        type=positive("mm", 1.0, 1e4),
        metavar="MM",
        help="with --pgv-only: which friction and radius hold y_max to this displacement [mm]; --plot draws the chart",
    )
    options.add_treatment(parser)
    inputs.add_method(parser)
    options.add_bearing(parser)
    options.add_output(parser, "predictions as CSV (.csv)")


def run(chosen: argparse.Namespace) -> int:
    """Predict every record at every PGV, or every PGV."""
    _check(chosen)
    outputs = Outputs.checked(chosen, inputs.input_files(chosen), (".csv",))
    # late, so that a slip in the command is answered at once
    from dcfp.doors.cli.predict_table import print_forecasts
    from dcfp.present.tables.comparisons import forecast_objects

    setting, nominal = inputs.setting(chosen, inputs.model(chosen))
    if chosen.allow is not None:
        return design.run(chosen, setting, outputs)
    forecasts = _forecasts(chosen, setting)
    _write(forecasts, setting, outputs)
    if chosen.json:
        print(json.dumps(forecast_objects(forecasts, setting), indent=2, allow_nan=False))
    else:
        print_forecasts(forecasts, setting, nominal)
    return 0


def _check(chosen: argparse.Namespace) -> None:
    if chosen.allow is not None:
        design.check(chosen)
    if chosen.pgv_only is None:
        chosen.needs_records = True
        inputs.record_names(chosen)
        return
    names = inputs.record_names(chosen)
    if names:
        msg = f"--pgv-only takes no record; leave out {names[0]}, or say --pgv."
        raise InputError(msg)
    for name in _OF_RECORDS:
        if getattr(chosen, name):
            msg = f"--{name.replace('_', '-')} is for records; with --pgv-only there is none."
            raise InputError(msg)
    if chosen.pgv is not None:
        msg = "--pgv scales records, and --pgv-only is for PGVs without one; give one of the two."
        raise InputError(msg)


def _forecasts(chosen: argparse.Namespace, setting: "Setting") -> "list[Forecast]":
    from dcfp.inference.forecast import forecast, forecast_from_pgv
    from dcfp.motion.measures import refuse_a_drift

    if chosen.pgv_only is not None:
        pgvs = [pgv * _KILO for pgv in chosen.pgv_only]
        calibrations = _calibrations(pgvs, setting) if chosen.interval else {}
        return [forecast_from_pgv(pgv, setting, calibrations.get(pgv)) for pgv in pgvs]
    motions = inputs.scaled(inputs.load_motions(chosen), chosen.pgv)
    for motion in motions:
        refuse_a_drift(motion)
    calibrations = _calibrations([_pgv(motion) for motion in motions], setting) if chosen.interval else {}
    return [forecast(motion, setting, calibrations.get(_pgv(motion))) for motion in motions]


def _pgv(motion: "GroundMotion") -> float:
    """PGV of a motion [mm/s], the same for all that were scaled to the same."""
    return float(f"{motion.peak_velocity:.9g}")


def _calibrations(pgvs: list[float], setting: "Setting") -> "dict[float, list[Case]]":
    from dcfp.doors.cli.progress import progress
    from dcfp.inference.calibration import calibration_set, cases_at

    wanted = list(dict.fromkeys(pgvs))
    with progress("analyses for the intervals", len(wanted) * len(calibration_set())) as advance:
        return {pgv: cases_at(pgv, setting, advance) for pgv in wanted}


def _write(forecasts: "list[Forecast]", setting: "Setting", outputs: Outputs) -> None:
    def data(part: Path, kind: str) -> None:
        from dcfp.present.tables.comparisons import forecasts_csv

        del kind
        part.write_text(forecasts_csv(forecasts), encoding="utf-8")

    def figure(part: Path, form: str) -> None:

        from dcfp.present.figures import save_figure

        save_figure(forecast_figure(forecasts, setting), part, form)

    outputs.write_with(data, figure)


# Which figure belongs to a prediction.


def forecast_figure(forecasts: "Sequence[Forecast]", setting: "Setting") -> "Figure":
    """Draw one record with its pulses and, beside them, the analysis; several records or PGVs beside each other."""
    from dcfp.inference import compare
    from dcfp.present.figures.forecasts import plot_forecasts

    if forecasts[0].motion is None:
        return _pgv_figure(forecasts)
    if len(forecasts) == 1:
        return pulse_figure(compare(forecasts[0].motion, setting, keep_response=True), setting)
    return plot_forecasts(forecasts)


def pulse_figure(case: "Case", setting: "Setting") -> "Figure":
    """Draw a case that kept its analysis, with the march through the pulses."""
    from dcfp.inference.case import march
    from dcfp.present.figures import plot_pulses
    from dcfp.present.figures.pulses import response_of

    marched = march(response_of(case).motion, setting, with_path=True)
    return plot_pulses(case, marched, constants=setting.constants)


def _pgv_figure(forecasts: "Sequence[Forecast]") -> "Figure":
    from dcfp.present.figures.forecasts import DRAWN, plot_pgv_prediction

    said = [next(iter(one.predicted.values())) for one in forecasts]
    if not all(None in one.intervals for one in forecasts):
        return plot_pgv_prediction([one.pgv for one in forecasts], said)
    known: dict[str, list[tuple[float, float, float]]] = {name: [] for name in DRAWN}
    for one in forecasts:
        for quantity, interval in one.intervals[None].items():
            if quantity.name in known:
                known[quantity.name].append((interval.low, interval.median, interval.high))
    return plot_pgv_prediction([one.pgv for one in forecasts], said, known)
