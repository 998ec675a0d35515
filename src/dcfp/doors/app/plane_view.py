"""What the page shows of an analysis in the plane: the orbit, the plate over time, and the histories of both directions."""

from dataclasses import replace
from typing import Any

import numpy as np
from nicegui import ui

from dcfp.analysis.plane_response import PlaneResponse
from dcfp.doors.app.charts import chart, image_of, kept_of_path, label, rows, warm_colours
from dcfp.doors.app.elements import Chart, Options, Plate, Text, Units
from dcfp.doors.app.fields import card
from dcfp.present import panels
from dcfp.schema.quantities import quantity
from dcfp.schema.units import MM

#: Colours that an orbit is drawn with.
_SHADES = 16
#: Pictures beside each other in the image that holds all of them.
_ACROSS = 8
_LENGTH = replace(quantity("displacement"), decimals=1)
_NO_FIELD = (
    "The temperature over the plate is that of the precise heating model: choose it under Friction and heat."
)


class PlaneView:
    """The cards of an analysis in the plane."""

    def __init__(self) -> None:
        with ui.element("div").classes("results") as self._place:
            with ui.element("div").classes("halves"):
                with card("Path of the isolation layer", "h3"):
                    self._orbit = Chart("Displacement in both directions, coloured by temperature", "square")
                with card("Temperature over the plate", "h3"):
                    self._plate = Plate()
                    self._note = Text("p").classes("note")
            with card("Histories of both directions", "h3"):
                self._histories = Chart(
                    "Ground velocity, displacement and force in both directions and their resultant, temperature and friction over time",
                    "taller",
                )
            with card("Energy", "h3"):
                self._energy = Chart("Energies over time")
            Text("p", "Pulses, predictions and codes are of one direction; choose a single component to see them.").classes("note")  # fmt: skip

    def set_visibility(self, seen: bool) -> None:
        """Show the cards or not."""
        self._place.set_visibility(seen)

    def show(self, response: PlaneResponse, units: Units) -> None:
        """Show an analysis."""
        self._orbit.draw(orbit(response, units))
        has_field = response.fields is not None
        self._plate.set_visibility(has_field)
        self._note.text = _plate_words(response) if has_field else _NO_FIELD
        if has_field:
            self._plate.load(plate_scene(response, units))
        described = [
            *(panels.directions(response, name) for name in ("ground_velocity", "displacement", "force")),
            panels.temperature(response),
            panels.friction(response),
        ]
        self._histories.draw(rows(described, units))
        self._energy.draw(chart(panels.energies(response), units))


def orbit(response: PlaneResponse, units: Units) -> Options:
    """Draw the path of the isolation layer in colours of the temperature of the contact."""
    part, length, heat = panels.shown(response), units.of(_LENGTH), units.of(quantity("temperature"))
    path, temperature = response.displacement_vectors[part], response.temperature[part]
    places = kept_of_path(path[:, 0], path[:, 1])
    path, temperature = length.shown(path[places]), temperature[places]
    low, high = panels.colour_ends(response, "temperature")
    shares = (0.5 * (temperature[:-1] + temperature[1:]) - low) / (high - low)
    shade_of = np.clip((shares * _SHADES).astype(int), 0, _SHADES - 1)
    ends = np.flatnonzero(np.diff(shade_of)) + 1
    pieces: list[list[Any]] = [[] for _ in range(_SHADES)]
    for first, last in zip((0, *ends.tolist()), (*ends.tolist(), shade_of.size), strict=True):
        # a gap parts it from what has the same colour before
        pieces[shade_of[first]] += [[None, None], *np.round(path[first : last + 1], 4).tolist()]
    colours = warm_colours()
    reach = float(length.shown(1.08 * max(response.peak_displacement, 1.0)))
    ends_of_axis = {"min": -reach, "max": reach, "splitNumber": 4}
    return {
        "xAxis": {"name": label("direction x", _LENGTH, units), **ends_of_axis},
        "yAxis": {"name": label("direction y", _LENGTH, units), **ends_of_axis},
        "grid": {"left": 58, "right": 18, "top": 34, "bottom": 42},
        "series": [
            {"name": f"{shade}", "data": data, "color": colours[(shade * len(colours)) // _SHADES], "silent": True}
            for shade, data in enumerate(pieces)
        ],
        "tooltip": {"show": False},
        "visualMap": {
            "type": "continuous", "seriesIndex": [], "min": float(heat.shown(low)), "max": float(heat.shown(high)),
            "inRange": {"color": colours}, "orient": "horizontal", "right": 8, "top": 0, "itemHeight": 90, "itemWidth": 10,
            "text": [f"{heat.shown(end):.0f} {heat.name}" for end in (high, low)], "calculable": False,
        },
    }  # fmt: skip


def plate_scene(response: PlaneResponse, units: Units) -> dict[str, Any]:
    """Return what the picture of the plate shows: its temperature at every moment in one image, the path of the slider and its size, and how to write numbers."""
    fields = response.fields
    assert fields is not None
    plate = _hotter(response)
    values = fields.temperature[:, plate]
    ambient = response.heating.ambient
    high = max(float(values.max()), ambient + 1.0)
    samples = np.searchsorted(response.time, fields.time - 1e-9)
    path = response.bearing.shares[plate] * response.displacement_vectors[: int(samples[-1]) + 1]
    kept = np.unique(np.concatenate((kept_of_path(path[:, 0], path[:, 1]), samples)))
    hottest = [np.unravel_index(int(one.argmax()), one.shape) for one in values]
    length, heat = units.of(_LENGTH), units.of(quantity("temperature"))
    spacing = float(fields.x[1] - fields.x[0])
    return {
        "url": image_of(beside((values[:, ::-1] - ambient) / (high - ambient))),
        "across": _ACROSS, "width": fields.x.size, "height": fields.y.size,
        "left": float(fields.x[0]) - 0.5 * spacing, "top": float(fields.y[-1]) + 0.5 * spacing, "spacing": spacing,
        "times": np.round(fields.time, 3).tolist(), "shows": fields.hottest,
        "path": np.round(path[kept], 1).tolist(), "ends": np.searchsorted(kept, samples).tolist(),
        "hottest": [
            [float(fields.x[column]), float(fields.y[row]), round(float(one[row, column]), 1)]
            for one, (row, column) in zip(values, hottest, strict=True)
        ],
        "radius": 0.5 * response.bearing.slider_diameter,
        "low": ambient, "high": high, "colours": warm_colours(),
        "length": {"unit": length.name, "size": length.size, "decimals": 0 if length is MM else 1},
        "heat": {"unit": heat.name, "size": heat.size, "zero": heat.zero},
    }  # fmt: skip


def _hotter(response: PlaneResponse) -> int:
    """Return which plate becomes hotter."""
    fields = response.fields
    return 0 if fields is None else int(fields.temperature.max(axis=(0, 2, 3)).argmax())


def _plate_words(response: PlaneResponse) -> str:
    which = (
        "" if len(set(response.bearing.radii)) == 1 else f", plate {_hotter(response) + 1}, the hotter one"
    )
    return (
        f"Dashed: the slider. White: the path of its centre. The dot: the hottest point of the moment{which}."
    )


def beside(pictures: Any) -> Any:
    """Return pictures of shape (n, rows, columns) beside and below each other as one."""
    count, tall, wide = pictures.shape
    below = -(-count // _ACROSS)
    whole = np.zeros((below * _ACROSS, tall, wide))
    whole[:count] = pictures
    return whole.reshape(below, _ACROSS, tall, wide).swapaxes(1, 2).reshape(below * tall, _ACROSS * wide)
