"""Charts of one analysis: loop, histories, energies, pulses, and the temperature on the plate."""

import base64
import io
from functools import cache
from typing import Any

import numpy as np

from dcfp.analysis import Response
from dcfp.arrays import FloatArray
from dcfp.doors.app.charts.look import (
    BLUE,
    GREEN,
    GREY,
    INK,
    MUTED,
    OCHRE,
    RED,
    axis,
    legend,
    level,
    line,
    mark,
    simple,
    tooltip,
)
from dcfp.doors.app.elements import Options
from dcfp.doors.app.thinning import kept, kept_of_path, points
from dcfp.doors.app.units import Units
from dcfp.inference import Case
from dcfp.present.figures.histories import shown

#: Capacity beside which a peak has to come for the capacity to be drawn [-].
_NEAR = 0.5
#: Frames of the animation at most, and its least time step [s].
_MOST_FRAMES, _LEAST_STEP = 3000, 0.02
_COLOURS = 64


def loop(response: Response, units: Units) -> Options:
    """Draw force against displacement."""
    part = shown(response)
    y, force = units.length.of(response.displacement[part]), units.force.of(response.force[part])
    place = kept_of_path(y, force)
    more = _capacity(response, units, "xAxis")
    return simple(
        axis(f"Displacement [{units.length.name}]", "x"),
        axis(f"Force [{units.force.name}]", "y"),
        [line("loop", points(y[place], force[place]), BLUE, **more)],
        tooltip={"show": False},
        grid={"left": 58, "right": 20, "top": 34, "bottom": 42},
    )


def _capacity(response: Response, units: Units, along: str) -> Options:
    capacity = response.bearing.displacement_capacity
    if capacity is None or response.peak_displacement < _NEAR * capacity:
        return {}
    side = capacity * units.length.factor
    return level((-side, side), along, "capacity")


def histories(response: Response, units: Units) -> Options:
    """Draw velocities, displacement, temperature and friction over the same time."""
    part = shown(response)
    time = response.time[part]
    ground = units.velocity.of(response.ground_velocity[part])
    structure = units.velocity.of(response.structure_velocity[part])
    y = units.length.of(response.displacement[part])
    hot = units.temperature.of(response.temperature[part])
    mu = response.friction[part]
    sliding = np.where(response.sliding[part] != 0.0, mu, np.nan)
    place = kept((ground, structure, y, hot, mu))

    def history(name: str, values: FloatArray, colour: str, row: int, **more: Any) -> Options:
        return line(name, points(time[place], values[place]), colour, xAxisIndex=row, yAxisIndex=row, **more)

    names = (
        f"Velocity [{units.velocity.name}]",
        f"Displacement [{units.length.name}]",
        f"Temperature of the contact [{units.temperature.name}]",
        "Coefficient of friction [–]",
    )
    shape = _rows(names, float(time[0]), float(time[-1]))
    shape["yAxis"][3]["min"] = 0
    series = [
        history("ground", ground, GREY, 0),
        history("structure", structure, BLUE, 0),
        history("displacement", y, BLUE, 1, **_capacity(response, units, "yAxis")),
        history("temperature", hot, RED, 2),
        history("sticking", mu, GREY, 3),
        history("sliding", sliding, OCHRE, 3),
    ]
    return {
        **shape,
        "animation": False,
        "series": series,
        "tooltip": tooltip(),
        "legend": [
            legend(("ground", "structure")),
            legend(("sticking", "sliding"), top=f"{_top(3) - 4.6:.1f}%"),
        ],
    }


_ROW_HEIGHT, _GAP = 16.0, 7.4


def _top(row: int) -> float:
    return 5.0 + row * (_ROW_HEIGHT + _GAP)


def _rows(names: tuple[str, ...], first: float, last: float) -> Options:
    rows = range(len(names))
    return {
        "grid": [
            {"left": 52, "right": 16, "top": f"{_top(row):.1f}%", "height": f"{_ROW_HEIGHT}%"} for row in rows
        ],
        "xAxis": [
            axis(
                "Time [s]" if row == len(names) - 1 else "",
                "x",
                gridIndex=row,
                min=round(first, 3),
                max=round(last, 3),
                axisLabel={"show": row == len(names) - 1, "color": MUTED, "fontSize": 12, "showMaxLabel": False, "showMinLabel": first == 0.0},
            )
            for row in rows
        ],
        "yAxis": [axis(name, "y", gridIndex=row, nameGap=13, splitNumber=3) for row, name in enumerate(names)],
        "axisPointer": {"link": [{"xAxisIndex": "all"}]},
    }  # fmt: skip


def energies(response: Response, units: Units) -> Options:
    """Draw where the energy is."""
    part = shown(response)
    energy, unit = response.energy, units.energy
    time = response.time[part]
    histories = [
        unit.of(one[part]) for one in (energy.hysteretic, energy.strain, energy.kinetic, energy.input)
    ]
    place = kept(histories, 260)
    names = ("friction", "elastic", "kinetic")
    colours = (OCHRE, GREEN, BLUE)
    parts = [
        line(
            name,
            points(time[place], one[place]),
            colour,
            stack="energy",
            areaStyle={"color": colour, "opacity": 0.28},
        )
        for name, one, colour in zip(names, histories[:3], colours, strict=True)
    ]
    total = line("input", points(time[place], histories[3][place]), INK)
    return simple(
        axis("Time [s]", "x", min=round(float(time[0]), 3), max=round(float(time[-1]), 3)),
        axis(f"Energy [{unit.name}]", "y"),
        [*parts, total],
        legend=legend(),
    )  # fmt: skip


