"""Test programs: those that come with the package, those of codes, and those that a user writes."""

import math

import numpy as np
import pytest

from dcfp.analysis.rig import load_program, run_program
from dcfp.analysis.rig.codes import (
    PrototypeDesign,
    criterion,
    judge_tests,
    property_factors,
    prototype_program,
)
from dcfp.errors import InputError
from dcfp.system import LI_2020

#: Li et al. (2020), Tables 1 and 2: pressure [N/mm2], amplitude [mm], peak velocity [mm/s], period as printed [s], cycles.
DEPENDENCY = {
    "T01": (60, 200, 400, 3.14, 4),
    "T02": (40, 200, 20, 62.83, 4),
    "T03": (60, 200, 20, 62.83, 4),
    "T04": (80, 200, 20, 62.83, 4),
}
ASCE = {
    "T01": (60, 268, 392, 4.26, 3),
    "T02": (60, 10, 14.646, 4.26, 20),
    "T03": (60, 100, 146.369, 4.26, 3),
    "T04": (60, 200, 292.738, 4.26, 3),
    "T05": (60, 268, 392.269, 4.26, 3),
    "T06": (60, 400, 585.476, 4.26, 3),
    "T07": (60, 400, 585.476, 4.26, 3),
    "T08": (40, 400, 585.476, 4.26, 3),
    "T09": (80, 400, 585.476, 4.26, 3),
    "T10": (30, 440, 644.024, 4.26, 1),
    "T11": (90, 440, 644.024, 4.26, 1),
    "T12a": (60, 300, 439.107, 4.26, 7),
    "T12b": (60, 300, 439.107, 4.26, 7),
    "T12c": (60, 300, 439.107, 4.26, 6),
    "T13": (60, 268, 392.269, 4.26, 3),
}


@pytest.mark.parametrize(
    ("name", "table", "slack"), [("dependency", DEPENDENCY, 0.002), ("asce", ASCE, 0.01)]
)
def test_the_papers_programs_are_as_printed(name, table, slack):
    program = load_program(name)
    assert [test.name for test in program.tests] == list(table)
    for test in program.tests:
        pressure, amplitude, velocity, period, cycles = table[test.name]
        wave = test.waveform
        assert test.load.values == (pressure,)
        assert (wave.amplitude, wave.peak_velocity, wave.cycles) == (amplitude, velocity, cycles)
        assert wave.period == pytest.approx(period, rel=slack)


def test_the_heat_of_the_endurance_test_stays_in_the_plate():
    program = load_program("asce")
    assert [len(tests) for tests in program.sequences].count(3) == 1
    loops = {test.test.name: test for test in run_program(program)}
    assert loops["T12a"].temperature[0] == 20.0
    assert 35.0 < loops["T12b"].temperature[0] < loops["T12a"].temperature[-1]
    assert loops["T12b"].temperature[0] < loops["T12c"].temperature[0]
    assert loops["T12c"].begins == pytest.approx(14 * loops["T12a"].test.waveform.period + 600.0)
    assert loops["T13"].temperature[0] == 20.0


def test_a_program_can_be_cut_to_some_tests():
    assert [test.name for test in load_program("asce").only(["T13", "T02"]).tests] == ["T02", "T13"]
    with pytest.raises(InputError, match="has no test 'T99'"):
        load_program("asce").only(["T99"])


FULL = """
name = "mine"
[[test]]
name = "slow"
waveform = "triangle"
amplitude = 50
peak_velocity = 10
cycles = 2
load = 7540
[[test]]
name = "ramped"
amplitude = 100
period = 4.0
cycles = 3
start = "ramp"
ramp_cycles = 2
load_points = [[0, 7540], [5, 9000], [6, 5000]]
pause = 120
"""


