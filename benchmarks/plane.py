"""Two directions: the station P695-FF-2 at PGV 0.5 m/s, without heating, with one point and with the field, against OpenSees' biaxial constant friction.

OpenSees takes a tenth of the record's step, all in one call. Ours is the whole of `respond()` with its default settings, the set-up included.
"""

from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from figure import Figure
from length import exponent
from opensees import is_available, run_opensees
from stopwatch import Seconds, in_turn, once, ratio

import dcfp

STATION, PGV = "P695-FF-2", 500.0
#: Step of OpenSees over that of the record.
PART = 0.1
#: What is compared: name, friction law, heating model, time at most [ms], how many times as quick as OpenSees at least.
MODELS = (
    ("none", "constant", "none", None, None),
    ("point", "li2020", "simplified", 1.2, 3000.0),
    ("field", "li2020", "precise", 4.0, 900.0),
)
#: Processes of OpenSees, and analyses of ours before and after each.
PROCESSES, ROUNDS = 5, 100
REPEATS, LONG_ROUNDS = (1, 2, 4, 8, 16), 5


def repeated(station: dcfp.Station, times: int) -> dcfp.Station:
    """Return a station again and again."""
    x, y = (
        dcfp.GroundMotion(np.tile(one.acceleration, times), one.time_step, one.name)
        for one in (station.x, station.y)
    )
    return dcfp.Station(x, y, name=station.name)


def whole(station: dcfp.Station, friction: str, heating: str) -> float:
    """Return the time of all that a user calls [s]."""
    return once(lambda: dcfp.respond(station, friction=friction, heating=heating, tail=0.0))


def compared(station: dcfp.Station) -> tuple[Seconds, Seconds, float]:
    """Return times [s] of OpenSees, shape (processes,), and ours, shape (models, processes), and the peak displacement of OpenSees [mm]."""
    watches = [partial(whole, station, friction, heating) for _, friction, heating, _, _ in MODELS]
    step = PART * station.time_step
    theirs: list[float] = []
    near: list[Seconds] = []
    with TemporaryDirectory() as folder:
        given = Path(folder) / "motion.npz"
        np.savez(given, acceleration=station.acceleration.T, interval=station.time_step)
        peak = run_opensees(given, 0, step)["peak"]
        before = in_turn(watches, ROUNDS)
        for _ in range(PROCESSES):
            theirs.append(run_opensees(given, 1, step)["seconds"][0])
            after = in_turn(watches, ROUNDS)
            near.append(np.median(np.hstack([before, after]), axis=1))
            before = after
    return np.array(theirs), np.array(near).T, peak


def of_length(station: dcfp.Station) -> list[Figure]:
    """Return the exponents of time over the length of the record."""
    stations = [repeated(station, times) for times in REPEATS]
    lengths = [one.x.acceleration.size for one in stations]
    found: list[Figure] = []
    for name, friction, heating, _, _ in MODELS[1:]:
        times = in_turn([partial(whole, one, friction, heating) for one in stations], LONG_ROUNDS)
        medians = np.median(times, axis=1)
        each = ", ".join(f"{1e9 * t / n:.0f}" for t, n in zip(medians, lengths, strict=True))
        found.append(
            Figure(
                f"in the plane, {name}, time over length, exponent", exponent(lengths, medians.tolist()),
                at_most=1.05, note=f"{each} ns a sample",
            )
        )  # fmt: skip
    return found


def figures() -> list[Figure]:
    """Return the times of ours, the ratios to that of OpenSees, and how time grows with length."""
    found = dcfp.load_station(STATION)
    assert found is not None
    station = found.scaled_to_pgv(PGV)
    if not is_available():
        missing = Figure("in the plane, OpenSees over ours", None, note="OpenSeesPy cannot be imported here")
        return [missing, *of_length(station)]
    theirs, ours, peak = compared(station)
    own = dcfp.respond(station, friction="constant", heating="none", tail=0.0).peak_displacement
    off = 100.0 * abs(peak / own - 1.0)
    rows = [
        Figure("in the plane, OpenSees, a tenth of the step", float(np.median(theirs)), "s", note=f"constant friction; its peak is {off:.3f} % off ours")
    ]  # fmt: skip
    for (name, _, _, at_most, at_least), seconds in zip(MODELS, ours, strict=True):
        rows.append(
            Figure(f"in the plane, {name}, respond()", 1e3 * float(np.median(seconds)), "ms", at_most=at_most)
        )
        rows.append(Figure(f"in the plane, OpenSees over {name}", ratio(theirs, seconds), at_least=at_least))
    return [*rows, *of_length(station)]
