"""How far off is the heat model? Finite elements against it: ``python heat_check.py FOLDER``.

Makes four figures in the folder and prints the tables, in two minutes. Needs dcfp, scikit-fem, scipy and
matplotlib.
"""

import sys
import time
from pathlib import Path

import cases
import checks
import closed_forms as cf
import figures
import numpy as np
from cases import MODEL, Long
from motions import Motion, Outcome
from plate_fe import Array


def heading(text: str) -> None:
    """Print a heading."""
    print(f"\n{text}\n{'-' * len(text)}")


def print_checks(depths: list, steps: list, spacings: list) -> None:
    """Print the convergence of the finite elements."""
    heading("Finite elements against closed forms and refined")
    for first, nodes, error in depths:
        print(
            f"first element {first:5.3f} mm, {nodes:3d} nodes in depth: half-space off by {100 * error:.5f} %"
        )
    worst = max(error for *_, error in checks.thickness_errors())
    print(f"theta series, 30 to 100 mm, both backs, 1 s to 2 h: off by at most {100 * worst:.5f} %")
    print(f"sheet on a body: off by {100 * checks.sheet_error():.5f} %")
    for count, end, closed in steps:
        print(f"T01 with {count:4d} steps per cycle: {end:.3f} degC, closed form {closed:.3f}")
    for spacing, planar, solid in spacings:
        print(f"T01 with nodes {spacing:4.1f} mm apart: square 2-D {planar:.3f}, round 3-D {solid:.3f} degC")
    for solid, label in ((False, "quadrilaterals"), (True, "hexahedra")):
        unknowns, stepped, modal = checks.whole_mesh(solid)
        print(f"whole mesh of {unknowns} unknowns, {label}: {stepped:.2f}, mode by mode {modal:.2f} degC")


def print_known(motion: Motion, result: dict[str, Array]) -> None:
    """Print temperatures under a known flux."""
    heading(f"{motion.name}: known flux, {motion.time[-1]:.1f} s")
    model = result[MODEL]
    if motion.modelled is not None:
        gap = np.abs(motion.modelled - model).max()
        print(f"dcfp: peak {motion.modelled.max():.2f} degC; from finite elements at most {gap:.2f} degC")
    print(f"{'':46s} {'peak':>8s} {'of rise':>9s} {'end':>8s} {'farthest':>9s}")
    for name, history in result.items():
        gap = history - model
        farthest = gap[np.abs(gap).argmax()]
        share = (history.max() - cases.AMBIENT) / (model.max() - cases.AMBIENT) - 1.0
        print(f"{name:46s} {history.max():8.2f} {100 * share:+8.2f}% {history[-1]:8.2f} {farthest:+9.2f}")


def print_fed_back(motion: Motion, outcomes: dict[str, Outcome]) -> None:
    """Print work of friction and temperatures where friction depends on temperature."""
    heading(f"{motion.name}: friction depends on temperature, same displacements")
    middle = motion.time[1:] - 0.5 * motion.step
    base = 0.0
    for name, outcome in outcomes.items():
        work = float((outcome.friction * motion.slip).sum())
        base = base or work
        text = f"{name:58s} work {100 * (work / base - 1):+7.2f} %, peak {outcome.contact.max():6.1f} degC"
        if motion.name == "T01":
            period = motion.time[-1] / 4.0
            first, second = np.interp([period, 1.5 * period], middle, outcome.friction)
            text += f", mu at zero in cycle 2 {first:.4f} {second:.4f}, mean {0.5 * (first + second):.4f}"
        print(text)


def print_long(long: Long) -> None:
    """Print temperatures after twenty cycles."""
    heading(f"20 cycles, 300 mm, 439 mm/s ({long.heating_time[-1]:.0f} s), then rest")
    print(f"{'':42s} {'end':>7s} {'+1 min':>7s} {'+10 min':>7s} {'+60 min':>7s}  1 degC off from [s]")
    for name, heating in long.heating.items():
        later = np.interp([60.0, 600.0, 3600.0], long.rest_time, long.rest[name])
        numbers = " ".join(f"{value:7.1f}" for value in (heating[-1], *later))
        print(f"{name:42s} {numbers}  {long.onset(name, 1.0):.0f}")


def print_kernels() -> None:
    """Print when a thickness shows, and the fading modes that stand for it."""
    heading("When an insulated back adds 1 %, 5 % and 10 % [s]: constant flux; echo of a short heating")
    for thickness in cases.THICKNESSES:
        steady = [cf.onset(thickness, share, True) for share in (0.01, 0.05, 0.1)]
        echo = [cf.onset(thickness, share, False) for share in (0.01, 0.05, 0.1)]
        print(
            f"{thickness:4.0f} mm: "
            + "  ".join(f"{t:6.0f}" for t in steady)
            + "; "
            + "  ".join(f"{t:6.0f}" for t in echo)
        )
    heading(
        "Fading modes: rate / a and weight / sqrt(a), a = (pi/L)^2 D, or a quarter of it for the cold back"
    )
    for cold in (False, True):
        rates, weights, error = cf.fading_modes(50.0, cold)
        own = rates[rates > 0.0][0]
        kind = "back at ambient" if cold else "insulated back"
        print(f"{kind}: off by at most {100 * error:.3f} % of the kernel")
        for rate, weight in zip(rates[:7] / own, weights[:7] / np.sqrt(own), strict=True):
            print(f"  {rate:10.5f} {weight:10.5f}")


def main(folder: Path) -> None:
    """Compute everything."""
    began = time.perf_counter()
    folder.mkdir(parents=True, exist_ok=True)
    figures.style()
    refinements = checks.depth_convergence(), checks.step_convergence(), checks.spacing_convergence()
    print_checks(*refinements)
    figures.convergence(folder / "heat_convergence.png", *refinements)
    motions = cases.motions()
    results = [cases.known_flux(motion) for motion in motions]
    figures.histories(folder / "heat_histories.png", motions, results)
    for motion, result in zip(motions, results, strict=True):
        print_known(motion, result)
    after = cases.surface_after()
    figures.surface(folder / "heat_surface.png", after)
    heading("Means over the round contact after T01 [degC]")
    print(f"area {after.mean:.2f}, along the diameter {after.diameter:.2f}", end=", ")
    print(f"weighted by the power of mu(local T) {after.weighted:.2f}")
    for motion in motions:
        print_fed_back(motion, cases.fed_back(motion))
    long = cases.long_rest()
    figures.thickness(folder / "heat_thickness.png", long)
    print_long(long)
    print_kernels()
    print(f"\n{time.perf_counter() - began:.0f} s")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: python heat_check.py FOLDER")
    main(Path(sys.argv[1]))
