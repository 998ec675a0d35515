"""A prediction of our own: the structure is marched along a ground velocity of straight legs, with friction that heats.

Of the ground it knows the nodes of `dcfp.methods.nodes` only, some 70 in the median of FEMA P-695. The structure keeps the velocity and the place in which one leg leaves it, spring (a) pulls
it back, and the coefficient of friction follows the law of the bearing. ``docs/prediction.md`` has the derivation and the evidence.
"""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import march as k
from dcfp.methods.method import Information, Look
from dcfp.methods.nodes import Nodes, find_nodes
from dcfp.methods.prediction import Ground, Methods, Predicted, PredictionMethod
from dcfp.methods.pulses import Prediction, Pulses
from dcfp.motion.load import Motion
from dcfp.schema.notebook import fields_card
from dcfp.system import FrictionLaw, Heating, System, SystemLike
from dcfp.system.plates import cold_plates, kernel_model

NAME = "pulse march"
#: Steps in a leg, at least, and the longest step [s].
PARTS, LONGEST_STEP = 4, 0.05
#: What the legs leave out of V_E, for a misfit of 1: this time [s] times the friction per mass over the PGV of the nodes; fitted to FEMA P-695.
_LEFT_OUT = 0.65


@dataclass(frozen=True, eq=False)
class PulseMarch:
    """How the structure moves along the legs, with its path over time [s, mm], shape (n,).

    The largest change of displacement began on the leg of a number counted from zero; None where nothing slides, or where it began after the last node. Where
    it has not come to rest within two minutes after that, that slide is not in the changes of displacement.
    """

    prediction: Prediction  #: peaks and energies
    leg: int | None
    nodes: int  #: number of what is known of the ground velocity
    rests: bool
    peak_temperature: float  #: highest temperature of the contact [degC]
    residual_displacement: float  #: displacement in which it rests at the end [mm]
    time: FloatArray
    displacement: FloatArray

    def _repr_html_(self) -> str:
        facts = {
            "nodes": self.nodes,
            "comes to rest": self.rests,
            "peak_temperature [degC]": self.peak_temperature,
        }
        return fields_card(self.prediction, "March along the legs", facts)


def march_through_pulses(
    ground: Nodes | Pulses | Motion,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    parts: int = PARTS,
    with_path: bool = False,
) -> PulseMarch:
    """March a rigid structure on a bearing along the straight legs of a ground velocity.

    Parameters
    ----------
    ground
        Nodes of a ground velocity; pulses, between whose peaks it is then straight; or a ground motion whose nodes are to be found.
    bearing, friction, heating
        As for `dcfp.respond`; spring (b) is taken as rigid.
    parts
        Steps in a leg, at least.
    with_path
        Whether to keep the displacement at the end of every step.

    Raises
    ------
    AnalysisError
        If a displacement is not a finite number.
    """
    nodes = ground if isinstance(ground, (Nodes, Pulses)) else find_nodes(ground)
    system = System.of(bearing, friction, heating)
    state, path = _marched(nodes, system, parts, with_path=with_path)
    if not np.isfinite(state[:-1]).all():
        what = "the march along the legs"
        raise system.friction.no_number(what)
    return PulseMarch(
        prediction=Prediction(
            displacement_change=state.peak_change,
            input_velocity=math.sqrt(2.0 * state.peak_input),
            hysteretic_velocity=math.sqrt(2.0 * state.peak_hysteretic),
            displacement=state.peak_displacement,
            total_velocity=_with_what_legs_leave_out(state, nodes),
        ),
        # not a number is below nothing
        leg=int(state.peak_leg) if state.peak_leg < nodes.times.size - 1 else None,
        nodes=nodes.times.size,
        rests=state.slip_sign == 0.0,
        peak_temperature=state.peak_temperature,
        residual_displacement=state.displacement,
        time=freeze(path[:, k.PATH_TIME].copy()),
        displacement=freeze(path[:, k.PATH_DISPLACEMENT].copy()),
    )


def _marched(
    nodes: Nodes | Pulses, system: System, parts: int, *, with_path: bool
) -> tuple[k.MarchState, FloatArray]:
    """Return state and path at the end; again with more cells where they did not suffice."""
    legs = np.maximum(parts, np.ceil(np.diff(nodes.times) / LONGEST_STEP))
    rows = int(legs.sum()) + k.FREE_STEPS if with_path else 0
    plates = cold_plates(system)
    while True:
        state = np.zeros(1, k.MARCH_STATE)
        state["peak_temperature"], state["peak_leg"] = system.heating.ambient, math.nan
        path = np.empty((rows, k.PATH_SIZE))
        model = kernel_model(system, plates)
        written, fits = k.march_along_legs(
            model, nodes.times, nodes.velocities, parts, LONGEST_STEP, state, path
        )
        if fits:
            return k.MarchState(*state[0].item()), path[:written]
        plates = cold_plates(system).with_room(plates.cells.shape[1])


def _with_what_legs_leave_out(state: k.MarchState, nodes: Nodes | Pulses) -> float:
    """Return V_E [mm/s] of the march; of nodes with what the ground velocity beside the legs puts in.

    It makes the structure slide where the legs do not, the more often the larger the friction is beside the ground's velocity.
    """
    velocity = math.sqrt(2.0 * max(state.input, 0.0))
    if not isinstance(nodes, Nodes) or state.path_length == 0.0:
        return velocity
    friction = state.hysteretic / state.path_length
    return velocity * math.exp(_LEFT_OUT * nodes.misfit * friction / np.abs(nodes.velocities).max())


def _predict(ground: Ground, methods: Methods) -> Predicted:
    marched = march_through_pulses(ground.nodes(methods.march_tolerance), methods.system)
    name = "" if ground.motion is None else ground.motion.name
    still = (
        f"{name}: the march still slides two minutes after the last node; its dy does not count that slide."
    )
    return Predicted(marched.prediction, nodes=marched.nodes, remarks=() if marched.rests else (still,))


PULSE_MARCH = PredictionMethod(
    key="march",
    name=NAME,
    head="march",
    knows=(Information.BLIND,),
    look=Look("D", "red", 0.9, order=5),
    predict=_predict,
)
