"""Runs one analysis with OpenSeesPy: ``python opensees_job.py job.json result.json``; in a process of its own, for it may take that with it."""

import json
import sys
from importlib import import_module
from pathlib import Path


def run(job):
    """Shake masses on springs in a row, on a spring that yields beside the pendulum's; return the peaks."""
    ops = import_module("openseespy.opensees")
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(0, 0.0)
    ops.fix(0, 1)
    ops.uniaxialMaterial("Elastic", 1, job["restoring"])
    ops.uniaxialMaterial("ElasticPP", 2, job["elastic"], job["yield"] / job["elastic"])
    for i, mass in enumerate(job["masses"]):
        ops.node(i + 1, 0.0)
        ops.mass(i + 1, mass)
        if i == 0:
            ops.element("zeroLength", 1, 0, 1, "-mat", 1, 2, "-dir", 1, 1)
        else:
            ops.uniaxialMaterial("Elastic", i + 2, job["stiffnesses"][i - 1], job["dampings"][i - 1])
            ops.element("zeroLength", i + 1, i, i + 1, "-mat", i + 2, "-dir", 1, "-doRayleigh", 0)
    ops.timeSeries("Path", 2, "-dt", job["interval"], "-values", *job["acceleration"])
    ops.pattern("UniformExcitation", 2, 1, "-accel", 2)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("BandGeneral")
    ops.test("NormDispIncr", 1e-9, 50)
    ops.algorithm("Newton")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    nodes = range(1, len(job["masses"]) + 1)
    peaks, failed = [0.0] * len(nodes), 0
    for _ in range(round((len(job["acceleration"]) - 1) * job["interval"] / job["step"])):
        failed += ops.analyze(1, job["step"]) != 0
        places = [0.0, *(ops.nodeDisp(node, 1) for node in nodes)]
        peaks = [max(peak, abs(places[i + 1] - places[i])) for i, peak in enumerate(peaks)]
    return {"peaks": peaks, "failed_steps": failed}


if __name__ == "__main__":
    job_file, result_file = map(Path, sys.argv[1:])
    result_file.write_text(json.dumps(run(json.loads(job_file.read_text()))))
