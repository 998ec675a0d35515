r"""A building on many bearings by brute force: very small uniform steps, floors and slab by their matrices, loads by trying which bearings press.

Nothing is shared with the kernels. Spring (b) of each bearing is cut back along its radius to the circle of yielding after every step, the floors are moved by their storeys' forces, the loads come
from the moments of the step before, and the heat at the centre of a plate is the whole past summed: the flux is constant in a step of the heat, and its weight in Eq. (11) exact.
"""

import math
from dataclasses import dataclass
from typing import Any

import numba
import numpy as np

from dcfp.arrays import FloatArray
from dcfp.constants import STANDARD_GRAVITY as GRAVITY
from dcfp.motion.station import Station
from dcfp.system import Li2020, NoHeating
from dcfp.system.plan import Plan

#: Longest steps of the motion and of the heat [s].
STEP, HEAT_STEP = 5e-5, 5e-3


@dataclass(frozen=True)
class PlanOutcome:
    """What a ground motion brings: peaks of slab [mm], rotation [rad], drifts [mm] and floors [mm/s2], least and largest load [N], temperature [degC] and time without load [s] of each bearing."""

    displacement: float
    rotation: float
    drift: FloatArray
    acceleration: FloatArray
    least: FloatArray
    largest: FloatArray
    temperature: FloatArray
    lifted: FloatArray


def integrate(plan: Plan, motion: Station, *, vertical: bool = False, step: float = STEP) -> PlanOutcome:
    """Shake a plan of equal bearings with two equal plates and the law of Li et al. (2020) from rest, with overturning where slab or storeys are high; `vertical`: the weight follows its component."""
    above, one = plan.structure, plan.systems[0]
    floors, bearing = above.floors, one.bearing
    of_slab = np.diag([plan.slab_mass, plan.slab_mass, plan.slab_inertia])
    size = 3 * (floors + 1)
    mass = np.zeros((size, size))
    mass[:3, :3], mass[3:, 3:] = of_slab, above.mass
    relative = np.hstack((-above.rigid, np.eye(3 * floors)))
    stiffness = relative.T @ above.stiffness @ relative
    lower, shapes = above.modes
    weighted = above.mass @ shapes
    damping = relative.T @ (weighted * above.damping) @ weighted.T @ relative if lower.size else stiffness
    heats = not isinstance(one.heating, NoHeating)
    parts = math.ceil(motion.time_step / HEAT_STEP)
    heat_step = motion.time_step / parts
    inner = math.ceil(heat_step / step)
    law = np.array(_law(plan))
    heights = np.concatenate(([0.0], above.heights)) + plan.height
    factor = math.sqrt(one.heating.diffusivity / math.pi) / one.heating.conductivity
    tips = plan.height > 0.0 or floors > 0
    ground = motion.acceleration
    rising = motion.require_vertical().acceleration if vertical else np.zeros(len(ground))
    found = _march(
        np.column_stack((ground, rising)), parts, inner, heat_step / inner, np.linalg.inv(mass), stiffness, damping, mass,
        plan.arms, plan.static_loads, plan.elastic_stiffnesses, plan.radii[0], bearing.slider_area, law,
        one.heating.ambient, factor if heats else 0.0, bearing.contact_half_side / bearing.shares[0],
        heights, tips, vertical,
    )  # fmt: skip
    return PlanOutcome(*found)


def _law(plan: Plan) -> tuple[float, ...]:
    """Return s, c, f, d, r, A, B, C of (s p^c + f) (1 - d exp(-r |v|)) (A exp(-B T) + C)."""
    law = plan.systems[0].friction
    if isinstance(law, Li2020):
        return (0.075 * 2.03, -0.19, 0.075 * 0.068, 0.55, 0.019, 1.13, 0.007, 0.0)
    return (law.reference, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)


def _loads_plainly(arms: FloatArray, own: FloatArray, tip_x: float, tip_y: float, loads: FloatArray) -> None:
    """Write the loads: those that pull are left out, one pull after the other, until none does and none that was left out would press; what stands on one line balances nothing."""
    count = own.size
    presses = own > 0.0
    for _ in range(100):
        matrix, right = np.zeros((3, 3)), np.zeros(3)
        for i in range(count):
            right[0] += own[i]
            right[1] += own[i] * arms[i, 0]
            right[2] += own[i] * arms[i, 1]
            if presses[i]:
                row = np.array([1.0, arms[i, 0], arms[i, 1]])
                for a in range(3):
                    right[a] -= own[i] * row[a]
                    for b in range(3):
                        matrix[a, b] += row[a] * row[b]
        right[1] += tip_x
        right[2] += tip_y
        if np.linalg.det(matrix) <= 1e-9 * matrix[0, 0] * matrix[1, 1] * matrix[2, 2]:
            loads[:] = 0.0
            break
        plane = np.linalg.solve(matrix, right)
        same = True
        for i in range(count):
            loads[i] = own[i] + plane[0] + plane[1] * arms[i, 0] + plane[2] * arms[i, 1]
            if (loads[i] > 0.0) != presses[i]:
                presses[i] = loads[i] > 0.0
                same = False
        if same:
            break
    for i in range(count):
        loads[i] = max(loads[i], 0.0)


_loads: Any = numba.njit(_loads_plainly)


