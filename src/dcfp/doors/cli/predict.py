"""``dcfp predict``: displacement and energy from velocity pulses, or from the PGV alone, with intervals or as a design."""

import argparse
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from dcfp.analysis.integration import usual_heating
from dcfp.doors.cli import inputs, predict_plane
from dcfp.doors.cli.console import Page, grid, grouped, progress
from dcfp.doors.cli.outputs import Answer, drawn
from dcfp.inference import Case, Methods, compare
from dcfp.inference.design_space import COEFFICIENTS, RADII, held_table, survey
from dcfp.inference.forecast import SET, Forecast, calibration_set, cases_at, forecast
from dcfp.inference.told import forecast_lines, forecast_objects, interval_lines
from dcfp.methods.nodes import find_nodes
from dcfp.methods.prediction import Constants, Ground, Nominal, nominal_coefficient
from dcfp.methods.pulse_march import march_through_pulses
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.measures import motion_remarks
from dcfp.motion.station import stations_of
from dcfp.system import System

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: What the columns are.
SYMBOLS = (
    "dy: largest change of displacement from one peak to the next; y_max: largest displacement; V_dE, V_dEhr: equivalent velocity sqrt(2E/m) of"
    " the energy put in and dissipated meanwhile; V_E: of all the energy put in."
)


def nominal(chosen: argparse.Namespace, system: System) -> Nominal:
    """Return the nominal coefficient and where it comes from."""
    if chosen.nominal_mu is not None:
        return Nominal(chosen.nominal_mu, "as given")
    return nominal_coefficient(system)


def methods_of(chosen: argparse.Namespace, system: System) -> tuple[Methods, Nominal]:
    """Return how records are predicted, and where the nominal coefficient comes from."""
    found = nominal(chosen, system)
    made = Methods.of(system, found)
    constants = replace(made.constants, **inputs.given(chosen, Constants))
    return replace(made, constants=constants, **inputs.given(chosen, Methods)), found


def run(chosen: argparse.Namespace) -> Answer:
    """Predict every record at every PGV, or every PGV; or find which bearings hold a displacement."""
    if chosen.pgv_only is None:
        records = inputs.load_records(chosen)
        if stations := stations_of(records):
            methods, friction = methods_of(chosen, inputs.system(chosen, usual_heating(stations)))
            return predict_plane.run(chosen, stations, methods, labels(methods, friction))
    else:
        records = []
    methods, friction = methods_of(chosen, inputs.system(chosen))
    if chosen.pgv_only is not None and chosen.allow is not None:
        return _design(chosen.pgv_only, chosen.allow, methods)
    motions = [one for one in inputs.scaled(records, chosen.pgv) if isinstance(one, GroundMotion)]
    forecasts = _forecasts(chosen, motions, methods)

    def page() -> Page:
        blocks = [
            labels(methods, friction),
            grid(forecast_lines(forecasts, methods, with_others=False), _heads(forecasts)),
        ]
        if any(one.intervals for one in forecasts):
            blocks.append(grid(interval_lines(forecasts, methods), _heads(forecasts)))
        return Page(blocks, _remarks(forecasts))

    return Answer(
        lambda: forecast_objects(forecasts, methods),
        page,
        lambda part, kind: forecast_lines(forecasts, methods).csv(),
        lambda: _figure(forecasts, methods),
    )


def labels(methods: Methods, friction: Nominal) -> list[tuple[str, str]]:
    """Return what stands above the tables: the bearing, its law, and the constants of the methods."""
    constants, law = methods.constants, methods.system.friction
    return [
        ("Bearing", str(methods.system.bearing)),
        (
            "Friction",
            f"{law.name}, reference coefficient {law.reference:g}, heating {methods.system.heating.name} from {methods.system.heating.ambient:g} °C;"
            f" nominal coefficient mu_n {friction.value:.4g} ({friction.source})",
        ),
        (
            "Constants",
            f"eps {constants.fall_ratio:g}, zeta {constants.change_ratio:g}, kg_ave {constants.average_slope:g} mm/s²,"
            f" amplification {constants.amplification:g} from a ku/kg of {constants.amplified_from:g} to 1;"
            f" pulses where the ground velocity turns back by {methods.threshold:g} PGV;"
            f" for the march straight legs that it leaves by {methods.march_tolerance:g} PGV, then fitted",
        ),
    ]


def _heads(forecasts: Sequence[Forecast]) -> int:
    """Return how many columns say what a forecast is of."""
    return 1 if forecasts[0].motion is None else 2


def _forecasts(
    chosen: argparse.Namespace, motions: Sequence[GroundMotion], methods: Methods
) -> list[Forecast]:
    if chosen.pgv_only is not None:
        known = _calibrations(chosen.pgv_only, methods) if chosen.interval else {}
        spectrum = inputs.spectrum(chosen)
        return [forecast(Ground(pgv, spectrum=spectrum), methods, known.get(pgv)) for pgv in chosen.pgv_only]
    known = _calibrations([_pgv(motion) for motion in motions], methods) if chosen.interval else {}
    return [forecast(motion, methods, known.get(_pgv(motion))) for motion in motions]


