"""The four figures."""

from pathlib import Path

import cases
import closed_forms as cf
import matplotlib as mpl
import numpy as np
from cases import CENTRE, MODEL, PLANAR, ROUND, SOLID, THICKNESSES, Long, Surface, plate_name
from motions import HALF_SIDE, RADIUS, Motion
from plate_fe import Array

mpl.use("Agg")
from matplotlib import pyplot as plt

WIDTH = 7.2  # [inch]
BLUES = ("#b2182b", "#ef8a62", "#67a9cf", "#2166ac")  # thin to thick


def style() -> None:
    """Set sizes for a page."""
    plt.rcParams.update(
        {
            "font.size": 8,
            "axes.titlesize": 8.5,
            "legend.fontsize": 7,
            "legend.frameon": False,
            "lines.linewidth": 1.1,
            "axes.spines.top": False,
            "axes.spines.right": False,
            "axes.grid": True,
            "grid.alpha": 0.25,
            "savefig.dpi": 140,
        }
    )


def _save(figure: plt.Figure, path: Path) -> None:
    figure.savefig(path)
    plt.close(figure)


def histories(path: Path, motions: list[Motion], results: list[dict[str, Array]]) -> None:
    """Contact temperatures under a known flux, and what each simplification adds to them."""
    figure, axes = plt.subplots(2, 3, figsize=(WIDTH, 4.3), sharex="col", layout="constrained")
    for column, (motion, result) in enumerate(zip(motions, results, strict=True)):
        top, low = axes[:, column]
        top.set_title(motion.name + (", friction 0.043" if motion.modelled is None else ""))
        top.plot(motion.time, result[CENTRE], color="0.6", lw=0.9, label="centre of plate, 1-D (simplified)")
        top.plot(motion.time, result[MODEL], color="k", label="square contact, 1-D (precise)")
        top.plot(motion.time, result[SOLID], color="#b2182b", ls="--", label="round contact, 3-D (reference)")
        for name, colour, line, label in (
            (SOLID, "#b2182b", "-", "round contact, 3-D"),
            (ROUND, "#ef8a62", "-", "round contact, 1-D"),
            (PLANAR, "#1b7837", "-", "square, 2-D conduction"),
            (plate_name(30.0, False), "#2166ac", "-", "30 mm, insulated back"),
            (plate_name(30.0, True), "#2166ac", ":", "30 mm, back at ambient"),
        ):
            low.plot(motion.time, result[name] - result[MODEL], color=colour, ls=line, label=label)
        low.set_xlabel("time [s]")
        low.set_xlim(0.0, motion.time[-1])
        top.set_ylim(bottom=0.0)
    axes[0, 0].set_ylabel("contact temperature [°C]")
    axes[1, 0].set_ylabel("minus precise model [°C]")
    handles = [*axes[0, 0].get_legend_handles_labels()[0], *axes[1, 0].get_legend_handles_labels()[0]]
    figure.legend(handles, [h.get_label() for h in handles], loc="outside lower center", ncols=3)
    _save(figure, path)


def surface(path: Path, after: Surface) -> None:
    """Surface of the plate after T01, seen from above and along lines."""
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(WIDTH, 3.1), layout="constrained", width_ratios=(1.25, 1.0)
    )
    y = np.concatenate((-after.y[:0:-1], after.y))
    both = np.concatenate((after.round[:, :0:-1], after.round), axis=1)
    shades = left.contourf(after.x, y, both.T, levels=np.arange(20.0, 210.0, 10.0), cmap="inferno")
    angle = np.linspace(0.0, 2.0 * np.pi, 200)
    left.plot(RADIUS * np.cos(angle), RADIUS * np.sin(angle), "w", lw=1.0)
    corner = HALF_SIDE * np.array([-1, 1, 1, -1, -1]), HALF_SIDE * np.array([-1, -1, 1, 1, -1])
    left.plot(*corner, "w--", lw=0.9)
    left.set(aspect="equal", xlabel="x along the sliding [mm]", ylabel="y [mm]", ylim=(-250, 250))
    left.set_title("surface after T01; slider in the middle")
    left.grid(visible=False)
    figure.colorbar(shades, ax=left, label="°C", shrink=0.85)
    right.plot(after.line_x, after.line, "k", label="square, 1-D, any y")
    for target, colour in ((0.0, "#b2182b"), (100.0, "#ef8a62"), (175.0, "#67a9cf")):
        n = int(np.argmin(np.abs(after.y - target)))
        right.plot(after.x, after.round[:, n], color=colour, label=f"round, 3-D, y = {after.y[n]:.0f} mm")
    right.set(xlabel="x along the sliding [mm]", ylabel="temperature [°C]", xlim=(-320, 320), ylim=(0, 210))
    figure.legend(*right.get_legend_handles_labels(), loc="outside lower center", ncols=4)
    right.set_title("along lines")
    _save(figure, path)


