r"""A test of the virtual machine by brute force: small uniform steps, and the whole past summed at every one of them.

Nothing is shared with the kernels, not even the modes of the heat or the constants of the law of Li et al. (2020). Spring (b) is cut back to
the yield surface after every step. The flux is constant in a step, and its weight in Eq. (11) exact:
:math:`2 (\sqrt{t-t_a} - \sqrt{t-t_b})`. The precise model is summed for all points at once: of the points under a slider of length 2a,
the part that was also under it when it was a distance d away is :math:`1 - d/2a`.
"""

import math
from dataclasses import dataclass
from functools import cache
from typing import Any

import numba
import numpy as np

from dcfp.analysis.rig import Loops, Program, RigTest, Sine, VerticalLoad, run_program
from dcfp.arrays import FloatArray
from dcfp.system import LI_2020, Bearing, Heating, PreciseHeating, SimplifiedHeating
from dcfp.verify.check import Found
from dcfp.verify.rig import SINES, of_each_cycle, run_named, run_one, worst_of


@dataclass(frozen=True)
class Path:
    """A displacement [mm] and its velocity [mm/s] at uniform steps [s].

    Where another test begins, at the step `relieved`, spring (b) is without force again.
    """

    step: float
    displacement: FloatArray
    velocity: FloatArray
    relieved: int = 0


@dataclass(frozen=True)
class Outcome:
    """What a path brings at each of its points: temperature of the contact [degC] (during a rest only at its end), horizontal force [N], work of the machine [N mm]."""

    temperature: FloatArray
    force: FloatArray
    work: FloatArray


def sine(amplitude: float, peak_velocity: float, cycles: int, steps_per_cycle: int) -> Path:
    """Return a sine from zero displacement and full velocity [mm, mm/s]."""
    angle = 2.0 * math.pi * np.arange(cycles * steps_per_cycle + 1) / steps_per_cycle
    step = 2.0 * math.pi * amplitude / peak_velocity / steps_per_cycle
    return Path(step, amplitude * np.sin(angle), peak_velocity * np.cos(angle))


def twice(path: Path, rest: int) -> Path:
    """Return a path, a rest of so many steps at zero, and the path once more."""
    still = np.zeros(rest)
    displacement = np.concatenate((path.displacement[:-1], still, path.displacement))
    velocity = np.concatenate((path.velocity[:-1], still, path.velocity))
    return Path(path.step, displacement, velocity, relieved=path.displacement.size - 1 + rest)


def li_2020_constants(pressure: float) -> FloatArray:
    """Return the constants of Eqs (7) to (10) of Li et al. (2020) at a pressure [N/mm2], as `integrate` takes them."""
    gamma = 2.03 * pressure**-0.19 + 0.068
    return np.array([0.075 * gamma, 0.55, 0.019, 1.13, 0.007, 0.0])


def integrate(
    path: Path,
    bearing: Bearing,
    law: FloatArray,
    heating: SimplifiedHeating | PreciseHeating,
    *,
    speed_factor: float = 1.0,
    heats_while_sticking: bool = False,
) -> Outcome:
    """Take a bearing with one plate, or two equal ones, along a path under its own vertical force.

    The coefficient is m (1 - d exp(-r s |v|)) (A exp(-B T) + C), in which `law` holds m, d, r, A, B, C and `speed_factor` is s.
    """
    share = bearing.shares[0]
    temperature, force, work = _march(
        path.displacement,
        path.velocity,
        path.step,
        path.relieved,
        np.array([bearing.vertical_force, bearing.effective_radius, bearing.elastic_stiffness]),
        law,
        speed_factor,
        math.sqrt(heating.diffusivity / math.pi) / heating.conductivity * share * bearing.pressure,
        heating.ambient,
        bearing.contact_half_side / share,
        isinstance(heating, PreciseHeating),
        heats_while_sticking,
    )
    return Outcome(temperature, force, work)


