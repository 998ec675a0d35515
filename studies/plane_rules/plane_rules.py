"""How is a method of one direction put to a station? ``python plane_rules.py FOLDER [FACTS]``.

Analyses the 50 stations of FEMA P-695 in the plane at four PGVs of the resultant, with the field of heat and with constant friction, and puts the methods of Li et al. (2020), with
the paper's constants, to each of them by several rules. Writes
the displacements (``facts.csv``) and the table (``plane_rules.md``) into `FOLDER`, and prints the table, in a minute; at once from `FACTS`, as they are kept beside this script.
"""

import csv
import math
import sys
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path

import numpy as np

from dcfp.analysis.plane_history import analyse_plane
from dcfp.inference.plane_forecast import calibration_stations
from dcfp.methods.li_2020 import predict_from_pgv, predict_from_pulses, predict_simplified
from dcfp.methods.pulses import PulsePrediction, Pulses, find_pulses
from dcfp.motion.named import VELOCITIES
from dcfp.motion.station import Station
from dcfp.system import System

SYSTEMS = {
    "field of heat": System.of(heating="precise"),
    "constant friction": System.of(friction="constant", heating="none"),
}
METHODS = {"pulse": predict_from_pulses, "simplified": predict_simplified}
#: Displacement [mm] of a rule, from what a method says by direction, counted from x towards y [degrees].
Rule = Callable[[Station, Callable[[float], float]], float]


def of_peak(station: Station) -> float:
    """Return the direction of the largest velocity [degrees]."""
    x, y = station.velocity[np.argmax(np.sum(station.velocity**2, axis=1))]
    return math.degrees(math.atan2(y, x))


def principal(station: Station) -> float:
    """Return the direction in which the velocity has the largest mean square [degrees]."""
    _, vectors = np.linalg.eigh(station.velocity.T @ station.velocity)
    return math.degrees(math.atan2(vectors[1, 1], vectors[0, 1]))


def beside(says: Callable[[float], float], first: float) -> float:
    """Return the root of the sum of the squares of a direction and the one across it."""
    return math.hypot(says(first), says(first + 90.0))


RULES: dict[str, Rule] = {
    "largest of 12 directions": lambda of, says: max(says(of_peak(of) + 15.0 * part) for part in range(12)),
    "direction of the peak velocity": lambda of, says: says(of_peak(of)),
    "principal axis of the velocity": lambda of, says: says(principal(of)),
    "larger of x and y": lambda of, says: max(says(0.0), says(90.0)),
    "SRSS of x and y": lambda of, says: beside(says, 0.0),
    "SRSS of the principal axes": lambda of, says: beside(says, principal(of)),
}


def facts() -> Iterator[dict[str, str]]:
    """Yield a row for each station and PGV: y_max and dy of the analyses, and dy of each method by each rule [mm]; 0 where it does not move."""
    for one in calibration_stations():
        for pgv in VELOCITIES:
            station = one.scaled_to_pgv(pgv)
            row = {"record": one.name, "pgv_m_s": f"{pgv / 1e3:g}"}
            for name, system in SYSTEMS.items():
                response = analyse_plane(station, system)
                row |= {f"y, {name}": f"{response.peak_displacement:.5g}", f"dy, {name}": f"{response.peak_change:.5g}"}  # fmt: skip
            for method, predict in METHODS.items():
                says = partial(_along, one, pgv / one.peak_velocity, predict, {})
                row |= {f"{method}, {rule}": f"{by(one, says):.5g}" for rule, by in RULES.items()}
            row["design, PGV of the resultant"] = f"{predict_from_pgv(pgv).displacement_change:.5g}"
            yield row


def _along(station: Station, factor: float, predict: Callable[[Pulses], PulsePrediction], known: dict[float, float], angle: float) -> float:  # fmt: skip
    """Return dy of a method in a direction [mm]; `known` are the directions that it was asked for before."""
    if angle not in known:
        pulses = find_pulses(station.rotated(-angle).x).scaled(factor)
        known[angle] = float(np.nan_to_num(predict(pulses).largest.displacement_change))
    return known[angle]


def table(rows: list[Mapping[str, str]]) -> str:
    """Return, for each method and rule, bias and in brackets dispersion of its dy over y_max of the analyses, over all and by PGV."""
    velocities = list(dict.fromkeys(row["pgv_m_s"] for row in rows))
    head = ["method, rule", "analysis", "cases", "all", *(f"{pgv} m/s" for pgv in velocities)]
    lines = [head, ["---"] * len(head)]
    known = [name for name in rows[0] if name.split(", ")[0] in (*METHODS, "design")]
    for name in known:
        for system in SYSTEMS:
            moved = [row for row in rows if float(row[name]) > 0.0]
            groups = [moved, *([row for row in moved if row["pgv_m_s"] == pgv] for pgv in velocities)]
            off = [[math.log(float(row[name]) / float(row[f"y, {system}"])) for row in group] for group in groups]  # fmt: skip
            lines.append([name, system, str(len(moved)), *(f"{math.exp(np.mean(one)):.2f} ({np.std(one, ddof=1):.2f})" for one in off)])  # fmt: skip
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def main(folder: Path, kept: Path | None) -> None:
    """Compute everything, or read the facts."""
    folder.mkdir(parents=True, exist_ok=True)
    if kept is None:
        rows = list(facts())
        with (folder / "facts.csv").open("w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, list(rows[0]))
            writer.writeheader()
            writer.writerows(rows)
    else:
        with kept.open(newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
    text = table(rows)
    print(text)
    (folder / "plane_rules.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: python plane_rules.py FOLDER [FACTS]")
    main(Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) == 3 else None)
