"""Friction laws: one that a user wrote beside a built-in one, and both beside the first edition of this package."""

import json
import os
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from figure import Figure
from stopwatch import in_turn, microseconds, once, ratio

#: Names a folder with the sources of the first edition, such as ``../first/src``.
FIRST_EDITION = "DCFP_FIRST_EDITION"
ROUNDS, REPETITIONS, PROCESSES = 41, 10, 9
#: The law of the paper as a user would write it.
LAW = """
from math import exp

def law(pressure, speed, temperature):
    gamma = 2.03 * pressure**-0.19 + 0.068
    return 0.075 * gamma * (1.0 - 0.55 * exp(-0.019 * speed)) * 1.13 * exp(-0.007 * temperature)
"""
#: Answers each line of its input, the name of a law, with the shortest computing time of some analyses [s].
ANALYSES = """
import sys
import dcfp
from own import law
motion = dcfp.load_motion("NCC").scaled_to_pgv(500.0)
laws = {"built-in": dcfp.Li2020(), "user": dcfp.UserFriction(law)}
for line in sys.stdin:
    friction = laws[line.strip()]
    found = [dcfp.respond(motion, friction=friction) for _ in range(REPETITIONS)]
    print(min(one.elapsed for one in found), found[0].peak_displacement, flush=True)
""".replace("REPETITIONS", str(REPETITIONS))
#: What a user waits for who wants one answer.
FIRST_ANSWER = """
import dcfp
from own import law
friction = dcfp.{friction}
print(dcfp.respond(dcfp.load_motion("NCC").scaled_to_pgv(500.0), friction=friction).peak_displacement)
"""
FRICTIONS = {"built-in": "Li2020()", "user": "UserFriction(law)"}


class Edition:
    """A process that makes analyses with one edition of the package.

    Parameters
    ----------
    sources
        Folder of the package; None for the one that is installed.
    folder
        With the user's law.
    """

    def __init__(self, sources: str | None, folder: str) -> None:
        self._process = subprocess.Popen(
            [sys.executable, "-c", ANALYSES],
            cwd=folder,
            env=environment(folder, sources),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def analysis(self, law: str) -> tuple[float, float]:
        """Return the computing time of an analysis [s], and its peak displacement [mm]."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._process.stdin.write(f"{law}\n")
        self._process.stdin.flush()
        seconds, displacement = map(float, self._process.stdout.readline().split())
        return seconds, displacement

    def close(self) -> None:
        """End the process."""
        self._process.communicate()


def environment(folder: str, sources: str | None = None) -> dict[str, str]:
    """Return the environment of a process that finds the user's law, and keeps its kernels in a folder."""
    places = [folder, *([] if sources is None else [sources])]
    known = os.environ.get("PYTHONPATH")
    return {
        **os.environ,
        "PYTHONPATH": os.pathsep.join([*places, *([known] if known else [])]),
        "DCFP_CACHE_DIR": f"{folder}/cache",
    }


def analyses(folder: str) -> list[Figure]:
    """Return the ratios of the computing times of analyses."""
    sources = {"now": None, "first": os.environ.get(FIRST_EDITION)}
    known = {name: place for name, place in sources.items() if name == "now" or place}
    editions = {name: Edition(place and str(Path(place).resolve()), folder) for name, place in known.items()}
    try:
        answers = {(name, law): editions[name].analysis(law)[1] for name in editions for law in FRICTIONS}
        watches = {
            (name, law): (lambda name=name, law=law: editions[name].analysis(law)[0])
            for name in editions
            for law in FRICTIONS
        }
        times = dict(zip(watches, in_turn(list(watches.values()), ROUNDS), strict=True))
    finally:
        for one in editions.values():
            one.close()
    off = max(answers.values()) / min(answers.values()) - 1.0
    user, built_in = times["now", "user"], times["now", "built-in"]
    note = f"{microseconds(user):.0f} us over {microseconds(built_in):.0f} us; the same law, peaks within {off:.1e}"
    found = [Figure("user's law over built-in", ratio(user, built_in), note=note)]
    for law, most in (("built-in", 1.02), ("user", 1.10)):
        what = f"{law} law over that of the first edition"
        if "first" in editions:
            one, other = times["now", law], times["first", law]
            note = f"{microseconds(one):.0f} us over {microseconds(other):.0f} us"
            found.append(Figure(what, ratio(one, other), at_most=most, note=note))
        else:
            found.append(
                Figure(what, None, at_most=most, note=f"{FIRST_EDITION} names no folder of its sources")
            )
    return found


def first_answers(folder: str) -> Figure:
    """Return by how much the second process with a user's law takes longer than one with a built-in law."""

    def start(friction: str) -> float:
        words = [sys.executable, "-c", FIRST_ANSWER.format(friction=friction)]
        return once(
            lambda: subprocess.run(
                words, check=True, capture_output=True, cwd=folder, env=environment(folder)
            )
        )

    for friction in FRICTIONS.values():  # the first process compiles
        start(friction)
    built_in, user = in_turn([lambda f=f: start(f) for f in FRICTIONS.values()], PROCESSES)
    # the shortest: what is longer is something else that the machine did
    later = float(user.min() - built_in.min())
    note = f"{user.min():.2f} s and {built_in.min():.2f} s, the shortest of {PROCESSES}"
    return Figure("user's law, second process, after built-in", later, "s", at_most=0.1, note=note)


def figures() -> list[Figure]:
    """Return what a user's law costs, and what laws cost in the first edition."""
    with TemporaryDirectory() as folder:
        (Path(folder) / "own.py").write_text(LAW, encoding="utf-8")
        return [*analyses(folder), first_answers(folder)]


if __name__ == "__main__":
    print(json.dumps([one.to_json() for one in figures()], indent=2))