def _summed_plainly(
    weights: FloatArray, flux: FloatArray, position: FloatArray, here: float, count: int, length: float
) -> float:
    """Sum the past of `count` steps, by how far the contact of some length [mm] then overlaps with that `here`."""
    total = 0.0
    for k in range(count):
        overlap = max(0.0, 1.0 - abs(here - position[k]) / length) if length > 0.0 else 1.0
        total += weights[count - 1 - k] * flux[k] * overlap
    return total


_summed: Any = numba.njit(fastmath=True)(_summed_plainly)


def _march_plainly(
    displacement: FloatArray,
    velocity: FloatArray,
    h: float,
    relieved: int,
    bearing: FloatArray,
    law: FloatArray,
    speed_factor: float,
    rise_per_flux: float,
    ambient: float,
    half_contact: float,
    along_the_line: bool,
    always: bool,
) -> tuple[FloatArray, FloatArray, FloatArray]:
    load, radius, elastic = bearing
    reference, drop, rate, scale, fall, floor = law
    steps = displacement.size - 1
    root = np.sqrt(h * np.arange(steps + 1.0))
    weights = 2.0 * (root[1:] - root[:-1])
    flux, position = np.zeros(steps), np.zeros(steps)
    temperature, force, work = np.full(steps + 1, ambient), np.zeros(steps + 1), np.zeros(steps + 1)
    length = 2.0 * half_contact if along_the_line else 0.0
    spring = 0.0
    for i in range(steps):
        travel = displacement[i + 1] - displacement[i]
        position[i] = 0.5 * (displacement[i] + displacement[i + 1])
        # the temperature in the middle of the step, from the last two
        warmth = temperature[i] + 0.5 * (temperature[i] - temperature[max(i - 1, 0)])
        friction = reference * (1.0 - drop * math.exp(-rate * speed_factor * abs(travel) / h))
        friction *= scale * math.exp(-fall * warmth) + floor
        reach = friction * load / elastic
        start = 0.0 if i == relieved else spring
        spring = min(max(start + travel, -reach), reach)
        slides = abs(start + travel) > reach
        if (slides or always) and (along_the_line or abs(position[i]) <= half_contact):
            flux[i] = friction * abs(travel) / h
        rests = travel == 0.0 and i + 2 <= steps and displacement[i + 2] == displacement[i + 1]
        temperature[i + 1] = temperature[i]
        if not rests:
            past = _summed(weights, flux, position, displacement[i + 1], i + 1, length)
            temperature[i + 1] = ambient + rise_per_flux * past
        force[i + 1] = load * displacement[i + 1] / radius + elastic * spring
        mean_force = load * position[i] / radius + 0.5 * elastic * (start + spring)
        work[i + 1] = work[i] + mean_force * travel
    return temperature, force, work


_march: Any = numba.njit(_march_plainly)


# ----- the virtual test machine against a brute-force integration of whole tests, and its tests cut in two -----

#: Samples of the virtual machine in a cycle.
_SAMPLES = 400
#: Small steps to a sample: they last 0.25, 1.34 and 0.34 ms; with 0.67 ms the second differs by no more than with 1.34 ms.
_PARTS = {"dependency T01": 32, "ASCE T02": 8, "ASCE T06": 32}
_PAUSED, _PAUSED_PARTS, _PERIODS_OF_REST = "ASCE T12a", 16, 14
#: Samples after a start at full velocity in which the first small steps are too long for their own error to be left out.
_SUDDEN = 20
_MODELS: dict[str, SimplifiedHeating | PreciseHeating] = {
    "simplified": SimplifiedHeating(),
    "precise": PreciseHeating(),
}


@cache
def _outcome(test: str, heating: str) -> tuple[Outcome, dict[str, float]]:
    """Return a test by the brute-force integration, and the words for its step [ms]."""
    _, amplitude, peak_velocity, cycles = SINES[test]
    path = sine(amplitude, peak_velocity, cycles, _SAMPLES * _PARTS[test])
    return integrate(path, LI_2020, li_2020_constants(60.0), _MODELS[heating]), {"step": 1e3 * path.step}


