"""The virtual test machine against closed forms, its energy balance, and its default settings against converged ones."""

import math
from functools import cache

import numpy as np

from dcfp.analysis.integration import DEFAULT
from dcfp.analysis.rig import Loops, Program, RigTest, Sine, Triangle, VerticalLoad, run_program
from dcfp.analysis.rig.waveform import Travel, Waveform
from dcfp.arrays import FloatArray
from dcfp.schema.declared import declared
from dcfp.system import LI_2020, Bearing, ConstantFriction, FrictionLaw, Heating, PreciseHeating
from dcfp.verify.check import Found

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


@declared
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
    heating: Heating | str,
    friction: FrictionLaw | None = None,
    *,
    pressure: float = 60.0,
    bearing: Bearing = LI_2020,
    tolerance: float = DEFAULT.tolerance,
) -> Loops:
    """Run one test on cold plates."""
    program = Program("check", (RigTest("T", waveform, VerticalLoad((pressure,))),))
    return run_program(program, bearing, friction, heating, tolerance=tolerance)[0]


@cache
def run_named(name: str, heating: str) -> Loops:
    """Run a test of `SINES` with the default settings."""
    pressure, amplitude, peak_velocity, cycles = SINES[name]
    return run_one(Sine(amplitude, peak_velocity, cycles), heating, pressure=pressure)


def of_each_cycle(loops: Loops, quantity: str) -> FloatArray:
    """Return a measure of every cycle."""
    return np.array([getattr(cycle, quantity) for cycle in loops.cycles])


_AMPLITUDE, _MU = 200.0, 0.043
_WAVES: dict[str, Waveform] = {
    one.kind: one for one in (Sine(_AMPLITUDE, 400.0, 3), Triangle(_AMPLITUDE, 400.0, 3))
}


def closed_form(wave: str, measure: str) -> Found:
    """Return a measure of the second cycle under constant friction, and its closed form."""
    bearing = LI_2020
    slip = _MU * bearing.vertical_force
    stiffness = bearing.restoring_stiffness + slip / _AMPLITUDE
    # spring (b) gives back what it stores at each end
    area = 4.0 * slip * (_AMPLITUDE - slip / bearing.elastic_stiffness)
    damping = 2.0 / math.pi * area / (stiffness * (2.0 * _AMPLITUDE) ** 2)
    quantity, expected, unit = {
        "k_eff = N (1/R + mu/A)": ("effective_stiffness", stiffness, "N/mm"),
        "area of the loop 4 mu N (A - mu N/kf)": ("energy", area, "N mm"),
        "coefficient at zero displacement mu": ("friction", _MU, "-"),
        "post-yield stiffness N/R": ("post_yield_stiffness", bearing.restoring_stiffness, "N/mm"),
        "beta_eff of that loop": ("effective_damping", damping, "-"),
    }[measure]
    cycle = run_one(_WAVES[wave], "none", ConstantFriction(_MU)).cycles[1]
    return Found(float(getattr(cycle, quantity)), expected, words={"unit": unit})


def energy(heating: str) -> dict[str, float]:
    """Return the largest residual of work - stored - hysteretic under constant loads over the work, by tests [-]."""
    residuals: dict[str, float] = {}
    for name in SINES:
        loops = run_named(name, heating)
        pendulum = 0.5 * loops.load * loops.displacement**2 / loops.bearing.effective_radius
        stored = pendulum + 0.5 * loops.bearing.elastic_stiffness * loops.elongation**2
        gap = np.abs(loops.work - loops.hysteretic_energy - (stored - stored[0])).max()
        residuals[name] = float(gap / loops.work[-1])
    return residuals


def fall_of_energy(heating: str) -> dict[str, float]:
    """Return the largest fall of the hysteretic energy between two samples over its end value, by tests [-]."""
    energies = {name: run_named(name, heating).hysteretic_energy for name in SINES}
    return {name: max(0.0, -float(np.diff(one).min()) / float(one[-1])) for name, one in energies.items()}


# ----- the default settings against converged ones -----

_MEASURES = {
    "coefficient at zero displacement": "friction",
    "energy of a cycle": "energy",
    "effective stiffness": "effective_stiffness",
}


@cache
def _converged(name: str, heating: str) -> Loops:
    """Run a test of `SINES` with settings at which nothing changes any more."""
    pressure, amplitude, peak_velocity, cycles = SINES[name]
    model = PreciseHeating(cells=400) if heating == "precise" else heating
    waveform = FinerSine(amplitude, peak_velocity, cycles, parts=4)
    return run_one(waveform, model, pressure=pressure, tolerance=1e-6)


def default_measure(heating: str, measure: str) -> dict[str, float]:
    """Return the largest relative error of a measure of a cycle with the default settings, by tests [-]."""
    errors: dict[str, float] = {}
    for name in SINES:
        found, reference = (
            of_each_cycle(run(name, heating), _MEASURES[measure]) for run in (run_named, _converged)
        )
        errors[name] = worst_of(found / reference - 1.0)
    return errors


def default_temperature(heating: str) -> dict[str, float]:
    """Return the errors of the peak temperature with the default settings, by tests [degC]."""
    return {
        name: run_named(name, heating).peak_temperature - _converged(name, heating).peak_temperature
        for name in SINES
    }


def worst_of(differences: FloatArray) -> float:
    """Return the largest difference with its sign."""
    return float(differences[np.abs(differences).argmax()])
