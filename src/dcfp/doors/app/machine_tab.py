"""The page of the test machine."""

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

from nicegui import ui

from dcfp.analysis.rig import Loops, Program, RigTest, Sine, load_program, run_program
from dcfp.doors.app import downloads
from dcfp.doors.app.charts import machine as charts
from dcfp.doors.app.elements import Chart, Grid, Text
from dcfp.doors.app.fields import Alert, BearingPanel, action, card, choice_field, number_field
from dcfp.doors.app.forms import Limits
from dcfp.doors.app.session import Latest, Session
from dcfp.errors import DcfpError, InputError

if TYPE_CHECKING:
    from dcfp.analysis.rig.waveform import Start

_SINE = "sine"
PROGRAMS = {
    "dependency": "dependency tests of Li et al. (2020)",
    "asce": "ASCE tests of Li et al. (2020)",
    _SINE: "a sine of your own",
}
_STARTS = {
    "speed": "at zero displacement, full speed",
    "ramp": "from rest, growing",
    "peak": "from rest, at the amplitude",
}
_ALL = "all tests"
_AMPLITUDE, _VELOCITY, _CYCLES = Limits(1.0, 2000.0, 10.0), Limits(0.1, 2000.0, 10.0), Limits(1.0, 50.0, 1.0)


@dataclass
class _Wave:
    """The sine of the visitor's own [mm, mm/s, -]."""

    amplitude: float | None = 200.0
    peak_velocity: float | None = 400.0
    cycles: float | None = 4.0
    start: str = "speed"

    def program(self) -> Program:
        """Return it as a program of one test."""
        for value, limits, words in (
            (self.amplitude, _AMPLITUDE, "amplitude [mm]"),
            (self.peak_velocity, _VELOCITY, "peak velocity [mm/s]"),
            (self.cycles, _CYCLES, "number of cycles"),
        ):
            if value is None or not limits.least <= value <= limits.most:
                msg = f"The {words} must be from {limits.least:g} to {limits.most:g}."
                raise InputError(msg)
        assert self.amplitude is not None
        assert self.peak_velocity is not None
        assert self.cycles is not None
        wave = Sine(self.amplitude, self.peak_velocity, int(self.cycles), cast("Start", self.start))
        return Program("sine", (RigTest("sine", wave),))


class MachineTab:
    """Fields and results of the test machine; arguments as for `ResponseTab`."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._client = ui.context.client
        self._name, self._wave, self._chosen = "dependency", _Wave(), _ALL
        self._tests: list[Loops] = []
        self._latest = Latest(self._work)
        with ui.element("div").classes("body"):
            with ui.element("aside").classes("side").props('aria-label="What is tested"'):
                self._add_program()
                self._bearing = BearingPanel(session.bearing, self.ask)
            with ui.element("div").classes("results"):
                self._alert = Alert()
                self._add_results()

    def _add_program(self) -> None:
        with card("Test program"):
            choice_field("Program", PROGRAMS, self._name, self._choose_program)
            with ui.element("div").classes("field") as self._own:
                with ui.element("div").classes("pair"):
                    number_field(
                        "Amplitude", "mm", self._wave.amplitude, _AMPLITUDE, self._setter("amplitude")
                    )
                    number_field(
                        "Peak velocity",
                        "mm/s",
                        self._wave.peak_velocity,
                        _VELOCITY,
                        self._setter("peak_velocity"),
                    )
                number_field("Cycles", "", self._wave.cycles, _CYCLES, self._setter("cycles"))
                choice_field("Start", _STARTS, self._wave.start, self._setter("start"))
            self._own.set_visibility(False)
            self._which = choice_field("Shown", {_ALL: _ALL}, _ALL, self._choose_test)  # fmt: skip

    def _add_results(self) -> None:
        with ui.element("div").classes("head-row"):
            self._title = Text("h2", "Test machine")
            self._busy = Text("span", "").classes("busy").props("role=status")
        with ui.element("div").classes("halves"):
            with card("Loops", "h3"):
                self._loops = Chart("Force against displacement of the tests", "middle")
            with card("Friction in each cycle", "h3"):
                self._friction = Chart("Coefficient of friction in each cycle", "middle")
        with card("Temperature of the contact", "h3"):
            self._temperature = Chart("Temperature of the contact over the time of each test")
        with card("Measures of each cycle", "h3"):
            self._measures = Grid("Measures of each cycle")
            Text("p", "k_eff and β_eff as ASCE/SEI 7-16, section 17.8; µ at zero: force over load where the displacement passes zero.").classes("note")  # fmt: skip
        self._remarks = ui.element("ul").classes("remarks")
        with card("Take it away", "h3"), ui.element("div").classes("actions"):
            self._add_download("Measures (CSV)", "tests.csv", downloads.tests_csv)
            self._add_download("All data (NetCDF)", "tests.nc", downloads.tests_netcdf)

    def open(self) -> None:
        """Show the fields as another page may have left them, and test."""
        self._bearing.refresh()
        self.ask()

    def ask(self) -> None:
        """Test what the fields hold."""
        self._latest.ask()

    def show_again(self) -> None:
        """Show the same in other units, or another test of them."""
        if not self._tests:
            return
        units = self._session.units
        some = [test for test in self._tests if self._chosen in (_ALL, test.test.name)]
        self._loops.draw(charts.loops_chart(some, units))
        self._friction.draw(charts.friction_chart(self._tests))
        self._temperature.draw(charts.temperature_chart(some, units))
        self._measures.fill(charts.cycle_head(units), charts.cycle_rows(some, units))
        self._remarks.clear()
        with self._remarks:
            for sentence in grouped(self._tests):
                Text("li", sentence)

    async def _work(self) -> None:
        try:
            model = self._session.bearing.model()
            program = self._wave.program() if self._name == _SINE else load_program(self._name)
            tests = await asyncio.to_thread(
                run_program, program, model.bearing, model.friction, model.heating
            )
        except DcfpError as error:
            if not self._client.is_deleted:
                self._alert.say(str(error))
            return
        if self._client.is_deleted:
            return
        self._alert.say("")
        self._tests = list(tests)
        self._title.text = PROGRAMS[self._name][:1].upper() + PROGRAMS[self._name][1:]
        names = [_ALL, *(test.test.name for test in tests)]
        if self._chosen not in names:
            self._chosen = _ALL
        self._which.set_options({name: name for name in names}, value=self._chosen)
        self.show_again()

    def _choose_program(self, name: str) -> None:
        self._name = name
        self._own.set_visibility(name == _SINE)
        self.ask()

    def _choose_test(self, name: str) -> None:
        if name and name != self._chosen:
            self._chosen = name
            self.show_again()

    def _setter(self, name: str) -> Callable[[object], None]:
        def set_value(value: object) -> None:
            setattr(self._wave, name, value)
            self.ask()

        return set_value

    def _add_download(self, label: str, name: str, make: Callable[[list[Loops]], bytes]) -> None:
        async def give() -> None:
            if self._tests:
                ui.download(await asyncio.to_thread(make, self._tests), name)

        action(label, give)


def grouped(tests: list[Loops]) -> list[str]:
    """Return the remarks of tests, those that several share once with all their names."""
    names: dict[str, list[str]] = {}
    for test in tests:
        for remark in test.remarks:
            told = remark.removeprefix(f"{test.test.name}: ")
            names.setdefault(told, []).extend([test.test.name] if told != remark else [])
    return [f"{', '.join(members)}: {told}" if members else told for told, members in names.items()]
