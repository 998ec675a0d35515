"""How unsafe is one direction? Every station of FEMA P-695 in the plane against what one direction gives; writes the tables and figures of ``docs/one_direction.md``.

Run ``python studies/one_direction/one_direction.py FOLDER``; a minute on two cores. With ``--by component`` the larger PGV of the two components is the target in
place of that of the resultant.
"""

import argparse
import csv
import math
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

import dcfp
from dcfp.analysis.batch import GroundSet, Lanes, respond_in_batch
from dcfp.motion.station import Station
from dcfp.present.figures import save_figure, style
from dcfp.present.figures.plane import plot_orbit

NAMES = [*(f"P695-FF-{i}" for i in range(1, 23)), *(f"P695-NF-{i}" for i in range(1, 29))]
PGVS = (250.0, 500.0, 750.0, 1000.0)
DIRECTIONS = 12
MODELS = {
    "constant": dcfp.System(friction=dcfp.ConstantFriction(0.043), heating=dcfp.NoHeating()),
    "heated": dcfp.System(heating=dcfp.PreciseHeating()),
}


def along(station: Station, angle: float) -> Station:
    """Return what the station's motion is in one direction, at an angle from x [degrees], alone."""
    turned = station.rotated(-angle)
    return replace(turned, y=replace(turned.y, acceleration=np.zeros_like(turned.y.acceleration)))


