"""The bearing in section under one analysis, and predictions and codes beside it."""

from dataclasses import replace
from typing import Any

import numpy as np

from dcfp.analysis import Response
from dcfp.doors.app.charts.look import BLUE, GREY, INK, MUTED, OCHRE, axis, level, simple, warm_colours
from dcfp.doors.app.elements import Cell, Head, Options
from dcfp.doors.app.units import Units
from dcfp.inference import Case
from dcfp.methods.code import CodeResult
from dcfp.methods.method import Information, Variant, variants
from dcfp.present.panels import shown
from dcfp.schema.nomenclature import quantity
from dcfp.schema.units import INCH, MM

#: Frames of the animation at most, and its least time step [s].
_MOST_FRAMES, _LEAST_STEP = 3000, 0.02
_LENGTH = replace(quantity("displacement"), decimals=1)
_COLOURS = {
    Information.BLIND: BLUE,
    Information.INFORMED: GREY,
    Information.PGV: OCHRE,
    Information.SPECTRUM: INK,
}


def words_of(variant: Variant) -> str:
    """Return a method and what it knows, in words."""
    method, information = variant
    return method if information is Information.SPECTRUM else f"{method}, {information.value}"


def bars(case: Case, units: Units) -> Options:
    """Draw what each method offers for the largest displacement, and the analysis as a line."""
    known = [variant for variant in reversed(variants()) if variant in case.predicted]
    length = units.of(_LENGTH)
    bounds = [length.shown(case.predicted[variant].bound) for variant in known]
    data = [
        {"value": round(bound, 4), "itemStyle": {"color": _COLOURS[variant.information]}}
        for variant, bound in zip(known, bounds, strict=True)
    ]
    analysed = case.analysed.whole.bound
    words = f"analysis {units.written(_LENGTH, analysed)} {length.name}"
    line = level((length.shown(analysed),), "xAxis", words, INK)
    line["markLine"]["label"] |= {"position": "end", "fontSize": 12}
    return {
        **simple(
            axis(f"y_max offered [{length.name}]", "x", scale=False, splitLine={"show": True, "lineStyle": {"color": "var(--line)"}}),
            {
                "type": "category",
                "data": [words_of(variant) for variant in known],
                "axisLabel": {"color": MUTED, "fontSize": 12, "width": 150, "overflow": "truncate"},
                "axisTick": {"show": False},
                "axisLine": {"lineStyle": {"color": MUTED}},
            },
            [{"type": "bar", "name": "y_max", "data": data, "barWidth": "58%", "animation": False, **line}],
            grid={"left": 162, "right": 24, "top": 30, "bottom": 42},
        ),
        "tooltip": {"show": False},
    }  # fmt: skip


def prediction_head(units: Units) -> list[Head]:
    """Return the heads of the table of predictions."""
    length = units.name(_LENGTH)
    return [
        Head("Method", number=False),
        Head("Knows", number=False),
        Head("dy", length),
        Head("over analysis", "–"),
        Head("y_max offered", length),
        Head("over analysis", "–"),
        Head("Verdict", number=False),
    ]


def prediction_rows(case: Case, units: Units) -> list[list[Cell | str]]:
    """Return a row for the analysis and for every method."""
    whole = case.analysed.whole
    rows: list[list[Cell | str]] = [
        ["analysis", "everything", units.written(_LENGTH, whole.displacement_change), "1.00", units.written(_LENGTH, whole.bound), "1.00", ""]
    ]  # fmt: skip
    for variant in variants():
        if variant not in case.predicted:
            continue
        said, beside = case.predicted[variant], case.analysed.beside(variant.information)
        change = said.displacement_change
        has_change = change == change  # codes do not say it
        rows.append(
            [
                variant.method,
                variant.information.value,
                units.written(_LENGTH, change),
                _ratio(change, beside.displacement_change) if has_change else "–",
                units.written(_LENGTH, said.bound),
                _ratio(said.bound, beside.bound),
                _verdict(case.codes.get(variant.method)),
            ]
        )
    return rows


def _ratio(said: float, analysed: float) -> str:
    return f"{said / analysed:.2f}" if analysed > 0.0 else "–"


def _verdict(result: CodeResult | None) -> Cell:
    if result is None:
        return Cell("")
    tone = {True: "good", False: "bad", None: "doubt"}[result.valid]
    return Cell(result.verdict, "" if not result.conditions else tone)


def code_remarks(case: Case) -> list[str]:
    """Return which conditions are broken, and what could not be confirmed."""
    remarks: list[str] = []
    for name, result in case.codes.items():
        broken = [
            f"{one.name} {one.found_words}, {one.limit_words}"
            for one in result.conditions
            if one.verdict.value == "not met"
        ]
        remarks += [f"{name}, not met: {'; '.join(broken)}."] if broken else []
        remarks += [f"{name}, unconfirmed: {'; '.join(result.unconfirmed)}."] if result.unconfirmed else []
    return remarks


def scene(response: Response, units: Units) -> dict[str, Any]:
    """Return what the animation shows: displacement and temperature at equal steps, and the geometry."""
    part = shown(response)
    span = float(response.time[part][-1])
    step = max(_LEAST_STEP, span / _MOST_FRAMES)
    time = np.arange(0.0, span + step, step)
    displacement = np.interp(time, response.time, response.displacement)
    temperature = np.interp(time, response.time, response.temperature)
    bearing = response.bearing
    capacity = bearing.displacement_capacity or 0.0
    length, heat = units.of(_LENGTH), units.of(quantity("temperature"))
    bar = 200.0 if length is not INCH else 254.0
    return {
        "step": step,
        "displacement": np.round(displacement, 2).tolist(),
        "temperature": np.round(temperature, 1).tolist(),
        "shows": round(float(time[int(np.abs(displacement).argmax())]), 2),
        "radii": list(bearing.radii if len(bearing.radii) == 2 else bearing.radii * 2),
        "diameter": bearing.slider_diameter,
        "tall": 0.35 * bearing.slider_diameter,
        "reach": max(capacity, response.peak_displacement, 50.0),
        "low": response.heating.ambient,
        "high": max(response.peak_temperature, response.heating.ambient + 1.0),
        "colours": warm_colours(),
        "length": {"unit": length.name, "size": length.size, "decimals": 1 if length is MM else 2},
        "heat": {"unit": heat.name, "size": heat.size, "zero": heat.zero},
        "bar": {"mm": bar, "words": f"{length.shown(bar):.0f} {length.name}"},
    }  # fmt: skip