def _pgv(motion: GroundMotion) -> float:
    """PGV of a motion [mm/s], the same for all that were scaled to the same."""
    return float(f"{motion.peak_velocity:.9g}")


def _calibrations(pgvs: Sequence[float], methods: Methods) -> dict[float, list[Case]]:
    wanted = list(dict.fromkeys(pgvs))
    with progress("analyses for the intervals", len(wanted) * len(calibration_set())) as advance:
        return {pgv: cases_at(pgv, methods, advance) for pgv in wanted}


def _remarks(forecasts: Sequence[Forecast]) -> list[str]:
    told = grouped(
        (one.motion.name if one.motion else "", remark)
        for one in forecasts
        for remark in (*(motion_remarks(one.motion, with_scale=False) if one.motion else ()), *one.remarks)
    )
    notes = [SYMBOLS]
    if forecasts[0].motion is not None:
        notes.append(
            "Pulse: from which peak to which the governing pulse rises. A method without a y_max of its own offers dy for it: of the analyses of"
            " FEMA P-695 dy is the larger in 9 of 10, but a dy predicted too small is not."
        )
    if any(one.intervals for one in forecasts):
        notes.append(
            f"Intervals hold 90 % of response history analyses of this bearing: from {SET} at the same PGV."
        )
    return [*told, *notes]


def _figure(forecasts: Sequence[Forecast], methods: Methods) -> "Figure":
    """Draw one record with its pulses and, beside them, the analysis; several records or PGVs beside each other."""
    first = forecasts[0].motion
    if first is None:
        return _pgv_figure(forecasts)
    if len(forecasts) == 1:
        return pulse_figure(compare(first, methods, keep_response=True), methods)
    return drawn("predictions.plot_forecasts", forecasts)()


def _pgv_figure(forecasts: Sequence[Forecast]) -> "Figure":
    from dcfp.present.figures.predictions import DRAWN, plot_pgv_prediction

    said = [next(iter(one.predicted.values())) for one in forecasts]
    known: dict[str, list[tuple[float, float, float]]] = {name: [] for name in DRAWN}
    for one in forecasts:
        for quantity, interval in one.intervals.get(None, {}).items():
            if quantity.title in known:
                known[quantity.title].append((interval.low, interval.median, interval.high))
    complete = all(None in one.intervals for one in forecasts)
    return plot_pgv_prediction([one.pgv for one in forecasts], said, known if complete else None)


def pulse_figure(case: Case, methods: Methods) -> "Figure":
    """Draw a case that kept its analysis, with the march."""
    from dcfp.present.figures import plot_pulses  # late: Matplotlib takes long to import
    from dcfp.present.figures.pulses import response_of

    nodes = find_nodes(response_of(case).motion, methods.march_tolerance)
    marched = march_through_pulses(nodes, methods.system, with_path=True)
    return plot_pulses(case, marched, constants=methods.constants)


def _design(pgvs: Sequence[float], allowed: float, methods: Methods) -> Answer:
    """Look at a grid of bearings for every PGV, and tell and draw which of them hold a displacement [mm]."""
    with progress("radii", len(pgvs) * RADII.size) as advance:
        spaces = [survey(calibration_set(), pgv, methods.system, report=advance) for pgv in pgvs]
    table = held_table(spaces, allowed, constants=methods.constants)
    lines = [
        ("Bearing", f"{methods.system.bearing}; its radii are varied"),
        (
            "Question",
            f"which reference coefficient of {methods.system.friction.name} holds y_max to {allowed:g} mm",
        ),
        ("Answer from", f"analyses of {SET} at each PGV, on a grid of bearings"),
    ]
    remarks = [
        "mu: the least reference coefficient from which on y_max stays below for half and for 95 % of the components, and the"
        f" horizontal force over the weight that goes with it; – where no coefficient of the grid, up to {COEFFICIENTS[-1]:g}, is enough.",
        *(
            f"At {one['pgv_m_s']:g} m/s other earthquakes of the same kind would give a mu, 95 % between {one['spread_low']:.2f} and {one['spread_high']:.2f}"
            " (19 earthquakes drawn with replacement, 5 to 95 %): trends with the radius within that are chance."
            for one in {row["pgv_m_s"]: row for row in table.objects()}.values()
        ),
        "Eq. (33) of Li et al. (2020) gives a nominal coefficient for dy, and does not know the radius.",
    ]

    figure = drawn("assessment.plot_design_chart", spaces, allowed)
    return Answer.of_table(table, lines, remarks, figure=figure)
