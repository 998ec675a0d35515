"""What is shown of analyses."""

from collections.abc import Callable

from nicegui import ui

from dcfp.analysis import Response, Status
from dcfp.doors.app.analysis import Predicted, remarks_on
from dcfp.doors.app.charts import predictions
from dcfp.doors.app.charts import response as charts
from dcfp.doors.app.elements import Cell, Chart, Grid, Head, Section, Text
from dcfp.doors.app.fields import card
from dcfp.doors.app.units import Units

_TONES = {Status.OK: "good", Status.BEYOND_CAPACITY: "bad", Status.STILL_MOVING: "doubt"}
_TILES = (
    "Largest displacement",
    "Largest swing",
    "Residual displacement",
    "Input energy V_E",
    "Largest force",
    "Force over weight",
    "Highest temperature",
    "Least friction",
)


class ResponseResults:
    """Numbers, table and charts.

    Parameters
    ----------
    pick
        Called with the number of the analysis that is to be shown.
    """

    def __init__(self, pick: Callable[[int], None]) -> None:
        with ui.element("div").classes("head-row"):
            with ui.element("div").classes("title-row"):
                self._title = Text("h2", "Response")
                self._status = Text("span", "").classes("status")
            self._busy = Text("span", "Calculating …").classes("busy").props("role=status")
        self._tiles = self._add_tiles()
        self._remarks = ui.element("ul").classes("remarks")
        with card("All records", "h3") as self._summary_card:
            self._summary = Grid("Peaks of every record", pick)
        with ui.element("div").classes("halves"):
            with card("Force and displacement", "h3"):
                self._loop = Chart("Horizontal force against displacement")
            with card("The bearing in section, to scale", "h3"):
                self._section = Section()
                Text("p", "Colour: temperature of the contact. Radii and slider are to scale, thicknesses are not known and drawn for the eye.").classes("note")  # fmt: skip
        with card("Histories", "h3"):
            self._histories = Chart("Velocities, displacement, temperature and friction over time", "tall")
        with card("Temperature on the lower plate", "h3") as self._plate_card:
            self._plate = Chart("Temperature along the plate over time, with the path of the slider")
        with ui.element("div").classes("halves"):
            with card("Energy", "h3"):
                self._energy = Chart("Energies over time")
            with card("Pulses of the ground velocity", "h3"):
                self._pulses = Chart("Ground velocity with its pulses")
        with card("Predictions and codes against the analysis", "h3"):
            self._nominal = Text("p").classes("note")
            self._bars = Chart("What each method offers for the largest displacement", "middle")
            self._predictions = Grid("Predictions beside the analysis")
            self._code_remarks = ui.element("ul").classes("remarks")

    def _add_tiles(self) -> list[tuple[Text, Text]]:
        tiles: list[tuple[Text, Text]] = []
        with ui.element("div").classes("tiles"):
            for number, name in enumerate(_TILES):
                with ui.element("div").classes("tile"):
                    Text("div", name).classes("tile-name")
                    value = Text("span", "–").classes("tile-value")
                    value.props(f"data-tile={number}")
                    tiles.append((value, Text("span").classes("tile-unit")))
        return tiles

    def say_busy(self, busy: bool) -> None:
        """Say whether something is being calculated."""
        self._busy.text = "Calculating …" if busy else ""

    def say_old(self) -> None:
        """Say that what is shown is not of the input that was refused since."""
        self._status.text = "of the last valid input"
        self._status.classes(replace="status old")

    def show(self, responses: list[Response], number: int, units: Units) -> None:
        """Show analyses, one of them in all detail."""
        one = responses[number]
        self._title.text = (
            f"{one.motion.name}, PGV {units.velocity.text(one.motion.peak_velocity)} {units.velocity.name}"
        )
        self._status.text = one.status.value
        self._status.classes(replace=f"status {_TONES[one.status]}")
        self._fill_tiles(one, units)
        _write_list(self._remarks, remarks_on(one))
        self._summary_card.set_visibility(len(responses) > 1)
        self._summary.fill(_heads(units), [_row(response, units) for response in responses], number)
        self._loop.draw(charts.loop(one, units))
        self._section.load(charts.scene(one, units))
        self._histories.draw(charts.histories(one, units))
        self._energy.draw(charts.energies(one, units))
        plate = charts.plate(one, units)
        self._plate_card.set_visibility(plate is not None)
        if plate is not None:
            self._plate.draw(plate)

    def _fill_tiles(self, one: Response, units: Units) -> None:
        ratio = one.peak_force / one.bearing.vertical_force
        values = (
            (units.length.text(one.peak_displacement), units.length.name),
            (units.length.text(one.peak_change), units.length.name),
            (units.length.text(one.residual_displacement), units.length.name),
            (units.velocity.text(one.input_velocity), units.velocity.name),
            (units.force.text(one.peak_force), units.force.name),
            (f"{ratio:.3f}", ""),
            (units.temperature.text(one.peak_temperature), units.temperature.name),
            (f"{one.least_friction:.4f}", ""),
        )
        for (value, unit), (shown, name) in zip(self._tiles, values, strict=True):
            value.text, unit.text = shown, name

    def show_predictions(self, response: Response, predicted: Predicted, units: Units) -> None:
        """Show predictions and codes beside the analysis."""
        case, nominal = predicted.case, predicted.nominal
        self._pulses.draw(charts.pulses(response, case, units))
        self._nominal.text = f"The methods take a constant µ of {nominal.value:.4g}: {nominal.source}."
        self._bars.draw(predictions.bars(case, units))
        self._predictions.fill(
            predictions.prediction_head(units), predictions.prediction_rows(case, units), 0
        )
        _write_list(self._code_remarks, predictions.code_remarks(case))


def _write_list(place: ui.element, sentences: list[str]) -> None:
    place.clear()
    place.set_visibility(bool(sentences))
    with place:
        for sentence in sentences:
            Text("li", sentence)


def _heads(units: Units) -> list[Head]:
    length, velocity = units.length.name, units.velocity.name
    return [
        Head("Record", number=False),
        Head("PGV", velocity),
        Head("y_max", length),
        Head("dy_max", length),
        Head("v_max", velocity),
        Head("residual", length),
        Head("F_max", units.force.name),
        Head("F/W", "–"),
        Head("T_max", units.temperature.name),
        Head("µ_min", "–"),
        Head("V_E", velocity),
        Head("V_Eh", velocity),
        Head("Status", number=False),
    ]


def _row(one: Response, units: Units) -> list[Cell | str]:
    length, velocity = units.length, units.velocity
    return [
        one.motion.name,
        velocity.text(one.motion.peak_velocity),
        length.text(one.peak_displacement),
        length.text(one.peak_change),
        velocity.text(one.peak_velocity),
        length.text(one.residual_displacement),
        units.force.text(one.peak_force),
        f"{one.peak_force / one.bearing.vertical_force:.3f}",
        units.temperature.text(one.peak_temperature),
        f"{one.least_friction:.4f}",
        velocity.text(one.input_velocity),
        velocity.text(one.hysteretic_velocity),
        Cell(one.status.value, _TONES[one.status]),
    ]