def temperature(test: str, heating: str) -> Found:
    """Return the largest difference of the temperature [degC]."""
    outcome, words = _outcome(test, heating)
    direct = outcome.temperature[:: _PARTS[test]]
    loops = run_named(test, heating)
    peak = float(direct.max())
    words = words | {"samples": direct.size, "peak": peak, "peaks": float(loops.temperature.max()) - peak}
    return Found(worst_of(loops.temperature - direct), 0.0, words=words)


def friction(test: str, heating: str) -> Found:
    """Return the largest relative difference of the force at zero displacement [-]."""
    outcome, words = _outcome(test, heating)
    half = _SAMPLES // 2
    direct = np.abs(outcome.force[:: half * _PARTS[test]][1:])
    computed = np.abs(run_named(test, heating).force[::half][1:])
    return Found(worst_of(computed / direct - 1.0), 0.0, words=words | {"samples": direct.size})


def energy(test: str, heating: str) -> Found:
    """Return the largest relative difference of the energy of a cycle [-]."""
    outcome, words = _outcome(test, heating)
    direct = np.diff(outcome.work[:: _SAMPLES * _PARTS[test]])
    computed = of_each_cycle(run_named(test, heating), "energy")
    return Found(worst_of(computed / direct - 1.0), 0.0, words=words | {"samples": direct.size})


def _in_turn(
    waveform: Sine, pause: float, heating: Heating | str, bearing: Bearing = LI_2020
) -> tuple[Loops, ...]:
    """Run a test twice, with a pause [s] between."""
    load = VerticalLoad((60.0,))
    tests = (RigTest("a", waveform, load), RigTest("b", waveform, load, pause=pause))
    return tuple(run_program(Program("check", tests), bearing, heating=heating))


def pause(heating: str) -> Found:
    """Return the largest difference of the temperature in two tests with a pause between them [degC]."""
    _, amplitude, peak_velocity, cycles = SINES[_PAUSED]
    path = sine(amplitude, peak_velocity, cycles, _SAMPLES * _PAUSED_PARTS)
    moving = path.displacement.size - 1
    rest = _PERIODS_OF_REST * _SAMPLES * _PAUSED_PARTS
    outcome = integrate(twice(path, rest), LI_2020, li_2020_constants(60.0), _MODELS[heating])
    first, second = _in_turn(Sine(amplitude, peak_velocity, cycles), rest * path.step, heating)
    before = first.temperature - outcome.temperature[: moving + 1 : _PAUSED_PARTS]
    after = second.temperature - outcome.temperature[moving + rest :: _PAUSED_PARTS]
    gap = worst_of(np.concatenate((before[_SUDDEN:], after[:1], after[_SUDDEN:])))
    words = {
        "rest": rest * path.step,
        "begins": after[0],
        "warm": second.temperature[0],
        "ends": after[-1],
        "step": 1e3 * path.step,
    }
    return Found(gap, 0.0, words=words)


def cut(heating: str) -> Found:
    """Return the difference of the temperature of a test in two where spring (b) is so stiff that its relief does not matter [degC]."""
    stiff = LI_2020.unchecked(elastic_stiffness=1e5 * LI_2020.elastic_stiffness)
    _, second = _in_turn(Sine(200.0, 400.0, 2), 0.0, heating, stiff)
    whole = run_one(Sine(200.0, 400.0, 4), heating, bearing=stiff)
    # the first sample of the second half sticks, and the heat of the last instant is missing there
    gap = worst_of(second.temperature[_SUDDEN:] - whole.temperature[-second.time.size :][_SUDDEN:])
    energies = of_each_cycle(second, "energy") / of_each_cycle(whole, "energy")[2:] - 1.0
    return Found(gap, 0.0, words={"energies": worst_of(energies)})
