"""A prediction of our own for a station: the structure is marched in the plane along straight legs of the ground velocity, with friction that heats.

Of the ground it knows the nodes of `dcfp.methods.nodes` only, in both directions at once. ``docs/prediction.md`` has the derivation and the evidence.
"""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.analysis.plane_response import largest_change
from dcfp.arrays import FloatArray, freeze
from dcfp.errors import InputError
from dcfp.kernels import plane_march as k
from dcfp.kernels.heat_state import MOST_HALVINGS
from dcfp.kernels.plane_heat import HOTTEST
from dcfp.kernels.plane_step import COEFFICIENTS
from dcfp.methods.nodes import Nodes, find_nodes
from dcfp.methods.pulses import Prediction
from dcfp.motion.station import Station
from dcfp.schema.notebook import fields_card
from dcfp.system import FrictionLaw, Heating, PreciseHeating, System, SystemLike
from dcfp.system.fields import cold_heat

NAME = "plane march"
#: Longest step [s], and distance of the friction from its chord in the middle of a step that is allowed, over mu g [-].
LONGEST_STEP, TOLERANCE = 0.05, 0.1
#: What the legs leave out of V_E, for a misfit of 1; fitted to FEMA P-695. It does not depend on the friction: sliding in one direction frees the other.
_LEFT_OUT = 0.27
#: Directions in which the largest change is looked for: 2.5 degrees beside it, a thousandth is missing.
_DIRECTIONS = 36
#: Displacement [mm] and rows of the path that there is room for at first.
_FIRST_REACH, _FIRST_ROWS = 1200.0, 4000
#: Most points of the field of heat across the slider: with 50 the predictions are the same, for five times the time.
POINTS = 10


@dataclass(frozen=True, eq=False)
class PlaneMarch:
    """How the structure moves in the plane along the legs, with its path over time [s, mm], shapes (n,) and (n, 2), at the ends of steps."""

    prediction: Prediction  #: peaks of the resultant, and all the energy put in
    nodes: int  #: number of what is known of the ground velocity
    rests: bool
    peak_temperature: float  #: highest temperature of the contact [degC]
    time: FloatArray
    displacement: FloatArray

    def _repr_html_(self) -> str:
        facts = {
            "nodes": self.nodes,
            "comes to rest": self.rests,
            "peak_temperature [degC]": self.peak_temperature,
        }
        return fields_card(self.prediction, "March in the plane", facts)


def march_in_plane(
    ground: Nodes | Station,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    longest: float = LONGEST_STEP,
) -> PlaneMarch:
    """March a rigid structure on a bearing in the plane along the straight legs of the ground velocity of a station.

    Parameters
    ----------
    ground
        Nodes of a ground velocity in both directions, or a station whose nodes are to be found.
    bearing, friction, heating
        As for `dcfp.respond` of a station; a field of heat is taken on fewer points. The vertical force is constant.
    longest
        Longest step [s].

    Raises
    ------
    InputError
        If the nodes are of one direction.
    AnalysisError
        If a displacement is not a finite number.
    """
    nodes = find_nodes(ground) if isinstance(ground, Station) else ground
    if nodes.velocities.ndim != 2:
        msg = "A march in the plane needs the nodes of a station, with two velocities each."
        raise InputError(msg)
    system = System.of(bearing, friction, heating, usual=PreciseHeating.name)
    state, path = _marched(nodes, system, longest)
    if not (math.isfinite(state.peak_displacement) and math.isfinite(state.displacement_x)):
        what = "the march in the plane"
        raise system.friction.no_number(what)
    displacement, velocity = freeze(path[:, k.PATH_X : k.PATH_Y + 1]), freeze(path[:, k.PATH_VELOCITY_X :])
    return PlaneMarch(
        prediction=Prediction(
            displacement_change=largest_change(displacement, velocity, 0.0, _DIRECTIONS)
            if len(path)
            else 0.0,
            input_velocity=math.nan,
            hysteretic_velocity=math.nan,
            displacement=state.peak_displacement,
            total_velocity=math.sqrt(2.0 * max(state.input, 0.0)) * math.exp(_LEFT_OUT * nodes.misfit),
        ),
        nodes=nodes.count,
        rests=bool(state.rests),
        peak_temperature=state.peak_temperature,
        time=freeze(path[:, k.PATH_TIME]),
        displacement=displacement,
    )


def _marched(nodes: Nodes, system: System, longest: float) -> tuple[k.PlaneMarchState, FloatArray]:
    """Return state and path at the end; again with more room where the slider left the grid or the path its rows."""
    tables = np.empty((2, MOST_HALVINGS + 1, COEFFICIENTS))
    x, y = (np.ascontiguousarray(one) for one in nodes.velocities.T)
    reach, rows = _FIRST_REACH, _FIRST_ROWS
    while True:
        heat = cold_heat(system, reach, points=POINTS)
        heat.field.tallies[:, HOTTEST] = math.inf
        state = np.zeros(1, k.PLANE_MARCH_STATE)
        state["peak_temperature"] = system.heating.ambient
        path = np.empty((rows, k.PATH_SIZE))
        steps, fits = k.march_in_plane(
            heat.model(system), heat.field, nodes.times, x, y, longest, TOLERANCE, tables, state, path
        )
        if fits and steps <= rows:
            return k.PlaneMarchState(*state[0].item()), path[:steps]
        reach, rows = reach if fits else 2.0 * reach, max(rows, steps)