def test_a_users_program(tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(FULL)
    program = load_program(path)
    slow, ramped = program.tests
    assert slow.waveform.period == 20.0
    assert slow.load.values == (7.54e6,)
    assert ramped.waveform.peak_velocity == pytest.approx(2.0 * math.pi * 100.0 / 4.0)
    assert ramped.load.at(np.array([2.5, 100.0]), LI_2020) == pytest.approx([8.27e6, 5.0e6])
    assert ramped.pause == 120.0
    assert len(run_program(program)) == 2


def test_a_measured_displacement_is_a_program(tmp_path):
    time = np.arange(0.0, 6.3, 0.01)
    lines = ["time [s],displacement [cm],load [MN]"]
    lines += [f"{t:.2f},{10.0 * math.sin(t):.6f},{5.0 + 0.2 * t:.6f}" for t in time]
    (tmp_path / "own.csv").write_text("\n".join(lines))
    (tmp_path / "own.toml").write_text('[[test]]\nname = "A"\nfile = "own.csv"\n')
    direct = run_program(load_program(tmp_path / "own.csv"))[0]
    named = run_program(load_program(tmp_path / "own.toml"))[0]
    assert direct.displacement.max() == pytest.approx(100.0, abs=1e-3)
    assert direct.load[0] == pytest.approx(5.0e6)
    assert (direct.force == named.force).all()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", "at least one"),
        ("tests = 3", "'tests'; did you mean 'test'"),
        ("test = 3", "at least one"),
        ("[[test]]\n", "amplitude is missing"),
        ("[[test]]\namplitude = 'x'\n", "amplitude: amplitude of the displacement must be a number of mm above 0, not 'x'"),
        ("[[test]]\namplitude = 100\ncycles = 3\n", "either peak_velocity"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\npeak_velocity = 9\n", "either peak_velocity"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 0\n", "period must be a number of s above 0, not 0"),
        ("[[test]]\namplitude = -100\ncycles = 3\nperiod = 4\n", "amplitude of the displacement must be a number of mm above 0, not -100"),
        ("[[test]]\namplitude = 100\ncycles = 1.3\nperiod = 4\n", "whole quarters"),
        ("[[test]]\namplitude = 100\ncycles = 1e9\nperiod = 4\n", "from 1 to 10000"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\npresure = 60\n", "'presure'; did you mean 'pressure'"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\npressure = 60\nload = 7540\n", "give one of"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\nload = -7540\n", "no tension"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\nload_points = [[0, 7540], [1, 0]]\n", "no tension"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\nload_points = [[1, 7540], [0, 7000]]\n", "must increase"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\nload_points = [1, 2]\n", "list of pairs"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\nstart = 'later'\n", "one of speed, peak, ramp"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\nwaveform = 'square'\n", "sine, triangle, circle, ellipse, eight, cloverleaf or file"),
        ("[[test]]\nwaveform = 'triangle'\namplitude = 100\ncycles = 3\nperiod = 4\nstart = 'ramp'\n", "no parameter of a triangle 'start'"),
        ("[[test]]\nfile = 'none.csv'\n", "there is no such file"),
        ("[[test]]\nwaveform = 'file'\n", "must name it"),
        ("[[test]]\nfile = 'none.csv'\ncycles = 3\n", "has no 'cycles'"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\npause = -1\n", "pause before"),
        ("[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\nrole = 'hero'\n", "must be one of"),
        ("code = 'asce'\n[[test]]\namplitude = 100\ncycles = 3\nperiod = 4\n", "'asce'"),
        ("[[test]]\nname = 'A'\namplitude = 1\ncycles = 1\nperiod = 4\n[[test]]\nname = 'A'\namplitude = 1\ncycles = 1\nperiod = 4\n",
         "two tests have the name"),
        ("a = ", "not TOML"),
    ],
)  # fmt: skip
def test_bad_programs_get_one_sentence(tmp_path, text, words):
    path = tmp_path / "bad.toml"
    path.write_text(text)
    with pytest.raises(InputError, match=words) as caught:
        load_program(path)
    sentence = str(caught.value)
    assert "\n" not in sentence
    assert sentence.startswith(str(path))


@pytest.mark.parametrize(
    ("test", "words"),
    [
        ("amplitude = 450\ncycles = 1\nperiod = 4\n", "beyond the plate"),
        ("amplitude = 100\ncycles = 1\nperiod = 4\nload = 7.54\n", "look at the unit of the load"),
        ("amplitude = 100\ncycles = 1\nperiod = 4\npressure = 60000\n", "look at the unit of the load"),
    ],
)
def test_tests_that_the_bearing_cannot_take(tmp_path, test, words):
    path = tmp_path / "bad.toml"
    path.write_text(f"[[test]]\n{test}")
    with pytest.raises(InputError, match=words):
        run_program(load_program(path))


