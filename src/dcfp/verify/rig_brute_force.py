"""The virtual test machine against a brute-force integration of whole tests, and its tests cut in two."""

from dataclasses import replace
from functools import cache, partial

import numpy as np

from dcfp.analysis.rig import Loops, Program, RigTest, Sine, VerticalLoad, run_program
from dcfp.arrays import FloatArray
from dcfp.system import LI_2020, Heating, PreciseHeating, SimplifiedHeating
from dcfp.verify.check import Finding, Task
from dcfp.verify.rig import PROMISED_MEASURE, PROMISED_TEMPERATURE
from dcfp.verify.rig_cases import GROUP, HEATED, SINES, of_each_cycle, run_named, run_one
from dcfp.verify.rig_explicit import Story, integrate, li_2020_constants, sine, twice

#: Samples of the virtual machine in a cycle.
_SAMPLES = 400
#: Small steps to a sample: they last 0.25, 1.34 and 0.34 ms; with 0.67 ms the second differs by no more than with 1.34 ms.
_PARTS = {"dependency T01": 32, "ASCE T02": 8, "ASCE T06": 32}
_PAUSED, _PAUSED_PARTS, _PERIODS_OF_REST = "ASCE T12a", 16, 14
#: Samples after a start at full velocity in which the first small steps are too long for their own error to be left out.
_SUDDEN = 20


@cache
def _story(name: str, heating: SimplifiedHeating | PreciseHeating) -> Story:
    _, amplitude, peak_velocity, cycles = SINES[name]
    path = sine(amplitude, peak_velocity, cycles, _SAMPLES * _PARTS[name])
    return integrate(path, LI_2020, li_2020_constants(60.0), heating)


def _source(name: str) -> str:
    _, amplitude, peak_velocity, _ = SINES[name]
    step = sine(amplitude, peak_velocity, 1, _SAMPLES * _PARTS[name]).step
    return f"explicit integration and direct convolution, {1e3 * step:.2f} ms"


def _worst(differences: FloatArray) -> float:
    return float(differences[np.abs(differences).argmax()])


def _temperature(name: str, heating: SimplifiedHeating | PreciseHeating) -> Finding:
    direct = _story(name, heating).temperature[:: _PARTS[name]]
    loops = run_named(name, heating)
    peaks = float(loops.temperature.max() - direct.max())
    note = (
        f"Largest difference of {direct.size} samples; of the peaks, {direct.max():.1f} degC, it is {peaks:.4f} degC."
        " Allowed: what the defaults promise."
    )
    return Finding(_worst(loops.temperature - direct), 0.0, "degC", PROMISED_TEMPERATURE, note, _source(name))


def _friction(name: str, heating: SimplifiedHeating | PreciseHeating) -> Finding:
    half = _SAMPLES // 2
    direct = np.abs(_story(name, heating).force[:: half * _PARTS[name]][1:])
    computed = np.abs(run_named(name, heating).force[::half][1:])
    note = f"Largest relative difference of {direct.size} passages. Allowed: what the defaults promise."
    return Finding(_worst(computed / direct - 1.0), 0.0, "-", PROMISED_MEASURE, note, _source(name))


def _energy(name: str, heating: SimplifiedHeating | PreciseHeating) -> Finding:
    direct = np.diff(_story(name, heating).work[:: _SAMPLES * _PARTS[name]])
    computed = of_each_cycle(run_named(name, heating), "energy")
    note = f"Largest relative difference of {direct.size} cycles. Allowed: what the defaults promise."
    return Finding(_worst(computed / direct - 1.0), 0.0, "-", PROMISED_MEASURE, note, _source(name))


def _paused(waveform: Sine, pause: float, heating: Heating) -> tuple[Loops, Loops]:
    load = VerticalLoad((60.0,))
    tests = (RigTest("a", waveform, load), RigTest("b", waveform, load, pause=pause))
    first, second = run_program(Program("check", tests), heating=heating)
    return first, second


def _pause(heating: SimplifiedHeating | PreciseHeating) -> Finding:
    _, amplitude, peak_velocity, cycles = SINES[_PAUSED]
    path = sine(amplitude, peak_velocity, cycles, _SAMPLES * _PAUSED_PARTS)
    moving = path.displacement.size - 1
    rest = _PERIODS_OF_REST * _SAMPLES * _PAUSED_PARTS
    story = integrate(twice(path, rest), LI_2020, li_2020_constants(60.0), heating)
    pause = rest * path.step
    first, second = _paused(Sine(amplitude, peak_velocity, cycles), pause, heating)
    before = first.temperature - story.temperature[: moving + 1 : _PAUSED_PARTS]
    after = second.temperature - story.temperature[moving + rest :: _PAUSED_PARTS]
    note = (
        f"T12a, {pause:.1f} s of rest, T12b: largest difference but for the first {_SUDDEN} samples of each,"
        f" where the small steps follow a sudden start too coarsely. When the rest ends it is {after[0]:.4f} degC at"
        f" {second.temperature[0]:.1f} degC, when all is over {after[-1]:.4f} degC. Allowed: what the defaults promise."
    )
    gap = _worst(np.concatenate((before[_SUDDEN:], after[:1], after[_SUDDEN:])))
    source = f"explicit integration and direct convolution of the whole story, {1e3 * path.step:.2f} ms"
    return Finding(gap, 0.0, "degC", PROMISED_TEMPERATURE, note, source)


def _cut(heating: Heating) -> Finding:
    """Cut a test in two where spring (b) is so stiff that its relief at the cut does not matter."""
    stiff = replace(LI_2020, elastic_stiffness=1e5 * LI_2020.elastic_stiffness)
    load = VerticalLoad((60.0,))
    halves = (RigTest("a", Sine(200.0, 400.0, 2), load), RigTest("b", Sine(200.0, 400.0, 2), load, pause=0.0))
    second = run_program(Program("check", halves), stiff, heating=heating)[1]
    whole = run_one(Sine(200.0, 400.0, 4), heating, bearing=stiff)
    # the first sample of the second half sticks, and the heat of the last instant is missing there
    gap = _worst(second.temperature[_SUDDEN:] - whole.temperature[-second.time.size :][_SUDDEN:])
    energies = of_each_cycle(second, "energy") / of_each_cycle(whole, "energy")[2:] - 1.0
    note = (
        "Dependency T01 as two tests of two cycles without a pause, kf times 1e5; a test begins with spring (b) relieved."
        f" Largest difference from sample {_SUDDEN} on; energies of the cycles differ by {_worst(energies):.1e}."
        " Allowed: what a step that begins at the cut instead of before it may bring."
    )
    return Finding(gap, 0.0, "degC", 0.02, note, "the same test in one")


_COMPARED = {
    "temperature": _temperature,
    "coefficient at zero displacement": _friction,
    "energy of a cycle": _energy,
}

TASKS = (
    *(
        Task(GROUP, f"brute force, {name}, {words}, {heating.name} heating", partial(measure, name, heating))
        for name in _PARTS
        for heating in HEATED
        for words, measure in _COMPARED.items()
    ),
    *(
        Task(
            GROUP,
            f"brute force, T12a, a pause, T12b, {heating.name} heating",
            partial(_pause, heating),
            long=True,
        )
        for heating in HEATED
    ),
    *(
        Task(GROUP, f"a test cut in two, {heating.name} heating", partial(_cut, heating))
        for heating in HEATED
    ),
)
