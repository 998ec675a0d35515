"""The design chart: displacement over friction and radius, and which bearings hold."""

import math

import numpy as np

from dcfp.arrays import FloatArray
from dcfp.doors.app.charts.look import BLUE, GREY, RED, axis, legend, line, simple
from dcfp.doors.app.elements import Cell, Head, Options
from dcfp.doors.app.thinning import points
from dcfp.doors.app.units import Units
from dcfp.inference.design_space import DesignSpace
from dcfp.schema.nomenclature import quantity

#: Displacements at which lines are drawn [mm], and forces over the weight [-].
_LEVELS = (25.0, 50.0, 75.0, 100.0, 150.0, 200.0, 300.0, 400.0, 500.0, 600.0, 800.0, 1000.0, 1500.0, 2000.0)
_LENGTH = quantity("displacement")
_FORCES = (0.04, 0.06, 0.08, 0.1, 0.125, 0.15, 0.2, 0.25, 0.3, 0.4)


def chart(space: DesignSpace, allowed: float, part: float, units: Units) -> Options:
    """Return lines of equal displacement [mm] over friction and radius; where `allowed` [mm] holds with a probability of `part` [-] it is shaded."""
    mu, radius = space.coefficients, space.radii / 1e3
    displacement = space.displacement_at(part)
    length = units.of(_LENGTH)
    series: list[Options] = []
    for one in _LEVELS:
        if abs(one - allowed) > 1e-9:
            words = f"{length.shown(one):.2f}".rstrip("0").rstrip(".")
            series += _lines(mu, radius, displacement, one, BLUE, words)
    for one in _FORCES:
        series += _lines(mu, radius, space.force_at(part), one, GREY, f"{one:g}", dashed=True)
    series += _lines(mu, radius, displacement, allowed, RED, allowed_words(allowed, units), width=2.4)
    return {
        **simple(
            axis("Reference coefficient of friction [–]", "x", min=float(mu[0]), max=float(mu[-1])),
            axis("Radius of each plate [m]", "y", min=float(radius[0]), max=float(radius[-1])),
            series,
            tooltip={"show": False},
            grid={"left": 52, "right": 24, "top": 34, "bottom": 46},
        ),
        "areas": _held(mu, radius, displacement, allowed),
    }  # fmt: skip


def allowed_words(allowed: float, units: Units) -> str:
    """Return the allowed displacement [mm] with the visitor's unit."""
    return f"{units.of(_LENGTH).shown(allowed):.4g} {units.name(_LENGTH)}"


def _lines(
    mu: FloatArray,
    radius: FloatArray,
    values: FloatArray,
    value: float,
    colour: str,
    words: str,
    *,
    width: float = 1.1,
    dashed: bool = False,
) -> list[Options]:
    """Return the lines of one value with its number in the middle of the longest."""
    from contourpy import contour_generator  # late: it comes with Matplotlib

    if not float(values.min()) < value < float(values.max()):
        return []
    found = [np.asarray(one) for one in contour_generator(mu, radius, values).lines(value)]
    longest = max(range(len(found)), key=lambda i: len(found[i]))
    series: list[Options] = []
    for number, one in enumerate(found):
        more: Options = {}
        if number == longest:
            # the numbers of forces stand lower than those of displacements, so that none covers another
            height = radius[0] + (0.25 if dashed else 0.72) * (radius[-1] - radius[0])
            place = one[int(np.abs(one[:, 1] - height).argmin())]
            label = {"show": True, "formatter": words, "color": colour, "fontSize": 11, "position": "inside",
                     "backgroundColor": "var(--card)", "padding": [1, 3]}  # fmt: skip
            point = {"coord": [float(place[0]), float(place[1])], "symbolSize": 1, "label": label}
            more = {"markPoint": {"symbol": "circle", "silent": True, "animation": False, "data": [point]}}
        look = {"width": width, "color": colour, "type": "dashed" if dashed else "solid"}
        series.append(line(words, points(one[:, 0], one[:, 1]), colour, lineStyle=look, silent=True, **more))
    return series


def _held(mu: FloatArray, radius: FloatArray, values: FloatArray, allowed: float) -> list[Options]:
    """Return where a displacement is at most what is allowed, as polygons."""
    from contourpy import FillType, contour_generator

    filled = contour_generator(mu, radius, values, fill_type=FillType.OuterCode).filled(-math.inf, allowed)
    outlines = [np.asarray(one).tolist() for one in filled[0] if one is not None]
    return [{"points": one, "color": BLUE, "opacity": 0.14} for one in outlines]


def curves(space: DesignSpace, allowed: float, part: float, units: Units) -> Options:
    """Draw displacement against friction, a line for each radius."""
    length = units.of(_LENGTH)
    displacement = length.shown(space.displacement_at(part))
    shades = np.linspace(1.0, 0.35, space.radii.size).tolist()
    series = [
        line(
            f"{radius / 1e3:g} m",
            points(space.coefficients, values),
            BLUE,
            lineStyle={"width": 1.6, "color": BLUE, "opacity": shade},
            itemStyle={"color": BLUE, "opacity": shade},
        )
        for radius, values, shade in zip(space.radii.tolist(), displacement, shades, strict=True)
    ]
    side = length.shown(allowed)
    series[0]["markLine"] = {
        "silent": True,
        "symbol": "none",
        "animation": False,
        "lineStyle": {"color": RED, "width": 2, "type": "solid"},
        "label": {"formatter": "allowed", "color": RED, "fontSize": 11, "position": "insideEndTop"},
        "data": [{"yAxis": side}],
    }
    return simple(
        axis("Reference coefficient of friction [–]", "x", min=float(space.coefficients[0]), max=float(space.coefficients[-1])),
        axis(f"Displacement [{length.name}]", "y", scale=False),
        series,
        grid={"left": 52, "right": 24, "top": 34, "bottom": 46},
        legend=legend(),
    )  # fmt: skip


def holding_head() -> list[Head]:
    """Return the heads of the table of what holds."""
    return [
        Head("Radius of each plate", "mm"),
        Head("Least µ, half of the earthquakes", "–"),
        Head("Force over weight", "–"),
        Head("Least µ, 95 % of the earthquakes", "–"),
        Head("Force over weight", "–"),
    ]


def holding_rows(space: DesignSpace, allowed: float) -> list[list[Cell | str]]:
    """Return for each radius the least coefficient that holds, and the force that goes with it."""
    found = [space.holding(allowed, part) for part in (0.5, 0.95)]
    least = float(space.coefficients[0])
    rows: list[list[Cell | str]] = []
    for i, radius in enumerate(space.radii.tolist()):
        cells: list[Cell | str] = [f"{radius:.0f}"]
        for coefficients, forces in found:
            value = float(coefficients[i])
            if math.isnan(value):
                cells += [Cell("none", "bad"), "–"]
            else:
                cells += [f"{'≤ ' if value <= least else ''}{value:.3f}", f"{float(forces[i]):.3f}"]
        rows.append(cells)
    return rows
