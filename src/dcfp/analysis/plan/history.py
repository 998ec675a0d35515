"""Response history analysis of an isolated building on many bearings."""

import math
import time

import numpy as np

from dcfp.analysis.integration import DEFAULT, LONGEST_STEP, Integration, halvings
from dcfp.analysis.plan.model import PlanModel, plan_model
from dcfp.analysis.plan.response import PlanResponse, time_to_rest
from dcfp.analysis.plane_history import PART_OF_PERIOD, TOLERANCE
from dcfp.arrays import FloatArray, first_rows, freeze
from dcfp.constants import STANDARD_GRAVITY
from dcfp.errors import AnalysisError, InputError
from dcfp.kernels import plan_bearing as b
from dcfp.kernels import plan_end as e
from dcfp.kernels import plan_integrate as k
from dcfp.kernels.motion import NO_NUMBER
from dcfp.kernels.plane_slide import PlaneControl
from dcfp.motion.ground_motion import parts_in, refined, with_tail
from dcfp.motion.station import Station
from dcfp.system import PreciseHeating
from dcfp.system.plan import Plan

#: Part of the tolerance of a rigid structure with storeys: the acceleration of a slab that carries little of the mass jumps where friction begins to slide.
_WITH_STOREYS = 0.5


def respond_plan(
    plan: Plan,
    motion: Station,
    *,
    vertical: bool = False,
    overturning: bool = True,
    step: float | None = None,
    tail: float | None = None,
    tolerance: float = DEFAULT.tolerance,
) -> PlanResponse:
    """Analyse an isolated building under the ground motion of a station.

    Parameters
    ----------
    plan
        Bearings, slab and storeys.
    motion
        Of the station.
    vertical
        Whether the weight follows the vertical component, W (1 + a_z / g).
    overturning
        Whether the loads of the bearings follow the overturning moment: of the floors, of the slab's own height and of the sliders' place; of a slab without height and floors there is none.
    step, tail, tolerance
        As of `dcfp.analysis.Integration`.

    Raises
    ------
    InputError
        If a value is out of range, there is no vertical component, or a bearing asks for a field of heat.
    AnalysisError
        If the analysis cannot be finished.
    """
    integration = Integration(step=step, tail=tail, tolerance=tolerance)
    if any(isinstance(one.heating, PreciseHeating) for one in plan.systems):
        msg = "The bearings of a plan are heated at one point each; choose the heating model simplified or none."
        raise InputError(msg)
    began = time.perf_counter()
    parts = 1 if step is None else parts_in(motion.time_step, step)
    interval = motion.time_step / parts

    def sampled(acceleration: FloatArray) -> FloatArray:
        return refined(with_tail(acceleration, motion.time_step, integration.tail), parts)

    ground = np.ascontiguousarray(sampled(motion.acceleration))
    ratios = np.ones(len(ground))
    if vertical:
        ratios = 1.0 + sampled(motion.require_vertical().acceleration) / STANDARD_GRAVITY
    model = plan_model(plan, interval)
    tips = overturning and (plan.height > 0.0 or bool(plan.storeys))
    changes = vertical or tips
    if not tips:
        model = _without_moments(model)
    masses = plan.static_loads / STANDARD_GRAVITY
    period = math.tau * math.sqrt(masses.sum() / plan.elastic_stiffnesses.sum())
    fewest = halvings(interval, min(LONGEST_STEP, PART_OF_PERIOD * period))
    finer = integration.tolerance / DEFAULT.tolerance * (_WITH_STOREYS if plan.storeys else 1.0)
    control = PlaneControl(interval, fewest, TOLERANCE * finer)
    free_from = len(motion.acceleration) * parts if tail is None else len(ground)
    linear = model.kernel.linear
    lines = np.zeros((len(ground), k.LINE))
    modes = np.zeros((len(ground), linear.roots.size), complex)
    kept = np.zeros((len(ground), plan.count, k.KEPT))
    tallies, state = np.zeros(e.TALLIES), np.zeros(linear.roots.size, complex)
    done = k.integrate_plan(
        model.kernel,
        ground,
        ratios,
        control,
        changes,
        free_from,
        time_to_rest(plan),
        state,
        model.room,
        tallies,
        lines,
        modes,
        kept,
    )
    if int(tallies[e.STATUS]) == NO_NUMBER:
        laws = dict.fromkeys(one.friction for one in plan.systems)
        if len(laws) == 1:
            raise next(iter(laws)).no_number(motion.name, done * interval)
        named = ", ".join(law.title for law in laws)
        msg = f"{motion.name} at {done * interval:.4g} s: no finite number; look at the friction laws {named}, of which one may raise there or return nan or infinity."
        raise AnalysisError(msg)
    count = done + 1
    return PlanResponse(
        plan=plan,
        motion=motion,
        time=freeze(np.arange(count) * interval),
        ground_acceleration=first_rows(ground, count),
        weight_ratio=first_rows(ratios, count),
        lines=first_rows(lines, count),
        modes=modes[:count],
        kept=first_rows(kept, count),
        model=model,
        tallies=freeze(tallies),
        overturning_counts=overturning,
        elapsed=time.perf_counter() - began,
    )


def _without_moments(model: PlanModel) -> PlanModel:
    """Return a model whose loads follow no moment."""
    kernel, linear = model.kernel, model.kernel.linear
    outputs, influence = linear.outputs.copy(), linear.influence.copy()
    for first in (b.TIPPING, b.OUTPUTS + b.TIPPING):
        outputs[..., first : first + 2] = 0.0
        influence[:, first : first + 2] = 0.0
    still = linear._replace(outputs=outputs, influence=influence)
    bearings = kernel.bearings
    bearings.constants[:, b.BEHIND] = 0.0
    fixed = kernel._replace(linear=still, lag=np.zeros((2, 3)), slab=kernel.slab._replace(height=0.0))
    return PlanModel(fixed, model.room, model.building, model.modes)
