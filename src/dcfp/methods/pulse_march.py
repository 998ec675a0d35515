"""A prediction of our own: the structure is marched through the pulses, with friction that heats.

It knows the times and velocities of the peaks, as the pulse method does. But the ground velocity between two peaks is half a cosine, the structure keeps the
velocity and the place in which one pulse leaves it, spring (a) pulls it back, and the coefficient of friction follows the law of the bearing.
``docs/prediction.md`` has the derivation and the evidence.
"""

import math
from dataclasses import dataclass

import numpy as np

from dcfp.arrays import FloatArray, freeze
from dcfp.kernels import pulses as k
from dcfp.methods.method import Information, Look
from dcfp.methods.prediction import Ground, Methods, Predicted, PredictionMethod
from dcfp.methods.pulses import MARCH_THRESHOLD, Prediction, Pulses, find_pulses
from dcfp.motion.load import Motion
from dcfp.schema.notebook import fields_card
from dcfp.system import FrictionLaw, Heating, System, SystemLike
from dcfp.system.plates import cold_plates, kernel_model

NAME = "pulse march"
#: Steps in a leg, at least, and the longest step [s].
PARTS, LONGEST_STEP = 12, 0.05


@dataclass(frozen=True, eq=False)
class PulseMarch:
    """How the structure moves through the pulses, with its path over time [s, mm], shape (n,).

    The largest change of displacement began on the rise of the pulse of a number counted from zero; None where nothing slides, or where it began after the
    last peak that has a pulse. Where it has not come to rest within two minutes after the last peak, that slide is not in the changes of displacement.
    """

    prediction: Prediction  #: peaks and energies
    pulse: int | None
    rests: bool
    peak_temperature: float  #: highest temperature of the contact [degC]
    residual_displacement: float  #: displacement in which it rests at the end [mm]
    time: FloatArray
    displacement: FloatArray

    def _repr_html_(self) -> str:
        facts = {"comes to rest": self.rests, "peak_temperature [degC]": self.peak_temperature}
        return fields_card(self.prediction, "March through the pulses", facts)


def march_through_pulses(
    ground: Pulses | Motion,
    bearing: SystemLike = None,
    friction: FrictionLaw | str | None = None,
    heating: Heating | str | None = None,
    *,
    parts: int = PARTS,
    with_path: bool = False,
) -> PulseMarch:
    """March a rigid structure on a bearing through the pulses of a ground motion.

    Parameters
    ----------
    ground
        Pulses of a ground velocity, or a ground motion whose pulses are to be found with the threshold of the march.
    bearing, friction, heating
        As for `dcfp.respond`; spring (b) is taken as rigid.
    parts
        Steps from one peak to the next, at least.
    with_path
        Whether to keep the displacement at the end of every step.

    Raises
    ------
    AnalysisError
        If a displacement is not a finite number.
    """
    pulses = ground if isinstance(ground, Pulses) else find_pulses(ground, MARCH_THRESHOLD)
    system = System.of(bearing, friction, heating)
    state, path = _marched(pulses, system, parts, with_path=with_path)
    if not np.isfinite(state[:-1]).all():
        what = "the march through the pulses"
        raise system.friction.no_number(what)
    return PulseMarch(
        prediction=Prediction(
            displacement_change=state.peak_change,
            input_velocity=math.sqrt(2.0 * state.peak_input),
            hysteretic_velocity=math.sqrt(2.0 * state.peak_hysteretic),
            displacement=state.peak_displacement,
            total_velocity=math.sqrt(2.0 * max(state.input, 0.0)),
        ),
        # the last leg has no pulse of its own; not a number is below nothing
        pulse=int(state.peak_leg) if state.peak_leg < pulses.count else None,
        rests=state.slip_sign == 0.0,
        peak_temperature=state.peak_temperature,
        residual_displacement=state.displacement,
        time=freeze(path[:, k.PATH_TIME].copy()),
        displacement=freeze(path[:, k.PATH_DISPLACEMENT].copy()),
    )


def _marched(
    pulses: Pulses, system: System, parts: int, *, with_path: bool
) -> tuple[k.PulseState, FloatArray]:
    """Return state and path at the end; again with more cells where they did not suffice."""
    legs = np.maximum(parts, np.ceil(np.diff(pulses.times) / LONGEST_STEP))
    rows = int(legs.sum()) + k.FREE_STEPS if with_path else 0
    plates = cold_plates(system)
    while True:
        state = np.zeros(1, k.PULSE_STATE)
        state["peak_temperature"], state["peak_leg"] = system.heating.ambient, math.nan
        path = np.empty((rows, k.PATH_SIZE))
        model = kernel_model(system, plates)
        written, fits = k.integrate_pulses(
            model, pulses.times, pulses.velocities, parts, LONGEST_STEP, state, path
        )
        if fits:
            return k.PulseState(*state[0].item()), path[:written]
        plates = cold_plates(system).with_room(plates.cells.shape[1])


def _predict(ground: Ground, methods: Methods) -> Predicted:
    marched = march_through_pulses(ground.pulses(methods.march_threshold), methods.system)
    name = "" if ground.motion is None else ground.motion.name
    still = (
        f"{name}: the march still slides two minutes after the last peak; its dy does not count that slide."
    )
    return Predicted(marched.prediction, remarks=() if marched.rests else (still,))


PULSE_MARCH = PredictionMethod(
    key="march",
    name=NAME,
    head="march",
    knows=(Information.BLIND,),
    look=Look("D", "red", 0.9, order=5),
    predict=_predict,
)
