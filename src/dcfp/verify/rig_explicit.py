r"""A test of the virtual machine by brute force: small uniform steps, and the whole past summed at every one of them.

Nothing is shared with the kernels, not even the modes of the heat or the constants of the law of Li et al. (2020). Spring (b) is cut back to
the yield surface after every step. The flux is constant in a step, and its weight in Eq. (11) exact:
:math:`2 (\sqrt{t-t_a} - \sqrt{t-t_b})`. The precise model is summed for all points at once: of the points under a slider of length 2a,
the part that was also under it when it was a distance d away is :math:`1 - d/2a`.
"""

import math
from dataclasses import dataclass
from typing import Any

import numba
import numpy as np

from dcfp.arrays import FloatArray
from dcfp.system import Bearing, PreciseHeating, SimplifiedHeating


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
