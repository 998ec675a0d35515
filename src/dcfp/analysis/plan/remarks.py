"""What a reader must know of the analysis of a building."""

from typing import TYPE_CHECKING

import numpy as np

from dcfp.analysis.assumptions import LARGEST_RESIDUAL
from dcfp.analysis.plan.model import LEAST_RATIO
from dcfp.kernels import plan_end as e

if TYPE_CHECKING:
    from dcfp.analysis.plan.response import PlanResponse


def remarks_of(response: "PlanResponse") -> tuple[str, ...]:
    """Return the sentences."""
    found = [
        *_energy(response),
        *_capacity(response),
        *_rest(response),
        *_uplift(response),
        *_pressure(response),
        *_vertical(response),
        *_laws(response),
    ]
    return tuple(found)


def _energy(response: "PlanResponse") -> list[str]:
    residual = response.energy.relative_residual
    if residual <= LARGEST_RESIDUAL:
        return []
    return [
        f"{response.name}: the energy balance closes only to {residual:.1e} of the input, so that no number here is to be trusted; storeys whose stiffnesses or masses lie many powers of ten apart are beyond the arithmetic."
    ]


def _capacity(response: "PlanResponse") -> list[str]:
    over = [
        (furthest, one.bearing.displacement_capacity, i, one.bearing.capacity_note)
        for i, (one, furthest) in enumerate(
            zip(response.plan.systems, response.peak_bearing_displacement.tolist(), strict=True), 1
        )
        if one.bearing.displacement_capacity is not None and furthest > one.bearing.displacement_capacity
    ]
    if not over:
        return []
    furthest, capacity, number, note = max(over)
    several = f", {len(over)} bearings in all" if len(over) > 1 else ""
    return [f"{response.name}: the displacement of bearing {number}, {furthest:.0f} mm, exceeds its capacity of {capacity:.0f} mm{f' ({note})' if note else ''}{several}."]  # fmt: skip


def _rest(response: "PlanResponse") -> list[str]:
    told = f"{response.name}: it still moves at the end, so the residual displacement is not final."
    return [] if response.rests else [told]


def _uplift(response: "PlanResponse") -> list[str]:
    if not response.uplift:
        return []
    times = response.uplift_time
    number, longest = int(times.argmax()) + 1, float(times.max())
    told = [
        f"{response.name}: {int((times > 0.0).sum())} of {len(times)} bearings lift off, bearing {number} longest, {longest:.2f} s in all; the others carry its load, without an impact when it lands."
    ]
    if response.tallies[e.ALL_LIFTED] > 0.0:
        told.append(
            f"{response.name}: for {int(response.tallies[e.ALL_LIFTED])} steps fewer than three bearings could have balanced the loads, and all of them were taken to be lifted."
        )
    return told


def _pressure(response: "PlanResponse") -> list[str]:
    """Say which pressures a law was not tested at."""
    told: list[str] = []
    for system in dict.fromkeys(response.plan.systems):
        own = np.array([one == system for one in response.plan.systems])
        tests = system.friction.tests()
        if tests is None:
            continue
        tested = tests.pressure
        least, most = (
            float(end(one[own]) / system.bearing.slider_area)
            for end, one in ((np.min, response.least_load), (np.max, response.largest_load))
        )
        if least < tested[0] * 0.99 or most > tested[1] * 1.01:
            floor = (
                f" (below {100 * LEAST_RATIO:g} % of that at rest it is taken to change no more)"
                if least == 0.0
                else ""
            )
            told.append(
                f"{response.name}: the pressure on bearings {system.bearing.name} goes from {least:.0f} to {most:.0f} N/mm2{floor}; the law {system.friction.name} was tested from {tested[0]:g} to {tested[1]:g} N/mm2."
            )
    return told


def _vertical(response: "PlanResponse") -> list[str]:
    ratio = response.weight_ratio
    if np.ptp(ratio) > 0.0:
        return [f"{response.name}: the weight follows the vertical component, from {ratio.min():.2f} to {ratio.max():.2f} times that at rest; slab and floors are rigid vertically."]  # fmt: skip
    if response.motion.vertical is not None:
        return [f"{response.name}: the vertical component is left out."]
    return []


def _laws(response: "PlanResponse") -> list[str]:
    laws = dict.fromkeys(one.friction for one in response.plan.systems)
    return [f"Friction law {law.name}: {law.caution}" for law in laws if law.caution]
