"""The tables of `dcfp predict`."""

from typing import TYPE_CHECKING

from dcfp.doors.cli.remarks import grouped
from dcfp.doors.cli.response_table import bearing_line
from dcfp.doors.cli.tables import add_row, new_table, page, print_labelled, print_remarks
from dcfp.motion.measures import motion_remarks

if TYPE_CHECKING:
    from collections.abc import Sequence

    from rich.console import Console

    from dcfp.inference import Setting
    from dcfp.inference.case import View
    from dcfp.inference.forecast import Forecast
    from dcfp.inference.nominal import Nominal

_NUMBERS = ("dy\n[mm]", "y_max\n[mm]", "V_dE\n[mm/s]", "V_dEhr\n[mm/s]", "V_E\n[mm/s]")
#: Quantities whose intervals are printed, with symbol and unit.
_WITH_INTERVAL = {"dy": ("dy", "mm"), "y": ("y_max", "mm"), "V_E": ("V_E", "mm/s")}
#: What a blind method knows, by its basis.
_KNOWS = {"blind": "record", "PGV only": "PGV"}
_KILO = 1e3
#: What the columns are.
SYMBOLS = (
    "dy: largest change of displacement from one peak to the next; y_max: largest displacement; V_dE, V_dEhr: equivalent velocity sqrt(2E/m) of"
    " the energy put in and dissipated meanwhile; V_E: of all the energy put in."
)


def print_forecasts(forecasts: "Sequence[Forecast]", setting: "Setting", nominal: "Nominal") -> None:
    """Print what was predicted, one row for each method, and the remarks."""
    with page() as out:
        print_labelled(out, labels(setting, nominal))
        out.print()
        if forecasts[0].motion is None:
            _print_from_pgv(out, forecasts)
        else:
            _print_records(out, forecasts)
        _print_intervals(out, forecasts)
        print_remarks(out, [*_remarks(forecasts), *_notes(forecasts)])


def labels(setting: "Setting", nominal: "Nominal") -> list[tuple[str, str]]:
    """Return what stands above the tables: the bearing, its law, and the constants of the methods."""
    constants, friction = setting.constants, setting.friction
    return [
        ("Bearing", bearing_line(setting.bearing)),
        (
            "Friction",
            f"{friction.name}, reference coefficient {friction.reference:g}, heating {setting.heating.name} from {setting.heating.ambient:g} °C;"
            f" nominal coefficient mu_n {nominal.value:.4g} ({nominal.source})",
        ),
        (
            "Constants",
            f"eps {constants.fall_ratio:g}, zeta {constants.change_ratio:g}, kg_ave {constants.average_slope:g} mm/s²;"
            f" pulses where the ground velocity turns back by {setting.threshold:g} PGV,"
            f" for the march by {setting.march_threshold:g} PGV",
        ),
    ]


def _print_from_pgv(out: "Console", forecasts: "Sequence[Forecast]") -> None:
    table = new_table([], ["PGV\n[m/s]", *(_NUMBERS[i] for i in (0, 2, 3))], ["Method"])
    for one in forecasts:
        for (method, _), said in one.predicted.items():
            add_row(
                table,
                [
                    f"{one.pgv / _KILO:g}",
                    f"{said.displacement_change:.1f}",
                    f"{said.input_velocity:.1f}",
                    f"{said.hysteretic_velocity:.1f}",
                    method.value,
                ],
            )
    out.print(table)


def _print_records(out: "Console", forecasts: "Sequence[Forecast]") -> None:
    table = new_table(["Record"], ["PGV\n[m/s]"], ["Method", "Knows"])
    for head in _NUMBERS:
        table.add_column(head, justify="right", no_wrap=True)
    table.add_column("Pulse\n[s]", justify="right", no_wrap=True)
    for one in forecasts:
        name = "" if one.motion is None else one.motion.name
        for row, (view, said) in enumerate(one.predicted.items()):
            method, basis = view
            found = (
                said.displacement_change,
                said.displacement,
                said.input_velocity,
                said.hysteretic_velocity,
                said.total_velocity,
            )
            head = [name, f"{one.pgv / _KILO:.3f}"] if row == 0 else ["", ""]
            add_row(
                table,
                [
                    *head,
                    method.value,
                    _KNOWS[basis.value],
                    *(_number(value) for value in found),
                    _pulse(one, view),
                ],
            )
    out.print(table)


def _number(value: float | None) -> str:
    return "–" if value is None else f"{value:.1f}"


def _pulse(one: "Forecast", view: "View") -> str:
    """Return from when to when the governing pulse rises."""
    place = one.governing.get(view)
    if place is None or one.pulses is None:
        return "–"
    return f"{one.pulses.starts[place]:.2f}–{one.pulses.peaks[place]:.2f}"


def _print_intervals(out: "Console", forecasts: "Sequence[Forecast]") -> None:
    if not any(one.intervals for one in forecasts):
        return
    of_records = forecasts[0].motion is not None
    table = new_table(["Record"] if of_records else [], ["PGV\n[m/s]"], ["Knowing"])
    for symbol, unit in _WITH_INTERVAL.values():
        for end in ("5 %", "median", "95 %"):
            table.add_column(f"{symbol}\n{end}\n[{unit}]", justify="right", no_wrap=True)
    for one in forecasts:
        for row, (view, intervals) in enumerate(one.intervals.items()):
            known = {quantity.name: interval for quantity, interval in intervals.items()}
            cells: list[str] = []
            for name in _WITH_INTERVAL:
                interval = known.get(name)
                ends = () if interval is None else (interval.low, interval.median, interval.high)
                cells += [_short(value) for value in ends] or ["–"] * 3
            names = [one.motion.name if one.motion and row == 0 else ""] if of_records else []
            pgv = f"{one.pgv / _KILO:.3f}" if row == 0 else ""
            add_row(table, [*names, pgv, "the PGV" if view is None else view[0].value, *cells])
    out.print()
    out.print(table)


def _short(value: float) -> str:
    return f"{value:.0f}" if value >= 10.0 else f"{value:.1f}"


def _remarks(forecasts: "Sequence[Forecast]") -> list[str]:
    return grouped(
        (one.motion.name if one.motion else "", remark)
        for one in forecasts
        for remark in (*(motion_remarks(one.motion, with_scale=False) if one.motion else ()), *one.remarks)
    )


def _notes(forecasts: "Sequence[Forecast]") -> list[str]:
    """Return what the columns mean."""
    notes = [SYMBOLS]
    if any(one.motion is not None for one in forecasts):
        notes.append(
            "Pulse: from which peak to which the governing pulse rises. A method without a y_max of its own offers dy for it: of the analyses of"
            " FEMA P-695 dy is the larger in 9 of 10, but a dy predicted too small is not."
        )
    if any(one.intervals for one in forecasts):
        from dcfp.inference.calibration import SET

        notes.append(
            f"Intervals hold 90 % of response history analyses of this bearing: from {SET} at the same PGV."
        )
    return notes
