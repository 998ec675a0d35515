r"""OpenSees on the virtual test machine: its heated element ``FPBearingPTV`` taken through the cycles of a sine.

A single concave bearing with the law of Kumar, Whittaker and Constantinou (2015) at constant pressure. How its element differs, and how that
is dealt with, is in `opensees`. Here its values are extrapolated in :math:`\sqrt{\Delta t}` only: where the slider leaves the monitoring
point its error also has a part of the order of a step that is not smooth, and another term would magnify it. The brute-force integration that
they are compared with also heats while spring (b) stretches; what the virtual machine gives stands beside them.
"""

import math
from functools import cache, partial
from typing import Any

import numpy as np

from dcfp.analysis.rig import Sine
from dcfp.arrays import FloatArray
from dcfp.system import SimplifiedHeating
from dcfp.verify.check import Finding
from dcfp.verify.explicit import KUMAR, SINGLE_CONCAVE
from dcfp.verify.opensees import or_skipped, run_job
from dcfp.verify.rig import SINES, run_one
from dcfp.verify.rig_explicit import Story, integrate, sine

#: Steps of OpenSees in a cycle; its convolution takes time with the square of their number.
_STEPS = (2000, 4000)
#: Steps of the brute-force integration in a cycle.
_FINE = 8000
_STEEL = SimplifiedHeating()
_MODEL = "OpenSees, McKenna, Scott and Fenves (2010), J. Comput. Civ. Eng. 24; element FPBearingPTV"


@cache
def analyse(name: str, steps_per_cycle: int) -> dict[str, Any]:
    """Take the bearing through a test of `SINES` with OpenSees; errors as of `run_job`."""
    _, amplitude, peak_velocity, cycles = SINES[name]
    return run_job(
        {
            "amplitude": amplitude,
            "peak_velocity": peak_velocity,
            "cycles": cycles,
            "steps_per_cycle": steps_per_cycle,
        }
    )


@cache
def _twin(name: str) -> Story:
    """Return the test by an integration that heats as OpenSees does."""
    _, amplitude, peak_velocity, cycles = SINES[name]
    law = np.array(KUMAR.at_pressure(SINGLE_CONCAVE.pressure)[1:])  # without its form
    path = sine(amplitude, peak_velocity, cycles, _FINE)
    return integrate(path, SINGLE_CONCAVE, law, _STEEL, heats_while_sticking=True)


def _extrapolated(coarse: FloatArray, fine: FloatArray) -> FloatArray:
    """Return the limit of values at `_STEPS` whose error goes with the root of the step."""
    return fine + (fine - coarse) / (math.sqrt(_STEPS[1] / _STEPS[0]) - 1.0)


def _temperature(name: str) -> Finding:
    _, amplitude, peak_velocity, cycles = SINES[name]
    runs = [np.array([max(analyse(name, steps)["temperature"])]) for steps in _STEPS]
    theirs = float(_extrapolated(*runs)[0])
    twin = float(_twin(name).temperature.max())
    ours = run_one(Sine(amplitude, peak_velocity, cycles), _STEEL, KUMAR, bearing=SINGLE_CONCAVE)
    at_steps = " and ".join(f"{run[0]:.2f}" for run in runs)
    note = (
        f"{name}. OpenSees in {_STEPS[0]} and {_STEPS[1]} steps a cycle: {at_steps} degC, and {theirs:.2f} extrapolated to no step."
        " Computed: a brute-force integration that also heats while spring (b) stretches, as OpenSees does; without that"
        f" the virtual machine gives {ours.peak_temperature:.2f}. Allowed: 22/7 (0.06 % of the rise) and a fifth of what the extrapolation adds."
    )
    limit = 6e-4 * (twin - _STEEL.ambient) + 0.2 * abs(theirs - float(runs[-1][0]))
    return Finding(twin, theirs, "degC", limit, note, f"{_MODEL}, Kumar et al. (2015)")


def _friction(name: str) -> Finding:
    _, amplitude, peak_velocity, cycles = SINES[name]
    load = SINGLE_CONCAVE.vertical_force
    runs = [
        np.abs(np.array(analyse(name, steps)["force"])[steps // 2 - 1 :: steps // 2]) / load
        for steps in _STEPS
    ]
    theirs = _extrapolated(*runs)
    twin = np.abs(_twin(name).force[_FINE // 2 :: _FINE // 2]) / load
    ours = run_one(Sine(amplitude, peak_velocity, cycles), _STEEL, KUMAR, bearing=SINGLE_CONCAVE)
    half = (ours.time.size - 1) // (2 * cycles)
    machine = np.abs(ours.force[half::half]) / load
    errors = twin / theirs - 1.0
    worst = int(np.abs(errors).argmax())
    note = (
        f"{name}, passage {worst + 1} of {errors.size}, which differs most; OpenSees with {_STEPS[-1]} steps a cycle:"
        f" {runs[-1][worst]:.5f}. Computed: as for the temperature; the virtual machine gives {machine[worst]:.5f}."
        " Allowed: a fifth of what the extrapolation adds, and 22/7."
    )
    limit = 6e-4 + 0.2 * float(np.abs(runs[-1] / theirs - 1.0).max())
    source = f"{_MODEL}, Kumar et al. (2015)"
    return Finding(float(twin[worst]), float(theirs[worst]), "-", limit, note, source, relative=True)


TASKS = tuple(
    or_skipped(f"test machine, {name}, {words}", partial(measure, name))
    for name in ("ASCE T03", "ASCE T04")
    for words, measure in (
        ("peak temperature", _temperature),
        ("coefficient at zero displacement", _friction),
    )
)
