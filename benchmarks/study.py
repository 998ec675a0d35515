"""A tenth of a study of a million analyses: rate, threads, memory; and twenty analyses beside OpenSees on all cores."""

import json
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from figure import Figure
from opensees import MODEL, STEP, is_available
from stopwatch import in_turn, once, ratio

import dcfp
from analysis import SINGLE
from dcfp.analysis.batch import GroundSet, Lanes, available_threads, respond_in_batch
from dcfp.analysis.integration import Integration
from dcfp.inference.forecast import calibration_set
from dcfp.study import Sampling, Study, Uniform, run_study
from dcfp.system import System

#: Of the whole study: components, PGVs and bearings, and what part of the PGVs is run.
PGVS, BEARINGS, PART = 100, 100, 10
ROUNDS = 5
#: Analyses that OpenSees and we share.
SHARED = 20
MEBIBYTE = 2.0**20

MEMORY = """
import json, resource, sys, tempfile
sys.path.insert(0, {folder!r})
from study import bearings, run_study, Study, calibration_set
import numpy as np
with tempfile.TemporaryDirectory() as folder:
    motions = calibration_set()
    study = Study(motions, {{"pgv": np.linspace(20.0, 2000.0, {pgvs})}}, bearings({bearings}))
    run_study(study, folder + "/s.zarr")
print(json.dumps([study.plan.count, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024]))
"""


def bearings(count: int) -> Sampling:
    """Return so many bearings: radius, coefficient and pressure as a Latin hypercube."""
    ranges = {"radius": Uniform(2000.0, 6000.0), "mu": Uniform(0.03, 0.12), "pressure": Uniform(30.0, 90.0)}
    return Sampling(ranges, count)


def tenth() -> Study:
    """Return every tenth PGV of the million: 100 components, 10 PGVs from 0.2 to 2 m/s, 100 bearings."""
    pgvs = np.linspace(2000.0 / PGVS, 2000.0, PGVS)[PART - 1 :: PART]
    return Study(calibration_set(), {"pgv": pgvs}, bearings(BEARINGS))


def rates() -> list[Figure]:
    """Return how fast the tenth is on one thread and on two, into a store, and what that makes of the million."""
    study = tenth()
    with TemporaryDirectory() as folder:

        def run(threads: int) -> float:
            return once(lambda: run_study(study, f"{folder}/{threads}.zarr", threads=threads, overwrite=True))

        run_study(Study(study.motions[:1], {"pgv": [500.0]}))  # compiles
        one, two = (run(threads) for threads in (1, 2))
    count = study.plan.count
    whole = len(calibration_set()) * PGVS * BEARINGS
    return [
        Figure("study, one thread", count / one, "1/s", note=f"{count} analyses in {one:.1f} s, stored"),
        Figure("study, two threads", count / two, "1/s", note=f"{count / two / 2:.0f} a second and core"),
        Figure("two threads over one", one / two, at_least=1.8, note="speed-up"),
        Figure("a million, projected", whole / count * two / 60.0, "min", at_most=15.0, note="two threads"),
    ]


def batch_over_single() -> Figure:
    """Return the time of an analysis in a batch over that of one alone, on one thread."""
    motions = calibration_set()
    grounds = GroundSet.of(motions)
    scales = np.array([[500.0 / motion.peak_velocity] for motion in motions])
    scaled = [motion.scaled(float(scale)) for motion, (scale,) in zip(motions, scales, strict=True)]
    lanes = Lanes.grid(len(motions), scales, [System()])
    batch, single = in_turn(
        [
            lambda: once(lambda: respond_in_batch(grounds, lanes)),
            lambda: sum(dcfp.respond(motion).elapsed for motion in scaled),
        ],
        ROUNDS,
    ) / len(motions)
    words = f"{1e6 * np.median(batch):.0f} us over {1e6 * np.median(single):.0f} us, the march alone"
    return Figure("batch over single analysis", ratio(batch, single), at_most=1.0, note=words)


def memory() -> list[Figure]:
    """Return the most memory of whole processes that run studies of different sizes."""
    found = []
    for pgvs, count in ((1, 10), (10, 10), (10, 100)):
        code = MEMORY.format(folder=str(Path(__file__).parent), pgvs=pgvs, bearings=count)
        done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
        analyses, held = json.loads(done.stdout)
        found.append((analyses, held / MEBIBYTE))
    note = ", ".join(f"{held:.0f} for {analyses}" for analyses, held in found)
    return [
        Figure("memory of a study", found[-1][1], "MiB", at_most=1024.0, note=note),
        Figure("memory, 100000 over 1000 analyses", found[-1][1] / found[0][1], at_most=1.1),
    ]


def beside_opensees() -> Figure:
    """Return the time of OpenSees in a process on each core over ours on as many threads, for the same analyses."""
    cores = available_threads()
    name = f"OpenSees over batch, {SHARED} analyses, {cores} cores each"
    if not is_available():
        return Figure(name, None, note="OpenSeesPy cannot be imported here")
    shortest = sorted(calibration_set(), key=lambda motion: motion.duration)[:SHARED]
    motions = [motion.scaled_to_pgv(500.0) for motion in shortest]
    model = System(SINGLE, dcfp.Kumar2015())
    parts = [motions[first::cores] for first in range(cores)]

    def ours() -> None:
        with ThreadPoolExecutor(cores) as pool:
            for _ in pool.map(lambda part: batch(part, model), parts):
                pass

    ours()  # compiles
    before = [once(ours) for _ in range(ROUNDS)]
    theirs = opensees(parts)
    after = [once(ours) for _ in range(ROUNDS)]
    mine = float(np.median(before + after))
    return Figure(name, theirs / mine, note=f"{theirs:.1f} s over {1e3 * mine:.2f} ms, PGV 0.5 m/s")


def batch(motions: list[dcfp.GroundMotion], model: System) -> None:
    """Analyse motions on one thread."""
    lanes = Lanes.grid(len(motions), np.ones((len(motions), 1)), [model])
    respond_in_batch(GroundSet.of(motions, Integration(tail=0.0)), lanes)


def opensees(parts: list[list[dcfp.GroundMotion]]) -> float:
    """Return how long the processes calculate that OpenSees runs in, one for each part, side by side [s]."""
    with TemporaryDirectory() as folder:
        processes = []
        for number, part in enumerate(parts):
            paths = [str(Path(folder) / f"{number}-{place}.npz") for place in range(len(part))]
            for path, motion in zip(paths, part, strict=True):
                np.savez(path, acceleration=motion.acceleration, interval=motion.time_step)
            words = [sys.executable, str(MODEL), str(STEP), "1", *paths]
            processes.append(
                subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
            )
        lines = [process.communicate()[0].splitlines() for process in processes]
    documents = [[json.loads(line) for line in part if line.startswith("{")] for part in lines]
    return max(sum(one["seconds"][0] for one in part) for part in documents)


def figures() -> list[Figure]:
    """Return everything about studies."""
    return [batch_over_single(), *rates(), *memory(), beside_opensees()]
