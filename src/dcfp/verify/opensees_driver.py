"""Shakes a bearing, or moves it to and fro, with OpenSeesPy: ``python opensees_driver.py job.json result.json``.

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

#: Stiffness of the directions that do not matter [N/mm, N mm].
_STIFF = 1e10
#: Mass on a node that is moved, over that under the vertical force [-].
_HEAVY = 1e7
_ITERATIONS = 50


def run(job: dict[str, Any]) -> dict[str, Any]:
    """Analyse a rigid mass on one bearing: under a ground acceleration the peaks, through cycles of a sine the histories."""
    is_moved = "cycles" in job
    ops: Any = import_module("openseespy.opensees")
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.node(1, 0.0, 0.0, 0.0)
    ops.node(2, 0.0, 0.0, 0.0)
    mass = job["mass"]
    ops.mass(2, _HEAVY * mass if is_moved else mass, mass, mass, 1e-6, 1e-6, 1e-6)
    ops.fix(1, 1, 1, 1, 1, 1, 1)
    ops.fix(2, 0, 1, 0, 1, 1, 1)
    ops.uniaxialMaterial("Elastic", 1, 1e8)
    ops.uniaxialMaterial("Elastic", 2, _STIFF)
    _add_bearing(ops, job)
    _press(ops, job["vertical_force"], 1e-9 if is_moved else 1e-8)
    return _move(ops, job) if is_moved else _shake(ops, job)


def _add_bearing(ops: Any, job: dict[str, Any]) -> None:
    orientation = (0.0, 0.0, 1.0, 1.0, 0.0, 0.0)  # local x is up, local y along the motion
    radius, initial_stiffness = job["radius"], job["initial_stiffness"]
    if job["model"] == "coulomb":
        ops.frictionModel("Coulomb", 1, job["friction"])
        ops.element(
            "singleFPBearing", 1, 1, 2, 1, radius, initial_stiffness, "-P", 1, "-T", 2, "-My", 2, "-Mz", 2,
            "-orient", *orientation, "-iter", _ITERATIONS, 1e-8,
        )  # fmt: skip
        return
    pressure_dependent, temperature_dependent, velocity_dependent = 0, 1, 1
    shear_distance, rayleigh, element_mass, unit_newton_millimetre = 0.0, 0, 0.0, 3
    ops.element(
        "FPBearingPTV", 1, 1, 2, job["friction"], pressure_dependent, job["pressure"], temperature_dependent,
        job["diffusivity"], job["conductivity"], velocity_dependent, job["velocity_rate"], radius,
        job["contact_radius"], initial_stiffness, 1, 2, 2, 2, *orientation, shear_distance, rayleigh,
        element_mass, _ITERATIONS, 1e-3, unit_newton_millimetre,
    )  # fmt: skip


def _press(ops: Any, force: float, tolerance: float) -> None:
    """Apply the vertical force [N] and hold it."""
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    ops.load(2, 0.0, 0.0, -force, 0.0, 0.0, 0.0)
    _choose_solver(ops, tolerance)
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    if ops.analyze(1) != 0:
        msg = "the vertical force could not be applied"
        raise RuntimeError(msg)
    ops.loadConst("-time", 0.0)
    ops.wipeAnalysis()


def _choose_solver(ops: Any, tolerance: float) -> None:
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", tolerance, _ITERATIONS)
    ops.algorithm("Newton")


def _shake(ops: Any, job: dict[str, Any]) -> dict[str, Any]:
    acceleration, interval, step = job["acceleration"], job["interval"], job["step"]
    ops.timeSeries("Path", 2, "-dt", interval, "-values", *acceleration)
    ops.pattern("UniformExcitation", 2, 1, "-accel", 2)
    _choose_solver(ops, 1e-9)
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    heated = job["model"] == "heated"
    peak, hottest, failed = 0.0, -math.inf, 0
    fluxes: list[float] = []
    for _ in range(round((len(acceleration) - 1) * interval / step)):
        failed += ops.analyze(1, step) != 0
        peak = max(peak, abs(ops.nodeDisp(2, 1)))
        if heated:
            hottest = max(hottest, ops.eleResponse(1, "temperature")[0])
            fluxes.append(ops.eleResponse(1, "HeatFlux")[0])
    return {"peak_displacement": peak, "peak_temperature": hottest, "fluxes": fluxes, "failed_steps": failed}


def _move(ops: Any, job: dict[str, Any]) -> dict[str, Any]:
    amplitude, peak_velocity, per_cycle = job["amplitude"], job["peak_velocity"], job["steps_per_cycle"]
    frequency = peak_velocity / amplitude
    step = 2.0 * math.pi / frequency / per_cycle
    count = job["cycles"] * per_cycle
    # the trapezoidal rule swings as the sine does if it is driven at its own frequency
    shrink = (math.tan(math.pi / per_cycle) / (math.pi / per_cycle)) ** 2
    drive = [
        amplitude * frequency**2 * shrink * math.sin(2.0 * math.pi * n / per_cycle) for n in range(count + 1)
    ]
    ops.timeSeries("Path", 2, "-dt", step, "-values", *drive)
    ops.pattern("UniformExcitation", 2, 1, "-accel", 2)
    ops.setNodeVel(2, 1, peak_velocity * math.sqrt(shrink), "-commit")
    _choose_solver(ops, 1e-9)
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    result: dict[str, Any] = {"displacement": [], "force": [], "temperature": [], "failed_steps": 0}
    for _ in range(count):
        result["failed_steps"] += ops.analyze(1, step) != 0
        result["displacement"].append(ops.nodeDisp(2, 1))
        result["force"].append(-ops.eleResponse(1, "force")[0])
        result["temperature"].append(ops.eleResponse(1, "temperature")[0])
    return result


if __name__ == "__main__":
    job_file, result_file = map(Path, sys.argv[1:])
    outcome = run(json.loads(job_file.read_text(encoding="utf-8")))
    result_file.write_text(json.dumps(outcome), encoding="utf-8")
