"""Moves a bearing to and fro with OpenSeesPy: ``python rig_opensees_driver.py job.json result.json``.

The node carries a mass so large that the bearing does not alter its motion, starts at full velocity and is driven by the acceleration of
the sine: an imposed displacement would leave the element without the velocity that it needs. It is run as a program of its own,
because OpenSeesPy prints when it ends and takes the whole process with it when it fails. Nothing of this package is imported.
Units: N, mm, s, t, degC.
"""

import json
import math
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

#: Stiffness of the directions that do not matter [N/mm, N mm].
_STIFF = 1e10
#: Mass on the node over that under the vertical force [-].
_HEAVY = 1e7
_ITERATIONS = 50


def run(job: dict[str, Any]) -> dict[str, Any]:
    """Take a bearing through some cycles of a sine; return its histories, a value for each step."""
    ops: Any = import_module("openseespy.opensees")
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.node(1, 0.0, 0.0, 0.0)
    ops.node(2, 0.0, 0.0, 0.0)
    mass = job["vertical_force"] / 9806.65
    ops.mass(2, _HEAVY * mass, mass, mass, 1e-6, 1e-6, 1e-6)
    ops.fix(1, 1, 1, 1, 1, 1, 1)
    ops.fix(2, 0, 1, 0, 1, 1, 1)
    ops.uniaxialMaterial("Elastic", 1, 1e8)
    ops.uniaxialMaterial("Elastic", 2, _STIFF)
    pressure_dependent, temperature_dependent, velocity_dependent = 0, 1, 1
    shear_distance, rayleigh, element_mass, unit_newton_millimetre = 0.0, 0, 0.0, 3
    ops.element(
        "FPBearingPTV", 1, 1, 2, job["friction"], pressure_dependent, job["pressure"], temperature_dependent,
        job["diffusivity"], job["conductivity"], velocity_dependent, job["velocity_rate"], job["radius"],
        job["contact_radius"], job["initial_stiffness"], 1, 2, 2, 2, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0,
        shear_distance, rayleigh, element_mass, _ITERATIONS, 1e-3, unit_newton_millimetre,
    )  # fmt: skip
    _press(ops, job["vertical_force"])
    return _move(ops, job)


def _press(ops: Any, force: float) -> None:
    """Apply the vertical force [N] and hold it."""
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    ops.load(2, 0.0, 0.0, -force, 0.0, 0.0, 0.0)
    _choose_solver(ops)
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    if ops.analyze(1) != 0:
        msg = "the vertical force could not be applied"
        raise RuntimeError(msg)
    ops.loadConst("-time", 0.0)
    ops.wipeAnalysis()


def _choose_solver(ops: Any) -> None:
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-9, _ITERATIONS)
    ops.algorithm("Newton")


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
    _choose_solver(ops)
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
