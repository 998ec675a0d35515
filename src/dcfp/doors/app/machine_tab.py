"""The page of the test machine."""

import asyncio
from collections.abc import Callable
from functools import partial

from nicegui import ui

from dcfp.analysis.rig import Loops, Program, RigTest, Sine, load_program, run_program
from dcfp.doors.app import downloads
from dcfp.doors.app.charts import machine as charts
from dcfp.doors.app.charts.look import chart, legend
from dcfp.doors.app.elements import Chart, Grid, Text
from dcfp.doors.app.fields import Alert, BearingPanel, action, card, choice_field, parameter_field
from dcfp.doors.app.forms import read_field
from dcfp.doors.app.session import Latest, Session
from dcfp.errors import DcfpError
from dcfp.present import panels
from dcfp.schema.parameters import Parameter
from dcfp.schema.units import MM, MM_PER_S, NONE

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
#: The sine of the visitor's own, with the values at first.
_WAVE = {
    "amplitude": Parameter("amplitude", MM, 1.0, 2000.0, step=10.0, default=200.0),
    "peak_velocity": Parameter("peak velocity", MM_PER_S, 0.1, 2000.0, step=10.0, default=400.0),
    "cycles": Parameter("number of cycles", NONE, 1, 50, step=1, kind=int, default=4),
    "start": Parameter("start", choices=tuple(_STARTS), kind=str, default="speed"),
}


class MachineTab:
    """Fields and results of the test machine; arguments as for `ResponseTab`."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._client = ui.context.client
        self._name, self._chosen = "dependency", _ALL
        self._wave = {key: one.default for key, one in _WAVE.items()}
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
            with ui.element("div").classes("pair") as self._own:
                for key, one in _WAVE.items():
                    parameter_field(one, one.default, partial(self._set_wave, key), _STARTS)
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
        self._loops.draw(chart(panels.loops(some), units))
        self._friction.draw(charts.friction_chart(self._tests))
        scroll = legend(type="scroll", left=230)
        self._temperature.draw(chart(panels.temperatures(some), units, 300, legend=scroll))
        self._measures.fill(charts.cycle_head(units), charts.cycle_rows(some, units))
        self._remarks.clear()
        with self._remarks:
            for sentence in grouped(self._tests):
                Text("li", sentence)

    async def _work(self) -> None:
        try:
            model = self._session.bearing.system()
            program = self._own_program() if self._name == _SINE else load_program(self._name)
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

    def _set_wave(self, key: str, value: object) -> None:
        self._wave[key] = value
        self.ask()

    def _own_program(self) -> Program:
        """Return the sine of the visitor's own as a program of one test."""
        wave = {key: read_field(one, self._wave[key]) for key, one in _WAVE.items()}
        return Program("sine", (RigTest("sine", Sine(**wave)),))

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
