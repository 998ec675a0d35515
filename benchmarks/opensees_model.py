"""A structure on a bearing as OpenSees models it; run in a process of its own, because it prints on its exit.

The arguments are the step [s], the number of timed runs and files that each hold a ground acceleration [mm/s2] and its step: of one direction
for the element that heats, or with a row for each of two directions for biaxial constant friction. On standard output: for each file one JSON document with the times [s] and the peak displacement [mm].
"""

import json
import math
import sys
from time import perf_counter

import numpy as np
import openseespy.opensees as ops

DIAMETER, PRESSURE, RADIUS, ELASTIC = 400.0, 60.0, 9000.0, 1.9e6
GRAVITY = 9806.65
FRICTION, VELOCITY_RATE = 0.075, 0.1
CONSTANT_FRICTION = 0.043
CONDUCTIVITY, DIFFUSIVITY = 16.0, 4.07
N_MM_S = 3  # the element's code for its units


def build(directions: int) -> None:
    """Build the bearing and the mass, free in one direction or two, and put the vertical load on."""
    force = PRESSURE * math.pi * DIAMETER**2 / 4.0
    mass = force / GRAVITY
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    ops.node(1, 0.0, 0.0, 0.0)
    ops.node(2, 0.0, 0.0, 0.0)
    ops.mass(2, mass, mass, mass, 1e-6, 1e-6, 1e-6)
    ops.fix(1, 1, 1, 1, 1, 1, 1)
    ops.fix(2, 0, 2 - directions, 0, 1, 1, 1)
    ops.uniaxialMaterial("Elastic", 1, 1e8)
    ops.uniaxialMaterial("Elastic", 2, 1e10)
    _add_heated(force) if directions == 1 else _add_constant(force)
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    ops.load(2, 0.0, 0.0, -force, 0.0, 0.0, 0.0)
    _solver(1e-8)
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    ops.analyze(1)
    ops.loadConst("-time", 0.0)
    ops.wipeAnalysis()


def _add_heated(force: float) -> None:
    ops.element(
        "FPBearingPTV", 1, 1, 2,
        FRICTION, 0, PRESSURE, 1, DIFFUSIVITY, CONDUCTIVITY, 1, VELOCITY_RATE,
        RADIUS, DIAMETER / 2.0, force / RADIUS + ELASTIC,
        1, 2, 2, 2, 0, 0, 1, 1, 0, 0, 0.0, 0, 0.0, 50, 1e-3, N_MM_S,
    )  # fmt: skip


def _add_constant(force: float) -> None:
    ops.frictionModel("Coulomb", 1, CONSTANT_FRICTION)
    ops.element(
        "singleFPBearing", 1, 1, 2, 1, RADIUS, force / RADIUS + ELASTIC,
        "-P", 1, "-T", 2, "-My", 2, "-Mz", 2, "-orient", 0, 0, 1, 1, 0, 0, "-iter", 50, 1e-8,
    )  # fmt: skip


def _solver(tolerance: float) -> None:
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", tolerance, 50)
    ops.algorithm("Newton")


def shake(accelerations: list[list[float]], interval: float) -> None:
    """Put the ground motion on and choose the time integration."""
    for direction, values in enumerate(accelerations, 1):
        ops.timeSeries("Path", 1 + direction, "-dt", interval, "-values", *values)
        ops.pattern("UniformExcitation", 1 + direction, direction, "-accel", 1 + direction)
    _solver(1e-7)
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")


def timed(accelerations: list[list[float]], interval: float, step: float, steps: int) -> float:
    """Return the time of one analysis, all its steps in one call [s]."""
    build(len(accelerations))
    shake(accelerations, interval)
    began = perf_counter()
    failed = ops.analyze(steps, step)
    elapsed = perf_counter() - began
    if failed:
        msg = "OpenSees did not converge"
        raise RuntimeError(msg)
    return elapsed


def peak(accelerations: list[list[float]], interval: float, step: float, steps: int) -> float:
    """Return the largest displacement at any step [mm]; this run is not timed."""
    build(len(accelerations))
    shake(accelerations, interval)
    largest = 0.0
    for _ in range(steps):
        ops.analyze(1, step)
        largest = max(largest, math.hypot(ops.nodeDisp(2, 1), ops.nodeDisp(2, 2)))
    return largest


def main() -> None:
    """Run the analyses that the command line asks for."""
    step, runs = float(sys.argv[1]), int(sys.argv[2])
    for path in sys.argv[3:]:
        with np.load(path) as given:
            accelerations, interval = np.atleast_2d(given["acceleration"]).tolist(), float(given["interval"])
        steps = round((len(accelerations[0]) - 1) * interval / step)
        seconds = [timed(accelerations, interval, step, steps) for _ in range(runs)]
        largest = peak(accelerations, interval, step, steps) if runs == 0 else None
        print(json.dumps({"seconds": seconds, "peak": largest}))


if __name__ == "__main__":
    main()
