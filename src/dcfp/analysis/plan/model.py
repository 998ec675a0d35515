"""A plan as the kernels take it: constants and state of the bearings, how the slab passes its weight on, and room for the numbers of a step."""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.analysis.plan.linear import Building, Modes, linear_part, pendulum_stiffness
from dcfp.arrays import FloatArray
from dcfp.constants import STANDARD_GRAVITY
from dcfp.kernels import plan_bearing as k
from dcfp.kernels.heat_state import MOST_HALVINGS
from dcfp.kernels.plan_damping import RATE_COLUMNS
from dcfp.kernels.plan_load import Slab
from dcfp.kernels.plan_modes import DRIVES, INTEGRATED, SLAB_COLUMNS, SUM_ROWS
from dcfp.kernels.plan_step import Plan as PlanKernel
from dcfp.kernels.plan_step import Work
from dcfp.kernels.sum_of_exponentials import MODES
from dcfp.system import NoHeating, System
from dcfp.system.plan import Plan, load_compliance
from dcfp.system.plates import modes_of as heat_modes
from dcfp.system.plates import system_constants

#: Part of the static pressure of a bearing below which its friction law is not asked for less: near lift-off a law of the pressure has no limit.
LEAST_RATIO = 0.01
#: Pressures of the table of references, and how many times the largest static one the last is.
_PRESSURES, _LARGEST_RATIO = 200, 30.0


@dataclass(frozen=True)
class PlanModel:
    """What the kernels work on, and the linear part that it holds."""

    kernel: PlanKernel
    room: Work
    building: Building
    modes: Modes


def plan_model(plan: Plan, interval: float) -> PlanModel:
    """Return the kernels' view of a plan at rest and cold, for a sample interval [s]."""
    linear, building, modes = linear_part(plan, interval)
    behind = np.array([left_behind(one) for one in plan.systems])
    arms, static = plan.arms, plan.static_loads
    compliance = load_compliance(plan)
    of_moments = np.column_stack((np.ones(plan.count), arms)) @ compliance[:, 1:]
    slab = Slab(
        weight=math.fsum(static),
        own_weight=plan.slab_mass * STANDARD_GRAVITY,
        moment_x=math.fsum(static * arms[:, 0]),
        moment_y=math.fsum(static * arms[:, 1]),
        compliance=compliance,
        leverage=float(np.linalg.norm(of_moments, axis=1).max()) * plan.count / plan.weight,
        needed_contacts=plan.needed_contacts,
        height=plan.height,
    )
    each = static * behind
    lag = np.zeros((2, 3))
    lag[0, 0] = lag[1, 1] = each.sum()
    lag[0, 2], lag[1, 2] = -(each * arms[:, 1]).sum(), (each * arms[:, 0]).sum()
    points = np.vstack((np.zeros((1, 2)), plan.corners - np.array(plan.mass_centre)))
    watched = np.column_stack((points, np.zeros(len(points))))
    kernel = PlanKernel(_bearings(plan, behind), slab, linear, pendulum_stiffness(plan), lag, watched)
    room = Work(
        motion=np.zeros((k.MOTION_ROWS, k.OUTPUTS)),
        free=np.zeros(2 * k.OUTPUTS),
        forces=np.zeros((k.FORCE_ROWS, k.FORCE_COLUMNS)),
        carried=np.zeros((6, k.FORCE_COLUMNS)),
        drive=np.zeros((3, DRIVES)),
        sums=np.zeros((SUM_ROWS, INTEGRATED)),
        storeys=np.zeros((2, 2, len(linear.fixed))),
        rates=np.zeros((3, RATE_COLUMNS)),
        slab=np.zeros((3, SLAB_COLUMNS)),
        half=np.zeros(linear.roots.size, np.complex128),
    )
    return PlanModel(kernel, room, building, modes)


def left_behind(system: System) -> float:
    """Return the part of the slab's displacement that the slider stays behind it: the share of the upper plate; the plate of a single one lies below."""
    shares = system.bearing.shares
    return shares[1] if len(shares) == 2 else 0.0


