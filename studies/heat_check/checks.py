"""Checks of the finite elements: against closed forms, by refinement, and on whole meshes step by step."""

import closed_forms as cf
import numpy as np
import scipy.sparse.linalg
import skfem
from motions import AMBIENT, HALF_SIDE, RADIUS, Motion, march, sine
from plate_fe import (
    CONDUCTIVITY,
    DIFFUSIVITY,
    Array,
    Patch,
    Plate,
    across,
    along,
    both_ways,
    depth,
    disc,
    even,
    strip,
)
from skfem.models.poisson import laplace, mass

TIMES = np.array([0.05, 1.0, 12.6, 100.0])


def constant_flux(times: Array, **line: object) -> Array:
    """Return rises of the surface of a one-dimensional plate under a unit flux."""
    rises = []
    for time in times:
        plate = Plate(across(), across(), depth(**line))
        plate.heat(np.ones((1, 1)), float(time))
        rises.append(plate.surface()[0, 0])
    return np.array(rises)


def depth_convergence() -> list[tuple[float, int, float]]:
    """Return first element [mm], number of nodes and largest relative error against 2 q sqrt(D t/pi)/k."""
    rows = []
    for first, growth in ((2.4, 2.4), (1.2, 1.8), (0.6, 1.5), (0.3, 1.35), (0.15, 1.25), (0.075, 1.2)):
        line = {"thickness": 400.0, "first": first, "growth": growth}
        error = constant_flux(TIMES, **line) / cf.constant_flux_rise(TIMES) - 1.0
        rows.append((first, depth(**line).nodes.size, float(np.abs(error).max())))
    return rows


def thickness_errors() -> list[tuple[float, bool, float]]:
    """Return thickness [mm], kind of back and largest relative error against the theta series, 1 s to 2 h."""
    times = np.geomspace(1.0, 7200.0, 9)
    rows = []
    for thickness in (30.0, 50.0, 80.0, 100.0):
        for cold in (False, True):
            rises = constant_flux(times, thickness=thickness, cold_back=cold)
            rows.append(
                (
                    thickness,
                    cold,
                    float(np.abs(rises / cf.constant_flux_rise(times, thickness, cold) - 1.0).max()),
                )
            )
    return rows


def sheet_error() -> float:
    """Return the largest relative error for a sheet on a body, against its images summed over the time."""
    body = (3.0, 3.1, 1.0)
    times = np.array([0.5, 5.0, 50.0])
    roots = (np.arange(20_000) + 0.5) / 20_000
    closed = [  # tau = t s^2 takes the kernel's singularity away
        cf.FACTOR * 2.0 * t * float(np.mean(roots * cf.sheet_kernel(t * roots**2, *body))) for t in times
    ]
    return float(np.abs(constant_flux(times, thickness=400.0, body=body) / closed - 1.0).max())


def step_convergence() -> list[tuple[int, float, float]]:
    """Return steps per cycle of T01 and its last contact temperature: finite elements, and closed form."""
    rows = []
    for per_cycle in (75, 150, 300, 600, 1200, 2400):
        motion = sine("T01", 200.0, 400.0, 4, per_cycle, 0.043)
        plate = Plate(along(both_ways(even(320.0, 2.0)), False), across(), depth(150.0))
        end = float(march(motion, plate, strip(plate, HALF_SIDE)).contact[-1])
        closed = AMBIENT + cf.line_mean(motion.time, motion.position, motion.flux, HALF_SIDE, 4000)
        rows.append((per_cycle, end, closed))
    return rows


def spacing_convergence() -> list[tuple[float, float, float]]:
    """Return spacing along the plate and T01's last contact temperature: planar square, and round in 3-D."""
    rows = []
    motion = sine("T01", 200.0, 400.0, 4, 300, 0.043)
    for spacing in (20.0, 10.0, 5.0, 2.5):
        x = along(both_ways(even(320.0, spacing)))
        planar = Plate(x, across(), depth(150.0))
        y = along(even(RADIUS + spacing, spacing, 300.0))
        solid = Plate(x, y, depth(150.0, growth=1.6))
        ends = [
            march(motion, p, patch).contact[-1]
            for p, patch in ((planar, strip(planar, HALF_SIDE)), (solid, disc(solid, RADIUS)))
        ]
        rows.append((spacing, float(ends[0]), float(ends[1])))
    return rows


def whole_mesh(solid: bool) -> tuple[int, float, float]:
    """Return number of unknowns, and contact temperatures after a cycle of T01: whole mesh, and mode by mode.

    Bilinear quadrilaterals or trilinear hexahedra, consistent mass, Crank-Nicolson steps, sparse solution.
    """
    motion = sine("T01", 200.0, 400.0, 1, 150, 0.043)
    nodes = both_ways(even(320.0, 10.0 if solid else 5.0))
    sides = even(RADIUS + 10.0, 10.0, 300.0)
    line = even(0.3, 0.3, 60.0, 1.4) if solid else even(0.2, 0.2, 60.0, 1.15)
    x, z = along(nodes), depth(60.0)
    modal = Plate(x, along(sides) if solid else across(), z)
    patch = disc(modal, RADIUS) if solid else strip(modal, HALF_SIDE)
    if solid:
        basis = skfem.Basis(skfem.MeshHex.init_tensor(nodes, sides, line), skfem.ElementHex1())
    else:
        basis = skfem.Basis(skfem.MeshQuad.init_tensor(nodes, line), skfem.ElementQuad1())
    end = _stepped(motion, patch, basis)
    return basis.N, end, float(march(motion, modal, patch).contact[-1])


def _stepped(motion: Motion, patch: Patch, basis: skfem.Basis) -> float:
    places = basis.doflocs
    top = np.flatnonzero(places[-1] == 0.0)
    top = top[np.lexsort(places[-2::-1, top])]
    stiffness = CONDUCTIVITY * laplace.assemble(basis)
    capacity = CONDUCTIVITY / DIFFUSIVITY / motion.step * mass.assemble(basis)
    solve = scipy.sparse.linalg.splu((capacity + 0.5 * stiffness).tocsc(), "MMD_AT_PLUS_A").solve
    rest = capacity - 0.5 * stiffness
    rises = np.zeros(basis.N)
    covered = patch.at(motion.position[0])
    for n in range(motion.slip.size):
        ahead = patch.at(motion.position[n + 1])
        load = rest @ rises
        load[top] += 0.5 * motion.flux[n] * (covered + ahead).ravel()
        rises, covered = solve(load), ahead
    return AMBIENT + float((rises[top] * covered.ravel()).sum() / covered.sum())
