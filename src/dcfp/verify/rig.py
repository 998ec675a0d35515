"""The virtual test machine against closed forms, its energy balance, and its default settings against converged ones."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from dcfp.analysis.rig import Loops, Program, RigTest, Sine, Triangle, VerticalLoad, run_program
from dcfp.analysis.rig.waveform import Travel, Waveform
from dcfp.arrays import FloatArray
from dcfp.system import (
    LI_2020,
    Bearing,
    ConstantFriction,
    FrictionLaw,
    Heating,
    NoHeating,
    PreciseHeating,
    SimplifiedHeating,
)
from dcfp.verify.check import Finding, Task

# What the checks of the virtual test machine share: the tests of Li et al. (2020), Tables 1 and 2, and how
# they are run.


GROUP = "Virtual test machine"
HEATED: tuple[SimplifiedHeating | PreciseHeating, ...] = (SimplifiedHeating(), PreciseHeating())

#: Pressure [N/mm2], amplitude [mm], peak velocity [mm/s], cycles: tests that differ.
SINES = {
    "dependency T01": (60.0, 200.0, 400.0, 4),
    "dependency T02": (40.0, 200.0, 20.0, 4),
    "dependency T03": (60.0, 200.0, 20.0, 4),
    "dependency T04": (80.0, 200.0, 20.0, 4),
    "ASCE T01": (60.0, 268.0, 392.0, 3),
    "ASCE T02": (60.0, 10.0, 14.646, 20),
    "ASCE T03": (60.0, 100.0, 146.369, 3),
    "ASCE T04": (60.0, 200.0, 292.738, 3),
    "ASCE T06": (60.0, 400.0, 585.476, 3),
    "ASCE T08": (40.0, 400.0, 585.476, 3),
    "ASCE T09": (80.0, 400.0, 585.476, 3),
    "ASCE T10": (30.0, 440.0, 644.024, 1),
    "ASCE T11": (90.0, 440.0, 644.024, 1),
    "ASCE T12a": (60.0, 300.0, 439.107, 7),
}


@dataclass(frozen=True)
class FinerSine(Sine):
    """A sine each of whose pieces is cut into equal parts."""

    parts: int = 1

    def travel(self) -> Travel:
        """Return the displacement."""
        return refined(super().travel(), self.parts)


def refined(travel: Travel, parts: int) -> Travel:
    """Return the same displacement with each piece cut into equal parts."""
    lengths = np.repeat(travel.lengths / parts, parts)
    start = np.tile(np.arange(parts), travel.lengths.size) * lengths
    a, b, c, d = np.repeat(travel.pieces, parts, axis=0).T
    moved = (a + start * (b + start * (c + start * d)), b + start * (2.0 * c + 3.0 * d * start))
    pieces = np.column_stack((*moved, c + 3.0 * d * start, d))
    return Travel(lengths, pieces, travel.cycles)


def run_one(
    waveform: Waveform,
    heating: Heating,
    friction: FrictionLaw | None = None,
    *,
    pressure: float = 60.0,
    bearing: Bearing = LI_2020,
    tolerance: float | None = None,
) -> Loops:
    """Run one test on cold plates."""
    program = Program("check", (RigTest("T", waveform, VerticalLoad((pressure,))),))
    if tolerance is None:
        return run_program(program, bearing, friction, heating)[0]
    return run_program(program, bearing, friction, heating, tolerance=tolerance)[0]


def run_named(name: str, heating: Heating) -> Loops:
    """Run a test of `SINES` with the default settings."""
    pressure, amplitude, peak_velocity, cycles = SINES[name]
    return run_one(Sine(amplitude, peak_velocity, cycles), heating, pressure=pressure)


def converged(name: str, heating: Heating) -> Loops:
    """Run a test of `SINES` with settings at which nothing changes any more."""
    pressure, amplitude, peak_velocity, cycles = SINES[name]
    if isinstance(heating, PreciseHeating):
        heating = PreciseHeating(cells=400)
    waveform = FinerSine(amplitude, peak_velocity, cycles, parts=4)
    return run_one(waveform, heating, pressure=pressure, tolerance=1e-6)


def of_each_cycle(loops: Loops, quantity: str) -> FloatArray:
    """Return a measure of every cycle."""
    return np.array([getattr(cycle, quantity) for cycle in loops.cycles])


_AMPLITUDE, _MU = 200.0, 0.043
_WAVES: tuple[Waveform, ...] = (Sine(_AMPLITUDE, 400.0, 3), Triangle(_AMPLITUDE, 400.0, 3))
_COULOMB = "closed form of a Coulomb loop"
#: What the default settings are to keep: measures of a cycle [-], temperature [degC].
PROMISED_MEASURE, PROMISED_TEMPERATURE = 1e-3, 0.2


def _closed_forms() -> dict[str, tuple[str, float, str]]:
    """Return for each measure of the second cycle its words, its closed form and its unit."""
    bearing = LI_2020
    slip = _MU * bearing.vertical_force
    stiffness = bearing.restoring_stiffness + slip / _AMPLITUDE
    # spring (b) gives back what it stores at each end
    area = 4.0 * slip * (_AMPLITUDE - slip / bearing.elastic_stiffness)
    damping = 2.0 / math.pi * area / (stiffness * (2.0 * _AMPLITUDE) ** 2)
    return {
        "effective_stiffness": ("k_eff = N (1/R + mu/A)", stiffness, "N/mm"),
        "energy": ("area of the loop 4 mu N (A - mu N/kf)", area, "N mm"),
        "friction": ("coefficient at zero displacement mu", _MU, "-"),
        "post_yield_stiffness": ("post-yield stiffness N/R", bearing.restoring_stiffness, "N/mm"),
        "effective_damping": ("beta_eff of that loop", damping, "-"),
    }


def _closed_form(waveform: Waveform, quantity: str) -> Finding:
    words, expected, unit = _closed_forms()[quantity]
    cycle = run_one(waveform, NoHeating(), ConstantFriction(_MU)).cycles[1]
    note = (
        f"{words}; second cycle of +-200 mm, constant friction. Allowed: rounding over some hundred samples."
    )
    computed = float(getattr(cycle, quantity))
    return Finding(computed, expected, unit, 1e-9, note, _COULOMB, relative=True)


def _energy(heating: Heating) -> Finding:
    """Return the largest residual of work - stored - hysteretic under constant loads, over the work."""
    residuals: dict[str, float] = {}
    for name in SINES:
        loops = run_named(name, heating)
        pendulum = 0.5 * loops.load * loops.displacement**2 / loops.bearing.effective_radius
        stored = pendulum + 0.5 * loops.bearing.elastic_stiffness * loops.elongation**2
        gap = np.abs(loops.work - loops.hysteretic_energy - (stored - stored[0])).max()
        residuals[name] = float(gap / loops.work[-1])
    worst = max(residuals, key=residuals.__getitem__)
    note = f"Largest of {len(SINES)} tests: {worst}. The work is summed by a rule that is exact for it, so only rounding is left."
    return Finding(residuals[worst], 0.0, "-", 1e-9, note, "work = stored + hysteretic energy")


def _monotone(heating: Heating) -> Finding:
    """Return the largest fall of the hysteretic energy between two samples over its end value."""
    falls: dict[str, float] = {}
    for name in SINES:
        energy = run_named(name, heating).hysteretic_energy
        falls[name] = max(0.0, -float(np.diff(energy).min()) / float(energy[-1]))
    worst = max(falls, key=falls.__getitem__)
    note = f"Largest fall of {len(SINES)} tests: {worst}. Allowed: rounding."
    return Finding(falls[worst], 0.0, "-", 1e-12, note, "friction gives no energy back")


def _default_measures(quantity: str, heating: Heating) -> Finding:
    errors: dict[str, float] = {}
    for name in SINES:
        reference = of_each_cycle(converged(name, heating), quantity)
        error = of_each_cycle(run_named(name, heating), quantity) / reference - 1.0
        errors[name] = float(error[np.abs(error).argmax()])
    worst = max(errors, key=lambda name: abs(errors[name]))
    note = f"Largest relative difference of all cycles of {len(SINES)} tests: {worst}. Allowed: what the defaults promise."
    return Finding(errors[worst], 0.0, "-", PROMISED_MEASURE, note, _CONVERGED)


def _default_temperature(heating: Heating) -> Finding:
    errors = {
        name: run_named(name, heating).peak_temperature - converged(name, heating).peak_temperature
        for name in SINES
    }
    worst = max(errors, key=lambda name: abs(errors[name]))
    note = f"Largest difference of peaks of {len(SINES)} tests: {worst}. Allowed: what the defaults promise."
    return Finding(errors[worst], 0.0, "degC", PROMISED_TEMPERATURE, note, _CONVERGED)


_CONVERGED = "the same test in 1600 pieces a cycle, tolerance 1e-6, 400 cells"


def _task(name: str, measure: Callable[[], Finding], *, long: bool = False) -> Task:
    return Task(GROUP, name, measure, long)


_DEFAULTS = {
    "friction": "coefficient at zero displacement",
    "energy": "energy of a cycle",
    "effective_stiffness": "effective stiffness",
}

TASKS = (
    *(
        _task(f"{waveform.kind}, {words}", partial(_closed_form, waveform, quantity))
        for waveform in _WAVES
        for quantity, (words, _, _) in _closed_forms().items()
    ),
    *(_task(f"energy closes, {heating.name} heating", partial(_energy, heating)) for heating in HEATED),
    *(
        _task(f"hysteretic energy never falls, {heating.name} heating", partial(_monotone, heating))
        for heating in HEATED
    ),
    *(
        _task(
            f"default settings, {words}, {heating.name} heating",
            partial(_default_measures, quantity, heating),
        )
        for heating in HEATED
        for quantity, words in _DEFAULTS.items()
    ),
    *(
        _task(
            f"default settings, peak temperature, {heating.name} heating",
            partial(_default_temperature, heating),
        )
        for heating in HEATED
    ),
)
