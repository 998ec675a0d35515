r"""A test of the virtual machine by brute force: small uniform steps, and the whole past summed at every one of them.

Nothing is shared with the kernels, not even the modes of the heat or the constants of the law of Li et al. (2020). Spring (b) is cut back to
the yield surface after every step. The flux is constant in a step, and its weight in Eq. (11) exact:
:math:`2 (\sqrt{t-t_a} - \sqrt{t-t_b})`. The precise model is summed for all points at once: of the points under a slider of length 2a,
the part that was also under it when it was a distance d away is :math:`1 - d/2a`.
"""

import math
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numba
import numpy as np

from dcfp.analysis.rig import Loops, Program, RigTest, Sine, VerticalLoad, run_program
from dcfp.arrays import FloatArray
from dcfp.system import LI_2020, Bearing, Heating, PreciseHeating, SimplifiedHeating
from dcfp.verify.check import Finding, Task
from dcfp.verify.rig import (
    GROUP,
    HEATED,
    PROMISED_MEASURE,
    PROMISED_TEMPERATURE,
    SINES,
    of_each_cycle,
    run_named,
    run_one,
)


@dataclass(frozen=True)
class Path:
    """A displacement at uniform steps.

    Attributes
    ----------
    step
        [s].
    displacement, velocity
        [mm] and [mm/s], shape (n + 1,).
    relieved
        Step at which spring (b) is without force again, because another test begins.
    """

    step: float
    displacement: FloatArray
    velocity: FloatArray
    relieved: int = 0


@dataclass(frozen=True)
class Story:
    """What a path brings, at each of its points.

    Attributes
    ----------
    temperature
        Of the contact [degC]; during a rest only at its end.
    force
        Horizontal [N].
    work
        Of the machine [N mm].
    """

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
) -> Story:
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
    return Story(temperature, force, work)


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


# The virtual test machine against a brute-force integration of whole tests, and its tests cut in two.


#: Samples of the virtual machine in a cycle.
_SAMPLES = 400
#: Small steps to a sample: they last 0.25, 1.34 and 0.34 ms; with 0.67 ms the second differs by no more than with 1.34 ms.
_PARTS = {"dependency T01": 32, "ASCE T02": 8, "ASCE T06": 32}
_PAUSED, _PAUSED_PARTS, _PERIODS_OF_REST = "ASCE T12a", 16, 14
#: Samples after a start at full velocity in which the first small steps are too long for their own error to be left out.
_SUDDEN = 20


@cache
def _story(name: str, heating: SimplifiedHeating | PreciseHeating) -> Story:
    _, amplitude, peak_velocity, cycles = SINES[name]
    path = sine(amplitude, peak_velocity, cycles, _SAMPLES * _PARTS[name])
    return integrate(path, LI_2020, li_2020_constants(60.0), heating)


def _source(name: str) -> str:
    _, amplitude, peak_velocity, _ = SINES[name]
    step = sine(amplitude, peak_velocity, 1, _SAMPLES * _PARTS[name]).step
    return f"explicit integration and direct convolution, {1e3 * step:.2f} ms"


def _worst(differences: FloatArray) -> float:
    return float(differences[np.abs(differences).argmax()])


def _temperature(name: str, heating: SimplifiedHeating | PreciseHeating) -> Finding:
    direct = _story(name, heating).temperature[:: _PARTS[name]]
    loops = run_named(name, heating)
    peaks = float(loops.temperature.max() - direct.max())
    note = (
        f"Largest difference of {direct.size} samples; of the peaks, {direct.max():.1f} degC, it is {peaks:.4f} degC."
        " Allowed: what the defaults promise."
    )
    return Finding(_worst(loops.temperature - direct), 0.0, "degC", PROMISED_TEMPERATURE, note, _source(name))


def _friction(name: str, heating: SimplifiedHeating | PreciseHeating) -> Finding:
    half = _SAMPLES // 2
    direct = np.abs(_story(name, heating).force[:: half * _PARTS[name]][1:])
    computed = np.abs(run_named(name, heating).force[::half][1:])
    note = f"Largest relative difference of {direct.size} passages. Allowed: what the defaults promise."
    return Finding(_worst(computed / direct - 1.0), 0.0, "-", PROMISED_MEASURE, note, _source(name))