def ratios(name: str, by: str) -> list[dict[str, float | str]]:
    """Return the peaks of a station in the plane, and of one direction at a time, at every PGV and with every model."""
    station = dcfp.load_station(name)
    assert station is not None
    target = (
        station.peak_velocity if by == "resultant" else max(station.x.peak_velocity, station.y.peak_velocity)
    )
    motions = [station, *(along(station, 180.0 * k / DIRECTIONS) for k in range(DIRECTIONS))]
    scales = np.tile(np.array(PGVS) / target, (len(motions), 1))
    peaks = respond_in_batch(GroundSet.of(motions), Lanes.grid(len(motions), scales, list(MODELS.values())))
    shape = (len(motions), len(PGVS), len(MODELS))
    y, t = (peaks[key].reshape(shape) for key in ("peak_displacement", "peak_temperature"))
    rows: list[dict[str, float | str]] = []
    for i, pgv in enumerate(PGVS):
        for j, model in enumerate(MODELS):
            u1, u2 = y[1, i, j], y[1 + DIRECTIONS // 2, i, j]
            large, small = max(u1, u2), min(u1, u2)
            rises = t[:, i, j] - 20.0
            rows.append(
                {
                    "station": name, "pgv": pgv, "model": model, "plane": y[0, i, j], "x": u1, "y": u2, "temperature": t[0, i, j],
                    "larger": y[0, i, j] / large, "srss": y[0, i, j] / math.hypot(large, small), "100/30": y[0, i, j] / math.hypot(large, 0.3 * small),
                    "twelve": y[0, i, j] / y[1:, i, j].max(), "rise": rises[0] / max(rises[1], rises[1 + DIRECTIONS // 2], 1e-9),
                    "heated/constant": y[0, i, 1] / y[0, i, 0],
                }
            )  # fmt: skip
    return rows


def table(
    rows: list[dict[str, float | str]], model: str, only: Callable[[str], bool] = lambda _: True
) -> str:
    """Return the table of a model: mean, 90 % quantile and largest of each ratio."""
    lines = []
    for pgv in PGVS:
        chosen = [
            row for row in rows if row["model"] == model and row["pgv"] == pgv and only(str(row["station"]))
        ]
        cells = [f"{pgv / 1e3:.2f}"]
        for key in ("larger", "srss", "100/30", "twelve"):
            values = np.array([float(row[key]) for row in chosen])
            cells.append(f"{values.mean():.2f} / {np.quantile(values, 0.9):.2f} / {values.max():.2f}")
        above = np.mean([float(row["100/30"]) > 1.0 for row in chosen])
        cells.append(f"{100 * above:.0f} %")
        if model == "heated":
            rise = np.array([float(row["rise"]) for row in chosen])
            ratio = np.array([float(row["heated/constant"]) for row in chosen])
            cells += [
                f"{rise.mean():.2f} / {rise.max():.2f}",
                f"{ratio.mean():.2f} ({np.quantile(ratio, 0.1):.2f}–{np.quantile(ratio, 0.9):.2f})",
            ]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


@style.styled
def plot_ratios(rows: list[dict[str, float | str]]) -> Figure:
    """Draw how often the peak in the plane exceeds each of the four one-directional answers, and by how much."""
    figure = style.new_figure(2.9)
    axes = figure.subplots(1, 2, sharey=True)
    words = {
        "larger": "larger component",
        "100/30": "100 % and 30 %",
        "srss": "SRSS of both",
        "twelve": "worst of twelve directions",
    }
    colours = (style.RED, style.OCHRE, style.BLUE, style.INK)
    share = np.linspace(0.0, 100.0, len(NAMES) * len(PGVS))
    for one, model in zip(axes, MODELS, strict=True):
        for (key, label), colour in zip(words.items(), colours, strict=True):
            values = np.sort([float(row[key]) for row in rows if row["model"] == model])[::-1]
            style.draw_line(one, share, values, colour, 1.1, label=label)
        one.axhline(1.0, color=style.GREY, linewidth=0.6)
        one.set_xlim(0.0, 100.0)
        one.set_ylim(0.6, 2.4)
        one.set_xlabel("share of stations and PGVs [%]")
        one.set_title("constant friction" if model == "constant" else "friction with heat")
    axes[0].set_ylabel("peak in the plane over it [-]")
    axes[1].legend(loc="upper right")
    return figure


@style.styled
def plot_cause(name: str, pgv: float) -> Figure:
    """Draw a station's displacement, temperature and friction in the plane, and of both components alone."""
    station = dcfp.load_station(name)
    assert station is not None
    station = station.scaled_to_pgv(pgv)
    motions = {"in the plane": station, "x alone": along(station, 0.0), "y alone": along(station, 90.0)}
    responses = {label: dcfp.respond(motion, MODELS["heated"]) for label, motion in motions.items()}
    figure = style.new_figure(3.4)
    left, right = figure.subfigures(1, 2, width_ratios=(1.0, 1.2))
    plot_orbit(responses["in the plane"], left.subplots())
    axes = right.subplots(2, 1, sharex=True)
    for one, history in zip(axes, ("displacement", "temperature"), strict=True):
        for (label, response), colour in zip(
            responses.items(), (style.INK, style.BLUE, style.OCHRE), strict=True
        ):
            entry = response.histories[history]
            style.draw_line(one, response.time, entry.display(entry.of(response)), colour, 0.8, label=label)
        one.set_ylabel(entry.label)
    style.legend_above(axes[0])
    axes[-1].set_xlabel("$t$ [s]")
    whole = responses["in the plane"]
    moves = whole.time[whole.displacement > 0.02 * whole.peak_displacement]
    axes[-1].set_xlim(float(moves[0]) - 2.0, float(moves[0]) + 40.0)
    return figure


def main() -> None:
    """Compute, print the tables, and write figure and data."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--by", choices=("resultant", "component"), default="resultant")
    chosen = parser.parse_args()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    with ProcessPoolExecutor() as pool:
        rows = [row for some in pool.map(ratios, NAMES, [chosen.by] * len(NAMES)) for row in some]
    with (chosen.folder / "one_direction.csv").open("w", newline="", encoding="utf-8") as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    for model in MODELS:
        print(model, table(rows, model), sep="\n")
        for group in ("FF", "NF"):
            print(model, group, table(rows, model, lambda name, group=group: f"-{group}-" in name), sep="\n")
    save_figure(plot_ratios(rows), chosen.folder / "one_direction.png")
    save_figure(plot_cause("P695-NF-12", 500.0), chosen.folder / "one_direction_cause.png")


if __name__ == "__main__":
    main()
