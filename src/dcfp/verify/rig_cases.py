"""What the checks of the virtual test machine share: the tests of Li et al. (2020), Tables 1 and 2, and how they are run."""

from dataclasses import dataclass

import numpy as np

from dcfp.analysis.rig import Loops, Program, RigTest, Sine, VerticalLoad, run_program
from dcfp.analysis.rig.waveform import Travel, Waveform
from dcfp.arrays import FloatArray
from dcfp.system import LI_2020, Bearing, FrictionLaw, Heating, PreciseHeating, SimplifiedHeating

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