def _march_plainly(
    ground: FloatArray, parts: int, inner: int, h: float, inverse: FloatArray, stiffness: FloatArray, damping: FloatArray, mass: FloatArray,
    arms: FloatArray, static: FloatArray, kf: FloatArray, radius: float, area: float, law: FloatArray,
    ambient: float, factor: float, edge: float, heights: FloatArray, tips: bool, vertical: bool,
) -> tuple[float, float, FloatArray, FloatArray, FloatArray, FloatArray, FloatArray, FloatArray]:  # fmt: skip
    count, size = static.size, inverse.shape[0]
    floors = size // 3
    steps = (ground.shape[0] - 1) * parts
    roots = np.sqrt(h * inner * np.arange(steps + 1.0))
    weights = 2.0 * factor * (roots[1:] - roots[:-1])
    flux = np.zeros((count, steps))
    q, v = np.zeros(size), np.zeros(size)
    ex, ey = np.zeros(count), np.zeros(count)
    loads, now, before = static.copy(), np.full(count, ambient), np.full(count, ambient)
    least, largest, hottest, lifted = static.copy(), static.copy(), np.full(count, ambient), np.zeros(count)
    drift, acceleration = np.zeros(floors - 1), np.zeros(floors)
    peak, turned = 0.0, 0.0
    force = np.zeros(size)
    for n in range(steps):
        sample, part = n // parts, n % parts
        rubbed = np.zeros(count)
        for j in range(inner):
            along = (part + (j + 0.5) / inner) / parts
            ax = ground[sample, 0] + along * (ground[sample + 1, 0] - ground[sample, 0])
            ay = ground[sample, 1] + along * (ground[sample + 1, 1] - ground[sample, 1])
            q += 0.5 * h * v
            of_floors = stiffness @ q + damping @ v
            force[:] = of_floors
            shear_x, shear_y, lag_x, lag_y = 0.0, 0.0, 0.0, 0.0
            for i in range(count):
                ux, uy = q[0] - q[2] * arms[i, 1], q[1] + q[2] * arms[i, 0]
                vx, vy = v[0] - v[2] * arms[i, 1], v[1] + v[2] * arms[i, 0]
                speed = math.sqrt(vx * vx + vy * vy)
                pressure = max(loads[i], 0.01 * static[i]) / area
                friction = (law[0] * pressure ** law[1] + law[2]) * (1.0 - law[3] * math.exp(-law[4] * speed))
                warm = now[i] + (now[i] - before[i]) * (j + 0.5) / inner
                friction *= law[5] * math.exp(-law[6] * warm) + law[7]
                rim = friction * loads[i] / kf[i]
                tx, ty = ex[i] + h * vx, ey[i] + h * vy
                long = math.sqrt(tx * tx + ty * ty)
                if long > rim:
                    slip = long - rim
                    tx, ty = tx * rim / long, ty * rim / long
                    rubbed[i] += friction * loads[i] * slip if math.sqrt(ux * ux + uy * uy) <= edge else 0.0
                fx = kf[i] * 0.5 * (tx + ex[i]) + loads[i] / radius * ux
                fy = kf[i] * 0.5 * (ty + ey[i]) + loads[i] / radius * uy
                ex[i], ey[i] = tx, ty
                shear_x, shear_y = shear_x + fx, shear_y + fy
                lag_x, lag_y = lag_x + 0.5 * loads[i] * ux, lag_y + 0.5 * loads[i] * uy
                force[0] += fx
                force[1] += fy
                force[2] += arms[i, 0] * fy - arms[i, 1] * fx
            a = -(inverse @ force)
            v += h * a
            for f in range(floors):
                v[3 * f] -= h * ax
                v[3 * f + 1] -= h * ay
            q += 0.5 * h * v
            if tips or vertical:
                # inertia of slab and floors at their heights
                inertia = -(mass @ a)
                tip_x, tip_y = lag_x, lag_y
                for f in range(floors):
                    tip_x += heights[f] * inertia[3 * f]
                    tip_y += heights[f] * inertia[3 * f + 1]
                if not tips:
                    tip_x, tip_y = 0.0, 0.0
                # at the end of the step
                along = (part + (j + 1.0) / inner) / parts
                rising = ground[sample, 2] + along * (ground[sample + 1, 2] - ground[sample, 2])
                _loads(arms, static * (1.0 + rising / GRAVITY), tip_x, tip_y, loads)
            for i in range(count):
                least[i], largest[i] = min(least[i], loads[i]), max(largest[i], loads[i])
                if loads[i] == 0.0:
                    lifted[i] += h
            peak, turned = max(peak, math.hypot(q[0], q[1])), max(turned, abs(q[2]))
            for f in range(floors):
                acceleration[f] = max(acceleration[f], math.hypot(a[3 * f], a[3 * f + 1]))
                if f > 0:
                    drift[f - 1] = max(
                        drift[f - 1], math.hypot(q[3 * f] - q[3 * f - 3], q[3 * f + 1] - q[3 * f - 2])
                    )
        for i in range(count):
            before[i] = now[i]
            if factor > 0.0:
                flux[i, n] = 0.5 * rubbed[i] / (area * h * inner)
                rise = 0.0
                for k in range(n + 1):
                    rise += weights[n - k] * flux[i, k]
                now[i] = ambient + rise
                hottest[i] = max(hottest[i], now[i])
    return peak, turned, drift, acceleration, least, largest, hottest, lifted


_march: Any = numba.njit(_march_plainly)
