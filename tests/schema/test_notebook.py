"""What a notebook shows of results: well-formed HTML, nothing of a user's as markup, and the numbers that matter."""

from dataclasses import dataclass, field, replace
from html.parser import HTMLParser

import numpy as np
import pytest

import dcfp
from dcfp.analysis.plan.shear_building import respond_in_one_direction, shear_building
from dcfp.analysis.rig import Program, RigTest, Sine
from dcfp.inference import Methods
from dcfp.methods import li_2020
from dcfp.methods.code_comparison import codes_under_record
from dcfp.methods.spectra import TabulatedSpectrum, input_energy_spectrum, response_spectrum
from dcfp.motion import named_records
from dcfp.schema.check import Check, Verdict
from dcfp.schema.notebook import MOST_ROWS, card, fields_card, shown, told
from dcfp.schema.quantities import Quantity
from dcfp.schema.units import MM
from dcfp.study import Study
from dcfp.study.scenario import Scenario, calculate
from dcfp.system import LI_2020, System

EVIL = "<script>alert('x')</script> & \"more\""


class Reader(HTMLParser):
    """Reads HTML, and refuses what is not closed in its order."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: set[str] = set()
        self.text = ""

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.open.append(tag)
        self.tags.add(tag)
        for _, value in attrs:
            assert value is not None
            assert "#" not in value.replace("currentColor", "")

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += f"{data} "


def read(html: str) -> Reader:
    reader = Reader()
    reader.feed(html)
    reader.close()
    assert reader.open == []
    assert reader.tags <= {"div", "strong", "table", "tr", "th", "td", "ul", "li"}
    return reader


def results() -> dict[str, tuple[object, tuple[str, ...]]]:
    """Return public results of evil names, each with words that its HTML must hold."""
    motion = replace(dcfp.load_motion("NCC").scaled_to_pgv(500.0), name=EVIL)
    bearing = replace(LI_2020, name=EVIL, displacement_capacity=50.0)
    response = dcfp.respond(motion, bearing)
    peak = f"{response.peak_displacement:.5g}"
    pulses = dcfp.find_pulses(motion)
    case = dcfp.compare(motion, Methods(System(bearing)), codes=True)
    program = Program(EVIL, (RigTest(EVIL, Sine(40.0, 100.0, 2)),))
    loops = dcfp.run_program(program, bearing)[0]
    building = shear_building(3, 0.5, System(bearing))
    comparison = codes_under_record(motion, System(bearing), 0.043)
    study = Study([motion], {"pgv": [250.0, 500.0]}, model=System(bearing), title=EVIL)
    calculation = calculate(Scenario(study))
    station = replace(dcfp.load_station("P695-FF-2"), name=EVIL)
    in_plane = dcfp.respond(station, bearing, heating="none", pgv=500.0)
    stations = Study([station], {"pgv": [500.0]}, model=System.of(bearing, heating="none"), title=EVIL)
    return {
        "motion": (motion, ("PGV [mm/s]", "500", motion.digest, "scaled by")),
        "station": (station, ("PGV [mm/s]", f"{station.peak_velocity:.5g}", station.digest)),
        "response in the plane": (in_plane, ("y1_max [mm]", f"{in_plane.peak_displacement_x:.5g}", "exceeds the capacity of 50 mm")),
        "study of stations": (stations, ("500", "analyses")),
        "calculation in the plane": (calculate(Scenario(stations)), ("y2_max [mm]", f"{in_plane.peak_displacement_y:.5g}")),
        "origin": (motion.origin, ("Canyon Country",)),
        "record": (named_records()[-1], ("P695-NF-28-b",)),
        "bearing": (bearing, ("radii [mm]", "4500, 4500", "vertical_force [N]")),
        "law": (dcfp.Kumar2015(), ("reference_pressure [N/mm2]", "60")),
        "cautious law": (dcfp.Lomiento2013(), ("unconfirmed",)),
        "heating": (dcfp.PreciseHeating(ambient=-10.0), ("ambient [degC]", "-10", "cells")),
        "model": (System(bearing), ("Li2020(", "SimplifiedHeating(")),
        "response": (response, ("y_max [mm]", peak, "beyond capacity", "exceeds the capacity of 50 mm")),
        "energy": (response.energy, ("hysteretic", "values")),
        "building": (building, ("mass [t]", "3 storeys")),
        "building response": (respond_in_one_direction(building, motion), ("y_max [mm]", "3 storeys")),
        "program": (program, ("sine",)),
        "test": (program.tests[0], ("waveform",)),
        "loops": (loops, ("keff [kN/mm]", f"{loops.cycles[0].effective_stiffness / 1e3:.5g}")),
        "cycle": (loops.cycles[0], ("Cycle 1",)),
        "pulses": (pulses, ("velocity [mm/s]", f"{pulses.velocities[0]:.5g}")),
        "prediction": (li_2020.predict_from_pgv(500.0), ("displacement_change [mm]", "216.61")),
        "pulse prediction": (li_2020.predict_from_pulses(pulses), ("governing pulse",)),
        "march": (dcfp.march_through_pulses(motion), ("nodes", "comes to rest", "peak_temperature [degC]")),
        "case": (case, ("pulse march", "ASCE 7-16 ELF", "outside its limits", peak)),
        "answer": (case.codes["ASCE 7-16 ELF"], ("verdict", "effective damping", "not met")),
        "condition": (case.codes["ASCE 7-16 ELF"].conditions[0], ("verdict",)),
        "comparison of codes": (comparison, ("Eurocode 8 simplified", "analysis [mm]")),
        "methods": (Methods(System(bearing)), ("march_tolerance",)),
        "spectrum": (response_spectrum(motion), ("periods [s]", "displacement [mm]")),
        "energy spectrum": (input_energy_spectrum(motion), ("velocity [mm/s]", "total_acceleration [mm/s2]")),
        "table": (TabulatedSpectrum(np.array([1.0, 2.0]), np.array([1.0, 2.0]), EVIL), ("accelerations [mm/s2]",)),
        "study": (study, ("250, 500", "analyses")),
        "scenario": (calculation.scenario, ("Li2020(",)),
        "result": (calculation.results[1], ("y_max [mm]", peak)),
        "calculation": (calculation, ("y_max [mm]", peak, "exceeds the capacity")),
        "check": (Check(EVIL, Verdict.MET, 1.0, "1 mm", unit="mm"), ("found",)),
    }  # fmt: skip


@pytest.fixture(scope="module")
def known() -> dict[str, tuple[object, tuple[str, ...]]]:
    return results()


def test_every_result_is_well_formed_and_has_its_numbers(known) -> None:
    for name, (result, words) in known.items():
        reader = read(result._repr_html_())
        for word in words:
            assert word in reader.text, (name, word, reader.text[:2000])


def test_what_identify_finds_shows_its_constants(tmp_path) -> None:
    tests = Program(
        "tests", tuple(RigTest(f"T{i}", Sine(150.0, speed, 3)) for i, speed in enumerate((50.0, 400.0)))
    )
    files = []
    for loops in dcfp.run_program(tests):
        table = np.column_stack((loops.time, loops.displacement, loops.force / 1e3, loops.load / 1e3))
        files.append(tmp_path / f"{loops.test.name}.csv")
        head = "time [s],displacement [mm],force [kN],load [kN]"
        np.savetxt(files[-1], table, delimiter=",", header=head, comments="")
    measurements = [dcfp.read_measurement(file) for file in files]
    assert "displacement [mm]" in read(measurements[0]._repr_html_()).text
    found = dcfp.identify(measurements)
    text = read(found._repr_html_()).text
    for one in found.estimates:
        assert one.name in text
        assert f"{one.value:.5g}" in text
    assert "samples used" in read(found.histories[0]._repr_html_()).text


def test_every_public_class_of_results_has_html(known) -> None:
    shown_classes = {type(result).__name__ for result, _ in known.values()}
    public = {name for name in dir(dcfp) if isinstance(getattr(dcfp, name, None), type)}
    left_out = {"AnalysisError", "DcfpError", "InputError", "Keep", "Sampling"}
    laws = {name for name in public if hasattr(getattr(dcfp, name), "_repr_html_")}
    assert public - left_out <= shown_classes | laws
    assert not {name for name in public - left_out if not hasattr(getattr(dcfp, name), "_repr_html_")}


def test_a_long_table_is_cut_and_says_so() -> None:
    text = read(card("many", rows=[{"number": i} for i in range(MOST_ROWS + 7)])).text
    assert "and 7 more rows" in text


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (None, "–"), ("", "–"), (True, "yes"), (float("nan"), "–"), (1.0 / 3.0, "0.33333"), ((), "–"), ((1.0, 2.5), "1, 2.5"),
        (np.array([1.0, 3.0]), "1 to 3, 2 values"), (np.array([]), "0 values"), (np.array(["a"]), "1 values"), (3, "3"),
    ],
)  # fmt: skip
def test_values(value: object, words: str) -> None:
    assert shown(value) == words


def test_units_come_from_declarations() -> None:
    @dataclass
    class Thing:
        length: float = field(default=1.0, metadata={"unit": MM})
        peak_velocity: float = 2.0
        load: str = "a word"

    text = read(fields_card(Thing())).text
    assert "length [mm]" in text
    assert "peak_velocity [mm/s]" in text
    assert "load [" not in text
    assert list(told([Quantity("y_max_mm", "", MM, name="y_max", get="length")], Thing())) == ["y_max [mm]"]


def test_a_unit_of_one_is_not_shown() -> None:
    assert "threshold [" not in read(fields_card(dcfp.find_pulses(dcfp.load_motion("NCC")), EVIL)).text