def pulses(response: Response, case: Case, units: Units) -> Options:
    """Draw the pulses on the ground velocity, and the one that governs."""
    part = shown(response)
    time, ground = response.time[part], units.velocity.of(response.ground_velocity[part])
    place = kept((ground,), 500)
    found = case.pulses
    inside = (found.times >= time[0]) & (found.times <= time[-1])
    peaks = points(found.times[inside], units.velocity.of(found.velocities[inside]))
    series = [
        line("ground velocity", points(time[place], ground[place]), GREY),
        line("pulses", peaks, BLUE, lineStyle={"width": 1.2, "color": BLUE, "type": "dashed"}),
        mark("peaks", peaks, BLUE),
    ]
    number = case.analysed.pulse
    if number is not None:
        whole = slice(number, number + 3)
        governing = points(found.times[whole], units.velocity.of(found.velocities[whole]))
        series.append(line("governing pulse", governing, RED, lineStyle={"width": 2.4, "color": RED}))
    names = ["ground velocity", "pulses", *(["governing pulse"] if number is not None else [])]
    return simple(
        axis("Time [s]", "x", min=round(float(time[0]), 3), max=round(float(time[-1]), 3)),
        axis(f"Velocity [{units.velocity.name}]", "y"),
        series,
        legend=legend(names),
    )


def plate(response: Response, units: Units) -> Options | None:
    """Return the temperature along the lower plate over time with the slider's path, or None where it was not kept."""
    profiles = response.profiles
    if profiles is None:
        return None
    part = shown(response)
    time = response.time[part]
    frames = (profiles.time >= time[0]) & (profiles.time <= time[-1])
    temperature = profiles.temperature[frames, 0, :]
    low, high = response.heating.ambient, max(float(temperature.max()), response.heating.ambient + 1.0)
    x = units.length.of(profiles.position)
    # as far as the contact comes, and a little more
    reach = response.bearing.contact_half_side + response.bearing.shares[0] * response.peak_displacement
    side = 1.1 * reach * units.length.factor
    path = units.length.of(response.bearing.shares[0] * response.displacement[part])
    place = kept((path,))
    when = profiles.time[frames]
    return {
        **simple(
            axis("Time [s]", "x", min=round(float(time[0]), 3), max=round(float(time[-1]), 3)),
            axis(f"Position on the plate [{units.length.name}]", "y", min=-side, max=side),
            [line("centre of the slider", points(time[place], path[place]), "#ffffff", lineStyle={"width": 1, "color": "#ffffff"})],
            tooltip={"show": False},
            grid={"left": 52, "right": 84, "top": 34, "bottom": 42},
        ),
        "visualMap": {
            "type": "continuous",
            "seriesIndex": [],
            "min": float(units.temperature.of(np.array(low))),
            "max": float(units.temperature.of(np.array(high))),
            "inRange": {"color": _colours()},
            "text": [f"{units.temperature.text(high)} {units.temperature.name}", f"{units.temperature.text(low)} {units.temperature.name}"],
            "textStyle": {"color": MUTED, "fontSize": 12},
            "right": 8, "top": "middle", "itemHeight": 120, "itemWidth": 12, "calculable": False,
        },
        "pictures": [
            {
                "url": picture(np.flipud(((temperature - low) / (high - low)).T)),
                "x": [float(when[0]), float(when[-1])],
                "y": [float(x[0]), float(x[-1])],
            }
        ],
    }  # fmt: skip


def picture(shares: FloatArray) -> str:
    """Return shares from 0 to 1, shape (rows, columns), as an image in the colours of temperatures: the address of a PNG."""
    from matplotlib import image  # late: Matplotlib takes long to import

    from dcfp.present.figures.style import warm_colours

    stream = io.BytesIO()
    writer: Any = image
    writer.imsave(stream, warm_colours()(np.clip(shares, 0.0, 1.0), bytes=True), format="png")
    return f"data:image/png;base64,{base64.b64encode(stream.getvalue()).decode()}"


@cache
def _colours() -> list[str]:
    from matplotlib.colors import to_hex  # late: Matplotlib takes long to import

    from dcfp.present.figures.style import warm_colours

    return [to_hex(warm_colours()(i / (_COLOURS - 1.0))) for i in range(_COLOURS)]


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
    bar = 200.0 if units.length_name != "in" else 254.0
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
        "colours": _colours(),
        "length": {"unit": units.length.name, "factor": units.length.factor, "decimals": units.length.decimals},
        "heat": {"unit": units.temperature.name, "factor": units.temperature.factor, "offset": units.temperature.offset},
        "bar": {"mm": bar, "words": f"{units.length.factor * bar:.0f} {units.length.name}"},
    }  # fmt: skip
