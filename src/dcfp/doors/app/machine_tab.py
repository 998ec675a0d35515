"""The page of the test machine."""

import asyncio
from dataclasses import replace
from functools import partial

import numpy as np
from nicegui import ui

from dcfp.analysis.rig import Loops, Program, RigTest, Sine, load_program, run_program
from dcfp.analysis.rig.loops import CYCLES
from dcfp.analysis.rig.virtual_test import rounds_of
from dcfp.doors.app.analysis import table_of
from dcfp.doors.app.charts import chart, line, points
from dcfp.doors.app.elements import Chart, Grid, Options, Text
from dcfp.doors.app.fields import card, choice_field, parameter_field
from dcfp.doors.app.session import Session, capitalised, read_field
from dcfp.doors.app.tab import Tab, write_list
from dcfp.present import panels
from dcfp.present.tables import write_tests
from dcfp.schema.parameters import Parameter
from dcfp.schema.table import Table
from dcfp.schema.units import MM, MM_PER_S, NONE

_SINE = "sine"
_PROGRAMS = {
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
#: What is told of a cycle here, besides what tables have.
_ALSO = ("displacement_min_mm", "friction_of_loop")
#: Cycles that are drawn with a mark each.
_FEW = 40


class MachineTab(Tab):
    """Fields and results of the test machine."""

    def __init__(self, session: Session) -> None:
        self._name, self._chosen = "dependency", _ALL
        self._wave = {key: one.default for key, one in _WAVE.items()}
        self._tests: list[Loops] = []
        super().__init__(session, "What is tested", "Test machine")

    def add_fields(self) -> None:
        """Add the program."""
        with card("Test program"):
            choice_field("Program", _PROGRAMS, self._name, self._choose_program)
            with ui.element("div").classes("pair") as self._own:
                for key, one in _WAVE.items():
                    parameter_field(one, one.default, partial(self._set_wave, key), _STARTS)
            self._own.set_visibility(False)
            self._which = choice_field("Shown", {_ALL: _ALL}, _ALL, self._choose_test)

    def add_results(self) -> None:
        """Add charts and table."""
        with ui.element("div").classes("halves"):
            with card("Loops", "h3"):
                self._loops = Chart("Force against displacement of the tests", "middle")
            with card("Friction in each cycle", "h3"):
                self._friction = Chart("Coefficient of friction in each cycle", "middle")
        with card("Temperature of the contact", "h3"):
            self._temperature = Chart("Temperature of the contact over the time of each test")
        with card("Measures of each cycle", "h3"):
            self._measures = Grid("Measures of each cycle")
            Text("p", "k_eff and b_eff as ASCE/SEI 7-16, section 17.8; mu_0: force over load where the displacement passes zero.").classes("note")  # fmt: skip
        self._remarks = ui.element("ul").classes("remarks")
        self.add_files(
            ("Measures (CSV)", "tests.csv", lambda: table_of(write_tests, self._tests, ".csv")),
            ("All data (NetCDF)", "tests.nc", lambda: table_of(write_tests, self._tests, ".nc")),
        )

    async def work(self) -> None:
        """Run the program."""
        system = self.session.bearing.system()
        if self._name == _SINE:
            wave = {key: read_field(one, self._wave[key]) for key, one in _WAVE.items()}
            program = Program(_SINE, (RigTest(_SINE, Sine(**wave)),))
        else:
            program = load_program(self._name)
        tests = await asyncio.to_thread(run_program, program, system)
        if self.is_gone:
            return
        self.complain("")
        self._tests = list(tests)
        self.title.text = capitalised(_PROGRAMS[self._name])
        names = [_ALL, *(test.test.name for test in tests)]
        if self._chosen not in names:
            self._chosen = _ALL
        self._which.set_options({name: name for name in names}, value=self._chosen)
        self.show_again()

    def show_again(self) -> None:
        """Show the same in other units, or another test of them."""
        if not self._tests:
            return
        units = self.session.units
        some = [test for test in self._tests if self._chosen in (_ALL, test.test.name)]
        self._loops.draw(chart(panels.of_tests(some, "force", "displacement", "force"), units))
        self._friction.draw(friction_chart(self._tests))
        scroll = {"type": "scroll", "left": 230}
        self._temperature.draw(chart(panels.of_tests(some, "temperature"), units, 300, legend=scroll))
        told = [replace(one, printed=one.printed or one.key in _ALSO) for one in CYCLES]
        self._measures.show(Table(tuple(told), rounds_of(some)), units)
        write_list(self._remarks, grouped(self._tests))

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


def friction_chart(tests: list[Loops]) -> Options:
    """Draw the coefficient at zero displacement and of the whole loop in each cycle, the tests one after another."""
    cycles = [cycle for test in tests for cycle in test.cycles]
    number = np.arange(1.0, len(cycles) + 1.0)
    marks = {"showSymbol": len(cycles) <= _FEW, "symbol": "circle", "symbolSize": 6}
    series = [
        line(words, points(number, np.array([getattr(cycle, name) for cycle in cycles])), colour, **marks)
        for words, name, colour in (
            ("at zero displacement", "friction", panels.BLUE),
            ("whole loop", "loop_friction", panels.OCHRE),
        )
    ]
    x = {"name": "Cycle, all tests in order", "minInterval": 1, "min": 0.5, "max": len(cycles) + 0.5}
    return {"xAxis": x, "yAxis": {"name": "µ [–]"}, "series": series, "legend": {}}


def grouped(tests: list[Loops]) -> list[str]:
    """Return the remarks of tests, those that several share once with all their names."""
    names: dict[str, list[str]] = {}
    for test in tests:
        for remark in test.remarks:
            told = remark.removeprefix(f"{test.test.name}: ")
            names.setdefault(told, []).extend([test.test.name] if told != remark else [])
    return [f"{', '.join(members)}: {told}" if members else told for told, members in names.items()]