def _energy(name: str, heating: SimplifiedHeating | PreciseHeating) -> Finding:
    direct = np.diff(_story(name, heating).work[:: _SAMPLES * _PARTS[name]])
    computed = of_each_cycle(run_named(name, heating), "energy")
    note = f"Largest relative difference of {direct.size} cycles. Allowed: what the defaults promise."
    return Finding(_worst(computed / direct - 1.0), 0.0, "-", PROMISED_MEASURE, note, _source(name))


def _paused(waveform: Sine, pause: float, heating: Heating) -> tuple[Loops, Loops]:
    load = VerticalLoad((60.0,))
    tests = (RigTest("a", waveform, load), RigTest("b", waveform, load, pause=pause))
    first, second = run_program(Program("check", tests), heating=heating)
    return first, second


def _pause(heating: SimplifiedHeating | PreciseHeating) -> Finding:
    _, amplitude, peak_velocity, cycles = SINES[_PAUSED]
    path = sine(amplitude, peak_velocity, cycles, _SAMPLES * _PAUSED_PARTS)
    moving = path.displacement.size - 1
    rest = _PERIODS_OF_REST * _SAMPLES * _PAUSED_PARTS
    story = integrate(twice(path, rest), LI_2020, li_2020_constants(60.0), heating)
    pause = rest * path.step
    first, second = _paused(Sine(amplitude, peak_velocity, cycles), pause, heating)
    before = first.temperature - story.temperature[: moving + 1 : _PAUSED_PARTS]
    after = second.temperature - story.temperature[moving + rest :: _PAUSED_PARTS]
    note = (
        f"T12a, {pause:.1f} s of rest, T12b: largest difference but for the first {_SUDDEN} samples of each,"
        f" where the small steps follow a sudden start too coarsely. When the rest ends it is {after[0]:.4f} degC at"
        f" {second.temperature[0]:.1f} degC, when all is over {after[-1]:.4f} degC. Allowed: what the defaults promise."
    )
    gap = _worst(np.concatenate((before[_SUDDEN:], after[:1], after[_SUDDEN:])))
    source = f"explicit integration and direct convolution of the whole story, {1e3 * path.step:.2f} ms"
    return Finding(gap, 0.0, "degC", PROMISED_TEMPERATURE, note, source)


def _cut(heating: Heating) -> Finding:
    """Cut a test in two where spring (b) is so stiff that its relief at the cut does not matter."""
    stiff = LI_2020.unchecked(elastic_stiffness=1e5 * LI_2020.elastic_stiffness)
    load = VerticalLoad((60.0,))
    halves = (RigTest("a", Sine(200.0, 400.0, 2), load), RigTest("b", Sine(200.0, 400.0, 2), load, pause=0.0))
    second = run_program(Program("check", halves), stiff, heating=heating)[1]
    whole = run_one(Sine(200.0, 400.0, 4), heating, bearing=stiff)
    # the first sample of the second half sticks, and the heat of the last instant is missing there
    gap = _worst(second.temperature[_SUDDEN:] - whole.temperature[-second.time.size :][_SUDDEN:])
    energies = of_each_cycle(second, "energy") / of_each_cycle(whole, "energy")[2:] - 1.0
    note = (
        "Dependency T01 as two tests of two cycles without a pause, kf times 1e5; a test begins with spring (b) relieved."
        f" Largest difference from sample {_SUDDEN} on; energies of the cycles differ by {_worst(energies):.1e}."
        " Allowed: what a step that begins at the cut instead of before it may bring."
    )
    return Finding(gap, 0.0, "degC", 0.02, note, "the same test in one")


_COMPARED = {
    "temperature": _temperature,
    "coefficient at zero displacement": _friction,
    "energy of a cycle": _energy,
}

TASKS = (
    *(
        Task(GROUP, f"brute force, {name}, {words}, {heating.name} heating", partial(measure, name, heating))
        for name in _PARTS
        for heating in HEATED
        for words, measure in _COMPARED.items()
    ),
    *(
        Task(
            GROUP,
            f"brute force, T12a, a pause, T12b, {heating.name} heating",
            partial(_pause, heating),
            long=True,
        )
        for heating in HEATED
    ),
    *(
        Task(GROUP, f"a test cut in two, {heating.name} heating", partial(_cut, heating))
        for heating in HEATED
    ),
)
