"""One analysis against OpenSees: the record NCC at PGV 0.5 m/s, a single concave bearing, the law of Kumar et al. (2015).

OpenSees takes steps of 1 ms, all in one call. Ours is the quickest of a few tolerances from which on the peak displacement
is within 0.1 % of the converged one.
"""

import json
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from figure import Figure
from stopwatch import in_turn, microseconds, once

import dcfp
from analysis import SINGLE, Analysis, motion_at, refined

STEP = 1e-3
#: From fine to coarse.
TOLERANCES = (0.005, 0.01, 0.02, 0.03, 0.05, 0.1, 0.2)
#: Largest relative difference from the converged peak displacement [-].
ACCURACY = 1e-3
#: Processes of OpenSees, and marches of ours before and after each.
PROCESSES, ROUNDS = 5, 200
MODEL = Path(__file__).parent / "opensees_model.py"


def is_available() -> bool:
    """Whether OpenSees can be started here."""
    if find_spec("openseespy") is None:
        return False
    trial = subprocess.run(
        [sys.executable, "-c", "import openseespy.opensees"], capture_output=True, check=False
    )
    return trial.returncode == 0


def run_opensees(given: Path, runs: int, step: float = STEP) -> dict[str, Any]:
    """Run OpenSees on the motion in a file; with no runs to time it looks for the peak."""
    words = [sys.executable, str(MODEL), str(step), str(runs), str(given)]
    done = subprocess.run(words, check=True, capture_output=True, text=True)
    return json.loads(done.stdout.splitlines()[-1])


def converged_peak(motion: dcfp.GroundMotion) -> float:
    """Return our peak displacement at a 32nd of the record's step [mm]."""
    return Analysis(refined(motion, 32), SINGLE, dcfp.Kumar2015(), tolerance=1e-6).peak_displacement


def quickest(motion: dcfp.GroundMotion, converged: float) -> Analysis:
    """Return the quickest analysis that is accurate, as are all with a finer tolerance."""
    accurate = []
    for tolerance in TOLERANCES:
        analysis = Analysis(motion, SINGLE, dcfp.Kumar2015(), tolerance=tolerance)
        if abs(analysis.peak_displacement / converged - 1.0) > ACCURACY:
            break
        accurate.append(analysis)
    if not accurate:
        msg = "no tolerance brings the peak displacement within 0.1 % of the converged one"
        raise RuntimeError(msg)
    times = in_turn([analysis.march for analysis in accurate], ROUNDS)
    return accurate[int(np.median(times, axis=1).argmin())]


def compared(given: Path, best: Analysis, default: Analysis) -> tuple[np.ndarray, np.ndarray]:
    """Return times [s] of OpenSees, shape (processes,), and ours, shape (3, processes): best, default, whole call."""

    def whole() -> float:
        return once(
            lambda: dcfp.respond(best.motion, SINGLE, best.friction, tail=0.0, tolerance=best.tolerance)
        )

    def ours() -> np.ndarray:
        return in_turn([best.march, default.march, whole], ROUNDS)

    theirs, near = [], []
    before = ours()
    for _ in range(PROCESSES):
        theirs.append(run_opensees(given, 1)["seconds"][0])
        after = ours()
        near.append(np.median(np.hstack([before, after]), axis=1))
        before = after
    return np.array(theirs), np.array(near).T


def figures() -> list[Figure]:
    """Return the ratio of the times, and how accurate each is."""
    if not is_available():
        return [Figure("OpenSees over march", None, at_least=1e4, note="OpenSeesPy cannot be imported here")]
    motion = motion_at("NCC")
    converged = converged_peak(motion)
    best = quickest(motion, converged)
    default = Analysis(motion, SINGLE, dcfp.Kumar2015())
    with TemporaryDirectory() as folder:
        given = Path(folder) / "motion.npz"
        np.savez(given, acceleration=motion.acceleration, interval=motion.time_step)
        peak = run_opensees(given, 0)["peak"]
        theirs, ours = compared(given, best, default)
    marched, by_default, whole = ours
    off = 100.0 * abs(best.peak_displacement / converged - 1.0)
    off_by_default = 100.0 * abs(default.peak_displacement / converged - 1.0)
    return [
        Figure("OpenSees, steps of 1 ms", float(np.median(theirs)), "s"),
        Figure("OpenSees, off the converged peak", 100.0 * abs(peak / converged - 1.0), "%"),
        Figure("march, accurate to 0.1 %", microseconds(marched), "us", note=f"tolerance {best.tolerance:g}, off by {off:.3f} %"),
        Figure("march, default tolerance", microseconds(by_default), "us", note=f"off by {off_by_default:.3f} %"),
        Figure("respond(), accurate to 0.1 %", microseconds(whole), "us", note="the march and all Python around it"),
        Figure("OpenSees over march", float(np.median(theirs / marched)), at_least=1e4),
        Figure("OpenSees over march, default tolerance", float(np.median(theirs / by_default))),
        Figure("OpenSees over respond()", float(np.median(theirs / whole))),
    ]  # fmt: skip
