"""The linear part of a building on its bearings: complex modes, and what a step of any length does to them."""

import math
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from dcfp.arrays import FloatArray
from dcfp.kernels.heat_state import MOST_HALVINGS
from dcfp.kernels.plan_modes import Linear
from dcfp.system.coupling import groups_apart, undamped_modes
from dcfp.system.plan import Plan

ComplexArray: TypeAlias = NDArray[np.complex128]

#: Terms of the series of phi.
_TERMS = 26


@dataclass(frozen=True)
class Building:
    """Matrices of a building for the slab's x, y, rotation about the centre of mass and the modes on a fixed base; the slab's pendulums are in the stiffness."""

    mass: FloatArray
    damping: FloatArray
    stiffness: FloatArray
    tipping: FloatArray  # (2, fixed-base modes): moment about the slab of inertia forces w2 eta + 2 z w eta' [t^0.5 mm]

    @classmethod
    def of(cls, plan: Plan) -> "Building":
        """Return the matrices of a plan."""
        above = plan.structure
        frequencies, shapes = above.modes
        count = frequencies.size
        mass, stiffness = np.eye(3 + count), np.zeros((3 + count, 3 + count))
        of_slab = np.diag([plan.slab_mass, plan.slab_mass, plan.slab_inertia])
        participation = shapes.T @ above.mass @ above.rigid
        mass[:3, :3] = of_slab + above.rigid.T @ above.mass @ above.rigid
        mass[3:, :3], mass[:3, 3:] = participation, participation.T
        stiffness[:3, :3] = pendulum_stiffness(plan)
        stiffness[3:, 3:] = np.diag(frequencies**2)
        damping = np.diag(np.concatenate((np.zeros(3), above.damping)))
        weighted = above.mass @ shapes
        arms = np.repeat(above.heights, 3)[:, np.newaxis] * weighted
        tipping = np.stack([arms[0::3].sum(axis=0), arms[1::3].sum(axis=0)])
        return cls(mass, damping, stiffness, tipping)


def pendulum_stiffness(plan: Plan) -> FloatArray:
    """Return the stiffness of all pendulums under the static loads, shape (3, 3); where all stand in one point, a spring that nothing turns is put there."""
    each, arms = plan.static_loads / plan.radii, plan.arms
    found = _summed(each, arms)
    least = 1e-6 * found[0, 0] * max(plan.slab_inertia / plan.slab_mass, 1.0)
    found[2, 2] = max(found[2, 2], least)
    return found


def _summed(each: FloatArray, arms: FloatArray) -> FloatArray:
    x, y = arms.T
    total, first, second, polar = (
        math.fsum(part) for part in (each, each * x, each * y, each * (x * x + y * y))
    )
    return np.array([[total, 0.0, -second], [0.0, total, first], [-second, first, polar]])


@dataclass(frozen=True)
class Modes:
    """Complex modes: [q; q'] is the real part of `shapes` times z, with z' = `roots` z + `of_velocity` times what M^-1 makes of forces."""

    roots: ComplexArray
    displacement: ComplexArray  # (coordinates, modes)
    velocity: ComplexArray
    gains: ComplexArray  # (modes, coordinates), of accelerations
    groups: list[tuple[slice, list[int]]]  # modes and coordinates that move apart from all others


def modes_of(building: Building) -> Modes:
    """Return the complex modes, one of each pair; coordinates that move apart are solved apart."""
    scale = 1.0 / np.sqrt(np.diag(building.mass))
    across = np.outer(scale, scale)
    mass, damping, stiffness = building.mass * across, building.damping * across, building.stiffness * across
    size = mass.shape[0]
    roots: list[ComplexArray] = []
    parts: list[tuple[list[int], ComplexArray, ComplexArray, ComplexArray]] = []
    for block in groups_apart(mass, stiffness):
        pick = np.ix_(block, block)
        found = _block_modes(mass[pick], damping[pick], stiffness[pick])
        roots.append(found.roots)
        parts.append((block, found.displacement, found.velocity, found.gains))
    count = sum(one.size for one in roots)
    displacement, velocity, gains = (
        np.zeros(shape, np.complex128) for shape in ((size, count), (size, count), (count, size))
    )
    first, groups = 0, list[tuple[slice, list[int]]]()
    for block, shape, rate, gain in parts:
        columns = slice(first, first + shape.shape[1])
        groups.append((columns, block))
        displacement[block, columns], velocity[block, columns] = shape, rate
        gains[columns, block] = gain
        first += shape.shape[1]
    scaled = scale[:, np.newaxis]
    return Modes(np.concatenate(roots), scaled * displacement, scaled * velocity, gains / scale, groups)


def _block_modes(mass: FloatArray, damping: FloatArray, stiffness: FloatArray) -> Modes:
    if not damping.any():
        squares, vectors = undamped_modes(mass, stiffness)
        shapes = vectors.astype(np.complex128)
        turning: ComplexArray = np.sqrt(squares.astype(np.complex128)) * 1j
        gains: ComplexArray = shapes.T @ mass.astype(np.complex128) / turning[:, np.newaxis]
        return Modes(turning, shapes, shapes * turning, gains, [])
    size = mass.shape[0]
    first_order = np.zeros((2 * size, 2 * size))
    first_order[:size, size:] = np.eye(size)
    first_order[size:, :size] = -np.linalg.solve(mass, stiffness)
    first_order[size:, size:] = -np.linalg.solve(mass, damping)
    found: tuple[ComplexArray, ComplexArray] = np.linalg.eig(first_order)
    every, vectors = found[0].astype(np.complex128), found[1].astype(np.complex128)
    inverse = np.asarray(np.linalg.inv(vectors), dtype=np.complex128)
    upper = every.imag >= 0.0
    weight = np.where(every.imag > 0.0, 2.0, 1.0)[upper]
    vectors, inverse = vectors[:, upper], inverse[upper]
    return Modes(every[upper], weight * vectors[:size], weight * vectors[size:], inverse[:, size:], [])


