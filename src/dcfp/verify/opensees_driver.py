"""Shakes a bearing, or moves it to and fro, with OpenSeesPy: ``python opensees_driver.py job.json result.json``; ``model.py`` beside the job builds it.

Where it is moved, the node carries a mass so large that the bearing does not alter its motion, starts at full velocity and is driven by the
acceleration of the sine: an imposed displacement would leave the element without the velocity that it needs.
It is run as a program of its own, because OpenSeesPy prints when it ends and takes the whole process with it when it fails.
Nothing of this package is imported. Units: N, mm, s, t, degC.
"""

import json
import math
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

#: Mass on a node that is moved, over that under the vertical force [-].
_HEAVY = 1e7


def run(model: Any, job: dict[str, Any]) -> dict[str, Any]:
    """Analyse a rigid mass on one bearing: under ground accelerations along x, or along x and y, the peaks, through cycles of a sine the histories."""
    model.build()
    return _move(model, job) if "cycles" in job else _shake(model, job)


def _begin(model: Any, interval: float, accelerations: list[list[float]]) -> None:
    """Begin a motion under accelerations of the ground in the directions 1 and perhaps 2."""
    for direction, values in enumerate(accelerations, 1):
        model.ops.timeSeries("Path", 1 + direction, "-dt", interval, "-values", *values)
        model.ops.pattern("UniformExcitation", 1 + direction, direction, "-accel", 1 + direction)
    model.choose_solver(1e-9)
    model.ops.integrator("Newmark", 0.5, 0.25)
    model.ops.analysis("Transient")


def _shake(model: Any, job: dict[str, Any]) -> dict[str, Any]:
    accelerations, interval, step, ops = job["accelerations"], job["interval"], job["step"], model.ops
    _begin(model, interval, accelerations)
    heated = hasattr(model, "CONDUCTIVITY")
    peak, hottest, failed = 0.0, -math.inf, 0
    fluxes: list[float] = []
    for _ in range(round((len(accelerations[0]) - 1) * interval / step)):
        failed += ops.analyze(1, step) != 0
        peak = max(peak, math.hypot(ops.nodeDisp(2, 1), ops.nodeDisp(2, 2)))
        if heated:
            hottest = max(hottest, ops.eleResponse(1, "temperature")[0])
            fluxes.append(ops.eleResponse(1, "HeatFlux")[0])
    return {"peak_displacement": peak, "peak_temperature": hottest, "fluxes": fluxes, "failed_steps": failed}


def _move(model: Any, job: dict[str, Any]) -> dict[str, Any]:
    ops, mass = model.ops, model.MASS
    ops.mass(model.STRUCTURE, _HEAVY * mass, mass, mass, 1e-6, 1e-6, 1e-6)
    amplitude, peak_velocity, per_cycle = job["amplitude"], job["peak_velocity"], job["steps_per_cycle"]
    frequency = peak_velocity / amplitude
    step = 2.0 * math.pi / frequency / per_cycle
    count = job["cycles"] * per_cycle
    # the trapezoidal rule swings as the sine does if it is driven at its own frequency
    shrink = (math.tan(math.pi / per_cycle) / (math.pi / per_cycle)) ** 2
    drive = [
        amplitude * frequency**2 * shrink * math.sin(2.0 * math.pi * n / per_cycle) for n in range(count + 1)
    ]
    ops.setNodeVel(2, 1, peak_velocity * math.sqrt(shrink), "-commit")
    _begin(model, step, [drive])
    result: dict[str, Any] = {"displacement": [], "force": [], "temperature": [], "failed_steps": 0}
    for _ in range(count):
        result["failed_steps"] += ops.analyze(1, step) != 0
        result["displacement"].append(ops.nodeDisp(2, 1))
        result["force"].append(-ops.eleResponse(1, "force")[0])
        result["temperature"].append(ops.eleResponse(1, "temperature")[0])
    return result


if __name__ == "__main__":
    job_file, result_file = map(Path, sys.argv[1:])
    sys.path.insert(0, str(job_file.parent))
    outcome = run(import_module("model"), json.loads(job_file.read_text(encoding="utf-8")))
    result_file.write_text(json.dumps(outcome), encoding="utf-8")
