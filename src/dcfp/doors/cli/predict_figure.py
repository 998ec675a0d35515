"""Which figure belongs to a prediction."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from dcfp.inference import Case, Setting
    from dcfp.inference.forecast import Forecast


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