def phi_functions(z: ComplexArray) -> ComplexArray:
    """Return phi_0 to phi_5 of complex numbers, phi_k = sum of z^n / (n + k)!, shape (6, ...)."""
    found = np.empty((6, *z.shape), complex)
    small = np.abs(z) < 1.0
    near = np.where(small, z, 0.0)
    far = np.where(small, 1.0, z)
    found[0] = np.exp(z)
    for k in range(1, 6):
        found[k] = (found[k - 1] - 1.0 / math.factorial(k - 1)) / far
    term, total = np.full(z.shape, 1.0 / math.factorial(5), complex), np.zeros(z.shape, complex)
    for n in range(_TERMS):
        total += term
        term = term * near / (n + 6)
    found[5] = np.where(small, total, found[5])
    for k in (4, 3, 2, 1):
        found[k] = np.where(small, 1.0 / math.factorial(k) + near * found[k + 1], found[k])
    return found


def linear_part(plan: Plan, interval: float) -> tuple[Linear, Building, Modes]:
    """Return what the kernels need of the linear part, for a sample interval [s] and its halves."""
    building = Building.of(plan)
    modes = modes_of(building)
    roots = modes.roots
    inverse_mass = np.linalg.inv(building.mass)
    # the ground's acceleration acts on the slab's coordinates alone, for all is relative to it
    gains = np.concatenate((modes.gains @ inverse_mass[:, :3], -modes.gains[:, :2]), axis=1).T
    slab, rates = modes.displacement[:3], modes.velocity[:3]
    square, damping = np.diag(building.stiffness)[3:], np.diag(building.damping)[3:]
    pushes = square[:, np.newaxis] * modes.displacement[3:] + damping[:, np.newaxis] * modes.velocity[3:]
    outputs = np.concatenate((slab, rates, building.tipping @ pushes))
    integrated = np.concatenate((slab, building.mass[:2] @ modes.displacement))
    # and one level more, for the middle of the shortest step
    lengths = interval * 0.5 ** np.arange(MOST_HALVINGS + 2.0)
    halves = _factors(roots, 0.5 * lengths)
    wholes = _factors(roots, lengths)
    both = np.stack((halves, wholes), axis=1)  # (levels, 2, 6, modes)
    of_start = outputs * both[:, :, :1]
    drives = [
        np.einsum("om,lhm,dm->lhod", outputs, factor * both[:, :, k], gains[part]).real
        for k, factor, part in ((1, 1.0, slice(0, 3)), (2, 1.0, slice(0, 3)), (3, 2.0, slice(0, 3)), (1, 1.0, slice(3, 5)), (2, 1.0, slice(3, 5)))
    ]  # fmt: skip
    influence = np.concatenate(drives, axis=3)
    levels = lengths.size
    order, groups = _observed(modes)
    storeys = np.stack((modes.displacement[3:][order].T, modes.velocity[3:][order].T))
    fixed = np.column_stack((square, damping, building.mass[3:, :3])).reshape(-1, 5)
    return (
        Linear(
            roots=roots,
            factors=np.ascontiguousarray(wholes),
            outputs=_parts(of_start.reshape(levels, -1, roots.size).swapaxes(1, 2), 1),
            influence=np.ascontiguousarray(influence.reshape(levels, -1, influence.shape[3])),
            gains=np.ascontiguousarray(gains),
            integrated=np.ascontiguousarray(integrated),
            rates=np.ascontiguousarray(rates),
            storeys=_parts(storeys, 1),
            fixed=np.ascontiguousarray(fixed[order]),
            groups=groups,
        ),
        building,
        modes,
    )


def _parts(values: ComplexArray, axis: int) -> FloatArray:
    """Return real and imaginary part along a new axis."""
    return np.ascontiguousarray(np.stack((values.real, values.imag), axis=axis))


def _observed(modes: Modes) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return the modes on a fixed base in the order of the groups in which they move, and first and last + 1 of both kinds of modes of each group."""
    order, groups = list[int](), list[tuple[int, int, int, int]]()
    for columns, coordinates in modes.groups:
        above = [one - 3 for one in coordinates if one >= 3]
        if above:
            groups.append((columns.start, columns.stop, len(order), len(order) + len(above)))
            order += above
    return np.array(order, dtype=np.int64), np.array(groups, dtype=np.int64).reshape(-1, 4)


def _factors(roots: ComplexArray, lengths: FloatArray) -> ComplexArray:
    """Return h^k phi_k of every root for steps of some `lengths` [s], shape (lengths, 6, roots)."""
    phi = phi_functions(lengths[:, np.newaxis] * roots)
    powers = lengths[:, np.newaxis] ** np.arange(6.0)
    return powers[:, :, np.newaxis] * phi.transpose(1, 0, 2)
