"""The default settings against converged ones, and how fast the error falls with the step."""

import math
from collections.abc import Callable, Iterable
from functools import partial

from dcfp.analysis import Response, respond
from dcfp.motion.ground_motion import GroundMotion
from dcfp.motion.synthetic import ricker
from dcfp.system import Heating, PreciseHeating, SimplifiedHeating
from dcfp.verify.check import Finding, Task, hundred_components, sixteen_analyses

GROUP = "Convergence"
#: What the default settings promise of the peak displacement [-] and of the peak temperature [degC].
_PROMISED_DISPLACEMENT, _PROMISED_TEMPERATURE = 1e-3, 0.2
_CONVERGED = "the same analysis at 1/16 of the record's step, tolerance 1e-6, 200 cells"

Motions = Callable[[], Iterable[tuple[str, GroundMotion]]]


def converged(motion: GroundMotion, heating: Heating) -> Response:
    """Analyse with settings at which nothing changes any more."""
    if isinstance(heating, PreciseHeating):
        heating = PreciseHeating(cells=200)
    return respond(motion, heating=heating, step=motion.time_step / 16.0, tolerance=1e-6)


def _displacement(motions: Motions, heating: Heating) -> Finding:
    errors: dict[str, float] = {}
    for name, motion in motions():
        reference = converged(motion, heating).peak_displacement
        errors[name] = respond(motion, heating=heating).peak_displacement / reference - 1.0
    worst = max(errors, key=lambda name: abs(errors[name]))
    note = f"Largest relative difference of peaks in {len(errors)} analyses: {worst}. Allowed: what the defaults promise."
    return Finding(errors[worst], 0.0, "-", _PROMISED_DISPLACEMENT, note, _CONVERGED)


def _temperature(motions: Motions, heating: Heating) -> Finding:
    errors: dict[str, float] = {}
    for name, motion in motions():
        reference = converged(motion, heating).peak_temperature
        errors[name] = respond(motion, heating=heating).peak_temperature - reference
    worst = max(errors, key=lambda name: abs(errors[name]))
    note = (
        f"Largest difference of peaks in {len(errors)} analyses: {worst}. Allowed: what the defaults promise."
    )
    return Finding(errors[worst], 0.0, "degC", _PROMISED_TEMPERATURE, note, _CONVERGED)


def _order(quantity: Callable[[Response], float]) -> Finding:
    """Slope of the error against the step, with the step's error control out of the way."""
    motion = ricker(500.0, 0.5, time_step=0.008)
    steps = [0.008 / 2.0**level for level in range(4)]
    reference = quantity(respond(motion, step=0.008 / 256.0, tolerance=1e-9))
    errors = [abs(quantity(respond(motion, step=step, tolerance=0.999)) - reference) for step in steps]
    slope = math.log2(errors[0] / errors[-1]) / (len(steps) - 1)
    sizes = ", ".join(f"{error:.1e}" for error in errors)
    note = (
        f"Ricker pulse, 0.5 m/s at 0.5 Hz; errors of the peak at steps of 8, 4, 2 and 1 ms: {sizes}."
        " Second order is meant; half an order less is allowed, because a turn falls differently into each step."
    )
    return Finding(slope, 2.0, "-", 0.5, note, "second order in the step", more_is_better=True)


def _tasks(label: str, motions: Motions, heating: Heating, *, long: bool) -> tuple[Task, ...]:
    return (
        Task(
            GROUP,
            f"peak displacement, {label}, {heating.name}",
            partial(_displacement, motions, heating),
            long,
        ),
        Task(
            GROUP, f"peak temperature, {label}, {heating.name}", partial(_temperature, motions, heating), long
        ),
    )


_HUNDRED: Motions = partial(hundred_components, 500.0)

TASKS = (
    *_tasks("16 analyses", sixteen_analyses, SimplifiedHeating(), long=False),
    *_tasks("16 analyses", sixteen_analyses, PreciseHeating(), long=True),
    *_tasks("100 components at 0.5 m/s", _HUNDRED, SimplifiedHeating(), long=True),
    *_tasks("100 components at 0.5 m/s", _HUNDRED, PreciseHeating(), long=True),
    Task(
        GROUP, "order of the peak displacement", partial(_order, lambda response: response.peak_displacement)
    ),
    Task(GROUP, "order of the peak temperature", partial(_order, lambda response: response.peak_temperature)),
)
