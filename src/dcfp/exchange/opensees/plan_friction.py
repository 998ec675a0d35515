"""Friction and damping of a building that OpenSees can have: constant in temperature, each bearing at its own load, and in proportion to the stiffness."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from dcfp.analysis.plan import PlanResponse
from dcfp.arrays import FloatArray
from dcfp.exchange.opensees.element import (
    Element,
    at_temperature,
    exported_law,
    friction_of,
    is_heated,
    is_unequal,
    knows_pressure,
)
from dcfp.kernels.law import Law
from dcfp.system import NoHeating, System
from dcfp.system.plan import Plan
from dcfp.system.storeys import MODAL, STIFFNESS_PROPORTIONAL


def elements_of(response: PlanResponse) -> tuple[Element, ...]:
    """Return the friction of each bearing at its static pressure, and at the mean of its temperature over its path and load.

    Raises
    ------
    InputError
        If OpenSees has nothing like a friction law.
    """
    plan = response.plan
    temperatures = _mean_temperatures(response).tolist()
    return tuple(
        at_temperature(law, system, mean if is_heated(system, law) else system.heating.ambient)
        for law, system, mean in zip(_laws(plan), plan.systems, temperatures, strict=True)
    )


def _laws(plan: Plan) -> Iterator[Law]:
    """Yield the law of each bearing at its static load."""
    for system, load in zip(plan.systems, plan.static_loads.tolist(), strict=True):
        yield exported_law(system, load / system.bearing.slider_area)


def _mean_temperatures(response: PlanResponse) -> FloatArray:
    """Return the mean of each bearing's temperature over its path, weighted with its load [degC]."""
    arms, (vx, vy, turn) = response.plan.arms, response.slab_velocity.T[:, :, np.newaxis]
    weight = response.bearing_load * np.hypot(vx - turn * arms[:, 1], vy + turn * arms[:, 0])
    total = weight.sum(axis=0)
    mean = (weight * response.bearing_temperature).sum(axis=0) / np.where(total > 0.0, total, 1.0)
    return np.asarray(np.where(total > 0.0, mean, response.bearing_temperature[0]), dtype=np.float64)


def reasons_of(plan: Plan, elements: tuple[Element, ...], *, changes: bool) -> tuple[str, ...]:
    """Return why what is exported is not what was analysed; `changes` where the loads do."""
    found = {
        "its friction knows no heat, and is that at the mean temperature of each bearing over its path": any(
            map(is_heated, plan.systems, _laws(plan))
        ),
        "its friction does not change with the pressure, and is that at the static load": changes
        and any(map(knows_pressure, plan.systems)),
        "two different plates are one with the sum of their radii": any(map(is_unequal, plan.systems, elements)),
        "its damping is in proportion to the stiffness, with the same ratio in the first mode on a fixed base": bool(plan.storeys)
        and plan.damping_kind == MODAL,
    }  # fmt: skip
    return tuple(words for words, differs in found.items() if differs)


def as_exported(plan: Plan, elements: tuple[Element, ...]) -> Plan:
    """Return the plan with the friction and the damping of the script."""
    types = tuple(
        System(one.bearing, friction_of(element), NoHeating(one.heating.ambient))
        for one, element in zip(plan.systems, elements, strict=True)
    )
    return replace(plan, types=types, damping_kind=STIFFNESS_PROPORTIONAL)