def _bearings(plan: Plan, behind: FloatArray) -> k.Bearings:
    systems, static = plan.systems, plan.static_loads
    kinds: list[System] = []
    which: list[int] = []
    for one in systems:
        same = [i for i, known in enumerate(kinds) if known is one or known == one]
        which.append(same[0] if same else len(kinds))
        if not same:
            kinds.append(one)
    constants = np.zeros((plan.count, k.CONSTANTS))
    areas = np.array([one.bearing.slider_area for one in systems])
    constants[:, [k.X, k.Y]] = plan.arms
    constants[:, k.STATIC], constants[:, k.ELASTIC] = static, plan.elastic_stiffnesses
    constants[:, k.OVER_RADIUS], constants[:, k.AREA] = 1.0 / plan.radii, areas
    constants[:, k.BEHIND], constants[:, k.KIND] = behind, which
    constants[:, k.LEAST_PRESSURE] = LEAST_RATIO * static / areas
    rows = k.KIND_ROWS + k.LEVEL_ROWS * (MOST_HALVINGS + 1)
    first_row = rows * len(kinds)
    modes = np.zeros((first_row + 2 * plan.count, MODES))
    table, references = np.zeros((len(kinds), k.KIND_COLUMNS)), np.zeros((len(kinds), _PRESSURES))
    state = np.zeros((plan.count, k.STATE))
    state[:, k.RATIO : k.RATIO + 2] = 1.0
    for i, kind in enumerate(kinds):
        own = np.array(which) == i
        pressures = static[own] / areas[own]
        for place in np.flatnonzero(own):
            constants[place, k.REFERENCE] = kind.friction.at_pressure(
                float(static[place] / areas[place])
            ).reference
        table[i], references[i] = _kind(kind, pressures, rows * i)
        if not isinstance(kind.heating, NoHeating):
            rates, weights, _ = heat_modes(kind.heating)
            modes[rows * i], modes[rows * i + 1] = rates, weights * kind.heating.rise_factor
        state[own, k.TEMPERATURE] = state[own, k.TEMPERATURE + 1] = state[own, k.HOTTEST] = (
            kind.heating.ambient
        )
    prepared = np.full((len(kinds), MOST_HALVINGS + 1, 3), math.nan)
    heated = table[table[:, k.HEATED] != 0.0]
    shares = np.maximum(heated[:, k.SHARE], np.where(heated[:, k.PLATES] == 2.0, heated[:, k.SHARE + 1], 0.0))
    edges = heated[:, k.HALF_CONTACT] / shares
    return k.Bearings(
        constants=constants,
        kinds=table,
        references=references,
        modes=modes,
        prepared=prepared,
        first_row=first_row,
        reach=float(np.hypot(*plan.arms.T).max()),
        nearest_edge=float(edges.min(initial=math.inf)),
        state=state,
        trial=np.zeros((plan.count, k.TRIAL)),
    )


def _kind(system: System, pressures: FloatArray, row: int) -> tuple[FloatArray, FloatArray]:
    """Return the numbers of a kind of bearing whose static pressures are known [N/mm2], and the logarithms of its references over that of the pressure."""
    bearing, heating, constants = system.bearing, system.heating, system_constants(system)
    found = np.zeros(k.KIND_COLUMNS)
    law = system.friction.at_pressure(bearing.pressure)
    found[k.FORM], found[k.LAW : k.LAW + 6] = law[0], law[1:]
    found[k.PLATES] = constants.plates
    found[k.SHARE : k.SHARE + 2] = constants.first_share, constants.second_share
    found[k.SPEED : k.SPEED + 2] = constants.first_speed, constants.second_speed
    found[k.HEATED] = 0.0 if isinstance(heating, NoHeating) else 1.0
    found[k.AMBIENT], found[k.HALF_CONTACT] = heating.ambient, bearing.contact_half_side
    found[k.INSTANT] = heat_modes(heating)[2] * heating.rise_factor
    found[k.HEAT_ROW] = row
    logs = np.linspace(
        math.log(LEAST_RATIO * float(pressures.min())),
        math.log(_LARGEST_RATIO * float(pressures.max())),
        _PRESSURES,
    )
    found[k.FIRST_LOG], found[k.PER_LOG] = logs[0], 1.0 / (logs[1] - logs[0])
    references = [system.friction.at_pressure(float(one)).reference for one in np.exp(logs)]
    # a function by address has none, and is asked at the pressure itself
    return found, np.log(np.maximum(np.abs(references), np.finfo(np.float64).tiny))