def thickness(path: Path, long: Long) -> None:
    """Kernels of plates, and the contact's cooling after twenty cycles."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(WIDTH, 3.6), layout="constrained")
    time = np.geomspace(5.0, 3600.0, 300)
    for thick, colour in zip(THICKNESSES, BLUES, strict=True):
        for cold in (False, True):
            line = ":" if cold else "-"
            label = plate_name(thick, cold)
            left.plot(time, cf.plate_kernel(time, thick, cold) * np.sqrt(time), color=colour, ls=line)
            right.plot(long.rest_time, long.rest[plate_name(thick, cold)], color=colour, ls=line, label=label)
    left.axhline(1.0, color="k")
    right.plot(long.rest_time, long.rest[MODEL], color="k", label="half-space, 1-D")
    solid = long.rest[f"{plate_name(50.0, False)}, round, 3-D"]
    right.plot(long.rest_time, solid, color="#1b7837", ls="--", label="50 mm, insulated, round, 3-D")
    deep = long.rest[cases.SOLID + ", deep"]
    right.plot(long.rest_time, deep, color="0.55", ls="--", label="half-space, round, 3-D")
    left.set(
        xscale="log",
        xlim=(5.0, 3600.0),
        ylim=(0.0, 3.0),
        xlabel="time t since the heat came [s]",
        ylabel="kernel over half-space's, G(t) √t [-]",
    )
    left.set_title("echo of the back of a plate")
    right.set(
        xscale="log",
        xlabel="time after 20 cycles [s]",
        ylabel="contact temperature [°C]",
        xlim=(1.0, 3600.0),
        ylim=(0, 240),
    )
    right.set_title("cooling at rest after 20 cycles of 300 mm")
    figure.legend(*right.get_legend_handles_labels(), loc="outside lower center", ncols=4)
    _save(figure, path)


def convergence(path: Path, depths: list, steps: list, spacings: list) -> None:
    """Refinement of the mesh in depth, of the steps and of the mesh along the plate."""
    figure, axes = plt.subplots(1, 3, figsize=(WIDTH, 2.5), layout="constrained")
    first, _, errors = np.array(depths).T
    axes[0].loglog(first, 100.0 * errors, "ko-", ms=3)
    axes[0].set(
        xlabel="first element in depth [mm]",
        ylabel="error of constant-flux rise [%]",
        title="depth: 0.05 s to 100 s",
    )
    count, ends, closed = np.array(steps).T
    axes[1].loglog(count[:-1], np.abs(ends - ends[-1])[:-1], "ko-", ms=3, label="finite elements")
    axes[1].loglog(
        count[:-1], np.abs(closed - closed[-1])[:-1], "s--", color="#2166ac", ms=3, label="closed form"
    )
    axes[1].set(
        xlabel="steps per cycle", ylabel="from finest steps [°C]", title="steps: T01, last temperature"
    )
    axes[1].legend()
    spacing, planar, solid = np.array(spacings).T
    axes[2].loglog(spacing[:-1], np.abs(planar - planar[-1])[:-1], "ko-", ms=3, label="square, 2-D")
    axes[2].loglog(
        spacing[:-1], np.abs(solid - solid[-1])[:-1], "s--", color="#b2182b", ms=3, label="round, 3-D"
    )
    axes[2].set(
        xlabel="spacing along the plate [mm]",
        ylabel="from finest spacing [°C]",
        title="plan: T01, last temperature",
    )
    axes[2].legend()
    axes[2].set_xticks([5.0, 10.0, 20.0], ["5", "10", "20"])
    axes[2].set_xticks([], minor=True)
    axes[1].set_xticks([100, 300, 1000], ["100", "300", "1000"])
    axes[1].set_xticks([], minor=True)
    _save(figure, path)
