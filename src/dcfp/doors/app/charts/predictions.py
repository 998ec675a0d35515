"""Predictions and codes beside the analysis: a chart and its table."""

from dcfp.doors.app.charts.look import BLUE, GREY, INK, MUTED, OCHRE, axis, level, simple
from dcfp.doors.app.elements import Cell, Head, Options
from dcfp.doors.app.units import Units
from dcfp.inference import Case
from dcfp.inference.case import VIEWS, Basis, View
from dcfp.methods.result import Answer

_COLOURS = {Basis.BLIND: BLUE, Basis.INFORMED: GREY, Basis.PGV: OCHRE, Basis.SPECTRUM: INK}


def words_of(view: View) -> str:
    """Return a method and what it knows, in words."""
    method, basis = view
    return method.value if basis is Basis.SPECTRUM else f"{method.value}, {basis.value}"


def bars(case: Case, units: Units) -> Options:
    """Draw what each method offers for the largest displacement, and the analysis as a line."""
    views = [view for view in reversed(VIEWS) if view in case.predicted]
    bounds = [case.predicted[view].bound * units.length.factor for view in views]
    data = [
        {"value": round(bound, 4), "itemStyle": {"color": _COLOURS[view[1]]}}
        for view, bound in zip(views, bounds, strict=True)
    ]
    analysed = case.analysed.whole.bound * units.length.factor
    words = f"analysis {units.length.text(case.analysed.whole.bound)} {units.length.name}"
    line = level((analysed,), "xAxis", words, INK)
    line["markLine"]["label"] |= {"position": "end", "fontSize": 12}
    return {
        **simple(
            axis(f"y_max offered [{units.length.name}]", "x", scale=False, splitLine={"show": True, "lineStyle": {"color": "var(--line)"}}),
            {
                "type": "category",
                "data": [words_of(view) for view in views],
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
    length = units.length.name
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
        ["analysis", "everything", units.length.text(whole.displacement_change), "1.00", units.length.text(whole.bound), "1.00", ""]
    ]  # fmt: skip
    for view in VIEWS:
        if view not in case.predicted:
            continue
        method, basis = view
        said, beside = case.predicted[view], case.analysed.beside(basis)
        change = said.displacement_change
        has_change = change == change  # codes do not say it
        rows.append(
            [
                method.value,
                basis.value,
                units.length.text(change) if has_change else "–",
                _ratio(change, beside.displacement_change) if has_change else "–",
                units.length.text(said.bound),
                _ratio(said.bound, beside.bound),
                _verdict(case.answers.get(method.value)),
            ]
        )
    return rows


def _ratio(said: float, analysed: float) -> str:
    return f"{said / analysed:.2f}" if analysed > 0.0 else "–"


def _verdict(answer: Answer | None) -> Cell:
    if answer is None:
        return Cell("")
    tone = {True: "good", False: "bad", None: "doubt"}[answer.valid]
    return Cell(answer.verdict, "" if not answer.conditions else tone)


def code_remarks(case: Case) -> list[str]:
    """Return which conditions are broken, and what could not be confirmed."""
    remarks: list[str] = []
    for name, answer in case.answers.items():
        broken = [
            f"{one.name} {one.found_words}, {one.limit_words}"
            for one in answer.conditions
            if one.verdict.value == "not met"
        ]
        remarks += [f"{name}, not met: {'; '.join(broken)}."] if broken else []
        remarks += [f"{name}, unconfirmed: {'; '.join(answer.unconfirmed)}."] if answer.unconfirmed else []
    return remarks