def test_the_asce_sequence_is_that_of_the_paper():
    """With the paper's D_M of 400 mm, D_TM of 440 mm and its period, the sequence has the amplitudes and cycles of Table 2."""
    period = 2.0 * math.pi * 400.0 / 585.476
    design = PrototypeDesign(400.0, period, total_displacement=440.0)
    program = prototype_program("asce7-16", design)
    found = [
        (
            t.load.values[0],
            round(t.waveform.amplitude, 6),
            round(t.waveform.peak_velocity, 2),
            t.waveform.cycles,
        )
        for t in program.tests
    ]
    for name in ("T02", "T03", "T04", "T05", "T06", "T07", "T10", "T11"):
        pressure, amplitude, velocity, _, cycles = ASCE[name]
        assert (pressure, amplitude, pytest.approx(velocity, abs=0.02), cycles) in found, name
    endurance = next(test for test in program.tests if test.role == "endurance")
    assert (endurance.waveform.amplitude, endurance.waveform.cycles) == (300.0, 7 + 7 + 6)


def test_checks_and_factors_of_a_constant_coefficient():
    """Nothing changes from cycle to cycle, so all factors are one and every limit is kept."""
    from dcfp.system import ConstantFriction, NoHeating

    program = load_program("asce")
    loops = run_program(program, friction=ConstantFriction(), heating=NoHeating())
    for factor in property_factors(loops):
        assert factor.upper == pytest.approx(1.0, abs=2e-3)  # the first cycle starts without friction
        assert factor.lower == pytest.approx(1.0, abs=2e-3)
        assert factor.enduring == pytest.approx(1.0, abs=2e-3)
    criteria = judge_tests(program, loops)
    assert criteria
    assert all(item.passed for item in criteria)


def test_heat_makes_the_first_cycle_the_strongest():
    program = load_program("asce")
    loops = run_program(program)
    friction = next(f for f in property_factors(loops) if f.name == "friction of the loop")
    seventh = next(test for test in loops if test.test.name == "T07")
    values = [cycle.loop_friction for cycle in seventh.cycles]
    mean = sum(values) / 3.0
    assert friction.nominal == pytest.approx(mean)
    assert friction.upper == pytest.approx(values[0] / mean)
    assert friction.lower == pytest.approx(values[2] / mean)
    assert friction.first_over_third == pytest.approx(values[0] / values[2])
    assert friction.enduring < friction.lower < 1.0 < friction.upper
    failed = {(item.subject, item.source) for item in judge_tests(program, loops) if not item.passed}
    assert ("T12a + T12b + T12c", "17.8.4 (6)") in failed


def test_en_15129_has_a_sequence_and_its_checks():
    program = prototype_program("en15129", PrototypeDesign(380.0, 4.26))
    assert [test.name for test in program.tests] == ["P1", "D1", "D2", "D3", "E1", "E2", "P2"]
    criteria = judge_tests(program, run_program(program))
    assert {item.of for item in criteria} == {"EN 15129"}
    assert not any(item.confirmed for item in criteria)


def test_a_program_of_no_code_is_not_judged():
    program = load_program("dependency")
    loops = run_program(program.only(["T01"]))
    assert judge_tests(program, loops) == []
    assert property_factors(loops) == []


def test_what_is_not_a_number_never_passes():
    values = {"code": "c", "clause": "1", "test": "t", "statement": "s", "limit": 1.0}
    assert not criterion(**values, value=math.nan).passed
    assert not criterion(**values, value=math.nan, at_least=True).passed
    assert criterion(**values, value=1.0).passed
    assert criterion(**values, value=1.0, at_least=True).passed


@pytest.mark.parametrize(
    "change", [{"displacement": 0.0}, {"period": -1.0}, {"least_load": 0.0}, {"endurance_cycles": 0}]
)
def test_impossible_designs_are_refused(change):
    with pytest.raises(InputError):
        PrototypeDesign(**{"displacement": 400.0, "period": 4.0, **change})
